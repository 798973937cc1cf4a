// A disc as in the original paper, with a temperature that falls towards the rim.
#include "palette.glsl"
#include "tone.glsl"

in vec2 corner;
flat in float centre;

uniform float pixels; // per radius
uniform float gain; // brightness of gas of 1500 K

out vec4 pixel;

const float RIM = 0.55;   // temperature of the rim, as a share of the centre's
const float RIM_AT = 0.95; // distance of that temperature from the centre, in radii

void main() {
    float distance = length(corner);
    float inside = clamp((1.0 - distance) * pixels + 0.5, 0.0, 1.0);
    float kilokelvin = centre * mix(1.0, RIM, smoothstep(0.0, RIM_AT, distance));
    pixel = vec4(displayed(radiance(kilokelvin, GAS_ROW) * gain), 1.0) * inside;
}

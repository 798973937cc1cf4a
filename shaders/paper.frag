// The paper's drawing: a hard disc, coloured by the distance from its centre.
#include "palette.glsl"
#include "tone.glsl"

in vec2 corner;
flat in float centre;

uniform float pixels; // in a radius
uniform float gain; // brightness of gas of 1500 K

out vec4 pixel;

const float RIM = 0.55;   // temperature of the rim, as a share of the centre's
const float RIM_AT = 0.95; // where it is reached, in radii

void main() {
    float distance = length(corner);
    float inside = clamp((1.0 - distance) * pixels + 0.5, 0.0, 1.0);
    float kilokelvin = centre * mix(1.0, RIM, smoothstep(0.0, RIM_AT, distance));
    pixel = vec4(displayed(radiance(kilokelvin) * gain), 1.0) * inside;
}

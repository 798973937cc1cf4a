// A sprite: a soft flake of noise that glows as a black body.
#include "palette.glsl"
#include "tone.glsl"

in vec2 corner;
flat in vec4 part;
flat in vec2 heat;

uniform sampler2D noise; // a tile; 0.5 is zero
uniform float gain; // brightness of gas of 1500 K

out vec4 shown;

const float PART = 0.16; // half the side of a sprite in the noise tile
const float RIM = 0.72;  // temperature of the rim, as a share of the middle's

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    vec4 grain = texture(noise, part.xy + PART * mat2(part.zw, -part.w, part.z) * corner);
    // The mean of the sum is 0.75.
    float flake = inside * smoothstep(0.0, 0.9, inside + 2.0 * (grain.x + 0.5 * grain.w - 0.75));
    vec3 colour = displayed(radiance(heat.x * mix(RIM, 1.0, flake)) * gain);
    shown = vec4(colour, 1.0) * (heat.y * flake);
}

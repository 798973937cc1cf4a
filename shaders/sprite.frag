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
const float MEAN = 0.75; // of the sum of two octaves of the noise
const float RAGGED = 2.0; // noise in the outline of a flake
const float FULL = 0.9;  // height of the flake from which it is opaque

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    vec4 grain = texture(noise, part.xy + PART * mat2(part.zw, -part.w, part.z) * corner);
    float flake = inside * smoothstep(0.0, FULL, inside + RAGGED * (grain.x + 0.5 * grain.w - MEAN));
    vec3 colour = displayed(radiance(heat.x * mix(RIM, 1.0, flake), GAS_ROW) * gain);
    shown = vec4(colour, 1.0) * (heat.y * flake);
}

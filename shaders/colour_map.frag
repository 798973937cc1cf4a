// The mean of a measured quantity, as a colour. Gas ends softly.
#include "field.glsl"
#include "scale.glsl"

in vec2 uv;

uniform float floor_x;    // middle of the domain, 0–1 over the picture
uniform float half_width; // from there to the side of the domain, in pictures
uniform float per_fade;   // 1 / width in which gas fades at that side, in pictures
uniform float per_cover;  // 1 / weight that covers what is behind it

out vec4 pixel;

void main() {
    vec4 gas = field_at(uv);
    float covered = smoothstep(0.0, 1.0, gas.x * per_cover) * clamp((half_width - abs(uv.x - floor_x)) * per_fade, 0.0, 1.0);
    pixel = dither(vec4(scale_colour(gas.y / max(gas.x, 1e-3)), 1.0)) * covered;
}

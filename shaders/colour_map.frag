// The colour of the mean of a measured quantity. Gas fades at its edge.
#include "field.glsl"
#include "scale.glsl"

in vec2 uv;

uniform float floor_x;    // middle of the domain, 0–1 over the picture
uniform float half_width; // half the width of the domain, in pictures
uniform float per_fade;   // 1 / width over which gas fades at the sides of the domain, in pictures
uniform float per_cover;  // 1 / weight of opaque gas

out vec4 pixel;

const float MIN_WEIGHT = 1e-3; // avoids a division by zero

void main() {
    vec4 gas = field_at(uv);
    float covered = smoothstep(0.0, 1.0, gas.x * per_cover) * clamp((half_width - abs(uv.x - floor_x)) * per_fade, 0.0, 1.0);
    pixel = dither(vec4(scale_colour(gas.y / max(gas.x, MIN_WEIGHT)), 1.0)) * covered;
}

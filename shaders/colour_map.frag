// The colour of the mean of a measured quantity. Gas fades at its edge, or into far air.
#include "field.glsl"
#include "scale.glsl"

in vec2 uv;

uniform float floor_x;    // middle of the domain, 0–1 over the picture
uniform float half_width; // half the width of the domain, in pictures
uniform float per_fade;   // 1 / width over which gas fades at the sides of the domain, in pictures
uniform float per_cover;  // 1 / weight of opaque gas
uniform float far_air;    // that quantity of far air, as a share of the span; below 0: nothing is beyond the gas

out vec4 pixel;

const float MIN_WEIGHT = 1e-3; // avoids a division by zero

void main() {
    vec4 gas = field_at(uv);
    float covered = smoothstep(0.0, 1.0, gas.x * per_cover) * clamp((half_width - abs(uv.x - floor_x)) * per_fade, 0.0, 1.0);
    float share = gas.y / max(gas.x, MIN_WEIGHT);
    if (far_air >= 0.0) {
        share = mix(far_air, share, covered);
        covered = 1.0;
    }
    pixel = dither(vec4(scale_colour(share), 1.0)) * covered;
}

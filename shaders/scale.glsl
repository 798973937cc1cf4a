// The colour of a share of the span, 0–1. Lightness is linear (OkLCh, B. Ottosson 2020), so that
// no colour suggests an edge. One-sided scales go from violet over red to yellow, two-sided ones
// from a dark middle to blue and to orange. web/scale.js draws the same colours on the bar.
#include "colour.glsl"

uniform float two_sided; // 1: the middle of the span is zero

vec3 scale_colour(float share) {
    // Lightness, chroma, hue [rad].
    vec3 lch = vec3(0.18 + 0.77 * share, 0.03 + share * (0.66 - 0.6 * share), 5.1487 + 2.9671 * share);
    if (two_sided > 0.0) {
        float side = 2.0 * share - 1.0;
        float far = abs(side);
        // Maximum chroma, hue at zero, and change of the hue.
        vec3 side_colour = side < 0.0 ? vec3(0.34, 4.5728, -0.733) : vec3(0.46, 0.2618, 1.1345);
        lch = vec3(0.16 + 0.74 * far, side_colour.x * far * (1.0 - 0.74 * far), side_colour.y + side_colour.z * far);
    }
    vec2 ab = lch.y * vec2(cos(lch.z), sin(lch.z));
    vec3 root = lch.x + ab.x * vec3(0.39634, -0.10556, -0.08948) + ab.y * vec3(0.2158, -0.06385, -1.29149);
    return encode(mat3(4.07674, -1.26844, -0.0042, -3.30771, 2.60976, -0.70342, 0.23097, -0.34132, 1.70761)
        * (root * root * root));
}

// The tone map: light to displayed colours.
#include "colour.glsl"

uniform vec3 pale;    // colour to which overexposed light pales, linear
uniform float yellow; // 1: light pales by way of yellow, as of soot; 0: directly

// Compresses the peak and keeps the hue. Compressing each channel would shift orange to yellow.
vec3 displayed(vec3 linear) {
    const float FAITHFUL = 0.8;  // maximum radiance with an unchanged hue
    const float HALF_PALE = 50.0; // squared excess at which half of the hue has paled
    float peak = max(linear.r, max(linear.g, linear.b));
    float compressed = 1.0 - exp(-peak);
    vec3 hue = linear / max(peak, 1e-6);
    float bright = max(peak - FAITHFUL, 0.0);
    float paled = bright * bright / (bright * bright + HALF_PALE);
    // Green rises early and blue late: orange pales by way of yellow.
    vec3 share = mix(vec3(paled), vec3(paled, paled * (1.7 - 0.7 * paled), paled * paled), yellow);
    return encode(compressed * mix(hue, pale, share));
}

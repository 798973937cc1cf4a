// The tone map: light to displayed colours.
#include "colour.glsl"

uniform vec3 pale;    // what light that is far too bright pales to, linear
uniform float yellow; // 1: it pales by way of yellow, as glowing soot does; 0: directly

// Compresses the peak and keeps the hue, so that orange stays orange. Compressing channel by
// channel would turn it lemon.
vec3 displayed(vec3 linear) {
    const float FAITHFUL = 0.8;  // radiance up to which the hue stays
    const float HALF_PALE = 13.0; // square of the radiance beyond it at which half has paled
    float peak = max(linear.r, max(linear.g, linear.b));
    float compressed = 1.0 - exp(-peak);
    vec3 hue = linear / max(peak, 1e-6);
    float bright = max(peak - FAITHFUL, 0.0);
    float paled = bright * bright / (bright * bright + HALF_PALE);
    // Red keeps, green rises early and blue late: from orange over yellow.
    vec3 share = mix(vec3(paled), vec3(paled, paled * (1.7 - 0.7 * paled), paled * paled), yellow);
    return encode(compressed * mix(hue, pale, share));
}

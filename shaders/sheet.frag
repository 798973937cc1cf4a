// Part of the atlas of a fire in another world: the light of a slice, or the glow and the light on
// smoke. No colour exceeds its alpha, so no path of a picture changes it.
#include "colour.glsl"

in vec2 uv;

uniform sampler2D light;
uniform sampler2D glow;
uniform sampler2D smoke_light;
uniform float light_range; // maximum radiance in targets
uniform float rooted;      // 1: the light is a square root; 0: it is linear
uniform float bloom;       // share of the glow, times the light range
uniform float soot;        // light on soot
uniform float whole;       // 1: glow and light on smoke, which all slices share; 0: a slice

out vec4 pixel;

const vec3 SOOT = vec3(0.36, 0.33, 0.31); // displayed colour of lit soot, as in the tone map

// Light and the coverage of what lies behind. Light beyond white stays apart from white.
vec4 stored(vec3 linear, float coverage) {
    float peak = max(linear.r, max(linear.g, linear.b));
    float alpha = 0.5 + 0.5 * coverage;
    return dither(vec4(encode(linear * ((1.0 - exp(-peak)) / max(peak, 1e-6))) * alpha, alpha));
}

void main() {
    if (whole == 0.0) {
        vec4 sharp = texture(light, uv);
        pixel = stored(sharp.rgb * (rooted > 0.0 ? sharp.rgb * light_range : vec3(1.0)), sharp.a);
        return;
    }
    vec2 at = vec2(uv.x, fract(2.0 * uv.y));
    vec3 soft = texture(glow, at).rgb;
    vec4 lit = texture(smoke_light, at);
    vec3 grey = SOOT * (soot * lit.a);
    pixel = uv.y < 0.5 ? stored(soft * soft * bloom, 1.0) : vec4(min(sqrt(lit.rgb * lit.rgb + grey * grey), 1.0), 1.0);
}

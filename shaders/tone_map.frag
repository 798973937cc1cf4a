// Light and glow to displayed colours, with premultiplied alpha.
#include "colour.glsl"
#include "tone.glsl"

in vec2 uv;

uniform sampler2D light;
uniform sampler2D glow;
uniform float light_range; // largest radiance that targets hold
uniform float bloom;     // glow's share of the sum, times the light range
uniform float scattered; // how much more of the glow smoke scatters
uniform float soot;      // light on soot

out vec4 shown;

const float UNSEEN = 0.004; // encoded light and coverage that no screen shows
const vec3 SOOT = vec3(0.36, 0.33, 0.31); // displayed colour of lit soot, a warm grey

void main() {
    vec4 sharp = texture(light, uv);
    vec3 soft = texture(glow, uv).rgb;
    if (max(max(sharp.a, sharp.r), soft.r) < UNSEEN) {
        shown = vec4(0.0);
        return;
    }
    vec3 sum = sharp.rgb * sharp.rgb * light_range + soft * soft * (bloom * (1.0 + scattered * sharp.a));
    vec3 colour = displayed(sum);
    // Glow has no body of its own, yet no colour may exceed its alpha. What
    // covers without shining is soot, and never quite black.
    float peak = max(colour.r, max(colour.g, colour.b));
    float alpha = clamp(sharp.a, peak, 1.0);
    float dark = alpha - peak;
    colour += SOOT * (soot * dark * dark / max(alpha, 1e-4));
    shown = dither(vec4(colour, alpha));
}

// Light and glow to displayed colours, with premultiplied alpha.
#include "colour.glsl"
#include "tone.glsl"

in vec2 uv;

uniform sampler2D light;
uniform sampler2D glow;
uniform sampler2D smoke_light;
uniform float light_range; // maximum radiance in targets
uniform float rooted;    // 1: the light is a square root; 0: it is linear
uniform float bloom;     // share of the glow, times the light range
uniform float soot;      // light on soot

out vec4 shown;

// Coverage, the root of the glow, and light below one step of eight bits.
const float INVISIBLE = 0.004;
const float DARK = 0.0003;
const float ADAPTED = 0.9; // share of the adapted hue in the faintest glow
const vec3 SOOT = vec3(0.36, 0.33, 0.31); // displayed colour of lit soot, a warm grey

void main() {
    vec4 sharp = texture(light, uv);
    vec3 soft = texture(glow, uv).rgb;
    if (max(sharp.a, soft.r) < INVISIBLE && sharp.r < DARK) {
        shown = vec4(0.0);
        return;
    }
    vec3 sum = sharp.rgb * (rooted > 0.0 ? sharp.rgb * light_range : vec3(1.0)) + soft * soft * bloom;
    vec3 colour = displayed(sum);
    // Glow covers nothing, but no colour may exceed its alpha. Coverage without emission is soot,
    // which is not quite black.
    float peak = max(colour.r, max(colour.g, colour.b));
    float bare = (1.0 - sharp.a) * (1.0 - peak);
    colour = adapted(colour, peak, ADAPTED * bare * bare);
    float alpha = clamp(sharp.a, peak, 1.0);
    float dark = alpha - peak;
    vec4 lit = texture(smoke_light, uv);
    vec3 grey = SOOT * (soot * lit.a);
    // Smoke shows its colour as far as it covers: thin smoke must not redden a page.
    colour += min(sqrt(lit.rgb * lit.rgb + grey * grey), 1.0) * (dark * dark / max(alpha, 1e-4));
    shown = dither(vec4(colour, alpha));
}

// Light and glow to displayed colours, with premultiplied alpha.
#include "colour.glsl"
#include "tone.glsl"

in vec2 uv;

uniform sampler2D light;
uniform sampler2D glow;
uniform float light_range; // maximum radiance in targets
uniform float bloom;     // share of the glow, times the light range
uniform float scattered; // additional share of the glow that smoke scatters
uniform float soot;      // light on soot

out vec4 shown;

const float INVISIBLE = 0.004; // encoded light and coverage below one step of eight bits
const vec3 SOOT = vec3(0.36, 0.33, 0.31); // displayed colour of lit soot, a warm grey

void main() {
    vec4 sharp = texture(light, uv);
    vec3 soft = texture(glow, uv).rgb;
    if (max(max(sharp.a, sharp.r), soft.r) < INVISIBLE) {
        shown = vec4(0.0);
        return;
    }
    vec3 sum = sharp.rgb * sharp.rgb * light_range + soft * soft * (bloom * (1.0 + scattered * sharp.a));
    vec3 colour = displayed(sum);
    // Glow covers nothing, but no colour may exceed its alpha. Coverage without emission is soot,
    // which is not quite black.
    float peak = max(colour.r, max(colour.g, colour.b));
    float alpha = clamp(sharp.a, peak, 1.0);
    float dark = alpha - peak;
    colour += SOOT * (soot * dark * dark / max(alpha, 1e-4));
    shown = dither(vec4(colour, alpha));
}

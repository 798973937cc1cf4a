// Light and glow to displayed colours, with premultiplied alpha.
#include "colour.glsl"
#include "tone.glsl"

in vec2 uv;
flat in vec4 fire;
flat in vec3 fire_light;

uniform sampler2D light;
uniform sampler2D glow;
uniform float light_range; // maximum radiance in targets
uniform float rooted;    // 1: the light is a square root; 0: it is linear
uniform float bloom;     // share of the glow, times the light range
uniform vec2 size;       // of the picture, in heights of the domain
uniform float soot;      // light on soot
uniform float extinction; // of opaque smoke, in 1 / heights of the domain

out vec4 shown;

// Coverage, the root of the glow, and light below one step of eight bits.
const float INVISIBLE = 0.004;
const float DARK = 0.0003;
const float SMOKY = 0.02;   // coverage beyond the light from which smoke is lit
const float ADAPTED = 0.7; // share of the adapted hue in the faintest glow
// The light of the fire on smoke: its share that is scattered, its least squared distance in heights of the domain, and
// squared radiance of gas that casts half a shadow.
const vec3 ALBEDO = vec3(0.12, 0.115, 0.11);
const float NEAREST = 0.02;
const float CLEAR = 0.05;
const int STEPS = 6;
// The sky on smoke: ways up at which smoke darkens it, in heights of the domain, and its shadow.
const vec3 ABOVE = vec3(0.015, 0.04, 0.1);
const float OVERCAST = 0.4;
const vec3 SOOT = vec3(0.36, 0.33, 0.31); // displayed colour of lit soot, a warm grey

// Coverage by smoke near a place; bright gas casts no shadow.
float casts(vec2 at) {
    vec4 near = texture(glow, at);
    vec3 lit = near.rgb * near.rgb * light_range;
    return near.a / (1.0 + dot(lit, lit) / CLEAR);
}

void main() {
    vec4 sharp = texture(light, uv);
    vec3 soft = texture(glow, uv).rgb;
    if (max(sharp.a, soft.r) < INVISIBLE && sharp.r < DARK) {
        shown = vec4(0.0);
        return;
    }
    vec3 sum = sharp.rgb * (rooted > 0.0 ? sharp.rgb * light_range : vec3(1.0)) + soft * soft * bloom;
    vec3 colour_of_smoke = vec3(0.0);
    float sky = 1.0;
    if (sharp.a - (1.0 - exp(-max(sum.r, max(sum.g, sum.b)))) > SMOKY) {
        // The light of the fire reaches smoke through the smoke between.
        vec2 to = fire.xy + clamp(uv - fire.xy, -fire.zw, fire.zw) - uv;
        float way = length(to * size);
        float between = 0.0;
        for (int i = 1; i <= STEPS; i++) between += casts(uv + to * (float(i) / float(STEPS + 1)));
        vec3 lit = fire_light * (light_range * exp(-extinction * way / float(STEPS) * between) / (NEAREST + way * way));
        lit = displayed(ALBEDO * lit);
        colour_of_smoke = lit * lit;
        vec3 over = vec3(casts(uv + vec2(0.0, ABOVE.x / size.y)), casts(uv + vec2(0.0, ABOVE.y / size.y)), casts(uv + vec2(0.0, ABOVE.z / size.y)));
        sky = exp(-OVERCAST * dot(over, vec3(1.0)));
    }
    vec3 colour = displayed(sum);
    // Glow covers nothing, but no colour may exceed its alpha. Coverage without emission is soot,
    // which is not quite black.
    float peak = max(colour.r, max(colour.g, colour.b));
    float bare = (1.0 - sharp.a) * (1.0 - peak);
    colour = adapted(colour, peak, ADAPTED * bare * bare);
    float alpha = clamp(sharp.a, peak, 1.0);
    float dark = alpha - peak;
    vec3 grey = SOOT * (soot * sky);
    // Smoke shows its colour as far as it covers: thin smoke must not redden a page.
    colour += sqrt(colour_of_smoke + grey * grey) * (dark * dark / max(alpha, 1e-4));
    shown = dither(vec4(colour, alpha));
}

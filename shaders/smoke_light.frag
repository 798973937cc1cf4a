// The light that reaches smoke through the smoke between: displayed light of the fire, and the share of the sky.
#include "tone.glsl"

in vec2 uv;
flat in vec4 fire;
flat in vec3 fire_light;

uniform sampler2D glow;
uniform float light_range; // maximum radiance in targets
uniform vec2 size;       // of the picture, in heights of the domain
uniform float extinction; // of opaque smoke, in 1 / heights of the domain

out vec4 smoke_light;

// The light of the fire on smoke: its share that is scattered, its least squared distance in heights of the domain, and
// squared radiance of gas that casts half a shadow.
const vec3 ALBEDO = vec3(0.12, 0.115, 0.11);
const float NEAREST = 0.02;
const float CLEAR = 0.05;
const int STEPS = 6;
// The sky on smoke: ways up at which smoke darkens it, in heights of the domain, and its shadow.
const vec3 ABOVE = vec3(0.015, 0.04, 0.1);
const float OVERCAST = 0.4;

// Coverage by smoke near a place; bright gas casts no shadow.
float casts(vec2 at) {
    vec4 near = texture(glow, at);
    vec3 lit = near.rgb * near.rgb * light_range;
    return near.a / (1.0 + dot(lit, lit) / CLEAR);
}

void main() {
    vec2 to = fire.xy + clamp(uv - fire.xy, -fire.zw, fire.zw) - uv;
    float way = length(to * size);
    float between = 0.0;
    for (int i = 1; i <= STEPS; i++) between += casts(uv + to * (float(i) / float(STEPS + 1)));
    vec3 lit = fire_light * (light_range * exp(-extinction * way / float(STEPS) * between) / (NEAREST + way * way));
    float over = 0.0;
    for (int i = 0; i < 3; i++) over += casts(uv + vec2(0.0, ABOVE[i] / size.y));
    vec3 colour = displayed(ALBEDO * lit);
    float peak = max(colour.r, max(colour.g, colour.b));
    smoke_light = vec4(adapted(colour, peak, 1.0 - 0.4 * peak), exp(-OVERCAST * over));
}

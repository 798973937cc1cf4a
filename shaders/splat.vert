// One quad per particle of the classic model: a kernel, stretched along its motion, and its payload
// for the field.
#include "particle.glsl"

uniform float radius;     // of the kernel [m]
uniform float weight;     // of a particle in its prime
uniform vec4 field_scale; // 1 / range of each value

out vec2 corner;       // −1–1 over the kernel
flat out vec4 payload; // weight, weight × kK, weight × glow, weight × smoke

const float STRETCH = 0.02; // time of motion over which a kernel stretches [s]
const float LONGEST = 2.2;  // maximum stretch
// The length grows with this power and the width with −1/2, so a stretched kernel gains area.
const float LENGTHENING = 0.75;
// Gas spreads while it rises: radius of a new kernel, and its increase with age.
const float NEWBORN = 0.85;
const float SPREAD = 0.4;
// Shares of a life in which particles fade in, heat up and fade out. Fading in and heating up also
// end after that number of seconds, so that long-lived particles do not stay dark.
const float FADE_IN = 0.15;
const float HEAT_UP = 0.30;
const float FADE_OUT = 0.45;
const float COLD_START = 0.62; // displayed share of the temperature of a new particle
// Glow starts at the first temperature and is complete at the second [kK].
const float DARK = 0.6;
const float GLOWING = 0.95;

void main() {
    Particle particle = this_particle();
    corner = particle.corner;

    float speed = length(particle.velocity);
    vec2 along = direction(particle, speed);
    float stretch = min(1.0 + speed * STRETCH / radius, LONGEST);

    float age = particle.state.z;
    float life = clamp(particle.state.w, 0.0, 1.0); // share that remains
    float lived = 1.0 - life;
    float widened = NEWBORN + SPREAD * lived;
    vec2 radii = radius * widened * vec2(inversesqrt(stretch), pow(stretch, LENGTHENING));
    gl_Position = clip(particle, particle.place + corner.x * radii.x * vec2(along.y, -along.x)
                                                + corner.y * radii.y * along);

    float born = smoothstep(0.0, 1.0, max(lived / FADE_IN, age / FADE_IN));
    float lit = smoothstep(0.0, 1.0, max(lived / HEAT_UP, age / HEAT_UP));
    float mass = weight * born * smoothstep(0.0, FADE_OUT, life) / (widened * widened);
    float kilokelvin = particle.state.x * 1e-3 * mix(COLD_START, 1.0, lit);
    float glow = smoothstep(DARK, GLOWING, kilokelvin);
    payload = mass * vec4(1.0, kilokelvin, glow, lived * lived * lived) * field_scale;
}

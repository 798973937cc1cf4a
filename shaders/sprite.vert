// One quad per particle: a slowly turning sprite with its own part of the noise tile.
#include "particle.glsl"

uniform float radius;  // [m]
uniform float turns;   // turns since the start at speed 1
uniform float opacity; // of a fully glowing sprite
uniform float full;    // remaining life or soot from which a sprite glows fully

out vec2 corner;
flat out vec4 part; // middle of the part of the tile; cosine and sine of the angle
flat out vec2 heat; // kK, opacity

// Irrational factors: consecutive numbers give different sprites, constant over time.
const vec4 UNLIKE = vec4(0.618034, 0.754878, 0.56984, 0.819173);
const float TURN = 6.2832; // [rad]
// Glow starts at the first temperature and is complete at the second [kK].
const float DARK = 0.75;
const float GLOWING = 1.05;
// Six speeds, from −2.5 to 2.5.
const float SPEEDS = 6.0;
const float FASTEST = 2.5;
// Faintest and smallest sprite, and the range of both.
const float FAINTEST = 0.3;
const float FAINT_RANGE = 0.7;
const float SMALLEST = 0.6;
const float SIZE_RANGE = 0.4;

void main() {
    Particle particle = this_particle();
    corner = particle.corner;
    vec4 state = particle.state; // temperature [K], volume [m²], number, remaining life or soot
    vec4 any = fract(state.z * UNLIKE);
    float angle = TURN * (any.x + turns * (floor(SPEEDS * any.y) - FASTEST));
    part = vec4(any.zy, cos(angle), sin(angle));
    heat.x = state.x * 1e-3;
    heat.y = opacity * (FAINTEST + FAINT_RANGE * any.w * any.w) * smoothstep(DARK, GLOWING, heat.x) * smoothstep(0.0, full, state.w);
    gl_Position = clip(particle, particle.place + corner * (heat.y > 0.0 ? radius * (SMALLEST + SIZE_RANGE * any.z) : 0.0));
}

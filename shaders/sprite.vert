// One quad a particle that glows: a sprite with a part of the noise tile of its own, which
// turns slowly.
#include "particle.glsl"

uniform float radius;  // [m]
uniform float turns;   // since the start, of a sprite of speed 1
uniform float opacity; // of a sprite that glows in full
uniform float full;    // what there is to glow from which a sprite glows in full

out vec2 corner;
flat out vec4 part; // of the tile: its middle; cosine and sine of its angle
flat out vec2 heat; // kK, opacity

// Irrational factors: any two consecutive numbers give unlike sprites, the same in every picture.
const vec4 UNLIKE = vec4(0.618034, 0.754878, 0.56984, 0.819173);
const float TURN = 6.2832; // [rad]
// Gas glows in full from the second temperature on and not below the first [kK].
const float DARK = 0.75;
const float GLOWING = 1.05;

void main() {
    Particle particle = this_particle();
    corner = particle.corner;
    vec4 state = particle.state; // temperature [K], volume [m²], number, what there is to glow
    vec4 any = fract(state.z * UNLIKE);
    // Six speeds, −2.5 to 2.5.
    float angle = TURN * (any.x + turns * (floor(6.0 * any.y) - 2.5));
    part = vec4(any.zy, cos(angle), sin(angle));
    heat.x = state.x * 1e-3;
    heat.y = opacity * (0.3 + 0.7 * any.w * any.w) * smoothstep(DARK, GLOWING, heat.x) * smoothstep(0.0, full, state.w);
    gl_Position = clip(particle, particle.place + corner * (heat.y > 0.0 ? radius * (0.6 + 0.4 * any.z) : 0.0));
}

// One quad per particle: a disc as in the original paper.
#include "particle.glsl"

uniform float radius; // [m]
uniform float pixels; // per radius
uniform float hottest; // temperature of all centres [kK]; 0: that of the particle

out vec2 corner; // in radii, one pixel beyond the rim
flat out float centre; // [kK]

const float GLOWING = 0.8; // minimum temperature of drawn gas [kK]

void main() {
    Particle particle = this_particle();
    corner = particle.corner * (1.0 + 1.0 / pixels);
    centre = hottest > 0.0 ? hottest : particle.state.x * 1e-3;
    gl_Position = clip(particle, particle.place + corner * (centre > GLOWING ? radius : 0.0));
}

// One quad a particle: the paper's round sprite.
#include "particle.glsl"

uniform float radius; // [m]
uniform float pixels; // in a radius
uniform float hottest; // temperature of every centre [kK]; 0: the particle's own

out vec2 corner; // in radii, a pixel beyond the rim
flat out float centre; // [kK]

const float GLOWING = 0.8; // cooler gas is not drawn [kK]

void main() {
    Particle particle = this_particle();
    corner = particle.corner * (1.0 + 1.0 / pixels);
    centre = hottest > 0.0 ? hottest : particle.state.x * 1e-3;
    gl_Position = clip(particle, particle.place + corner * (centre > GLOWING ? radius : 0.0));
}

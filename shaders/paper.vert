// One quad a particle: the paper's round sprite.

uniform vec4 sprite; // radius [m], pixels in a radius
uniform vec4 heat;   // temperature of the centre [kK], or 0: the particle's own; luminance exponent, gain

out vec2 corner; // in radii, a pixel further than the rim
flat out float centre; // [kK]

void main() {
    Particle particle = this_particle();
    corner = particle.corner * (1.0 + 1.0 / sprite.y);
    centre = heat.x > 0.0 ? heat.x : particle.state.x * 1e-3;
    // Gas that does not glow is not drawn.
    gl_Position = clip(particle, particle.place + corner * (centre > 0.8 ? sprite.x : 0.0));
}

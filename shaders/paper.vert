// One quad a particle: the paper's round sprite.

uniform vec4 sprite; // radius [m], pixels in a radius

out vec2 corner; // in radii, a pixel further than the rim

void main() {
    Particle particle = this_particle();
    corner = particle.corner * (1.0 + 1.0 / sprite.y);
    gl_Position = clip(particle, particle.place + corner * sprite.x);
}

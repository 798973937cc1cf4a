// One quad a particle: what is measured of it, to be summed with the kernel of the
// gas that fills its volume; or, where the kernel weighs nothing, as a disc of its own.

uniform vec4 kernel; // radius [m], 1 / its integral [1/m²], how far the quad reaches in radii, pixels in one
uniform vec4 span;   // least, 1 / (most − least), 1: signed

out vec2 corner;       // in radii
flat out vec4 payload; // weight, weight × share of the span

void main() {
    Particle particle = this_particle();
    corner = particle.corner * kernel.z;
    gl_Position = clip(particle, particle.place + corner * kernel.x);
    float share = clamp((particle.state.w - span.x) * span.y, 0.0, 1.0);
    float weight = kernel.y > 0.0 ? particle.state.y * kernel.y : 1.0;
    payload = weight * vec4(1.0, share, 0.0, 0.0);
}

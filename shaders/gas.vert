// One quad a particle: the kernel of gas that fills a volume, and what that
// gas adds to the fields or, in a second draw, to the velocities.

uniform vec4 kernel; // radius [m], 1 / its integral [1/m²], 1: velocities
uniform vec4 scale;  // what the target's range leaves of each field

out vec2 corner;       // −1–1 over the kernel
flat out vec4 payload; // weight; weight × kK, soot, burning or × velocity

void main() {
    Particle particle = this_particle();
    corner = particle.corner;
    gl_Position = clip(particle, particle.place + corner * kernel.x);
    // Inside gas the weights of all kernels sum up to 1.
    vec4 state = particle.state; // temperature [K], volume [m²], soot, burning [1/s]
    vec3 held = kernel.z > 0.0 ? vec3(particle.velocity, 0.0) : vec3(state.x * 1e-3, state.zw);
    payload = state.y * kernel.y * vec4(1.0, held) * scale;
}

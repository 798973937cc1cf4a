// One quad per particle of the combustion model: its kernel and payload for the field or, in the
// velocity pass, for the flow.
#include "particle.glsl"

uniform float radius;     // of the kernel [m]
uniform float peak;       // 1 / integral of the kernel [1/m²]
uniform float velocities; // 1: the velocity pass
uniform vec4 field_scale; // 1 / range of each value
uniform float row;        // first row of the sample
uniform float stride;     // draws one of so many particles
uniform float ahead;      // time from the sample to the moment of the slice [s]
uniform vec2 slice_scale; // scale of the slice; x is negative if it is mirrored

out vec2 corner;       // −1–1 over the kernel
flat out vec4 payload; // weight; weight × kK, soot, burning or weight × velocity

void main() {
    Particle particle = particle_from(int(row), int(stride));
    corner = particle.corner;
    gl_Position = clip(particle, particle.place + particle.velocity * ahead + corner * radius);
    // Inside gas the weights of all kernels sum to 1.
    vec4 state = particle.state; // temperature [K], volume [m²], soot, burning [1/s]
    vec3 carried = velocities > 0.0 ? vec3(particle.velocity * slice_scale, 0.0) : vec3(state.x * 1e-3, state.zw);
    payload = state.y * peak * vec4(1.0, carried) * field_scale;
}

// One quad per particle, with the measured quantity as a share of the colour scale.
#include "particle.glsl"

uniform float radius;    // of the kernel or disc [m]
uniform float reach;     // half the side of the quad in radii: a disc needs another pixel for its soft rim
uniform float peak;      // 1 / integral of the kernel [1/m²]; 0: a disc of weight 1
uniform float span_from; // quantity of the first colour
uniform float per_span;  // 1 / (quantity of the last colour − that of the first)

out vec2 corner;       // in radii
flat out vec4 payload; // weight, weight × share of the span

void main() {
    Particle particle = this_particle();
    corner = particle.corner * reach;
    // Where open air ends, the payload of a particle covers more room, and its disc fades.
    float wide = peak > 0.0 ? 1.0 + particle.state.z : 1.0;
    gl_Position = clip(particle, particle.place + corner * radius * wide);
    float share = clamp((particle.state.w - span_from) * per_span, 0.0, 1.0);
    float weight = peak > 0.0 ? particle.state.y * peak / (wide * wide) : 1.0 - 0.5 * particle.state.z;
    payload = weight * vec4(1.0, share, 0.0, 0.0);
}

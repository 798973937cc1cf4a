// Reads a particle and positions a corner of its quad. One instance draws a block of quads, because
// an instance costs software renderers and some phones far more than a quad. QUADS_PER_INSTANCE, PARTICLES_PER_ROW and TEXELS_PER_PARTICLE
// come from build/values.rs.
#include "particles.glsl"

uniform vec2 clip_scale;     // metres to clip coordinates
uniform vec2 clip_offset;    // middle of the floor in clip coordinates
uniform float count;         // number of particles

struct Particle {
    vec2 place;    // [m]
    vec2 velocity; // [m/s]
    vec4 state;    // temperature [K] and three values of the model
    vec2 corner;   // this vertex in the quad, −1 or 1
    bool real;     // false for unused quads of the last block
};

// The particle of that number in the rows from `first` on.
Particle particle_at(int number, int first) {
    ivec2 texel = ivec2(number % PARTICLES_PER_ROW * TEXELS_PER_PARTICLE, number / PARTICLES_PER_ROW + first);
    vec4 motion = texelFetch(particles, texel, 0);
    vec4 state = texelFetch(particles, texel + ivec2(1, 0), 0);
    int at = gl_VertexID % 6; // two triangles: 0 1 2, 2 1 3
    int which = at < 3 ? at : at == 3 ? 2 : at == 4 ? 1 : 3;
    return Particle(motion.xy, motion.zw, state,
                    vec2(which & 1, which >> 1) * 2.0 - 1.0, float(number) < count);
}

// The particle of this quad, one of each `every` ones in the rows from `first` on.
Particle particle_from(int first, int every) {
    return particle_at((gl_InstanceID * QUADS_PER_INSTANCE + gl_VertexID / 6) * every, first);
}

Particle this_particle() {
    return particle_from(0, 1);
}

// Direction of the motion; upward at rest.
vec2 direction(Particle particle, float speed) {
    return speed > 1e-4 ? particle.velocity / speed : vec2(0.0, 1.0);
}

// Clip coordinates; outside the clip volume for an unused quad.
vec4 clip(Particle particle, vec2 place) {
    return particle.real ? vec4(place * clip_scale + clip_offset, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}

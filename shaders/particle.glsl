// Reading particles. Their numbers lie in a texture, and one instance draws a
// whole block of quads: a software renderer, and some phones, pay for every
// instance far more than for a quad.

const int BLOCK = 64;       // quads an instance
const int ROW = 512;        // particles a row of the texture

uniform sampler2D particles; // two texels each
uniform vec4 world; // metres to clip: scale, offset
uniform vec4 count; // particles

struct Particle {
    vec2 place;    // [m]
    vec2 velocity; // [m/s]
    vec4 state;    // temperature [K] and what else its model says of it
    vec2 corner;   // which corner of its quad this vertex is, −1 or 1
    bool real;     // the last block may not be full
};

Particle this_particle() {
    int number = gl_InstanceID * BLOCK + gl_VertexID / 6;
    ivec2 texel = ivec2(number % ROW * 2, number / ROW);
    vec4 motion = texelFetch(particles, texel, 0);
    vec4 state = texelFetch(particles, texel + ivec2(1, 0), 0);
    int at = gl_VertexID % 6; // two triangles: 0 1 2, 2 1 3
    int corner = at < 3 ? at : at == 3 ? 2 : at == 4 ? 1 : 3;
    return Particle(motion.xy, motion.zw, state,
                    vec2(corner & 1, corner >> 1) * 2.0 - 1.0, float(number) < count.x);
}

vec4 clip(Particle particle, vec2 place) {
    return particle.real ? vec4(place * world.xy + world.zw, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}

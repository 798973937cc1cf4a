// Numbers that are listed in the texture of particles, four in a texel. PARTICLES_PER_ROW and TEXELS_PER_PARTICLE come from build/values.rs.
#include "particles.glsl"

// A number of a list of rows: its first texel and the length of a row come first.
float listed(vec2 first, ivec2 at) {
    int number = at.y * int(first.y) + at.x;
    int texel = int(first.x) + number / 4;
    return texelFetch(particles, ivec2(texel % (PARTICLES_PER_ROW * TEXELS_PER_PARTICLE), texel / (PARTICLES_PER_ROW * TEXELS_PER_PARTICLE)), 0)[number % 4];
}

// The quad of a solid.
#include "solid.glsl"

out vec2 uv;        // 0–1 over the picture
flat out vec3 turn; // direction of its width; a number that differs between solids
flat out vec3 grid; // of a solid with fuel: the first texel, columns and rows of its cells; else zeros
out vec2 spot;      // from the middle of the lower left one, in cells

const float UNLIKE = 0.37; // tiles of noise between the pictures of consecutive solids

void main() {
    turn = vec3(this_solid().velocity, float(gl_VertexID / 6) * UNLIKE);
    uv = gl_Position.xy * 0.5 + 0.5;
    grid = vec3(0.0);
    spot = local;
    float number = floor(body.w / MATERIAL_FACTOR);
    if (number >= FUEL_OFFSET) {
        // Its temperature is the place of its cells; its material is drawn on what it was at first.
        int place = int(body.w - number * MATERIAL_FACTOR) + PARTICLES_PER_ROW;
        ivec2 head = ivec2(place % PARTICLES_PER_ROW * TEXELS_PER_PARTICLE, place / PARTICLES_PER_ROW);
        vec4 size = texelFetch(particles, head, 0);
        vec4 box = texelFetch(particles, head + ivec2(1, 0), 0);
        grid = vec3(float((place + 1) * TEXELS_PER_PARTICLE), size.yz);
        spot = (local / vec2(size.w, box.x) * 0.5 + 0.5) * grid.yz - 0.5;
        body = vec4(box.yzw, (number - FUEL_OFFSET) * MATERIAL_FACTOR);
    }
}

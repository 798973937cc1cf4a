// The quad of a solid.
#include "solid.glsl"

out vec2 uv;        // 0–1 over the picture
flat out vec3 turn; // direction of its width; a number that differs between solids
flat out vec3 grid; // of a solid with fuel: the first texel, columns and rows of its cells; else zeros
out vec2 spot;      // from the middle of the lower left one, in cells
out vec2 world;     // [m]
// The two nearest solids before it, without links of a chain: middle and direction of the width; half of the inner
// box and radius [m], which are zeros where there is none.
flat out vec4 frame_a;
flat out vec4 frame_b;
flat out vec3 box_a;
flat out vec3 box_b;

// Two long solids that touch at their ends: distance of their middles, as a share of half of their lengths.
const float LINK = 0.8;
const int MAX_OTHERS = 64;
const float UNLIKE = 0.37; // tiles of noise between the pictures of consecutive solids

void main() {
    Particle solid = this_solid(true);
    int own_number = gl_InstanceID + int(first_solid);
    turn = vec3(solid.velocity, float(own_number) * UNLIKE);
    uv = gl_Position.xy * 0.5 + 0.5;
    world = (gl_Position.xy - clip_offset) / clip_scale;
    frame_a = frame_b = vec4(solid.place, 1.0, 0.0);
    box_a = box_b = vec3(0.0);
    vec3 own = solid.state.xyz;
    vec2 nearest = vec2(0.0);
    // A sampled solid has none, and other quads than the first of a box are not drawn.
    int others = solid.real && own.z >= 0.0 ? MAX_OTHERS : 0;
    for (int other = own_number + 1; other < min(int(count), own_number + others); other++) {
        vec4 frame = texelFetch(particles, ivec2(other * TEXELS_PER_PARTICLE, 0), 0);
        vec3 box = texelFetch(particles, ivec2(other * TEXELS_PER_PARTICLE + 1, 0), 0).xyz;
        float apart = distance(frame.xy, solid.place);
        float close = length(own.xy) + own.z + length(box.xy) + box.z - apart;
        float length_of_both = max(own.x, own.y) + max(box.x, box.y);
        float thickness_of_both = min(own.x, own.y) + own.z + min(box.x, box.y) + box.z;
        // A negative radius is a place of samples.
        if (box.z < 0.0 || length_of_both > thickness_of_both && apart > LINK * length_of_both) close = 0.0;
        if (close > nearest.x) {
            nearest = vec2(close, nearest.x);
            frame_b = frame_a;
            box_b = box_a;
            frame_a = frame;
            box_a = box;
        } else if (close > nearest.y) {
            nearest.y = close;
            frame_b = frame;
            box_b = box;
        }
    }
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

// The backdrop, drawn once per size: a wall of bricks, the ground before it, or both.
#include "noise.glsl"

in vec2 uv;

uniform vec2 floor_middle; // middle of the world's floor, 0–1 over the picture
uniform vec2 size;         // of the picture, in heights of the domain
uniform float wall_foot;   // where the wall meets the ground, in heights of the domain
uniform float wall;        // 1 if there is a wall, or 0
uniform float ground;      // 1 stone, 2 earth, 3 sand, 4 snow

out vec4 scenery; // square root of colour; share of ground

// All sizes are in heights of the domain.
const float PERSPECTIVE = 0.3;  // depth below the wall at which the floor appears twice as large
const float STONE_ROW = 0.9;    // texture coordinate of the visible row of stones
const float WALL_SHADE = 0.04;  // height of the dark edge to the ground, on the wall
const float FLOOR_SHADE = 0.02; // and on the ground
const float HORIZON = 0.06; // depth over which a ground without a wall begins
const vec3 MORTAR = vec3(0.11, 0.1, 0.09);
const vec3 DARK_CLAY = vec3(0.34, 0.15, 0.09);
const vec3 PALE_CLAY = vec3(0.5, 0.27, 0.17);

vec4 rough(vec2 place) {
    return noise_at(place, 0.0);
}

// Bricks in rows, every other row shifted by half a brick, with joints. The factors on coordinates
// decorrelate reads of the noise; the factors on noise set the wear of a brick.
vec3 bricks(vec2 place, vec2 brick) {
    vec4 worn = rough(place * 2.3);
    vec2 cell = place / brick + 0.02 * worn.xy;
    float row = floor(cell.y);
    cell.x += 0.5 * mod(row, 2.0) + 0.12 * rough(vec2(row * 0.37, 0.1)).x;
    vec2 edge = (0.5 - abs(fract(cell) - 0.5)) * brick / brick.y;
    float face = smoothstep(0.03, 0.12, min(edge.x, edge.y) + 0.03 * worn.w);
    vec4 own = rough(floor(cell) * vec2(0.173, 0.291) + 0.05);
    vec3 clay = mix(DARK_CLAY, PALE_CLAY, 0.5 + own.x) * (1.0 + 0.5 * own.y);
    return mix(MORTAR, clay, face) * (1.0 + 0.22 * worn.z + 0.3 * worn.w);
}

// The ground approaches the viewer downwards.
vec3 ground_at(vec2 place, float near) {
    vec2 flat_place = vec2(place.x, STONE_ROW) / near;
    if (ground < 1.5) return bricks(flat_place, vec2(0.3, 0.15)).ggb;
    vec4 wide = rough(flat_place * vec2(0.7, 2.1));
    vec4 fine = rough(flat_place * vec2(2.9, 7.3)) + 0.5 * rough(flat_place * vec2(7.9, 19.0));
    if (ground < 2.5) return vec3(0.2, 0.14, 0.09) * max(1.0 + 0.5 * wide.x + 0.7 * fine.x + 0.6 * fine.w, 0.1);
    if (ground < 3.5) return vec3(0.56, 0.42, 0.26) * (1.0 + 0.25 * sin(160.0 * flat_place.y + 5.0 * wide.x) + 0.2 * wide.y + 0.25 * fine.w);
    return vec3(0.8, 0.86, 0.95) * (1.0 + 0.18 * wide.x + 0.1 * fine.x + 0.08 * fine.w);
}

void main() {
    vec2 place = (uv - floor_middle) * size;
    float depth = wall_foot - place.y; // below the foot of the wall
    // Wall and ground are dark where they meet.
    vec3 colour = depth > 0.0 ? ground_at(place, 1.0 + depth / PERSPECTIVE) : bricks(place, vec2(0.17, 0.062));
    float joint = smoothstep(0.0, depth > 0.0 ? FLOOR_SHADE : WALL_SHADE, abs(depth) + 0.005);
    float share = wall > 0.5 ? step(0.0, depth) : smoothstep(0.0, HORIZON, depth);
    scenery = vec4(sqrt(colour * joint), share);
}

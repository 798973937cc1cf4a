// The backdrop, drawn once per size: a wall of bricks on a floor of stone.
#include "noise.glsl"

in vec2 uv;

uniform vec2 floor_middle; // middle of the world's floor, 0–1 over the picture
uniform vec2 size;         // of the picture, in heights of the domain
uniform float wall_foot;   // where the wall meets the floor, in heights of the domain

out vec4 scenery; // square root of colour; share of floor

// All sizes are in heights of the domain.
const float PERSPECTIVE = 0.3;  // depth below the wall at which the floor appears twice as large
const float STONE_ROW = 0.9;    // texture coordinate of the visible row of stones
const float WALL_SHADE = 0.04;  // height of the dark edge to the floor, on the wall
const float FLOOR_SHADE = 0.02; // and on the floor
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

void main() {
    vec2 place = (uv - floor_middle) * size;
    float depth = wall_foot - place.y; // below the foot of the wall
    // The floor approaches the viewer downwards. Wall and floor are dark where they meet.
    float near = 1.0 + depth / PERSPECTIVE;
    vec3 colour = depth > 0.0 ? bricks(vec2(place.x, STONE_ROW) / near, vec2(0.3, 0.15)).ggb
                              : bricks(place, vec2(0.17, 0.062));
    float joint = smoothstep(0.0, depth > 0.0 ? FLOOR_SHADE : WALL_SHADE, abs(depth) + 0.005);
    scenery = vec4(sqrt(colour * joint), step(0.0, depth));
}

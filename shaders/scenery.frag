// The backdrop, drawn once per size: a wall of bricks, the ground before it, or both.
#include "noise.glsl"

in vec2 uv;

uniform vec2 floor_middle; // middle of the world's floor, 0–1 over the picture
uniform vec2 size;         // of the picture, in heights of the domain
uniform float wall_foot;   // foot of the wall on the ground, in heights of the domain
uniform float wall;        // 1 if there is a wall, or 0
uniform float ground;      // 1 stone, then EARTH, SAND, SNOW of build/values.rs

out vec4 scenery; // square root of colour; share of ground

// All sizes are in heights of the domain.
const float PERSPECTIVE = 0.3;  // depth below the wall at which the floor appears twice as large
const float STONE_ROW = 0.9;    // texture coordinate of the visible row of stones
const float WALL_SHADE = 0.04;  // height of the dark edge to the ground, on the wall
const float FLOOR_SHADE = 0.02; // and on the ground
const float HORIZON = 0.15; // depth over which a ground without a wall begins
const float UNEVEN = 0.05; // and by how much of it noise moves that
const vec3 MORTAR = vec3(0.085, 0.077, 0.07);
const vec3 DARK_CLAY = vec3(0.24, 0.115, 0.075);
const vec3 PALE_CLAY = vec3(0.42, 0.24, 0.16);

const float FOOT = 0.005;  // least depth: the edge itself is not black
const vec2 WALL_BRICK = vec2(0.17, 0.062); // a brick of the wall
const vec2 SLAB = vec2(0.3, 0.15); // flat stones on the ground
// Factors on coordinates that decorrelate reads of the noise.
const float WORN_PLACE = 2.3;
const float ROW_PLACE = 0.37;
const float ROW_START = 0.1;
const vec2 CELL_PLACE = vec2(0.173, 0.291);
const float CELL_START = 0.05;
const float HORIZON_PLACE = 0.6;
const vec2 WIDE_PLACE = vec2(0.7, 2.1); // stretched across, as things lie on the ground
const vec2 FINE_PLACE = vec2(2.9, 7.3);
const vec2 FINER_PLACE = vec2(7.9, 19.0);
// Wear of bricks: displacement of their edges and of rows, in bricks.
const float WAVY = 0.02;
const float STAGGER = 0.12;
// Mortar ends and a brick begins at these distances from its edge, in its heights; noise moves them.
const float JOINT = 0.03;
const float BRICK_FACE = 0.12;
const float RAGGED = 0.03;
// Light along an edge of a brick: its width in heights of the brick, and how much brighter or darker it is.
const float EDGE_LIGHT = 0.22;
const float EDGE_CONTRAST = 0.45;
// Share of noise in the brightness of a brick, and of all: broad and fine.
const float UNLIKE = 0.5;
const float STAINS = 0.22;
const float GRAIN = 0.3;
const vec3 SLAB_COLOUR = vec3(1.4, 1.0, 0.8);
const vec3 SOIL = vec3(0.2, 0.12, 0.075);
const float SOIL_WIDE = 0.5; // shares of noise in the brightness: clods, crumbs, grain
const float SOIL_FINE = 0.7;
const float SOIL_GRAIN = 0.6;
const float SOIL_DARKEST = 0.1;
const vec3 BEACH = vec3(0.56, 0.42, 0.26);
const float RIPPLES = 0.25;  // amplitude in the brightness of sand
const float RIPPLE = 160.0;  // ripples, in radians for each height of the domain
const float BEND = 5.0;      // their meander [rad]
const float DUNES = 0.2;     // shares of broad and fine noise
const float SAND_GRAIN = 0.25;
const vec3 WHITE = vec3(0.8, 0.86, 0.95); // bluish, as snow in the shade
const float DRIFTS = 0.18;   // shares of noise in the brightness
const float HOLLOWS = 0.1;
const float SNOW_GRAIN = 0.08;

vec4 rough(vec2 place) {
    return noise_at(place, 0.0);
}

// Bricks in rows, every other row shifted by half a brick, with joints.
vec3 bricks(vec2 place, vec2 brick) {
    vec4 worn = rough(place * WORN_PLACE);
    vec2 cell = place / brick + WAVY * worn.xy;
    float row = floor(cell.y);
    cell.x += 0.5 * mod(row, 2.0) + STAGGER * rough(vec2(row * ROW_PLACE, ROW_START)).x;
    vec2 edge = (0.5 - abs(fract(cell) - 0.5)) * brick / brick.y;
    float edge_side = sign(fract(cell.y) - 0.5);
    float face = smoothstep(JOINT, BRICK_FACE, min(edge.x, edge.y) + RAGGED * worn.w);
    vec4 own = rough(floor(cell) * CELL_PLACE + CELL_START);
    vec3 clay = mix(DARK_CLAY, PALE_CLAY, 0.5 + own.x) * (1.0 + UNLIKE * own.y);
    // A joint is recessed: it is dark below the upper brick, whose lower edge is dark, too, and the upper edge of a brick is bright.
    float down = edge_side * (1.0 - smoothstep(0.0, EDGE_LIGHT, edge.y));
    return mix(MORTAR, clay, face) * (1.0 + STAINS * worn.z + GRAIN * worn.w) * (1.0 + EDGE_CONTRAST * down);
}

// The ground approaches the viewer downwards.
vec3 ground_at(vec2 place, float near) {
    vec2 flat_place = vec2(place.x, STONE_ROW) / near;
    if (ground < EARTH) return bricks(flat_place, SLAB).g * SLAB_COLOUR;
    vec4 wide = rough(flat_place * WIDE_PLACE);
    vec4 fine = rough(flat_place * FINE_PLACE) + 0.5 * rough(flat_place * FINER_PLACE);
    if (ground < SAND) return SOIL * max(1.0 + SOIL_WIDE * wide.x + SOIL_FINE * fine.x + SOIL_GRAIN * fine.w, SOIL_DARKEST);
    if (ground < SNOW) return BEACH * (1.0 + RIPPLES * sin(RIPPLE * flat_place.y + BEND * wide.x) + DUNES * wide.y + SAND_GRAIN * fine.w);
    return WHITE * (1.0 + DRIFTS * wide.x + HOLLOWS * fine.x + SNOW_GRAIN * fine.w);
}

void main() {
    vec2 place = (uv - floor_middle) * size;
    float depth = wall_foot - place.y; // below the foot of the wall
    // Wall and ground are dark along the foot of the wall.
    vec3 colour = depth > 0.0 ? ground_at(place, 1.0 + depth / PERSPECTIVE) : bricks(place, WALL_BRICK);
    float joint = smoothstep(0.0, depth > 0.0 ? FLOOR_SHADE : WALL_SHADE, abs(depth) + FOOT);
    float share = wall > 0.5 ? step(0.0, depth) : smoothstep(0.0, HORIZON, depth - UNEVEN * abs(rough(vec2(place.x * HORIZON_PLACE, 0.0)).x));
    scenery = vec4(sqrt(colour * joint), share);
}

// A backdrop, drawn once: a wall of bricks on a floor of stone.

in vec2 uv;

uniform sampler2D noise; // a tile; 0.5 is zero
uniform vec4 view; // width / height of the picture; where the wall stands
uniform vec4 origin; // the floor's middle, in pictures; size of the picture, in heights of the domain

out vec4 scenery; // square root of colour; share of floor

vec4 rough(vec2 place) {
    return textureLod(noise, place, 0.0) * 2.0 - 1.0;
}

// Bricks in rows, every other one shifted by half, with joints between them.
vec3 bricks(vec2 place, vec2 size) {
    vec4 worn = rough(place * 2.3);
    vec2 cell = place / size + 0.02 * worn.xy;
    float row = floor(cell.y);
    cell.x += 0.5 * mod(row, 2.0) + 0.12 * rough(vec2(row * 0.37, 0.1)).x;
    vec2 edge = (0.5 - abs(fract(cell) - 0.5)) * size / size.y;
    float face = smoothstep(0.03, 0.12, min(edge.x, edge.y) + 0.03 * worn.w);
    vec4 own = rough(floor(cell) * vec2(0.173, 0.291) + 0.05);
    vec3 clay = mix(vec3(0.34, 0.15, 0.09), vec3(0.5, 0.27, 0.17), 0.5 + own.x) * (1.0 + 0.5 * own.y);
    return mix(vec3(0.11, 0.1, 0.09), clay, face) * (1.0 + 0.22 * worn.z + 0.3 * worn.w);
}

void main() {
    vec2 place = (uv - origin.xy) * origin.zw;
    float depth = view.y - place.y; // below the foot of the wall
    // A floor that comes nearer downwards, and is dark where it meets the wall.
    float near = 1.0 + depth / 0.3;
    vec3 colour = depth > 0.0 ? bricks(vec2(place.x, 0.9) / near, vec2(0.3, 0.15)).ggb
                              : bricks(place, vec2(0.17, 0.062));
    float joint = smoothstep(0.0, depth > 0.0 ? 0.02 : 0.04, abs(depth) + 0.005);
    scenery = vec4(sqrt(colour * joint), step(0.0, depth));
}

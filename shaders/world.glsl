// The position of the world in the picture.

uniform vec2 picture_size; // [m]
uniform vec2 floor_middle; // middle of the world's floor, 0–1 over the picture
uniform float zoom;        // height of the picture in heights of the domain
uniform vec4 sources[MAX_SOURCES]; // middle of the lower edge [m], width [m]; 1 for one whose flame begins at every height of it: on a solid or among turned ones; or 0
uniform float source_count; // at least 1

// Distances up and down from a source relative to one aside: gas belongs to the source that it rises from.
const float UPWARDS = 0.1;
const float DOWNWARDS = 4.0;

vec2 to_metres(vec2 at) {
    return (at - floor_middle) * picture_size;
}

// The source of the gas at a place [m].
vec4 source_at(vec2 place) {
    vec4 nearest = sources[0];
    float least = 1e9;
    for (int i = 0; i < MAX_SOURCES; i++) {
        if (float(i) >= source_count) break;
        vec2 from = place - sources[i].xy;
        float away = length(vec2(max(abs(from.x) - 0.5 * sources[i].z, 0.0), max(-DOWNWARDS * from.y, UPWARDS * from.y)));
        if (away < least) {
            least = away;
            nearest = sources[i];
        }
    }
    return nearest;
}

// Height above the floor in heights of the domain.
float domain_height(vec2 at) {
    return (at.y - floor_middle.y) * zoom;
}

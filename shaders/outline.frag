// The outline of a solid: a pale line on a dark one, visible on every colour.
#include "distance.glsl"

out vec4 pixel;

const float LINE = 1.0; // half of its width [pixels]
const float DARK = 2.0; // half of the width of the dark line
const vec2 OPACITY = vec2(0.9, 0.5); // of both

void main() {
    float away = abs(surface(local, node).z) / pixel_size;
    vec2 inside = clamp(vec2(LINE, DARK) + 0.5 - away, 0.0, 1.0) * OPACITY;
    pixel = vec4(inside.xxx, max(inside.x, inside.y));
}

// A particle as a disc in the colour of its measured quantity.
#include "scale.glsl"

in vec2 corner;
flat in vec4 payload; // opacity, and its product with the share of the span

uniform float pixels; // per radius

out vec4 pixel;

void main() {
    float inside = clamp((1.0 - length(corner)) * pixels + 0.5, 0.0, 1.0);
    pixel = vec4(scale_colour(payload.y / max(payload.x, 1e-3)), 1.0) * (inside * payload.x);
}

// The quad of a solid.
#include "solid.glsl"

out vec2 uv;        // 0–1 over the picture
flat out vec3 turn; // direction of its width; a number that differs between solids

void main() {
    turn = vec3(this_solid().velocity, float(gl_VertexID / 6) * 0.37);
    uv = gl_Position.xy * 0.5 + 0.5;
}

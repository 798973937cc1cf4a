// How far the gas has carried each of two noise patterns since that pattern began:
// the offset where the gas was in the last picture, and the way since.

in vec2 uv;

uniform sampler2D flow;           // weight, weight × velocity
uniform sampler2D carried_before; // this pass's output, one picture earlier
uniform vec2 step_time; // time since then by the size of the picture [s/m]
uniform vec2 kept;      // of each pattern: 1, or 0 where it begins in this picture

out vec4 carried; // in pictures: of one pattern, of the other

const float THIN = 0.1; // weight below which gas carries less: its velocity is a rim's, not a flame's

void main() {
    vec4 gas = texture(flow, uv);
    vec2 way = gas.yz / max(gas.x, THIN) * step_time;
    carried = texture(carried_before, uv - way) * kept.xxyy + way.xyxy;
}

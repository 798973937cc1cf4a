// How far the gas has carried each of two patterns of noise since that began:
// from where the gas was before, and the way since then.

in vec2 uv;

uniform sampler2D flow;   // weight, weight × velocity
uniform sampler2D before; // the same as the output, one picture earlier
uniform vec4 carried; // time since then as 1 / m: across, up; what is kept of each pattern

out vec4 drift; // in pictures: of one pattern, of the other

void main() {
    vec4 gas = texture(flow, uv);
    vec2 way = gas.yz / max(gas.x, 0.1) * carried.xy;
    drift = texture(before, uv - way) * carried.zzww + way.xyxy;
}

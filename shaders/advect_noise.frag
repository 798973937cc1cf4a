// Noise advection: the offset of each of two patterns since its start. It is the offset at the
// gas's position at the last sample, whose picture may show another part of the world, plus the
// displacement since then.

in vec2 uv;

uniform sampler2D flow;           // weight, weight × velocity
uniform sampler2D advected_noise_before; // the output of this pass at the last sample
uniform vec2 per_metre; // 1 / size of the picture [1/m]
uniform float elapsed;  // time since that sample [s]
uniform vec2 seconds;   // time for which each pattern moves, at its start for longer than since that sample [s]
uniform vec2 before_scale;  // from a position in this picture to that in the last one: the factor
uniform vec2 before_offset; // and the offset of that position
uniform vec2 kept;      // of each pattern: 0 if it restarts, else 1

out vec4 noise_offsets; // in sizes of the picture: first pattern, second pattern

const float THIN = 0.1; // weight below which gas advects less: the rim of a flame has no definite velocity

void main() {
    vec4 gas = texture(flow, uv);
    vec2 speed = gas.yz / max(gas.x, THIN) * per_metre;
    vec2 place = (uv - speed * elapsed) * before_scale + before_offset;
    noise_offsets = texture(advected_noise_before, place) * kept.xxyy / before_scale.xyxy + speed.xyxy * seconds.xxyy;
}

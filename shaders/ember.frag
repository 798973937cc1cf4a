// The light of one ember.

in vec2 corner;
flat in vec4 heat;

uniform sampler2D black_body; // chroma, ln luminance, by temperature
uniform vec4 table; // kK to table coordinate: scale, offset

out vec4 light; // as of the flame: square root of light / range; coverage

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    vec4 body = texture(black_body, vec2(heat.x * table.x + table.y, 0.5));
    vec3 emitted = body.rgb * exp(heat.y * body.a) * (heat.z * inside * inside);
    light = vec4(sqrt(emitted * heat.w), 0.6 * inside * min(heat.z, 1.0));
}

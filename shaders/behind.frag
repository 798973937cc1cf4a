// The light of the slices behind the front one.

in vec2 uv;

uniform sampler2D behind;

out vec4 light; // linear; coverage

void main() {
    light = texture(behind, uv);
}

// Shrinks the light to a quarter of its width.

in vec2 uv;

uniform sampler2D source;
uniform vec4 texel; // size of a texel of the source

out vec4 blurred;

vec3 at(float x, float y) {
    vec3 root = texture(source, uv + vec2(x, y) * texel.xy).rgb;
    return root * root;
}

void main() {
    blurred = vec4(sqrt(0.25 * (at(-1.0, -1.0) + at(1.0, -1.0) + at(-1.0, 1.0) + at(1.0, 1.0))), 1.0);
}

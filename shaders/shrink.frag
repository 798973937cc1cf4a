// Shrinks the light, however much larger it is.

in vec2 uv;

uniform sampler2D source;
uniform vec4 texel; // size of a texel of the smaller copy

out vec4 blurred;

void main() {
    vec3 sum = vec3(0.0);
    for (float y = -1.5; y < 2.0; y += 1.0) {
        for (float x = -1.5; x < 2.0; x += 1.0) {
            vec3 root = texture(source, uv + vec2(x, y) * 0.4 * texel.xy).rgb;
            sum += root * root;
        }
    }
    blurred = vec4(sqrt(sum / 16.0), 1.0);
}

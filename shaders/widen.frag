// Doubles a blurred copy and joins it with the next sharper one.

in vec2 uv;

uniform sampler2D wide;
uniform sampler2D narrow;
uniform vec4 texel; // size of a texel of the wide one, share of the narrow one

out vec4 blurred;

vec3 at(float x, float y) {
    vec3 root = texture(wide, uv + vec2(x, y) * texel.xy).rgb;
    return root * root;
}

void main() {
    vec3 sum = at(-1.0, 0.0) + at(1.0, 0.0) + at(0.0, -1.0) + at(0.0, 1.0)
             + 2.0 * (at(-0.5, -0.5) + at(0.5, -0.5) + at(-0.5, 0.5) + at(0.5, 0.5));
    vec3 root = texture(narrow, uv).rgb;
    blurred = vec4(sqrt(mix(sum / 12.0, root * root, texel.z)), 1.0);
}

// Downsamples the light and coverage, or a copy, to the next blurred copy.

in vec2 uv;

uniform sampler2D sharper; // the light, or the next sharper copy
uniform vec2 texel;        // size of a texel of the smaller copy
uniform float rooted;      // 1: it is a square root; 0: it is linear

out vec4 blur;

const float STEP = 0.4; // distance of 4 × 4 reads in texels; they span 1.6 texels, so neighbours overlap

void main() {
    vec4 sum = vec4(0.0);
    for (float y = -1.5; y < 2.0; y += 1.0) {
        for (float x = -1.5; x < 2.0; x += 1.0) {
            vec4 read = texture(sharper, uv + vec2(x, y) * STEP * texel);
            sum += vec4(rooted > 0.0 ? read.rgb * read.rgb : read.rgb, read.a);
        }
    }
    blur = vec4(sqrt(sum.rgb / 16.0), sum.a / 16.0);
}

// Upsamples a blurred copy and blends it with the next sharper one.

in vec2 uv;

uniform sampler2D wider; // the blurred copy
uniform sampler2D blur;  // the next sharper one
uniform vec2 texel;      // size of a texel of the wider one
uniform float share;     // of the sharper one

out vec4 glow;

vec4 at(float x, float y) {
    vec4 copy = texture(wider, uv + vec2(x, y) * texel);
    return vec4(copy.rgb * copy.rgb, copy.a);
}

// Eight reads of a tent filter without its middle; the weights sum to 12.
void main() {
    vec4 sum = at(-1.0, 0.0) + at(1.0, 0.0) + at(0.0, -1.0) + at(0.0, 1.0)
             + 2.0 * (at(-0.5, -0.5) + at(0.5, -0.5) + at(-0.5, 0.5) + at(0.5, 0.5));
    vec4 copy = texture(blur, uv);
    glow = mix(sum / 12.0, vec4(copy.rgb * copy.rgb, copy.a), share);
    glow.rgb = sqrt(glow.rgb);
}

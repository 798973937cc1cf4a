// Light and glow to colours that a screen shows, with premultiplied alpha.

in vec2 uv;

uniform sampler2D light;
uniform sampler2D glow;
uniform vec4 strength; // light range, bloom × light range, light on soot, that of the glow on it
uniform vec4 pale; // what light that is far too bright pales to, and how

out vec4 shown;

void main() {
    vec4 sharp = texture(light, uv);
    vec3 soft = texture(glow, uv).rgb;
    if (max(max(sharp.a, sharp.r), soft.r) < 0.004) {
        shown = vec4(0.0);
        return;
    }
    vec3 sum = sharp.rgb * sharp.rgb * strength.x + soft * soft * (strength.y * (1.0 + strength.w * sharp.a));
    vec3 colour = encode(tone_map(sum, pale));
    // Glow has no body of its own, yet no colour may exceed its alpha. What
    // covers without shining is soot, and never quite black.
    float peak = max(colour.r, max(colour.g, colour.b));
    float alpha = clamp(sharp.a, peak, 1.0);
    float dark = alpha - peak;
    colour += vec3(0.36, 0.33, 0.31) * (strength.z * dark * dark / max(alpha, 1e-4));
    shown = dither(vec4(colour, alpha));
}

// The finished fire in front of its backdrop, which it lights, and which shimmers
// behind hot gas.

in vec2 uv;

uniform sampler2D fire;
uniform sampler2D scenery; // square root of colour
uniform sampler2D lamp;    // square root of the fire's light / range
uniform sampler2D field;   // weight, weight × kK
uniform sampler2D noise;   // a tile; 0.5 is zero
uniform vec4 haze;  // tiles across and up the picture, tiles risen, how far it bends, of the height
uniform vec4 part;  // used part of the field target, largest coordinate in it
uniform vec4 range; // what the target's range took of weight and heat; light range

out vec4 pixel;

void main() {
    vec2 gas = texture(field, min(uv * part.xy, part.zw)).xy * range.xy;
    float hot = smoothstep(0.35, 1.1, gas.y / max(gas.x, 0.05)) * min(1.5 * gas.x, 1.0);
    vec2 tile = uv * haze.xy - vec2(0.0, haze.z);
    vec4 wave = textureLod(noise, tile, 0.0) + 0.5 * textureLod(noise, tile * 2.0 + 0.3, 0.0).wzyx - 0.75;
    vec2 bent = wave.xy * hot * haze.w * vec2(haze.y / haze.x, 1.0);
    vec3 behind = texture(scenery, uv + bent).rgb;
    vec3 root = texture(lamp, uv).rgb;
    vec3 seen = behind * behind * (root * root * range.z * 30.0 + vec3(0.035, 0.04, 0.055));
    vec4 shown = texture(fire, uv);
    pixel = dither(vec4(shown.rgb + encode(seen / (1.0 + 0.6 * seen)) * (1.0 - shown.a), 1.0));
}

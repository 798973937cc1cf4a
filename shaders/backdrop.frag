// The finished fire in front of its backdrop, which it lights, and which shimmers
// behind hot gas.

in vec2 uv;

uniform sampler2D fire;
uniform sampler2D scenery; // square root of colour; share of floor
uniform sampler2D lamp;    // square root of the fire's light / range
uniform sampler2D field;   // weight, weight × kK
uniform sampler2D noise;   // a tile; 0.5 is zero
uniform vec4 haze;  // tiles across and up the picture, tiles risen, how far it bends, of the height
uniform vec4 part;  // used part of the field target, largest coordinate in it
uniform vec4 range; // what the target's range took of weight and heat; light range

out vec4 pixel;

// How high in the picture the light is that falls on the floor.
const float FLOOR_SEES = 0.2;
// How much more light falls on the floor than on the wall.
const float FLOOR_GAIN = 1.3;

void main() {
    vec2 gas = texture(field, min(uv * part.xy, part.zw)).xy * range.xy;
    float hot = smoothstep(0.35, 1.1, gas.y / max(gas.x, 0.05)) * min(1.5 * gas.x, 1.0);
    vec2 tile = uv * haze.xy - vec2(0.0, haze.z);
    vec4 wave = textureLod(noise, tile, 0.0) + 0.5 * textureLod(noise, tile * 2.0 + 0.3, 0.0).wzyx - 0.75;
    vec2 bent = wave.xy * hot * haze.w * vec2(haze.y / haze.x, 1.0);
    vec4 behind = texture(scenery, uv + bent);
    // The floor lies right below the flame and faces it: a pool of light.
    vec3 root = texture(lamp, vec2(uv.x, mix(uv.y, FLOOR_SEES, behind.a))).rgb;
    float pool = mix(1.0, FLOOR_GAIN, behind.a);
    vec3 seen = behind.rgb * behind.rgb * (root * root * range.z * 30.0 * pool + vec3(0.035, 0.04, 0.055));
    vec4 shown = texture(fire, uv);
    pixel = dither(vec4(shown.rgb + encode(seen / (1.0 + 0.6 * seen)) * (1.0 - shown.a), 1.0));
}

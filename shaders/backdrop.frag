// The finished fire in front of its backdrop, which it lights, and which shimmers behind hot gas.
#include "field.glsl"
#include "colour.glsl"

in vec2 uv;

uniform sampler2D shown;
uniform sampler2D scenery;    // square root of colour; share of floor
uniform sampler2D irradiance; // square root of the fire's light / range
uniform sampler2D noise;      // a tile; 0.5 is zero
uniform vec2 haze_tiles;   // noise tiles across and up the picture
uniform float haze_risen;  // tiles
uniform float haze_bend;   // how far hot gas bends the view, in heights of the picture
uniform vec2 weight_range; // what the field target's range took of weight and weight × kK
uniform float light_range; // largest radiance that targets hold

out vec4 pixel;

// Gas bends the view from the first temperature on, most at the second [kK].
const float WARM = 0.35;
const float HOT = 1.1;
const float THIN = 0.05;      // weight below which the temperature is uncertain
const float DENSE = 1.5;      // 1 / weight that bends in full
const float FLOOR_SEES = 0.2; // height in the picture of the light that falls on the floor
const float FLOOR_GAIN = 1.3; // light on the floor, which faces the flame, beside that on the wall
const float LIT = 30.0;       // brightness of the fire's light on the backdrop
const vec3 NIGHT = vec3(0.035, 0.04, 0.055); // light without the fire, bluish
const float SHOULDER = 0.6;   // compression of the lit backdrop

void main() {
    vec2 gas = field_at(uv).xy * weight_range;
    float hot = smoothstep(WARM, HOT, gas.y / max(gas.x, THIN)) * min(DENSE * gas.x, 1.0);
    vec2 tile = uv * haze_tiles - vec2(0.0, haze_risen);
    // Two octaves; the offset keeps them apart, and 0.75 is their mean.
    vec4 wave = textureLod(noise, tile, 0.0) + 0.5 * textureLod(noise, tile * 2.0 + 0.3, 0.0).wzyx - 0.75;
    vec2 bent = wave.xy * hot * haze_bend * vec2(haze_tiles.y / haze_tiles.x, 1.0);
    vec4 behind = texture(scenery, uv + bent);
    // The floor lies right below the flame and faces it: a pool of light.
    vec3 root = texture(irradiance, vec2(uv.x, mix(uv.y, FLOOR_SEES, behind.a))).rgb;
    float pool = mix(1.0, FLOOR_GAIN, behind.a);
    vec3 seen = behind.rgb * behind.rgb * (root * root * light_range * LIT * pool + NIGHT);
    vec4 fire = texture(shown, uv);
    pixel = dither(vec4(fire.rgb + encode(seen / (1.0 + SHOULDER * seen)) * (1.0 - fire.a), 1.0));
}

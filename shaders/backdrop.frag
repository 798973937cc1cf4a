// The displayed fire in front of its backdrop, which it illuminates and makes shimmer.
#include "field.glsl"
#include "colour.glsl"

in vec2 uv;

uniform sampler2D shown;
uniform sampler2D scenery;    // square root of colour; share of ground
uniform sampler2D irradiance; // square root of 16 irradiance / range
uniform sampler2D noise;      // a tile; 0.5 is zero
uniform vec2 haze_tiles;   // noise tiles across and up the picture
uniform float haze_risen;  // tiles
uniform float haze_bend;   // displacement of the view behind hot gas, in heights of the picture
uniform vec2 weight_range; // range of weight and weight × kK in the field
uniform float light_range; // maximum radiance in targets
uniform float wall;        // 1 if there is a wall, or 0
uniform vec4 background;   // premultiplied
uniform vec3 sky;          // light of the background
uniform float page;        // share of the page that is seen through the ground
uniform vec2 foot;         // foot of the fire, 0–1 over the picture
uniform vec2 size;         // of the picture, in heights of the domain
uniform float soot;        // coverage of the wall above the fire by soot

out vec4 pixel;

// Displacement starts at the first temperature and is complete at the second [kK].
const float WARM = 0.35;
const float HOT = 1.1;
const float THIN = 0.05;      // weight below which the temperature is uncertain
const float DENSE = 1.5;      // 1 / weight of complete displacement
// The share of ground at which it is whole by day, and the light of the sky of a day.
const float DAY_HORIZON = 0.15;
const float DAY = 0.2;
const float FLOOR_LIGHT = 0.2; // height in the picture of the light that reaches the ground
const float FLOOR_GAIN = 2.2; // light on the ground, which faces the flame, relative to the wall
// Distance before and behind the fire at which the ground gets half of it, as it is seen, in heights of the domain.
const float FLOOR_DEPTH = 0.14;
// On a page: the distance beside the fire, in heights of the domain.
const float PAGE_REACH = 0.26;
// On a page: share of the ground's own colours besides a mean one; share of the adapted hue; displayed light of which
// a half is drawn, since dim light reddens a white page; and where it ends at the edges of the picture.
const float OWN = 0.4;
const vec3 MEAN_GROUND = vec3(0.28);
const float ADAPTED = 0.5;
const float PAGE_DIM = 0.25;
const float EDGE = 0.1;
// Soot on the wall: a plume from the foot, whose width grows upwards and which begins above it.
const float PLUME_WIDTH = 0.12;
const float PLUME_GROWTH = 0.22;
const float PLUME_BEGIN = 0.1;
const float PLUME_END = 0.6;
const float LIT = 30.0 / 16.0; // brightness of the irradiance
const vec3 NIGHT = vec3(0.035, 0.04, 0.055); // bluish light without the fire
const float SHOULDER = 0.6;   // compression of the lit backdrop
const float APART = 0.3;      // offset in the tile that decorrelates two octaves of the noise
const float MEAN = 0.75;      // of their sum

void main() {
    vec2 gas = field_at(uv).xy * weight_range;
    float hot = smoothstep(WARM, HOT, gas.y / max(gas.x, THIN)) * min(DENSE * gas.x, 1.0);
    vec2 tile = uv * haze_tiles - vec2(0.0, haze_risen);
    vec4 wave = textureLod(noise, tile, 0.0) + 0.5 * textureLod(noise, tile * 2.0 + APART, 0.0).wzyx - MEAN;
    vec2 bent = wave.xy * hot * haze_bend * vec2(haze_tiles.y / haze_tiles.x, 1.0);
    vec4 behind = texture(scenery, uv + bent);
    // By day the ground begins at once; by night it is seen as far as the fire lights it.
    behind.a = mix(behind.a, smoothstep(0.0, DAY_HORIZON, behind.a), smoothstep(0.0, DAY, sky.b));
    // The ground below the flame faces it and shows a pool of light.
    vec3 root = texture(irradiance, vec2(uv.x, mix(uv.y, FLOOR_LIGHT, behind.a))).rgb;
    vec2 from = (uv - foot) * size;
    float depth = from.y / FLOOR_DEPTH;
    float aside = from.x / PAGE_REACH;
    float far = (1.0 + page) * depth * depth + page * aside * aside * aside * aside;
    float pool = mix(1.0, FLOOR_GAIN / (1.0 + far), behind.a);
    float across = from.x / (PLUME_WIDTH + PLUME_GROWTH * max(from.y, 0.0));
    float stain = soot * (1.0 - behind.a) * smoothstep(PLUME_BEGIN, PLUME_END, from.y) * exp(-across * across);
    vec3 albedo = behind.rgb * behind.rgb * (1.0 - stain);
    albedo = mix(albedo, mix(MEAN_GROUND, albedo, OWN), page);
    // Without a wall, only the ground is there; over a transparent page, only its light.
    float there = max(wall, behind.a);
    float cover = max(wall, behind.a * background.a);
    vec3 seen = albedo * (root * root * (light_range * LIT * pool * there) + (NIGHT + sky) * cover);
    vec4 fire = texture(shown, uv);
    vec3 lit = encode(seen / (1.0 + SHOULDER * seen));
    // Light covers as much of a page as it adds.
    float peak = max(lit.r, max(lit.g, lit.b));
    vec2 inside = clamp((0.5 - abs(uv - 0.5)) / EDGE, 0.0, 1.0);
    lit = mix(lit, adapted(lit, peak, ADAPTED * (1.0 - peak) * (1.0 - peak)) * (inside.x * inside.y * peak / (peak + PAGE_DIM)), page);
    cover = max(cover, max(lit.r, max(lit.g, lit.b)));
    vec4 whole = vec4(lit, cover) + background * (1.0 - cover);
    // Displayed colours are about roots of light. Flame adds its light to that of a wall, and hides only what it covers
    // beyond that.
    float shine = max(fire.r, max(fire.g, fire.b));
    vec3 seen_through = whole.rgb * (1.0 - fire.a + shine * (1.0 - shine));
    vec3 added = min(sqrt(fire.rgb * fire.rgb + seen_through * seen_through), 1.0);
    pixel = dither(mix(fire + whole * (1.0 - fire.a), vec4(added, 1.0), wall));
}

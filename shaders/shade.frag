// Shades the field of the classic model: rising noise warps and erodes it, it glows as a black body,
// and smoke hides it.
#include "field.glsl"
#include "noise.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "world.glsl"

in vec2 uv;

uniform sampler2D wide;         // the blurred field
uniform vec4 field_range;       // range of weight, weight × kK, × glow, × smoke in the field
uniform float per_flame_height; // [1/m]
uniform float tiles;            // noise tiles per metre
uniform float risen;            // rise of the gas in tiles
uniform float warp;             // displacement of the gas by fine structure [m]
uniform float detail;           // amount of fine structure
uniform float air;              // temperature of the air [kK]
uniform float smoke;            // optical depth of smoke per weight
uniform float gain; // brightness of gas of 1500 K
uniform float fire_share;       // 1: fire is visible; 0: only its smoke
uniform float soft_top;         // 1: gas fades below the top of the domain

out vec4 light; // encoded; coverage

const float INVISIBLE = 0.004;   // blurred weight without a visible effect
const float OPTICAL_DEPTH = 2.6; // of the glow in the middle of one kernel
const float AIR = 0.6;           // weight of the air that cools thin gas, in kernels
const float GROWN = 0.6;         // height of full displacement, in flame heights
const float FOOT = 0.3;          // share of that displacement at the source
const float BASE = 0.2;          // height of the base, in flame heights
// Factors on coordinates in tiles. Rust computes `risen` modulo 100 tiles, so 100 × BROAD and
// 100 × FINE are whole.
const float BROAD = 0.62;
const float FINE = 1.05;
const float FINE_ACROSS = 2.1;
const float CHAOS = 0.06;        // displacement of the fine noise by the broad noise, in tiles
// Glow starts at the first temperature, is complete at the second, and opaque at the third [kK].
const float DARK = 0.7;
const float GLOWING = 1.1;
const float OPAQUE = 1.05;
// Gas fades between these heights if the top of the domain is visible, in heights of the domain.
const float LEAVING = 0.75;
const float GONE = 0.98;
const float UPWARD = 1.4;        // upward displacement relative to that across
// Shares of broad and fine noise in the grain.
const float BROAD_GRAIN = 0.9;
const float FINE_GRAIN = 0.7;
// Erosion: its mean and maximum in units of grain, its amount at the source, its increase with
// height, and its share at the base, which would otherwise show a line and two corners.
const float EROSION_MEAN = 0.45;
const float MAX_EROSION = 1.6;
const float ERODED = 0.16;
const float ERODED_ABOVE = 0.45;
const float ERODED_BASE = 0.6;
// Thin gas at the base is invisible: rate of its loss below a depth.
const float THIN_LOSS = 4.0;
const float THIN = 0.6;
const float DIMMED = 0.3;        // share of the glow that full erosion dims
// The base of the flame is higher at its rim than in its middle, by this share of the squared
// distance in half source widths. Noise roughens it, and the flame thins over a range of heights.
const float BOWL = 0.8;
const float MAX_RIM = 1.5;
const float RAGGED_BASE = 0.25;
const float BASE_FROM = 0.35;    // below the base
const float BASE_TO = 0.4;
// Air cools thin gas to at least this share of its temperature, and half way at this glow.
const float COOLED = 0.5;
const float HALF_COOLED = 0.08;
const float GRAIN_COOLING = 0.24; // [kK]
const float DENSE = 2.5;         // 1 / depth of opaque gas
// Brightness of thin gas, and its increase with depth.
const float THIN_LIGHT = 0.25;
const float DENSE_LIGHT = 0.75;
const float ABSORBED = 0.5;     // share of the hidden light that smoke absorbs; it scatters the rest

void main() {
    vec4 around = texture(wide, uv) * field_range;
    if (around.x < INVISIBLE) {
        light = vec4(0.0);
        return;
    }
    vec2 place = to_metres(uv);
    vec4 source = source_at(place);
    float above = max(place.y - source.y, 0.0) * per_flame_height;
    vec2 tile = place * tiles;

    // Broad noise displaces the gas, more at greater heights.
    vec4 broad = noise_at(vec2(tile.x, (tile.y - risen) * BROAD), 0.0);
    float growth = smoothstep(0.0, GROWN, above);
    vec2 moved = broad.xy * vec2(1.0, UPWARD) * warp * (FOOT + growth) / picture_size;
    vec4 gas = field_at(uv + moved) * field_range;

    // Fine noise erodes the glow to tongues with dark gaps.
    vec4 fine = noise_at(vec2(tile.x * FINE_ACROSS, (tile.y - risen) * FINE) + broad.yx * CHAOS, 0.0);
    float grain = BROAD_GRAIN * broad.z + FINE_GRAIN * fine.w;
    float eroded = clamp(EROSION_MEAN + grain, 0.0, MAX_EROSION) * detail;
    float depth = around.z / (around.z + AIR);
    float base = 1.0 - smoothstep(0.0, BASE, above);
    float left = gas.z - eroded * (ERODED + ERODED_ABOVE * max(growth, ERODED_BASE * base))
               - THIN_LOSS * base * max(THIN - depth, 0.0);
    left = max(left, 0.0) * (1.0 - DIMMED * min(eroded, 1.0));

    float per_half_source = 2.0 / source.z;
    float rim = min(abs(place.x - source.x) * per_half_source, MAX_RIM);
    float over = abs(place.y - source.y) * per_half_source - BOWL * rim * rim + RAGGED_BASE * grain * min(detail, 1.0);
    left *= max(smoothstep(-BASE_FROM, BASE_TO, over), source.w);

    // Dense flame is bright; air mixes into thin flame and cools it.
    float hot = around.y / around.x;
    float kilokelvin = mix(max(air, COOLED * hot), hot, depth * left / (left + HALF_COOLED)) - GRAIN_COOLING * grain * detail;

    float covered = (1.0 - exp(-OPTICAL_DEPTH * left * depth)) * smoothstep(DARK, GLOWING, kilokelvin) * fire_share;
    float opaque = covered * smoothstep(DARK, OPAQUE, kilokelvin) * min(DENSE * depth, 1.0);
    float hidden = 1.0 - exp(-smoke * around.w);
    vec3 emitted = radiance(kilokelvin, GAS_ROW) * (gain * depth * (THIN_LIGHT + DENSE_LIGHT * depth) * covered);
    opaque *= opacity_of(emitted);
    vec3 sum = emitted * (1.0 - ABSORBED * hidden);
    float soft = 1.0 - soft_top * smoothstep(LEAVING, GONE, domain_height(uv));
    light = vec4(encode_light(sum), 1.0 - (1.0 - opaque) * (1.0 - hidden)) * soft;
}

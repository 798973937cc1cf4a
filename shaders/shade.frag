// The classic model's field to light: warped and eroded by rising noise, glowing as a black
// body, hidden by its own smoke.
#include "field.glsl"
#include "noise.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "world.glsl"

in vec2 uv;

uniform sampler2D wide;         // the field as seen from farther away
uniform vec4 field_range;       // what the target's range took of weight, weight × kK, × glow, × smoke
uniform float per_flame_height; // [1/m]
uniform float per_half_source;  // 1 / half the source's width [1/m]
uniform float tiles;            // noise tiles per metre
uniform float risen;            // tiles that the gas has risen
uniform float warp;             // how far fine structure moves the gas [m]
uniform float detail;           // how much fine structure there is
uniform float air;              // temperature of the air [kK]
uniform float smoke;            // optical depth of smoke per weight
uniform float gain; // brightness of gas of 1500 K
uniform float fire_share;       // 1: fire is seen; 0: only its smoke
uniform float soft_top;         // 1: gas fades below the top of the domain

out vec4 light; // encoded; coverage

const float UNSEEN = 0.004;      // weight around that leaves no trace
const float OPTICAL_DEPTH = 2.6; // of the glow in the middle of one kernel
const float AIR = 0.6;           // weight of the air that cools thin gas, in kernels
const float GROWN = 0.6;         // flame heights at which noise moves gas in full
const float FOOT = 0.3;          // share of that motion at the source
const float BASE = 0.2;          // flame heights that count as its base
// Tiles are read at these factors of place and speed. Rust drops whole hundreds of tiles from
// `risen`, so both factors times 100 are whole.
const float BROAD = 0.62;
const float FINE = 1.05;
const float FINE_ACROSS = 2.1;
const float CHAOS = 0.06;        // how far broad noise shifts the fine noise, in tiles
// Gas begins to glow at the first temperature, and covers in full at the second [kK].
const float DARK = 0.7;
const float GLOWING = 1.1;
const float OPAQUE = 1.05;
// Gas fades between these heights, in heights of the domain, where it is seen to leave.
const float LEAVING = 0.75;
const float GONE = 0.98;

void main() {
    vec4 around = texture(wide, uv) * field_range;
    if (around.x < UNSEEN) {
        light = vec4(0.0);
        return;
    }
    vec2 place = to_metres(uv);
    float above = max(place.y - source.y, 0.0) * per_flame_height;
    vec2 tile = place * tiles;

    // Broad noise has moved the gas, farther the higher it is, and more up than across.
    vec4 broad = noise_at(vec2(tile.x, (tile.y - risen) * BROAD), 0.0);
    float growth = smoothstep(0.0, GROWN, above);
    vec2 moved = broad.xy * vec2(1.0, 1.4) * warp * (FOOT + growth) / picture_size;
    vec4 gas = field_at(uv + moved) * field_range;

    // Tongues and dark gaps: finer noise erodes the glow, more of it higher up, and at the
    // base, which would end in a line and two corners otherwise.
    vec4 fine = noise_at(vec2(tile.x * FINE_ACROSS, (tile.y - risen) * FINE) + broad.yx * CHAOS, 0.0);
    float grain = 0.9 * broad.z + 0.7 * fine.w;
    float eroded = clamp(0.45 + grain, 0.0, 1.6) * detail;
    float depth = around.z / (around.z + AIR);
    float base = 1.0 - smoothstep(0.0, BASE, above);
    float left = gas.z - eroded * (0.16 + 0.45 * max(growth, 0.6 * base)) - 4.0 * base * max(0.6 - depth, 0.0);
    left = max(left, 0.0) * (1.0 - 0.3 * min(eroded, 1.0));

    // The flame stands on its source as in a bowl, whose rim is higher than its middle, and
    // thins towards it.
    float rim = min(abs(place.x - source.x) * per_half_source, 1.5);
    float over = abs(place.y - source.y) * per_half_source - 0.8 * rim * rim + 0.25 * grain * min(detail, 1.0);
    left *= smoothstep(-0.35, 0.4, over);

    // The thicker the flame around, the brighter; air has mixed in where it is thin, and
    // cools it.
    float hot = around.y / around.x;
    float kilokelvin = mix(max(air, 0.5 * hot), hot, depth * left / (left + 0.08)) - 0.24 * grain * detail;

    float covered = (1.0 - exp(-OPTICAL_DEPTH * left * depth)) * smoothstep(DARK, GLOWING, kilokelvin) * fire_share;
    float opaque = covered * smoothstep(DARK, OPAQUE, kilokelvin) * min(2.5 * depth, 1.0);
    float hidden = 1.0 - exp(-smoke * around.w);
    vec3 emitted = radiance(kilokelvin) * (gain * depth * (0.25 + 0.75 * depth) * covered);
    opaque *= opacity_of(emitted);
    // Smoke scatters half of the light that it takes.
    vec3 sum = emitted * (1.0 - 0.5 * hidden);
    float soft = 1.0 - soft_top * smoothstep(LEAVING, GONE, domain_height(uv));
    light = vec4(encode_light(sum), 1.0 - (1.0 - opaque) * (1.0 - hidden)) * soft;
}

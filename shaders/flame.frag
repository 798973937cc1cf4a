// Shades the field of the combustion model. Advected noise displaces and erodes the gas. Hot soot
// glows as a black body, cold soot is smoke.
#include "field.glsl"
#include "noise.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "world.glsl"

in vec2 uv;

uniform sampler2D noise_offsets; // offsets of two advected noise patterns, in sizes of the picture
uniform vec4 field_range;       // range of weight, weight × kK, × soot, × burning in the field
uniform float per_domain_width; // [1/m]
uniform float closed;           // 1: the domain ends at its edges; 0: open air
uniform float picture_height;   // before it is enlarged, in heights of the domain
uniform float picture_bottom;   // its lower edge above the floor, in heights of the domain
uniform vec2 tiles;             // noise tiles per metre
uniform float risen;            // rise of the patterns without advection, in tiles
uniform vec4 pattern_starts;    // offsets of the patterns in the tile
uniform vec2 pattern_shares;    // shares of the patterns
uniform float warp;             // displacement of the gas by fine structure [m]
uniform float detail;           // amount of fine structure
uniform float air;              // temperature of the air [kK]
uniform float depth;            // optical depth of the slice, that of a single one is 1
uniform float smoke;            // optical depth of cold gas with a soot of 1
uniform float gain; // brightness of gas of 1500 K
uniform float fire_share;       // 1: fire is visible; 0: only its smoke
uniform float lowest;           // height of the lowest source [m]
uniform float roundness;        // 0: a plane flame; 1: a flame that is round about its axis
uniform float kernel_variance;  // of the squared soot of a single particle [m²]
uniform float premixed;         // burn time of gas that was mixed with air [s]; 0: gas that forms soot
uniform float soot_per_fuel;    // soot that a share of fuel leaves
uniform float per_soft_floor;   // 1 / height over which gas fades above a visible floor, in heights of the domain

out vec4 light; // encoded; coverage

const float OPTICAL_DEPTH = 3.0; // of gas with a soot of 1
// Undisplaced soot below which nothing is visible, and from which gas is fully visible: noise
// does not displace gas to where there is none.
const float INVISIBLE = 0.003;
const float VISIBLE = 0.03;
// Noise is read half a level coarser than the level whose texels have the size of the picture's.
// NOISE_LEVELS comes from build/values.rs.
const float LEVEL_BIAS = 0.5;
const float GROWN = 0.8;         // height of full displacement above the source, in source widths
const float FOOT = 0.35;         // share of that displacement at the source
const float FULL = 1.25;         // 1 / weight of gas without air
// A closed domain is periodic in x: gas fades between these distances from its middle, in widths of the
// domain,
const float SIDE = 0.36;
const float SIDE_END = 0.48;
// and between these heights below the top of the domain or of the picture.
const float TOP = 0.72;
const float TOP_END = 0.96;
// Glow starts at the first temperature and is complete at the second [kK].
const float DARK = 0.9;
const float GLOWING = 1.35;
// The mean of gas below this temperature is of thin hot sheets and cold gas, and the sheets shine [kK].
const float SHEETS = 1.6;
const float SHEET_SHARE = 0.65;
const float ROUND_SHARE = 0.2;   // of a round flame, whose temperature is about that of its sheet
// Thin sheets burn out before they have cooled: soot that is gone from gas at the lower temperature and none at the upper [kK].
const float BURNT_OUT = 0.2;
const float COOLED = 1.0;
const float BURNING = 1.5;
// Smoke forms where gas cools from the second to the first temperature [kK],
const float COLD = 0.5;
const float COOLING = 1.1;
// between these heights above the lowest source, in widths of the first: lower down, cool soot would draw a
// grey rim around the flame.
const float ALOFT = 0.2;
const float HIGH = 1.4;
const float ROUND_HIGH = 1.5;    // additional share for round flames, which are narrow
// Noise of the smoke: its levels above that of the flame, its displacement, and its contrast.
const float SMOKE_LEVEL = 1.5;
const float SMOKE_WARP = 0.8;
const float SMOKE_CONTRAST = 0.6;
const float FINE_SHARE = 0.4;    // displacement by the fine noise relative to the broad noise
// The base of the flame is higher at its rim than in its middle, by this share of the squared
// distance in half source widths, up to a maximum.
const float BOWL = 0.2;
const float MAX_BOWL = 2.0;
const float RAGGED_BASE = 0.24;  // amplitude of the noise in the height of the base, in source widths
const float BASE = 0.5;          // height over which the base thins, in source widths
const float BROAD_SHEETS = 0.7;  // share of the broad noise in the sheets
// Soot that noise erodes: its amount, and the mean, broad and fine part of the erosion.
const float ERODED = 0.13;
const float EROSION_MEAN = 0.5;
const float EROSION_BROAD = 0.7;
const float EROSION_FINE = 0.5;
const float SHEET_CONTRAST = 1.8; // exponent of the soot in sheets
const float SHEET_COOLING = 0.14; // [kK]

// The gas whose moments are the axis and radius of a round flame: samples, half their width, and their height,
// which averages the noise of single particles, in source widths; and the distance within which axes are one.
const int SAMPLES = 40;
const float HALF_WIDTH = 1.6;
const float AVERAGED = 1.0;
const float SAME = 0.1;
const float EDGE = 1.15;         // temperature at its edge [kK]
const float SOFT_EDGE = 0.25;    // softness of that edge, in squared radii
// Kernels spread the heat as they spread the soot: the loss in the middle of its excess over the edge for each share of their
// variance, and the least variance of the heat, which is uncertain at the tip, in squared source widths.
const float SPREAD = 1.5;
const float TIP = 0.03;
const float CORE = 0.85;         // radius of the fuel in its middle, in radii
const float THIN = 0.4;         // optical depth relative to that of a plane flame: a small flame is thin
// Time in which soot forms above the source, and mean time since the soot's fuel burnt in which the fuel in the middle
// burns [s].
const float FORMATION = 0.036;
const float BURNOUT = 0.12;
const float GRAVITY = 9.81;      // [m/s²]
const float ROOT = 0.2;          // height over which the flame begins, in source widths
const float CUP = 0.45;          // height of its root at the rim above that at the axis, in source widths
// Gas that was mixed with air burns without soot: shares of it that burn in the burn time at the end of the mantle, at the
// cone and in the unburnt middle of the cone, and the chord of that middle.
const float OXIDES = 0.004;
const float CONE = 0.015;
const float UNBURNT = 0.019;
const float CONE_CORE = 1.0;
// Light of the cone, mostly of C2*, and, for each share that burns, of the mantle, where carbon monoxide burns with a pale
// continuum.
const vec3 SWAN = vec3(0.06, 0.5, 1.8);
const vec3 MANTLE = vec3(1.2, 2.2, 8.7);
// Light of CH* (431 nm) and C2* (473, 516 nm) of gas that burns at 1/s.
const vec3 BLUE = vec3(0.03, 0.18, 1.0) * 0.1;

// Half the chord of a ball of radius 1 whose square is `squared` from the line of sight.
float half_chord(float squared) {
    return sqrt(max(squared, 0.0)) * smoothstep(0.0, SOFT_EDGE, squared);
}

// Reads both patterns, `finer` times as fine.
vec4 pattern(vec4 places, vec2 level, float finer) {
    level += log2(finer);
    return noise_at(places.xy * finer, level.x) * pattern_shares.x
         + noise_at(places.zw * finer, level.y) * pattern_shares.y;
}

void main() {
    light = vec4(0.0);
    vec2 place = to_metres(uv);
    vec4 offsets = texture(noise_offsets, uv) * picture_size.xyxy;
    vec4 places = (place.xyxy - offsets) * tiles.xyxy + pattern_starts - vec2(0.0, risen).xyxy;
    vec4 across = dFdx(places);
    vec4 along = dFdy(places);
    across = max(across * across, along * along);
    float around = field_at(uv).z * field_range.z;
    if (around < INVISIBLE && premixed == 0.0) return;
    vec2 level = 0.5 * log2(max(across.xz, across.yw)) + (NOISE_LEVELS + LEVEL_BIAS);
    vec4 broad = pattern(places, level, 1.0);
    vec4 fine = pattern(places, level, 2.0);
    vec4 source = source_at(place);
    float source_width = source.z;
    float on_solid = source.w;
    float above = (place.y - source.y) / source_width;

    float growth = smoothstep(0.0, GROWN, above);
    vec2 moved = (broad.xy + FINE_SHARE * fine.yx) * warp * (FOOT + growth);
    moved *= 1.0 - roundness;
    vec2 at = uv + moved / picture_size;
    vec4 gas = field_at(at) * field_range;
    float weight = max(gas.x, 1e-4);
    float share = min(FULL * weight, 1.0);
    float kilokelvin = mix(air, gas.y / weight, share);
    float up = domain_height(uv);
    float fade = smoothstep(INVISIBLE, VISIBLE, around)
               * (1.0 - closed * smoothstep(SIDE, SIDE_END, abs(place.x) * per_domain_width))
               * (1.0 - closed * smoothstep(TOP, TOP_END, max(up, (up - picture_bottom) / picture_height))) * clamp(up * per_soft_floor, 0.0, 1.0);
    float soot = gas.z / weight * share * fade;

    float rim = 2.0 * (place.x - source.x) / source_width;
    float base = smoothstep(0.0, BASE, above - BOWL * min(rim * rim, MAX_BOWL) + RAGGED_BASE * broad.w * min(detail, 1.0));
    base = max(base, on_solid);

    // Dark gaps and bright sheets.
    float sheet = fine.z + BROAD_SHEETS * broad.w;
    float left = max(soot - detail * ERODED * max(EROSION_MEAN + EROSION_BROAD * broad.z + EROSION_FINE * fine.w, 0.0), 0.0);
    left = max(left - BURNT_OUT * (1.0 - smoothstep(COOLED, BURNING, kilokelvin)), 0.0);
    left *= base * exp(-SHEET_CONTRAST * detail * sheet);
    kilokelvin -= SHEET_COOLING * detail * sheet;

    vec3 blue = vec3(0.0);
    if (premixed > 0.0) {
        // About an axis, gas that burns is normally distributed, so the logarithm of its share is a squared chord.
        float burns = premixed * gas.w / weight * share;
        float cone = half_chord(log(burns / CONE)) - CONE_CORE * half_chord(log(burns / UNBURNT));
        blue = SWAN * cone + MANTLE * min(burns, CONE) * half_chord(log(burns / OXIDES));
        left = 0.0;
    } else if (roundness > 0.0) {
        float of_kernels = kernel_variance / (source_width * source_width);
        // The gas as far as half the way to the next flame.
        float half_width = HALF_WIDTH;
        for (int i = 0; i < MAX_SOURCES; i++) {
            if (float(i) >= source_count) break;
            float apart = abs(sources[i].x - source.x) / source_width;
            if (apart > SAME) half_width = min(half_width, 0.5 * apart);
        }
        vec3 moments = vec3(0.0);
        vec4 sums = vec4(0.0);
        vec2 burning = vec2(0.0);
        for (int i = 0; i < SAMPLES; i++) {
            float across = half_width * ((float(i) + 0.5) * (2.0 / float(SAMPLES)) - 1.0);
            float higher = AVERAGED * (fract(float(i) * 0.618) - 0.5);
            vec2 there = vec2(source.x + across * source_width, place.y + higher * source_width);
            vec4 gas_there = field_at(there / picture_size + floor_middle) * field_range;
            float squared = gas_there.z * gas_there.z;
            moments += squared * vec3(1.0, across, across * across);
            sums += squared * squared * vec4(gas_there.yxz, 1.0);
            burning += gas_there.w * gas_there.zw;
        }
        float axis = moments.y / max(moments.x, 1e-6);
        // Without that of the kernels: a flame is as wide with few particles as with many.
        float variance = max(moments.z / max(moments.x, 1e-6) - axis * axis - of_kernels, 1e-4);
        float hottest = sums.x / max(sums.y, 1e-4);
        float soot_inside = sums.z / max(sums.w, 1e-6);
        float burns = burning.y / max(burning.x, 1e-6) * soot_inside;
        // Soot and heat are normally distributed about the axis.
        float edge = 4.0 * variance * log(max((hottest - air) / (EDGE - air), 1.00001));
        float away = (place.x + moved.x - source.x) / source_width - axis;
        float squared = away * away / edge;
        float age = (burning.x + 1e-3) / (soot_per_fuel * burning.y + 1e-4);
        // Hot gas rises by a t² / 2 with the buoyant acceleration a = g (T / air - 1).
        float formed = max(above, 0.0) * source_width / (0.5 * FORMATION * FORMATION * GRAVITY * max(hottest / air - 1.0, 0.1));
        formed = 1.0 - exp(-formed * formed * formed);
        float core = exp(-age * age / (BURNOUT * BURNOUT));
        float begun = max(smoothstep(-0.5 * ROOT, 0.5 * ROOT, above - CUP * squared), on_solid) * step(EDGE, hottest);
        float chord = (half_chord(1.0 - squared) - core * half_chord(CORE * CORE - squared)) * begun;
        left = mix(left, THIN * soot_inside * chord * formed, roundness);
        kilokelvin = mix(kilokelvin, EDGE + (hottest - EDGE) * (1.0 + SPREAD * of_kernels / max(variance, TIP)), roundness);
        blue = BLUE * (roundness * burns * chord * (1.0 - formed));
    }

    float glowing = smoothstep(DARK, GLOWING, kilokelvin) * fire_share;
    float covered = 1.0 - exp(-OPTICAL_DEPTH * depth * left);
    vec3 emitted = radiance(mix(kilokelvin, max(kilokelvin, SHEETS), mix(SHEET_SHARE, ROUND_SHARE, roundness)), GAS_ROW) * (gain * covered * glowing) + blue * (gain * fire_share);
    float aloft = smoke * smoothstep(ALOFT, HIGH, (place.y - lowest) / sources[0].z / (1.0 + ROUND_HIGH * roundness));
    float hidden = 0.0;
    if (aloft > 0.0) {
        // Smoke is softer than flame.
        vec4 soft = pattern(places, level + SMOKE_LEVEL, 1.0);
        vec4 cold = field_at(uv + soft.xy * (warp * SMOKE_WARP) / picture_size) * field_range;
        float there = min(FULL * cold.x, 1.0);
        float cold_soot = cold.z / max(cold.x, 1e-4) * there * fade;
        float smoke_kilokelvin = mix(air, cold.y / max(cold.x, 1e-4), there);
        hidden = 1.0 - exp(-aloft * cold_soot * exp(-SMOKE_CONTRAST * detail * soft.w) * (1.0 - smoothstep(COLD, COOLING, smoke_kilokelvin)));
    }
    // The brightness of a single slice decides what hides the background.
    float opaque = covered * glowing * opacity_of(emitted / depth);
    light = vec4(encode_light(emitted), 1.0 - (1.0 - opaque) * (1.0 - hidden));
}

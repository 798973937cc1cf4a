// The field of burning gas to light: noise that the gas carries moves and thins it; its soot
// glows as a black body and, once cold, is smoke.
#include "field.glsl"
#include "noise.glsl"
#include "palette.glsl"
#include "light.glsl"
#include "world.glsl"

in vec2 uv;

uniform sampler2D carried;      // how far, in pictures, the gas has carried two patterns
uniform vec4 field_range;       // what the target's range took of weight, weight × kK, × soot, × burning
uniform float source_width;     // [m]
uniform float per_domain_width; // [1/m]
uniform vec2 tiles;             // noise tiles per metre
uniform float risen;            // tiles that a pattern rises where gas cannot carry it
uniform vec4 pattern_starts;    // where in the tile each pattern began
uniform vec2 pattern_shares;    // how much of each is seen
uniform float warp;             // how far fine structure moves the gas [m]
uniform float detail;           // how much fine structure there is
uniform float air;              // temperature of the air [kK]
uniform float smoke;            // optical depth of cold gas with a soot of 1
uniform float gain; // brightness of gas of 1500 K
uniform float fire_share;       // 1: fire is seen; 0: only its smoke
uniform float per_soft_floor;   // 1 / heights of the domain in which gas ends at a floor that is seen

out vec4 light; // encoded; coverage

const float OPTICAL_DEPTH = 3.0; // of gas with a soot of 1
// Soot around that leaves no trace, and from which gas shows in full: noise does not carry gas
// to where none is.
const float UNSEEN = 0.003;
const float SEEN = 0.03;
// Noise is read from the level whose texels are as large as the picture's, and half a level
// coarser. NOISE_LEVELS comes from build/values.rs.
const float SHARPNESS = 0.5;
const float GROWN = 0.8;         // source widths above the source at which noise moves gas in full
const float FOOT = 0.35;         // share of that motion at the source
const float FULL = 1.25;         // 1 / weight at which no air is mixed in
// Gas that leaves the domain on one side comes back on the other: it fades between these
// distances from the middle, in widths of the domain,
const float SIDE = 0.36;
const float SIDE_END = 0.48;
// and between these heights below the top of the domain or of the picture.
const float TOP = 0.72;
const float TOP_END = 0.96;
// Gas begins to glow at the first temperature and glows in full at the second [kK].
const float DARK = 0.75;
const float GLOWING = 1.0;
// Smoke forms where gas cools from the second to the first temperature [kK],
const float COLD = 0.5;
const float COOLING = 1.1;
// between these heights above the source, in its widths: cool soot beside a flame would draw a
// grey rim.
const float ALOFT = 0.2;
const float HIGH = 1.4;

// What the gas has folded finer than texels is not seen.
vec4 pattern(vec4 places, vec2 level, float finer) {
    level += log2(finer);
    return noise_at(places.xy * finer, level.x) * pattern_shares.x
         + noise_at(places.zw * finer, level.y) * pattern_shares.y;
}

void main() {
    light = vec4(0.0);
    vec2 place = to_metres(uv);
    vec4 offsets = texture(carried, uv) * picture_size.xyxy;
    vec4 places = (place.xyxy - offsets) * tiles.xyxy + pattern_starts - vec2(0.0, risen).xyxy;
    vec4 across = dFdx(places);
    vec4 along = dFdy(places);
    across = max(across * across, along * along);
    float around = field_at(uv).z * field_range.z;
    if (around < UNSEEN) return;
    vec2 level = 0.5 * log2(max(across.xz, across.yw)) + (NOISE_LEVELS + SHARPNESS);
    vec4 broad = pattern(places, level, 1.0);
    vec4 fine = pattern(places, level, 2.0);
    float above = (place.y - source.y) / source_width;

    float growth = smoothstep(0.0, GROWN, above);
    vec2 moved = (broad.xy + 0.4 * fine.yx) * warp * (FOOT + growth);
    vec4 gas = field_at(uv + moved / picture_size) * field_range;
    float weight = max(gas.x, 1e-4);
    float share = min(FULL * weight, 1.0);
    float kilokelvin = mix(air, gas.y / weight, share);
    float up = domain_height(uv);
    float soot = gas.z / weight * share * smoothstep(UNSEEN, SEEN, around)
               * (1.0 - smoothstep(SIDE, SIDE_END, abs(place.x) * per_domain_width))
               * (1.0 - smoothstep(TOP, TOP_END, max(up, uv.y))) * clamp(up * per_soft_floor, 0.0, 1.0);

    // The flame stands on its source as in a bowl, whose rim is higher than its middle, and
    // thins towards it.
    float rim = 2.0 * (place.x - source.x) / source_width;
    float base = smoothstep(0.0, 0.5, above - 0.2 * min(rim * rim, 2.0) + 0.24 * broad.w * min(detail, 1.0));

    // Dark gaps and bright sheets.
    float sheet = fine.z + 0.7 * broad.w;
    float left = max(soot - detail * 0.13 * max(0.5 + 0.7 * broad.z + 0.5 * fine.w, 0.0), 0.0);
    left *= base * exp(-1.8 * detail * sheet);
    kilokelvin -= 0.14 * detail * sheet;

    float glowing = smoothstep(DARK, GLOWING, kilokelvin) * fire_share;
    float covered = 1.0 - exp(-OPTICAL_DEPTH * left);
    vec3 emitted = radiance(kilokelvin) * (gain * covered * glowing);
    float aloft = smoothstep(ALOFT, HIGH, above);
    float hidden = 1.0 - exp(-smoke * soot * aloft * (1.0 - smoothstep(COLD, COOLING, kilokelvin)));
    // Thin bright flame hides more than it shines.
    float opaque = covered * (2.0 - covered) * glowing * opacity_of(emitted);
    light = vec4(encode_light(emitted), 1.0 - (1.0 - opaque) * (1.0 - hidden));
}

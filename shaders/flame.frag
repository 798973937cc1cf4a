// From fields of burning gas to light: the gas is moved and thinned by noise
// that it carries along, its soot glows as a black body and, once cold, is smoke.

in vec2 uv;

uniform sampler2D field;      // weight, weight × kK, weight × soot, weight × burning
uniform sampler2D drift;      // how far, in pictures, the gas has carried two patterns
uniform sampler2D noise;      // a tile; 0.5 is zero
uniform sampler2D black_body; // chroma, ln luminance, by temperature
uniform vec4 view;   // width, height [m], height of the source [m], its width [m]
uniform vec4 origin; // the floor's middle, in pictures; place of the source [m]; picture in heights of the domain
uniform vec4 part;   // used part of the field target, largest coordinate in it
uniform vec4 range;  // what the target's range took of each field
uniform vec4 grain;  // noise tiles per metre: across, up; warp [m], detail
uniform vec4 start;  // where in the tile each pattern began
uniform vec4 seen;   // share of each pattern; level of the tile with texels as large as it; tiles risen
uniform vec4 matter; // optical depth of soot, of smoke; temperature of the air [kK]; 1 / width of the domain [1/m]
uniform vec4 shine;  // luminance exponent, gain, 1 / light range; 1 / heights of the domain that are soft at the floor
uniform vec4 table;  // kK to table coordinate: scale, offset; share of fire

out vec4 light; // square root of light / range; coverage

// What the gas has folded finer than texels is not seen.
vec4 pattern(vec4 places, vec2 level, float finer) {
    level += log2(finer);
    return (textureLod(noise, places.xy * finer, level.x) * 2.0 - 1.0) * seen.x
         + (textureLod(noise, places.zw * finer, level.y) * 2.0 - 1.0) * seen.y;
}

void main() {
    light = vec4(0.0);
    vec2 place = (uv - origin.xy) * view.xy;
    vec4 carried = texture(drift, uv) * view.xyxy;
    vec4 places = (place.xyxy - carried) * grain.xyxy + start - vec2(0.0, seen.w).xyxy;
    vec4 across = dFdx(places);
    vec4 along = dFdy(places);
    across = max(across * across, along * along);
    float around = texture(field, min(uv * part.xy, part.zw)).z * range.z;
    if (around < 0.003) return;
    vec2 level = 0.5 * log2(max(across.xz, across.yw)) + seen.z;
    vec4 broad = pattern(places, level, 1.0);
    vec4 fine = pattern(places, level, 2.0);
    float above = (place.y - view.z) / view.w;

    float growth = smoothstep(0.0, 0.8, above);
    vec2 moved = (broad.xy + 0.4 * fine.yx) * grain.z * (0.35 + growth);
    vec4 gas = texture(field, min((uv + moved / view.xy) * part.xy, part.zw)) * range;
    float weight = max(gas.x, 1e-4);
    float share = min(1.25 * weight, 1.0);
    float kilokelvin = mix(matter.z, gas.y / weight, share);
    // What leaves the domain on one side comes back on the other, and above it and the
    // picture ends: none of that is seen. Nor is where the noise would carry gas to nothing.
    float up = (uv.y - origin.y) * origin.w;
    float soot = gas.z / weight * share * smoothstep(0.003, 0.03, around)
               * (1.0 - smoothstep(0.36, 0.48, abs(place.x) * matter.w)) * (1.0 - smoothstep(0.72, 0.96, max(up, uv.y))) * clamp(up * shine.w, 0.0, 1.0);

    // The flame stands on its source as in a bowl, whose rim is higher than its
    // middle, and thins towards it.
    float rim = 2.0 * (place.x - origin.z) / view.w;
    float base = smoothstep(0.0, 0.5, above - 0.2 * min(rim * rim, 2.0) + 0.24 * broad.w * min(grain.w, 1.0));

    // Dark gaps and bright sheets.
    float sheet = fine.z + 0.7 * broad.w;
    float left = max(soot - grain.w * 0.13 * max(0.5 + 0.7 * broad.z + 0.5 * fine.w, 0.0), 0.0);
    left *= base * exp(-1.8 * grain.w * sheet);
    kilokelvin -= 0.14 * grain.w * sheet;

    float glowing = smoothstep(0.75, 1.0, kilokelvin) * table.z;
    float covered = 1.0 - exp(-matter.x * left);
    vec4 body = texture(black_body, vec2(kilokelvin * table.x + table.y, 0.5));
    vec3 emitted = body.rgb * exp(shine.x * body.a) * (shine.y * covered * glowing);
    // Smoke forms above the flame. Cool soot beside the flame would draw a grey rim.
    float aloft = smoothstep(0.2, 1.4, above);
    float hidden = 1.0 - exp(-matter.y * soot * aloft * (1.0 - smoothstep(0.5, 1.1, kilokelvin)));
    // Over a bright ground, thin bright flame hides more than it shines. Dim red gas
    // hides no more than it shines: it would draw a dark rim.
    float bright = smoothstep(0.02, 0.5, max(emitted.r, max(emitted.g, emitted.b)));
    float opaque = covered * (2.0 - covered) * glowing * bright;
    light = vec4(sqrt(emitted * shine.z), 1.0 - (1.0 - opaque) * (1.0 - hidden));
}

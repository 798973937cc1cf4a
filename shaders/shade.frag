// From fields to light: warped and eroded by rising noise, glowing as a black
// body, hidden by its own smoke.

in vec2 uv;

uniform sampler2D field;      // weight, weight × kK, weight × glow, weight × smoke
uniform sampler2D wide;       // the same as seen from farther away
uniform sampler2D noise;      // a tile; 0.5 is zero
uniform sampler2D black_body; // chroma, ln luminance, by temperature
uniform vec4 view;    // width, height [m], height of the source [m], 1 / flame height
uniform vec4 origin;  // the floor's middle, in pictures; place of the source [m]; picture in heights of the domain
uniform vec4 part;    // used part of the field target, largest coordinate in it
uniform vec4 range;   // what the target's range took of each field
uniform vec4 rise;    // noise tiles per metre, tiles risen, warp [m], erosion
uniform vec4 matter;  // optical depth, weight of the air, its temperature [kK], smoke
uniform vec4 shine;   // luminance exponent, gain, 1 / light range, 1 / half the source's width
uniform vec4 table;   // kK to table coordinate: scale, offset; share of fire; 1: soft at the top of the domain

out vec4 light; // square root of light / range; coverage

void main() {
    vec4 around = texture(wide, uv) * range;
    if (around.x < 0.004) {
        light = vec4(0.0);
        return;
    }
    vec2 place = (uv - origin.xy) * view.xy;
    float above = max(place.y - view.z, 0.0) * view.w;
    vec2 tile = place * rise.x;

    // The gas has moved by what broad noise says, farther the higher it is.
    vec4 broad = textureLod(noise, vec2(tile.x, (tile.y - rise.y) * 0.62), 0.0) * 2.0 - 1.0;
    float growth = smoothstep(0.0, 0.6, above);
    vec2 moved = broad.xy * vec2(1.0, 1.4) * rise.z * (0.3 + growth) / view.xy;
    vec4 gas = texture(field, min((uv + moved) * part.xy, part.zw)) * range;

    // Tongues and dark gaps: finer noise eats the glow, more of it higher up,
    // and at the base, which would end in a line and two corners otherwise.
    vec4 fine = textureLod(noise, vec2(tile.x * 2.1, (tile.y - rise.y) * 1.05) + broad.yx * 0.06, 0.0) * 2.0 - 1.0;
    float grain = 0.9 * broad.z + 0.7 * fine.w;
    float eaten = clamp(0.45 + grain, 0.0, 1.6) * rise.w;
    float depth = around.z / (around.z + matter.y);
    float base = 1.0 - smoothstep(0.0, 0.2, above);
    float left = gas.z - eaten * (0.16 + 0.45 * max(growth, 0.6 * base)) - 4.0 * base * max(0.6 - depth, 0.0);
    left = max(left, 0.0) * (1.0 - 0.3 * min(eaten, 1.0));

    // The flame stands on its source as in a bowl, whose rim is higher than its
    // middle, and thins towards it.
    float rim = min(abs(place.x - origin.z) * shine.w, 1.5);
    float over = abs(place.y - view.z) * shine.w - 0.8 * rim * rim + 0.25 * grain * min(rise.w, 1.0);
    left *= smoothstep(-0.35, 0.4, over);

    // The thicker the flame around, the brighter; air has mixed in where it is
    // thin, and cools it.
    float hot = around.y / around.x;
    float kilokelvin = mix(max(matter.z, 0.5 * hot), hot, depth * left / (left + 0.08)) - 0.24 * grain * rise.w;
    vec4 body = texture(black_body, vec2(kilokelvin * table.x + table.y, 0.5));

    float covered = (1.0 - exp(-matter.x * left * depth)) * smoothstep(0.7, 1.1, kilokelvin) * table.z;
    float opaque = covered * smoothstep(0.7, 1.05, kilokelvin) * min(2.5 * depth, 1.0);
    float hidden = 1.0 - exp(-matter.w * around.w);
    vec3 emitted = body.rgb * exp(shine.x * body.a) * (shine.y * depth * (0.25 + 0.75 * depth) * covered);
    // Dim red gas hides no more than it shines: over a bright ground it would draw a dark rim.
    opaque *= smoothstep(0.02, 0.5, max(emitted.r, max(emitted.g, emitted.b)));
    vec3 sum = emitted * (1.0 - 0.5 * hidden);
    float soft = 1.0 - table.w * smoothstep(0.75, 0.98, (uv.y - origin.y) * origin.w);
    light = vec4(sqrt(sum * shine.z), 1.0 - (1.0 - opaque) * (1.0 - hidden)) * soft;
}

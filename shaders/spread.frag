// The fields as seen from farther away: what a place's wider surroundings
// hold. Turbulence mixes air in from there, so the flame's heart stays hot.

in vec2 uv;

uniform sampler2D field;
uniform vec4 reads; // distance of two reads; used part of the field target

out vec4 wide;

void main() {
    vec2 centre = uv * reads.zw;
    wide = vec4(0.0);
    for (float y = -2.0; y <= 2.0; y += 1.0) {
        for (float x = -2.0; x <= 2.0; x += 1.0) {
            float weight = (3.0 - abs(x)) * (3.0 - abs(y));
            wide += weight / 81.0 * texture(field, centre + vec2(x, y) * reads.xy);
        }
    }
}

// The field as seen from farther away: what the wider neighbourhood of a place holds.
// Turbulence mixes air in from there, so the heart of a flame stays hot.

in vec2 uv;

uniform sampler2D field;
uniform vec2 field_used; // share of the target that the frame uses
uniform vec2 read_step;  // between two reads, in coordinates of the target

out vec4 wide;

// A 5 × 5 tent: weights 1 2 3 2 1 each way, which sum up to 81.
void main() {
    vec2 centre = uv * field_used;
    wide = vec4(0.0);
    for (float y = -2.0; y <= 2.0; y += 1.0) {
        for (float x = -2.0; x <= 2.0; x += 1.0) {
            float weight = (3.0 - abs(x)) * (3.0 - abs(y));
            wide += weight / 81.0 * texture(field, centre + vec2(x, y) * read_step);
        }
    }
}

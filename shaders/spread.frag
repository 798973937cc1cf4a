// Blurs the field: the mean of a wider neighbourhood. Turbulence mixes air in from there, so the
// core of a flame stays hot.

in vec2 uv;

uniform sampler2D field;
uniform vec2 field_used; // used share of the target
uniform vec2 read_step;  // distance of two reads, in coordinates of the target

out vec4 wide;

// A 5 × 5 tent filter: weights 1 2 3 2 1 in each direction, which sum to 81.
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

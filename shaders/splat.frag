// Adds one particle to the fields.

in vec2 corner;
flat in vec4 payload;

out vec4 fields;

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    fields = payload * (inside * inside);
}

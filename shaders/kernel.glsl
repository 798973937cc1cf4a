// Accumulates the payload of a particle with the kernel (1 − q²)².

in vec2 corner;
flat in vec4 payload;

out vec4 field;

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    field = payload * (inside * inside);
}

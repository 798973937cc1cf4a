// One particle as a disc, coloured by what is measured of it.

in vec2 corner;
flat in vec4 payload; // 1, share of the span

uniform vec4 kernel; // …, pixels in a radius
uniform vec4 span;   // …, 1: signed

out vec4 pixel;

void main() {
    float inside = clamp((1.0 - length(corner)) * kernel.w + 0.5, 0.0, 1.0);
    pixel = vec4(scale_colour(payload.y, span.z), 1.0) * inside;
}

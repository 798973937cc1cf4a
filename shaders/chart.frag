// From sums of what is measured to its mean, by colours. Gas ends softly.

in vec2 uv;

uniform sampler2D field; // weight, weight × share of the span
uniform vec4 part; // used part of the field target, largest coordinate in it
uniform vec4 edge; // of the domain: pictures from its middle to it, 1 / those in which it fades, its middle
uniform vec4 span; // …, 1: signed, 1 / weight that covers

out vec4 pixel;

void main() {
    vec4 gas = texture(field, min(uv * part.xy, part.zw));
    float covered = smoothstep(0.0, 1.0, gas.x * span.w) * clamp((edge.x - abs(uv.x - edge.z)) * edge.y, 0.0, 1.0);
    pixel = dither(vec4(scale_colour(gas.y / max(gas.x, 1e-3), span.z), 1.0)) * covered;
}

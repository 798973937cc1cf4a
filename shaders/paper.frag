// The paper's drawing: a hard disc, its colour by the distance from the centre.

in vec2 corner;
flat in float centre; // [kK]

uniform sampler2D black_body; // chroma, ln luminance, by temperature
uniform vec4 sprite; // radius [m], pixels in a radius
uniform vec4 heat;   // …, luminance exponent, gain
uniform vec4 table;  // kK to table coordinate: scale, offset
uniform vec4 pale;   // what light that is far too bright pales to, and how

out vec4 pixel;

void main() {
    float distance = length(corner);
    float inside = clamp((1.0 - distance) * sprite.y + 0.5, 0.0, 1.0);
    float kilokelvin = centre * mix(1.0, 0.55, smoothstep(0.0, 0.95, distance));
    vec4 body = texture(black_body, vec2(kilokelvin * table.x + table.y, 0.5));
    vec3 shown = encode(tone_map(body.rgb * exp(heat.y * body.a) * heat.z, pale));
    pixel = vec4(shown, 1.0) * inside;
}

// One sprite: a soft flake of noise that glows as a black body.

in vec2 corner;
flat in vec4 part;
flat in vec2 heat;

uniform sampler2D noise;      // a tile; 0.5 is zero
uniform sampler2D black_body; // chroma, ln luminance, by temperature
uniform vec4 shine; // luminance exponent, gain
uniform vec4 table; // kK to table coordinate: scale, offset
uniform vec4 pale;  // what light that is far too bright pales to, and how

out vec4 shown;

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    vec4 grain = texture(noise, part.xy + 0.16 * mat2(part.zw, -part.w, part.z) * corner);
    float flake = inside * smoothstep(0.0, 0.9, inside + 2.0 * (grain.x + 0.5 * grain.w - 0.75));
    vec4 body = texture(black_body, vec2(heat.x * (0.72 + 0.28 * flake) * table.x + table.y, 0.5));
    vec3 colour = encode(tone_map(body.rgb * exp(shine.x * body.a) * shine.y, pale));
    shown = vec4(colour, 1.0) * (heat.y * flake);
}

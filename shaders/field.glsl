// Reads the field, of which a frame uses only the lower left part.

uniform sampler2D field;
uniform vec2 field_used; // share of the target that the frame uses
uniform vec2 field_edge; // centre of the last texel in use: a read beyond it would blend with unused texels

vec4 field_at(vec2 at) {
    return texture(field, min(at * field_used, field_edge));
}

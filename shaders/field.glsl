// Reads the field. A frame uses only its lower left part.

uniform sampler2D field;
uniform vec2 field_used; // used share of the target
uniform vec2 field_edge; // centre of the last used texel: filtering beyond it would include unused texels

vec4 field_at(vec2 at) {
    return texture(field, min(at * field_used, field_edge));
}

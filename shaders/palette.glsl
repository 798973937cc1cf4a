// Emission by temperature. TABLE_SCALE and TABLE_OFFSET come from build/values.rs.

uniform sampler2D palette; // chroma, ln luminance
uniform float luminance_exponent; // below 1: compresses the range of luminance

// Rows of the table: of gas, and of solids, which glow as a black body in every palette.
const float GAS_ROW = 0.25;
const float SOLID_ROW = 0.75;

vec3 radiance(float kilokelvin, float row) {
    vec4 entry = texture(palette, vec2(kilokelvin * TABLE_SCALE + TABLE_OFFSET, row));
    return entry.rgb * exp(luminance_exponent * entry.a);
}

// Emission by temperature. TABLE_SCALE and TABLE_OFFSET come from build/values.rs.

uniform sampler2D palette; // chroma, ln luminance
uniform float luminance_exponent; // below 1: compresses the range of luminance

vec3 radiance(float kilokelvin) {
    vec4 entry = texture(palette, vec2(kilokelvin * TABLE_SCALE + TABLE_OFFSET, 0.5));
    return entry.rgb * exp(luminance_exponent * entry.a);
}

// Irradiance on the wall: the fire is an area light in front of it.
#include "lean.glsl"

in vec2 uv;

uniform sampler2D widest_blur; // of the light
uniform vec2 size; // of the picture, in heights of the domain

// Square root of 16 light / range: a wall gets far less light than a flame gives. Then the lean of the light.
out vec4 irradiance;

const float DISTANCE_SQUARED = 0.06; // square of the fire's distance from the wall, in heights of the domain
const float LEVEL = 0.03; // least way up to the light, in heights of the domain
const float DARKEST = 1e-6; // light below which there is no lean

void main() {
    // One filtered read covers four texels, so all texels count for any shape of the picture.
    vec2 reads = ceil(vec2(textureSize(widest_blur, 0)) / 2.0);
    vec3 sum = vec3(0.0);
    vec2 way = vec2(0.0, DARKEST);
    for (float y = 0.5; y < reads.y; y += 1.0) {
        for (float x = 0.5; x < reads.x; x += 1.0) {
            vec2 at = vec2(x, y) / reads;
            vec3 root = texture(widest_blur, at).rgb;
            vec2 across = (at - uv) * size;
            // Inverse square law times the cosines at both ends.
            float near = DISTANCE_SQUARED / (DISTANCE_SQUARED + dot(across, across));
            vec3 lit = root * root * near * near;
            sum += lit;
            way += dot(lit, vec3(1.0)) * vec2(across.x, max(across.y, LEVEL));
        }
    }
    irradiance = vec4(4.0 * sqrt(sum * size.x * size.y / (reads.x * reads.y)), encode_lean(way.x / way.y));
}

// The light of an ember, or what a droplet or steam scatters.
#include "palette.glsl"
#include "light.glsl"

in vec2 corner;
flat in vec2 spark;

out vec4 light; // encoded; coverage

const float OPACITY = 0.6; // in the middle of a full spark
const vec3 WATER = vec3(0.42, 0.47, 0.52); // radiance where it is opaque

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    vec3 emitted = radiance(spark.x) * (spark.y * inside * inside);
    light = vec4(encode_light(emitted), OPACITY * inside * min(spark.y, 1.0));
    // Droplets and steam, which have no temperature, cover more than they shine.
    if (spark.x < 0.0) light = vec4(encode_light(WATER), 1.0) * (spark.y * inside);
}

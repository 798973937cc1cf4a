// The light of an ember.
#include "palette.glsl"
#include "light.glsl"

in vec2 corner;
flat in vec2 spark;

out vec4 light; // encoded; coverage

const float OPACITY = 0.6; // in the middle of a full spark

void main() {
    float inside = max(1.0 - dot(corner, corner), 0.0);
    vec3 emitted = radiance(spark.x) * (spark.y * inside * inside);
    light = vec4(encode_light(emitted), OPACITY * inside * min(spark.y, 1.0));
}

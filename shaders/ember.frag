// The light of an ember, or what a droplet or steam scatters.
#include "palette.glsl"
#include "light.glsl"

in vec2 flown;
flat in vec2 ribbon;
flat in vec2 spark;

out vec4 light; // encoded; coverage

const float OPACITY = 0.8; // in the middle of a full spark
const vec3 WATER = vec3(0.42, 0.47, 0.52); // radiance where it is opaque
// What the eye keeps of the path decays from the spark to the tail: exponent of its light, and width of the tail.
const float DECAY = 3.0;
const float TAIL = 0.6;
// Maximum radiance. A brighter spark only has a brighter halo: equal white pixels have a straight edge.
const float BRIGHTEST = 3.0;
const float HALO = 0.012;     // share of its light
const float MOST_HALO = 0.25; // radiance
const float WIDTH = 3.0;      // of the halo, in radii

void main() {
    float back = clamp(flown.x, 0.0, ribbon.x);
    // Left of the path, which is a parabola; the slope of the path shortens the way to it.
    float slope = ribbon.y * back;
    vec2 away = vec2(flown.x - back, (flown.y - 0.5 * slope * back) * inversesqrt(1.0 + slope * slope));
    float late = back / max(ribbon.x, 1.0);
    float square = dot(away, away);
    float width = mix(1.0, TAIL, late);
    float inside = max(1.0 - square / (width * width), 0.0);
    inside *= inside * inside;
    if (spark.x < 0.0) {
        // Droplets and steam, which have no temperature, cover more than they shine.
        light = vec4(encode_light(WATER), 1.0) * (spark.y * inside);
        return;
    }
    vec3 emitted = radiance(spark.x, GAS_ROW) * (spark.y * exp(-DECAY * late));
    float peak = max(emitted.r, max(emitted.g, emitted.b));
    vec3 hue = emitted / max(peak, 1e-6);
    float outside = max(1.0 - square / (WIDTH * WIDTH), 0.0);
    float core = BRIGHTEST * (1.0 - exp(-peak / BRIGHTEST)) * inside;
    float halo = min(HALO * peak, MOST_HALO) * outside * outside * outside;
    light = vec4(encode_light(hue * (core + halo)), OPACITY * inside * min(peak, 1.0));
}

// One quad per ember: a spark, stretched along its motion. A spark smaller than a pixel is
// larger and fainter, so that it does not flicker.
#include "particle.glsl"

uniform float smallest; // radius [m]
uniform float gain; // brightness of gas of 1500 K

out vec2 corner;
flat out vec2 spark; // kK, brightness

const float EXPOSURE = 0.008; // exposure time [s]
const float LONGEST = 3.0;    // maximum stretch
const float FADE_OUT = 0.2;   // share of its life in which a spark fades

void main() {
    Particle particle = this_particle();
    corner = particle.corner;
    float speed = length(particle.velocity);
    vec2 along = direction(particle, speed);
    float real_radius = 0.5 * particle.state.y;
    float radius = max(real_radius, smallest);
    float stretch = clamp(speed * EXPOSURE / radius, 1.0, LONGEST);
    gl_Position = clip(particle, particle.place
        + radius * (corner.x * vec2(along.y, -along.x) + corner.y * stretch * along));
    float share = real_radius / radius;
    float alive = smoothstep(0.0, FADE_OUT, particle.state.w);
    // Of water, a negative temperature and its opacity.
    spark = vec2(particle.state.x * 1e-3, particle.state.x < 0.0 ? particle.state.z : gain * alive * share * share / stretch);
}

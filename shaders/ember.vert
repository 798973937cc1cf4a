// One quad per ember: a ribbon along the path that a spark has flown during the exposure. A ribbon that is
// thinner than a pixel is wider and fainter, so that it does not flicker.
#include "particle.glsl"

uniform float smallest; // radius [m]
uniform float gain; // brightness of gas of 1500 K
uniform float largest; // diameter of embers in the simulation [m]
uniform float time; // [s]

out vec2 flown;       // from the spark, back along its direction and to its left, in radii
flat out vec2 ribbon; // its length in radii, and its curvature [1/radii]
flat out vec2 spark;  // kK, brightness

const float EXPOSURE = 0.03;   // exposure time [s]
const float WATER_LENGTH = 4.0; // longest streak of water, in radii
const float BEND = 1.2;        // largest angle between both ends of a ribbon [rad]
const float FADE_OUT = 0.2;    // share of its life in which a spark fades
// The simulation draws diameters evenly between this share of the largest and the largest.
const float SMALLEST_SHARE = 0.4;
const float MEDIAN = 0.7;
// Firebrands have log-normal sizes (F. Hedayati et al. 2019): the log-logistic law has nearly the same
// shape, and its quantile is a power of the odds.
const float SIZE_POWER = 0.35;
const float RAREST = 0.02;     // share of the embers of the smallest and of the largest size
// Glint of a tumbling flake: two frequencies [Hz] with their ranges, and their amplitudes.
const vec2 TUMBLING = vec2(2.5, 8.0);
const vec2 TUMBLING_RANGE = vec2(3.0, 6.0);
const vec2 GLINT = vec2(0.6, 0.5);
const vec2 PHASE = vec2(2.7e4, 9.1e4); // a number of each diameter [1/m]
const float TURN = 6.2832;
const float SPREAD = 0.2;     // length of a ribbon over which its light spreads, for each radius
const float MARGIN = 3.0;      // of the quad, in radii, as wide as the halo

void main() {
    Particle particle = this_particle();
    float speed = length(particle.velocity);
    vec2 along = direction(particle, speed);
    bool water = particle.state.x < 0.0;
    float share = clamp((particle.state.y / largest - SMALLEST_SHARE) / (1.0 - SMALLEST_SHARE), RAREST, 1.0 - RAREST);
    float real_radius = 0.5 * (water ? particle.state.y : MEDIAN * largest * pow(share / (1.0 - share), SIZE_POWER));
    float radius = max(real_radius, smallest);
    float path = speed * EXPOSURE / radius;
    if (water) path = min(path, WATER_LENGTH);
    // The third number is the rate of turn of a spark [rad/s], and the opacity of water.
    float turned = water ? 0.0 : clamp(particle.state.z * EXPOSURE, -BEND, BEND);
    ribbon = vec2(path, turned / max(path, 1.0));
    float bend = 0.5 * ribbon.y * path * path;
    flown = vec2(particle.corner.x < 0.0 ? -MARGIN : path + MARGIN,
                 particle.corner.y < 0.0 ? min(bend, 0.0) - MARGIN : max(bend, 0.0) + MARGIN);
    gl_Position = clip(particle, particle.place - radius * (flown.x * along + flown.y * vec2(along.y, -along.x)));
    vec2 phase = fract(particle.state.y * PHASE);
    vec2 glint = 1.0 + GLINT * sin(TURN * ((TUMBLING + TUMBLING_RANGE * phase) * time + phase));
    float alive = smoothstep(0.0, FADE_OUT, particle.state.w);
    // Its light spreads over the ribbon.
    float thin = real_radius / radius;
    float brightness = gain * alive * glint.x * glint.y * thin * thin / (1.0 + SPREAD * path);
    spark = vec2(particle.state.x * 1e-3, water ? particle.state.z : brightness);
}

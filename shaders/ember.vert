// One quad an ember: a spark, drawn out along its way. One that is smaller than
// a pixel is drawn larger and fainter, so that it does not flicker.

uniform vec4 spark; // smallest radius [m], time of exposure [s]
uniform vec4 shine; // luminance exponent, gain, 1 / light range

out vec2 corner;
flat out vec4 heat; // kK, luminance exponent, brightness

void main() {
    Particle particle = this_particle();
    corner = particle.corner;
    float speed = length(particle.velocity);
    vec2 along = speed > 1e-4 ? particle.velocity / speed : vec2(0.0, 1.0);
    float wanted = 0.5 * particle.state.y;
    float radius = max(wanted, spark.x);
    float drawn_out = clamp(speed * spark.y / radius, 1.0, 3.0);
    gl_Position = clip(particle, particle.place
        + radius * (corner.x * vec2(along.y, -along.x) + corner.y * drawn_out * along));
    float share = wanted / radius;
    float alive = smoothstep(0.0, 0.2, particle.state.w);
    heat = vec4(particle.state.x * 1e-3, shine.x, shine.y * alive * share * share / drawn_out, shine.z);
}

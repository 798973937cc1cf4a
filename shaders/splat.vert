// One quad a particle: a smooth kernel, drawn out along the way it moves,
// and what that particle adds to the fields.

uniform vec4 kernel; // radius [m], time of stretch [s], weight
uniform vec4 scale;  // what the target's range leaves of each field

out vec2 corner;       // −1–1 over the kernel
flat out vec4 payload; // weight, weight × kK, weight × glow, weight × smoke

void main() {
    Particle particle = this_particle();
    corner = particle.corner;

    float speed = length(particle.velocity);
    vec2 along = speed > 1e-4 ? particle.velocity / speed : vec2(0.0, 1.0);
    float drawn_out = min(1.0 + speed * kernel.y / kernel.x, 2.2);

    // Gas spreads while it rises: the kernel widens and thins.
    float age = particle.state.z;
    float life = clamp(particle.state.w, 0.0, 1.0); // what remains of it
    float lived = 1.0 - life;
    float widened = 0.85 + 0.4 * lived;
    vec2 radii = kernel.x * widened * vec2(inversesqrt(drawn_out), pow(drawn_out, 0.75));
    gl_Position = clip(particle, particle.place + corner.x * radii.x * vec2(along.y, -along.x)
                                                + corner.y * radii.y * along);

    // Nothing pops: a particle comes from nothing, catches fire, and goes to
    // nothing. However long it lives, it does not wait to catch fire.
    float born = smoothstep(0.0, 1.0, max(lived / 0.15, age / 0.15));
    float lit = smoothstep(0.0, 1.0, max(lived / 0.30, age / 0.30));
    float weight = kernel.z * born * smoothstep(0.0, 0.45, life) / (widened * widened);
    float kilokelvin = particle.state.x * 1e-3 * mix(0.62, 1.0, lit);
    float glow = smoothstep(0.6, 0.95, kilokelvin);
    payload = weight * vec4(1.0, kilokelvin, glow, lived * lived * lived) * scale;
}

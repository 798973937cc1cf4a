// One quad a particle that glows: a sprite with a part of the noise tile of its own,
// which turns slowly.

uniform vec4 sprite; // radius [m], turns, opacity, how much of it there must be to glow fully

out vec2 corner;
flat out vec4 part; // of the tile: its middle; cosine and sine of its angle
flat out vec2 heat; // kK, opacity

void main() {
    Particle particle = this_particle();
    corner = particle.corner;
    vec4 state = particle.state; // temperature [K], volume [m²], number, what there is to glow
    // Of no order, and the same in every picture.
    vec4 any = fract(state.z * vec4(0.618034, 0.754878, 0.56984, 0.819173));
    float angle = 6.2832 * (any.x + sprite.y * (floor(6.0 * any.y) - 2.5));
    part = vec4(any.zy, cos(angle), sin(angle));
    heat.x = state.x * 1e-3;
    heat.y = sprite.z * (0.3 + 0.7 * any.w * any.w) * smoothstep(0.75, 1.05, heat.x) * smoothstep(0.0, sprite.w, state.w);
    gl_Position = clip(particle, particle.place + corner * (heat.y > 0.0 ? sprite.x * (0.6 + 0.4 * any.z) : 0.0));
}

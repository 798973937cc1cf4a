// Targets store the square root of radiance / light range, so that half floats and eight bits
// resolve dark light as finely as the eye.

uniform float light_scale; // 1 / light range

vec3 encode_light(vec3 emitted) {
    return sqrt(emitted * light_scale);
}

// Opacity over a bright background. Bright flame hides it; dim red gas does not, because covering
// more than it emits would draw a dark rim.
float opacity_of(vec3 emitted) {
    const float DIM = 0.02;   // radiance that hides nothing
    const float BRIGHT = 0.5; // radiance that hides as much as the flame covers
    return smoothstep(DIM, BRIGHT, max(emitted.r, max(emitted.g, emitted.b)));
}

// Light is kept as the square root of radiance / light range: half floats and eight bits
// then resolve dark light as finely as an eye does.

uniform float light_scale; // 1 / light range

vec3 encode_light(vec3 emitted) {
    return sqrt(emitted * light_scale);
}

// Light over a bright ground: bright flame hides the ground, dim red gas does not, because
// covering more than it shines would draw a dark rim.
float opacity_of(vec3 emitted) {
    const float DIM = 0.02;   // radiance that hides nothing
    const float BRIGHT = 0.5; // radiance that hides as much as the flame covers
    return smoothstep(DIM, BRIGHT, max(emitted.r, max(emitted.g, emitted.b)));
}

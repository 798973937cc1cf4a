// A target of half floats stores the light, so that slices blend. One of eight bits stores the square root of
// light / light range, which resolves dark light as finely as the eye.

uniform float light_scale; // 1 / light range; 0 if the target stores the light

vec3 encode_light(vec3 emitted) {
    return light_scale > 0.0 ? sqrt(emitted * light_scale) : emitted;
}

// Opacity over a bright background. Bright flame hides it; dim red gas does not, because covering
// more than it emits would draw a dark rim.
float opacity_of(vec3 emitted) {
    const float DIM = 0.02;   // radiance that hides nothing
    const float BRIGHT = 0.5; // radiance that hides as much as the flame covers
    return smoothstep(DIM, BRIGHT, max(emitted.r, max(emitted.g, emitted.b)));
}

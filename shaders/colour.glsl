// Linear colours to displayed ones.

// The sRGB encoding. Three square roots approximate its power law to a third of a step of eight
// bits, far faster than a power on software renderers.
vec3 encode(vec3 linear) {
    linear = clamp(linear, 0.0, 1.0);
    vec3 second = sqrt(linear);
    vec3 fourth = sqrt(second);
    vec3 power = 0.6620 * second + 0.6841 * fourth - 0.3236 * sqrt(fourth) - 0.0225 * linear;
    return mix(12.92 * linear, power, step(0.0031308, linear));
}

// A displayed light, whose peak is given, as an eye sees it that has adapted to its hue: less red. A white page would
// show the complement of dim light, which is redder than bright light.
vec3 adapted(vec3 hue, float peak, float share) {
    return mix(hue, sqrt(hue * peak), share);
}

// Adds half a step of eight bits of interleaved gradient noise (J. Jimenez 2014) against banding.
// All channels get the same noise, so no colour exceeds its alpha.
vec4 dither(vec4 colour) {
    const float AMPLITUDE = 0.99; // below 1, so that colours that are exact in eight bits do not change
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return colour + (grain - 0.5) * AMPLITUDE / 255.0;
}

// Linear colours to displayed ones.

// The sRGB encoding, the last step of all. Its power law by three square roots: within a third
// of a step of eight bits, and far cheaper than a power where there is no graphics card.
vec3 encode(vec3 linear) {
    linear = clamp(linear, 0.0, 1.0);
    vec3 second = sqrt(linear);
    vec3 fourth = sqrt(second);
    vec3 power = 0.6620 * second + 0.6841 * fourth - 0.3236 * sqrt(fourth) - 0.0225 * linear;
    return mix(12.92 * linear, power, step(0.0031308, linear));
}

// Half a step of eight bits of interleaved gradient noise (J. Jimenez 2014) against bands: the
// same in every channel, so that no colour exceeds its alpha.
vec4 dither(vec4 colour) {
    const float AMPLITUDE = 0.99; // below 1: a colour that eight bits hold exactly stays as it is
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return colour + (grain - 0.5) * AMPLITUDE / 255.0;
}

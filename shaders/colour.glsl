// From light to what a screen shows.

// Compresses the peak and keeps the hue, so that orange stays orange; only
// what is far too bright pales: towards `white`, by way of yellow as far as its
// fourth number says. Channel by channel, orange would turn lemon.
vec3 tone_map(vec3 light, vec4 white) {
    float peak = max(light.r, max(light.g, light.b));
    float shown = 1.0 - exp(-peak);
    vec3 hue = light / max(peak, 1e-6);
    float bright = max(peak - 0.8, 0.0);
    float pale = bright * bright / (bright * bright + 13.0);
    vec3 share = mix(vec3(pale), vec3(pale, pale * (1.7 - 0.7 * pale), pale * pale), white.a);
    return shown * mix(hue, white.rgb, share);
}

// The sRGB encoding, the last step of all. Its power law by three square roots:
// within a third of a step of eight bits, and far cheaper than a power where
// there is no graphics card.
vec3 encode(vec3 linear) {
    linear = clamp(linear, 0.0, 1.0);
    vec3 second = sqrt(linear);
    vec3 fourth = sqrt(second);
    vec3 power = 0.6620 * second + 0.6841 * fourth - 0.3236 * sqrt(fourth) - 0.0225 * linear;
    return mix(12.92 * linear, power, step(0.0031308, linear));
}

// Half a step of eight bits of noise, against bands: the same in every channel,
// so that no colour exceeds its alpha.
vec4 dither(vec4 colour) {
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return colour + (noise - 0.5) * 0.99 / 255.0;
}

// Reads the tile of gradient noise: three smooth channels and a fine one, about −1 to 1.
// The level is explicit, because derivatives are undefined after an early return.

uniform sampler2D noise;

vec4 noise_at(vec2 place, float level) {
    return textureLod(noise, place, level) * 2.0 - 1.0;
}

// The lean of the light: its horizontal way for each way up, as the fourth number of the irradiance.

const float LEAN_RANGE = 2.0; // largest lean to each side

float encode_lean(float way) {
    return clamp(way * (0.5 / LEAN_RANGE) + 0.5, 0.0, 1.0);
}

float decode_lean(float number) {
    return (number - 0.5) * (2.0 * LEAN_RANGE);
}

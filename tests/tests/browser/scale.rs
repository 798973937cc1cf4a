//! The colours of a measured quantity, by their definition.

/// The colour of a share of the scale, 0–1, in OkLCh (B. Ottosson 2020) and
/// then in sRGB, 0–255.
pub fn colour(share: f32, signed: bool) -> [f32; 3] {
    let (lightness, chroma, degrees) = if signed {
        let side = 2.0 * share - 1.0;
        let far = side.abs();
        let (most, hue) = if side < 0.0 {
            (0.34, 262.0 - 42.0 * far)
        } else {
            (0.46, 15.0 + 65.0 * far)
        };
        (0.16 + 0.74 * far, most * far * (1.0 - 0.74 * far), hue)
    } else {
        let chroma = 0.03 + 0.6 * share * (1.0 - share) + 0.06 * share;
        (0.18 + 0.77 * share, chroma, 295.0 + 170.0 * share)
    };
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let (a, b) = (chroma * cosine, chroma * sine);
    let l = (lightness + 0.396_337_78 * a + 0.215_803_76 * b).powi(3);
    let m = (lightness - 0.105_561_346 * a - 0.063_854_17 * b).powi(3);
    let s = (lightness - 0.089_484_18 * a - 1.291_485_5 * b).powi(3);
    [
        4.076_741_7 * l - 3.307_711_6 * m + 0.230_969_94 * s,
        -1.268_438 * l + 2.609_757_4 * m - 0.341_319_4 * s,
        -0.004_196_086 * l - 0.703_418_6 * m + 1.707_614_7 * s,
    ]
    .map(|linear| {
        let linear = linear.clamp(0.0, 1.0);
        255.0
            * if linear <= 0.003_130_8 {
                12.92 * linear
            } else {
                1.055 * linear.powf(1.0 / 2.4) - 0.055
            }
    })
}

//! The pixel format of the targets.
//!
//! Half floats wherever the browser can draw into them, and never full floats, which phones
//! cannot blend. Without half floats, eight bits hold scaled values: coarser, but a fire.

use crate::gl::Graphics;

/// Pixels of the off-screen targets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetFormat {
    /// Half floats.
    Rgba16F,
    /// Eight bits from 0 to 1, with scaled values.
    Rgba8,
}

impl TargetFormat {
    /// The formats to try, best first.
    pub(crate) fn candidates(gl: &impl Graphics) -> &'static [TargetFormat] {
        let half_floats = gl.has_extension("EXT_color_buffer_float")
            || gl.has_extension("EXT_color_buffer_half_float");
        if half_floats {
            &[TargetFormat::Rgba16F, TargetFormat::Rgba8]
        } else {
            &[TargetFormat::Rgba8]
        }
    }

    /// A short name for statistics.
    pub const fn name(self) -> &'static str {
        match self {
            TargetFormat::Rgba16F => "rgba16f",
            TargetFormat::Rgba8 => "rgba8",
        }
    }

    /// Internal format, type of its channels.
    pub(crate) const fn constants(self) -> (u32, u32) {
        match self {
            TargetFormat::Rgba16F => (glow::RGBA16F, glow::HALF_FLOAT),
            TargetFormat::Rgba8 => (glow::RGBA8, glow::UNSIGNED_BYTE),
        }
    }

    /// Largest value of each field that must still be told apart: weight,
    /// weight × kK, glow, smoke. The splat divides by it, the reader multiplies.
    pub(crate) const fn field_range(self) -> [f32; 4] {
        match self {
            TargetFormat::Rgba16F => [1.0; 4],
            // Six kernels on top of each other, at most 2600 K.
            TargetFormat::Rgba8 => [6.0, 6.0 * 2.6, 6.0, 6.0],
        }
    }

    /// The same for the combustion model, whose kernels sum up to about 1:
    /// weight, weight × kK, soot, burning [1/s].
    pub(crate) const fn gas_range(self) -> [f32; 4] {
        match self {
            TargetFormat::Rgba16F => [1.0; 4],
            TargetFormat::Rgba8 => [1.25, 1.25 * 2.6, 1.0, 4.0],
        }
    }

    /// Largest radiance that is kept before the tone map, which shows
    /// everything above it as nearly white.
    pub(crate) const fn light_range(self) -> f32 {
        match self {
            TargetFormat::Rgba16F => 1.0,
            TargetFormat::Rgba8 => 24.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_bits_hold_the_hottest_gas_wherever_they_hold_its_weight() {
        let [weight, heat, ..] = TargetFormat::Rgba8.field_range();
        let hottest = crate::constants::HOTTEST / 1000.0;
        // The mean temperature is heat / weight, so heat must not saturate first.
        assert!(heat >= weight * hottest * 0.999);
    }

    #[test]
    fn one_particle_is_visible_in_eight_bits() {
        for range in TargetFormat::Rgba8.field_range() {
            assert!(255.0 / range >= 10.0, "less than ten levels");
        }
    }
}

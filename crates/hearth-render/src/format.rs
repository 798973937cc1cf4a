//! The format of the targets.
//!
//! Half floats if the browser can render to them; never full floats, which phones cannot blend.
//! Otherwise eight bits store scaled values, with visible steps.

use crate::gl::Graphics;

/// Format of the off-screen targets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetFormat {
    /// Half floats.
    Rgba16F,
    /// Eight bits from 0 to 1 with scaled values.
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

    /// Name in statistics.
    pub const fn name(self) -> &'static str {
        match self {
            TargetFormat::Rgba16F => "rgba16f",
            TargetFormat::Rgba8 => "rgba8",
        }
    }

    /// Internal format and type of the channels.
    pub(crate) const fn constants(self) -> (u32, u32) {
        match self {
            TargetFormat::Rgba16F => (glow::RGBA16F, glow::HALF_FLOAT),
            TargetFormat::Rgba8 => (glow::RGBA8, glow::UNSIGNED_BYTE),
        }
    }

    /// Maximum of each value of the classic model's field: weight, weight × kK, glow, smoke. The
    /// splat divides by it, readers multiply by it.
    pub(crate) const fn field_range(self) -> [f32; 4] {
        match self {
            TargetFormat::Rgba16F => [1.0; 4],
            // Six overlapping kernels of at most 2600 K.
            TargetFormat::Rgba8 => [6.0, 6.0 * 2.6, 6.0, 6.0],
        }
    }

    /// The same of the combustion model, whose kernels sum to about 1: weight, weight × kK, soot,
    /// burning [1/s].
    pub(crate) const fn gas_range(self) -> [f32; 4] {
        match self {
            TargetFormat::Rgba16F => [1.0; 4],
            TargetFormat::Rgba8 => [1.25, 1.25 * 2.6, 1.0, 1.5],
        }
    }

    /// Whether targets store the square root of the light, which resolves dark light but does not blend.
    pub(crate) const fn is_rooted(self) -> bool {
        matches!(self, TargetFormat::Rgba8)
    }

    /// 1 / the maximum radiance of a target that stores its root; 0 for one that stores the light.
    pub(crate) const fn light_scale(self) -> f32 {
        if self.is_rooted() {
            1.0 / self.light_range()
        } else {
            0.0
        }
    }

    /// Maximum radiance before tone mapping. The tone map shows a higher one as nearly white.
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
    fn in_eight_bits_the_weight_saturates_before_the_heat() {
        let [weight, heat, ..] = TargetFormat::Rgba8.field_range();
        let hottest = crate::constants::HOTTEST_KELVIN / 1000.0;
        // The mean temperature is heat / weight.
        assert!(heat >= weight * hottest * 0.999);
    }

    #[test]
    fn a_single_particle_is_visible_in_eight_bits() {
        for range in TargetFormat::Rgba8.field_range() {
            assert!(255.0 / range >= 10.0, "less than ten levels");
        }
    }
}

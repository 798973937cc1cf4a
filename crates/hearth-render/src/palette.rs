//! Colours of the fire by temperature.
//!
//! Soot glows as a black body. Other palettes interpolate between a cool and a hot hue and
//! multiply by the brightness of a black body of the same temperature, so that exposure and
//! luminance exponent have the same effect in every palette.

use hearth_core::Parameters;
use hearth_core::params::{Colour, Palette};

use crate::blackbody::{self, NEUTRAL_KELVIN};
use crate::constants::{COLOUR_ENTRIES, COOLEST_KELVIN, HOTTEST_KELVIN};

/// Temperatures of a palette's cool and hot hue \[K\].
const COOL_KELVIN: f32 = 1000.0;
const HOT_KELVIN: f32 = 1900.0;
/// Shares of a channel and of its saturated value in the pale colour, and the channel value that
/// saturates to one half.
const PALE_SHARES: [f32; 2] = [0.35, 0.65];
const PALE_HALF: f32 = 0.03;
/// Temperature whose hue is that of the light as a whole \[K\]: the mean of displayed light, in which dim gas counts more
/// than in the sum of radiances.
const GLOW_KELVIN: f32 = 1600.0;
/// Colour to which overexposed soot pales, linear.
const PALE_SOOT: [f32; 3] = [1.0, 0.92, 0.66];

/// All values that a table of colours depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tint {
    palette: Palette,
    /// Cool and hot colour of the custom palette; transparent for other palettes.
    ends: [Colour; 2],
    /// White balance of the camera \[K\].
    white: f32,
}

impl Tint {
    /// The tint that parameters select.
    pub fn of(parameters: &Parameters) -> Tint {
        let palette = parameters.palette;
        let ends = match palette {
            Palette::Custom => [parameters.cool_colour, parameters.hot_colour],
            _ => [Colour::TRANSPARENT; 2],
        };
        let white = parameters.white_balance;
        Tint {
            palette,
            ends,
            white,
        }
    }

    fn is_black_body(self) -> bool {
        self.palette == Palette::Blackbody
    }

    /// Linear sRGB of the cool and the hot hue. The hues are those of the emission lines (Gaydon,
    /// *The Spectroscopy of Flames*, 1974): CH at 431 nm and C₂ at 473 and 516 nm in gas; CuCl
    /// at 430–530 nm and CuOH at 537 and 547 nm; Li at 671 and 610 nm. Hot hues are paler.
    fn hues(self) -> [[f32; 3]; 2] {
        match self.palette {
            Palette::Blackbody | Palette::Gas => [[0.07, 0.13, 1.0], [0.30, 0.62, 1.0]],
            Palette::Copper => [[0.01, 0.42, 0.22], [0.30, 1.0, 0.42]],
            Palette::Lithium => [[0.75, 0.0, 0.05], [1.0, 0.13, 0.24]],
            Palette::Ghost => [[0.16, 0.46, 0.70], [0.62, 1.0, 0.86]],
            Palette::Custom => self.ends.map(linear),
        }
    }

    /// The colour to which overexposed light pales, in linear sRGB; and 1 if it pales by way of
    /// yellow, as soot does, or 0.
    pub fn pale(self) -> ([f32; 3], f32) {
        if self.is_black_body() {
            return (PALE_SOOT, 1.0);
        }
        let [_, hot] = self.hues();
        let pale =
            |channel| PALE_SHARES[0] * channel + PALE_SHARES[1] * channel / (channel + PALE_HALF);
        (hot.map(pale), 0.0)
    }

    /// The colour of the light as a whole, in sRGB.
    fn glow(self) -> [u8; 3] {
        if self.palette == Palette::Custom {
            let [r, g, b, _] = self.ends[1].rgba;
            return [r, g, b];
        }
        let span = (HOTTEST_KELVIN - COOLEST_KELVIN) / (COLOUR_ENTRIES - 1) as f32;
        let entry = ((GLOW_KELVIN - COOLEST_KELVIN) / span).round() as usize;
        let [r, g, b, _] = self.row()[entry];
        let peak = r.max(g).max(b);
        [r, g, b].map(|channel| (255.0 * encoded(channel / peak)).round() as u8)
    }

    /// The colour table as two rows of texels: that of the gas, and that of solids, which glow as a black body in every
    /// palette.
    pub fn table(self) -> Vec<[f32; 4]> {
        [self.row(), blackbody::table(self.white.into())].concat()
    }

    /// The row of the gas: chroma and ln(luminance), as [`blackbody::table`]. A camera adapts to a black body alone:
    /// other palettes keep their hues.
    fn row(self) -> Vec<[f32; 4]> {
        let white = if self.is_black_body() {
            self.white.into()
        } else {
            NEUTRAL_KELVIN
        };
        let mut table = blackbody::table(white);
        if !self.is_black_body() {
            let [cool, hot] = self.hues();
            let span = (HOTTEST_KELVIN - COOLEST_KELVIN) / (COLOUR_ENTRIES - 1) as f32;
            for (entry, texel) in table.iter_mut().enumerate() {
                let kelvin = COOLEST_KELVIN + span * entry as f32;
                let share = ((kelvin - COOL_KELVIN) / (HOT_KELVIN - COOL_KELVIN)).clamp(0.0, 1.0);
                // Red is the black body's brightest channel.
                let peak = texel[0];
                for (channel, (cool, hot)) in texel.iter_mut().zip(cool.into_iter().zip(hot)) {
                    *channel = peak * (cool + share * (hot - cool));
                }
            }
        }
        table
    }
}

/// The colour of a fire's light as a whole, as `#rrggbb`.
pub fn light_colour(parameters: &Parameters) -> String {
    let [r, g, b] = Tint::of(parameters).glow();
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// The colour to which overexposed light pales, in linear sRGB, and 1 if it pales by way of yellow, or 0.
pub fn pale(parameters: &Parameters) -> [f32; 4] {
    let ([r, g, b], yellow) = Tint::of(parameters).pale();
    [r, g, b, yellow]
}

/// The sRGB encoding, by the square roots of `shaders/colour.glsl`.
fn encoded(linear: f32) -> f32 {
    let second = linear.sqrt();
    let fourth = second.sqrt();
    let power = 0.6620 * second + 0.6841 * fourth - 0.3236 * fourth.sqrt() - 0.0225 * linear;
    if linear < 0.003_130_8 {
        12.92 * linear
    } else {
        power
    }
}

/// Linear sRGB of a colour, times its alpha. A cubic decodes sRGB.
fn linear(colour: Colour) -> [f32; 3] {
    let [r, g, b, a] = colour.rgba.map(|channel| f32::from(channel) / 255.0);
    [r, g, b].map(|c| a * c * (0.0125 + c * (0.6822 + c * 0.3053)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::{Choice, Input, Model};

    fn tint(palette: &str) -> Tint {
        let mut parameters = Parameters::new(Model::Combustion);
        let set = parameters.set("palette", Input::Text(palette));
        assert_eq!(set, Ok(()));
        Tint::of(&parameters)
    }

    #[test]
    fn brightness_increases_with_temperature_in_every_palette() {
        for name in Palette::NAMES {
            let table = tint(name).row();
            let exponent = Parameters::default().luminance_exponent;
            let peaks: Vec<f32> = table
                .iter()
                .map(|[r, g, b, ln]| r.max(*g).max(*b) * (exponent * ln).exp())
                .collect();
            assert!(peaks.is_sorted(), "{name}: {peaks:?}");
        }
    }

    #[test]
    fn each_palette_has_its_hue() {
        let middle = |name: &str| {
            let table = tint(name).row();
            let [r, g, b, _] = table[COLOUR_ENTRIES / 2];
            [r, g, b]
        };
        let [r, g, b] = middle("gas");
        assert!(b > g && g > r, "gas is blue");
        let [r, g, b] = middle("copper");
        assert!(g > b && b > r, "copper is green");
        let [r, g, b] = middle("lithium");
        assert!(r > b && b > g, "lithium is crimson");
        let [r, g, b] = middle("ghost");
        assert!(g > r && b > r && r > 0.2 * g, "a ghost is pale");
    }

    #[test]
    fn the_custom_palette_goes_from_one_colour_to_the_other() {
        let mut parameters = Parameters::new(Model::Combustion);
        let values = [
            ("palette", "custom"),
            ("cool_colour", "#0000ff"),
            ("hot_colour", "#ff8000"),
        ];
        let set = parameters.set_all(values.map(|(id, text)| (id, Input::Text(text))));
        assert_eq!(set, Ok(()));
        let table = Tint::of(&parameters).row();
        let [first, last] = [table[0], table[COLOUR_ENTRIES - 1]];
        assert!(first[0] == 0.0 && first[1] == 0.0 && first[2] > 0.0);
        assert_eq!(last[2], 0.0);
        // sRGB 128 is 0.216 of linear 1.
        assert!((last[1] / last[0] - 0.216).abs() < 0.005, "{last:?}");
    }

    #[test]
    fn the_white_balance_adapts_a_black_body_and_no_other_palette() {
        let balanced = |palette: &str, kelvin| {
            let mut parameters = Parameters::new(Model::Combustion);
            let set = parameters.set("white_balance", Input::Number(kelvin));
            assert_eq!(set, Ok(()));
            assert_eq!(parameters.set("palette", Input::Text(palette)), Ok(()));
            Tint::of(&parameters)
        };
        assert_eq!(balanced("blackbody", 6500.0).glow(), [255, 111, 0]);
        let [_, _, blue] = balanced("blackbody", 2600.0).glow();
        assert!(blue > 60, "{blue}");
        for palette in ["gas", "copper", "lithium", "ghost", "custom"] {
            let [warm, neutral] = [2600.0, 6500.0].map(|kelvin| balanced(palette, kelvin));
            assert_eq!(warm.row(), neutral.row(), "{palette}");
            assert_eq!(warm.glow(), neutral.glow(), "{palette}");
            // Glowing solids are adapted.
            assert_ne!(warm.table(), neutral.table(), "{palette}");
        }
    }

    #[test]
    fn the_glow_of_a_custom_palette_is_its_hot_colour() {
        let mut parameters = Parameters::new(Model::Combustion);
        let values = [("palette", "custom"), ("hot_colour", "#12ab34")];
        let set = parameters.set_all(values.map(|(id, text)| (id, Input::Text(text))));
        assert_eq!(set, Ok(()));
        assert_eq!(Tint::of(&parameters).glow(), [0x12, 0xab, 0x34]);
    }

    #[test]
    fn decoding_follows_the_srgb_standard() {
        for value in 0..=255_u8 {
            let [decoded, ..] = linear(Colour::rgb(value, 0, 0));
            let encoded = f32::from(value) / 255.0;
            let exact = if encoded <= 0.040_45 {
                encoded / 12.92
            } else {
                ((encoded + 0.055) / 1.055).powf(2.4)
            };
            assert!((decoded - exact).abs() < 0.002, "{value}");
        }
    }
}

//! A frame: all that its passes know of the fire, the picture and the camera.

use hearth_core::params::{Backdrop, Colour, DisplayMode, Layers, Model};
use hearth_core::{Parameters, Source};

use crate::bounds::ParticleBounds;
use crate::format::TargetFormat;
use crate::kernel::Kernel;
use crate::motion::Motion;
use crate::resolution::Layout;
use crate::viewport::Viewport;

/// Brightness of a flame of 1500 K at an exposure of 0.
const GAIN: f32 = 2.0;
/// How far glow reaches, in texels of its widest copy.
const HALO: f32 = 3.5;
/// Smallest radius of a kernel in texels: a narrower one would flicker as it moves.
const TEXELS: f32 = 1.5;
/// How far above the foot of the fire the wall meets the floor, in heights of the domain.
const BEHIND: f32 = 0.1;
/// Highest foot of the fire that the floor reaches, in heights of the domain.
const HIGHEST: f32 = 0.6;

/// One frame.
pub struct Frame<'a> {
    /// Physics and look.
    pub parameters: &'a Parameters,
    /// Where the fire stands.
    pub source: Source,
    /// Sizes of the targets.
    pub layout: Layout,
    /// Pixels of the targets.
    pub format: TargetFormat,
    /// Where the world stands in the picture.
    pub viewport: Viewport,
    /// Seconds of fire.
    pub time: f64,
    /// Number of particles.
    pub particles: usize,
    /// Number of embers.
    pub embers: usize,
    /// How far the fine structure has come, and the scale of what is measured.
    pub motion: Motion,
    /// Kernels of the particles, at least as wide as texels can show.
    pub kernel: Kernel,
    /// The part of the field target that this frame uses.
    pub used: [u32; 2],
    /// What the fire without its glow can reach: left, lower, right, upper edge \[m\].
    pub reach: [f32; 4],
    /// Whether the backdrop is to be drawn again.
    pub scenery_is_stale: bool,
}

impl<'a> Frame<'a> {
    /// The frame of so many particles and embers within their bounds.
    pub fn new(
        parameters: &'a Parameters,
        (layout, format): (Layout, TargetFormat),
        (viewport, time): (Viewport, f64),
        ([particles, embers], bounds): ([usize; 2], &ParticleBounds),
        motion: Motion,
    ) -> Frame<'a> {
        let source = Source::of(parameters);
        let kernel = Kernel::of(parameters, &source);
        let used = layout.used_field(particles, kernel.radius, viewport.metres[1]);
        let mut frame = Frame {
            parameters,
            source,
            layout,
            format,
            viewport,
            time,
            particles,
            embers,
            motion,
            kernel,
            used,
            reach: [0.0; 4],
            scenery_is_stale: true,
        };
        frame.kernel.radius = frame.resolved(kernel.radius, used[1]);
        frame.reach = bounds.widened(kernel.margin.max(frame.kernel.radius));
        frame
    }

    /// Whether it is of that display mode.
    pub fn shows(&self, mode: DisplayMode) -> bool {
        self.parameters.display_mode == mode
    }

    /// Whether it shows the fire of that model.
    pub fn burns_as(&self, model: Model) -> bool {
        self.shows(DisplayMode::Fire) && self.parameters.model() == model
    }

    /// Whether it shows a quantity of the gas as a field.
    pub fn shows_quantity(&self) -> bool {
        !matches!(
            self.parameters.display_mode,
            DisplayMode::Fire
                | DisplayMode::Paper
                | DisplayMode::Sprites
                | DisplayMode::Particles
                | DisplayMode::Neighbours
        )
    }

    /// Whether its gas carries noise along. Eight bits are too few for that; there, the noise
    /// rises as a whole.
    pub fn carries_noise(&self) -> bool {
        self.burns_as(Model::Combustion) && self.format == TargetFormat::Rgba16F
    }

    /// Whether the fire burns in front of a backdrop of its own.
    pub fn has_backdrop(&self) -> bool {
        self.shows(DisplayMode::Fire) && self.parameters.backdrop == Backdrop::Bricks
    }

    /// Whether light is blurred: for its glow, or to light a backdrop.
    pub fn blooms(&self) -> bool {
        self.has_backdrop() || self.shows(DisplayMode::Fire) && self.parameters.bloom > 0.0
    }

    /// The widest level of the bloom.
    pub fn widest_blur(&self) -> usize {
        self.layout.limits.sharper_shares.len()
    }

    /// A radius that a target of so many lines can show \[m\].
    pub fn resolved(&self, radius: f32, lines: u32) -> f32 {
        radius.max(TEXELS * self.viewport.metres[1] / lines as f32)
    }

    /// Size of a pixel \[m\].
    pub fn pixel(&self) -> f32 {
        self.viewport.metres[1] / self.layout.picture[1] as f32
    }

    /// Share of the field target that is used.
    pub fn field_used(&self) -> [f32; 2] {
        self.field_share(0.0)
    }

    /// Largest coordinate in that part: the middle of its last texel.
    pub fn field_edge(&self) -> [f32; 2] {
        self.field_share(0.5)
    }

    #[inline(never)]
    fn field_share(&self, inset: f32) -> [f32; 2] {
        let whole = self.layout.field;
        [0, 1].map(|axis| (self.used[axis] as f32 - inset) / whole[axis] as f32)
    }

    /// What the field target's range took of each value.
    pub fn field_range(&self) -> [f32; 4] {
        match self.parameters.model() {
            Model::Classic => self.format.field_range(),
            Model::Combustion => self.format.gas_range(),
        }
    }

    /// What the fire and its glow can reach \[m\]: the glow ends a few texels of its widest copy
    /// away from the fire.
    pub fn halo(&self) -> [f32; 4] {
        let lines = self.layout.blurs()[self.widest_blur()][1];
        let halo = HALO * self.viewport.metres[1] / lines as f32;
        let [left, lower, right, upper] = self.reach;
        [left - halo, lower - halo, right + halo, upper + halo]
    }

    /// Brightness of gas of 1500 K.
    pub fn gain(&self) -> f32 {
        GAIN * doubled(self.parameters.exposure)
    }

    /// 1 if fire is seen, or 0.
    pub fn fire_share(&self) -> f32 {
        f32::from(self.parameters.layers != Layers::Smoke)
    }

    /// How strongly smoke hides, if it is seen.
    pub fn smoke_opacity(&self) -> f32 {
        match self.parameters.layers {
            Layers::Fire => 0.0,
            Layers::Both | Layers::Smoke => self.parameters.smoke_opacity,
        }
    }

    /// The measured quantity of the first colour, and 1 / the span to the last one.
    pub fn span(&self) -> [f32; 2] {
        let [min, max] = self
            .motion
            .scale
            .ends()
            .map_or([0.0, 1.0], |(_, ends)| ends);
        [min, 1.0 / (max - min)]
    }

    /// 1 if the middle of the measured span is zero, or 0.
    pub fn two_sided(&self) -> f32 {
        let quantity = self.parameters.display_mode.quantity();
        f32::from(quantity.is_some_and(|quantity| quantity.signed))
    }

    /// Where the wall of the backdrop meets the floor, in heights of the domain: the fire stands
    /// on the floor, a little in front of the wall.
    pub fn wall_foot(&self) -> f32 {
        (self.source.base.y / self.parameters.domain_height).min(HIGHEST) + BEHIND
    }
}

/// Two to the power of `times`.
pub fn doubled(times: f32) -> f32 {
    libm::expf(times * std::f32::consts::LN_2)
}

/// `tiles` without whole hundreds: the noise repeats, also where a shader reads it at a multiple
/// of 0.01 of that place, and a small number keeps its digits however long a fire burns.
pub fn wrapped(tiles: f64) -> f32 {
    (tiles - 100.0 * (tiles / 100.0).floor()) as f32
}

/// The background as the picture holds it: premultiplied sRGB.
pub fn background(colour: Colour) -> [f32; 4] {
    let [r, g, b, a] = colour.rgba.map(|channel| f32::from(channel) / 255.0);
    [r * a, g * a, b * a, a]
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::Input;

    #[test]
    fn one_step_of_exposure_doubles_the_light() {
        let gain = |exposure| {
            let mut parameters = Parameters::new(Model::Classic);
            assert_eq!(parameters.set("exposure", Input::Number(exposure)), Ok(()));
            doubled(parameters.exposure)
        };
        assert!((gain(1.0) / gain(0.0) - 2.0).abs() < 1e-6);
    }

    #[test]
    fn a_background_is_premultiplied() {
        let behind = Colour {
            rgba: [255, 128, 0, 51],
        };
        let [r, g, b, a] = background(behind);
        assert!(r <= a && g <= a && b == 0.0);
        assert!((a - 0.2).abs() < 1e-6 && (r - 0.2).abs() < 1e-6);
        assert_eq!(background(Colour::TRANSPARENT), [0.0; 4]);
    }
}

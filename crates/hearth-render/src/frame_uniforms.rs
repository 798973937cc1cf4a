//! What the uniforms of all passes of a frame follow from: the fire, the picture and the camera.

use hearth_core::params::{Colour, DisplayMode, Edges, Layers, Model, Palette};
use hearth_core::{Parameters, SourcePlace};

use crate::advection::Phase;
use crate::bounds::Bounds;
use crate::constants::MAX_SOURCES;
use crate::format::TargetFormat;
use crate::kernel::Kernel;
use crate::resolution::Layout;
use crate::scale::Scale;
use crate::slices::Slice;
use crate::viewport::Viewport;

/// Brightness of gas of 1500 K at an exposure of 0, in the classic and the combustion model, whose slices share the light.
const CLASSIC_GAIN: f32 = 2.0;
const COMBUSTION_GAIN: f32 = 2.64;
/// Reach of the glow in texels of its widest copy.
const HALO_TEXELS: f32 = 3.5;
/// Minimum radius of a kernel in texels. Narrower kernels flicker as they move.
const MIN_KERNEL_TEXELS: f32 = 1.5;
/// Particles that a pass draws.
#[derive(Clone, Copy, Debug, Default)]
pub struct Batch {
    /// Number of particles.
    pub count: usize,
    /// First row of a sample of the history; `None` for the present particles.
    pub row: Option<u32>,
    /// Time from the sample to the moment that is drawn \[s\].
    pub ahead: f32,
    /// Weight of the sample.
    pub share: f32,
    /// Unit of volumes \[m²\].
    pub unit: f32,
    /// One of so many particles is drawn, with that weight.
    pub stride: usize,
}

impl Batch {
    /// The present particles.
    pub fn present(count: usize) -> Batch {
        Batch {
            count,
            row: None,
            ahead: 0.0,
            share: 1.0,
            unit: 1.0,
            stride: 1,
        }
    }
}

/// How far the noise is advected in a pass.
#[derive(Clone, Copy, Debug, Default)]
pub struct Advected {
    /// Time of advection \[s\].
    pub elapsed: f32,
    /// For each pattern: 0 if it restarts, else 1.
    pub kept: [f32; 2],
    /// Index of the newer of the two targets.
    pub newest: usize,
}

/// What the uniforms of a frame follow from.
#[derive(Clone)]
pub struct FrameUniforms<'a> {
    /// Parameters of physics and look.
    pub parameters: &'a Parameters,
    /// Temperature at which particles of the classic model are born \[K\].
    pub birth_temperature: f32,
    /// Position of the fire: of its first source.
    pub source: SourcePlace,
    /// Middle of the lower edge and width of each source \[m\], and 1 if its flame begins at every height of it.
    pub sources: &'a [[f32; 4]],
    /// Sizes of the targets.
    pub layout: Layout,
    /// Format of the targets.
    pub format: TargetFormat,
    /// Position of the world in the picture.
    pub viewport: Viewport,
    /// Position of the world when the noise was last advected.
    pub before: Viewport,
    /// Age of the fire \[s\].
    pub time: f64,
    /// The particles.
    pub particles: Batch,
    /// Number of embers.
    pub embers: usize,
    /// Number of solids.
    pub solids: usize,
    /// Number of the first of them that are drawn with the lit wall.
    pub cladding: usize,
    /// The slice.
    pub slice: Slice,
    /// Phase of the advected patterns.
    pub phase: Phase,
    /// Advection of the noise.
    pub advected: Advected,
    /// Distance that the gas has risen \[m\].
    pub risen: f64,
    /// Height of the flame above the source \[m\].
    pub flame_height: f32,
    /// The colour scale.
    pub scale: Scale,
    /// Kernels of the particles, at least as wide as the texels resolve.
    pub kernel: Kernel,
    /// Size of the used part of the field \[texels\].
    pub used: [u32; 2],
    /// Bounds of the fire without its glow.
    pub reach: Bounds,
    /// Bounds of the slices behind the front one, if there are any.
    pub behind: Option<Bounds>,
    /// Whether the picture is an atlas of [sheets](crate::View::sheets).
    pub sheets: bool,
    /// Whether the backdrop is drawn again.
    pub scenery_is_stale: bool,
}

impl<'a> FrameUniforms<'a> {
    /// The same frame with other particles.
    #[inline(never)]
    pub fn with(&self, particles: Batch) -> FrameUniforms<'a> {
        FrameUniforms {
            particles,
            ..self.clone()
        }
    }

    /// Number and places of the sources for the shaders, in the slice.
    pub fn source_places(&self) -> (f32, [f32; 4 * MAX_SOURCES]) {
        let mut places = [0.0; 4 * MAX_SOURCES];
        for (to, place) in places.chunks_exact_mut(4).zip(self.sources) {
            to.copy_from_slice(place);
            to[0] += self.slice.shift;
        }
        (self.sources.len().min(MAX_SOURCES) as f32, places)
    }

    /// Fits the kernels, the used part of the field and the reach to the bounds of the gas.
    pub fn fit(&mut self, bounds: &Bounds) {
        let height = self.viewport.metres[1];
        let (count, behind) = (self.particles.count, self.slice.index > 0);
        self.used = self
            .layout
            .used_field(count, self.kernel.radius, height, behind);
        self.kernel.radius = self.resolved(self.kernel.radius, self.used[1]);
        // The light of gas with soot is where its kernels are, though displaced gas is read there.
        let displaced = if self.burns_as(Model::Combustion) && !self.is_premixed() {
            0.0
        } else {
            self.kernel.margin
        };
        self.reach = Bounds::around(&[*bounds], displaced.max(self.kernel.radius));
    }

    /// Whether the display mode is `mode`.
    pub fn shows(&self, mode: DisplayMode) -> bool {
        self.parameters.display_mode == mode
    }

    /// Whether it shows a fire of `model`.
    pub fn burns_as(&self, model: Model) -> bool {
        self.shows(DisplayMode::Fire) && self.parameters.model() == model
    }

    /// Whether the gas ends at the edges of the domain. Open air reaches beyond the picture.
    pub fn is_closed(&self) -> bool {
        let parameters = self.parameters;
        parameters.model() == Model::Classic || parameters.edges == Edges::Periodic
    }

    /// Whether its gas was mixed with air before it burns, and shines without soot.
    pub fn is_premixed(&self) -> bool {
        self.parameters.palette == Palette::Gas && self.parameters.roundness > 0.0
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

    /// Whether the gas advects the noise. Eight bits are too few for the offsets: with them the
    /// noise only rises.
    pub fn advects_noise(&self) -> bool {
        self.burns_as(Model::Combustion) && self.format == TargetFormat::Rgba16F
    }

    /// Whether it shows solids in the light of the fire.
    pub fn lights_solids(&self) -> bool {
        self.shows(DisplayMode::Fire) && self.solids > 0
    }

    /// Whether the light is blurred, for its glow or for the irradiance on a backdrop and on solids.
    pub fn blooms(&self) -> bool {
        self.has_backdrop()
            || self.sheets
            || self.lights_solids()
            || self.shows(DisplayMode::Fire)
                && (self.parameters.bloom > 0.0 || self.smoke_opacity() > 0.0)
    }

    /// Level of the widest copy of the bloom.
    pub fn widest_blur(&self) -> usize {
        self.layout.limits.sharper_shares.len()
    }

    /// At least the minimum radius that a target with that number of lines resolves \[m\].
    pub fn resolved(&self, radius: f32, lines: u32) -> f32 {
        radius.max(MIN_KERNEL_TEXELS * self.viewport.metres[1] / lines as f32)
    }

    /// Size of a pixel \[m\].
    pub fn pixel(&self) -> f32 {
        self.texel(self.layout.picture)
    }

    /// Size of a texel of a target of that size \[m\].
    pub fn texel(&self, [_, lines]: [u32; 2]) -> f32 {
        self.viewport.metres[1] / lines as f32
    }

    /// Used share of the field.
    pub fn field_used(&self) -> [f32; 2] {
        self.field_share(0.0)
    }

    /// Maximum coordinate of that share: the middle of its last texel.
    pub fn field_edge(&self) -> [f32; 2] {
        self.field_share(0.5)
    }

    fn field_share(&self, inset: f32) -> [f32; 2] {
        let whole = self.layout.field;
        [0, 1].map(|axis| (self.used[axis] as f32 - inset) / whole[axis] as f32)
    }

    /// Range of each value of the field.
    pub fn field_range(&self) -> [f32; 4] {
        match self.parameters.model() {
            Model::Classic => self.format.field_range(),
            Model::Combustion => self.format.gas_range(),
        }
    }

    /// Bounds of the fire and its glow. The glow ends a few texels of its widest copy away
    /// from the fire.
    pub fn halo(&self) -> Bounds {
        let lines = self.layout.blurs()[self.widest_blur()][1];
        let halo = HALO_TEXELS * self.viewport.metres[1] / lines as f32;
        Bounds::around(&[self.reach], halo)
    }

    /// Brightness of gas of 1500 K.
    pub fn gain(&self) -> f32 {
        let base = match self.parameters.model() {
            Model::Classic => CLASSIC_GAIN,
            Model::Combustion => COMBUSTION_GAIN,
        };
        base * exp2(self.parameters.exposure)
    }

    /// 1 if the fire is visible, or 0.
    pub fn fire_share(&self) -> f32 {
        f32::from(self.parameters.layers != Layers::Smoke)
    }

    /// Opacity of the smoke; 0 if it is not visible.
    pub fn smoke_opacity(&self) -> f32 {
        match self.parameters.layers {
            Layers::Fire => 0.0,
            Layers::Both | Layers::Smoke => self.parameters.smoke_opacity,
        }
    }

    /// Quantity of the first colour, and 1 / span to the last.
    pub fn span(&self) -> [f32; 2] {
        let [min, max] = self.scale.ends().map_or([0.0, 1.0], |(_, ends)| ends);
        [min, 1.0 / (max - min)]
    }

    /// 1 if the middle of the colour scale is zero, or 0.
    pub fn two_sided(&self) -> f32 {
        let quantity = self.parameters.display_mode.quantity();
        f32::from(quantity.is_some_and(|quantity| quantity.signed))
    }
}

/// Two to the power of `exponent`.
pub fn exp2(exponent: f32) -> f32 {
    libm::expf(exponent * std::f32::consts::LN_2)
}

/// `tiles` modulo 100. The noise repeats, also at multiples of 0.01 of a coordinate, and a small
/// number keeps its precision during a long fire.
pub fn wrapped(tiles: f64) -> f32 {
    (tiles - 100.0 * (tiles / 100.0).floor()) as f32
}

/// The background in the format of the picture: premultiplied sRGB.
pub fn background(colour: Colour) -> [f32; 4] {
    let [r, g, b, a] = colour.rgba.map(|channel| f32::from(channel) / 255.0);
    [r * a, g * a, b * a, a]
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::Input;

    #[test]
    fn an_exposure_step_doubles_the_light() {
        let gain = |exposure| {
            let mut parameters = Parameters::new(Model::Classic);
            assert_eq!(parameters.set("exposure", Input::Number(exposure)), Ok(()));
            exp2(parameters.exposure)
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

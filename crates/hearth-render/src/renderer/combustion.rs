//! The combustion model's passes: gas to fields, noise that it carries along,
//! flames and embers to light.

use hearth_core::{Parameters, Source};

use super::fire::{Body, Fire, RADII_PER_LENGTH, peak};
use super::{NOTHING, fire_share, gain, smoke_opacity, table_coordinates, without_hundreds};
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::noise;
use crate::passes::Pass;
use crate::target::bind;

/// Brightness beside that of the classic model: this gas is hotter.
const BRIGHTNESS: f32 = 0.34;
/// Optical depth of gas with a soot of 1.
const OPTICAL_DEPTH: f32 = 3.0;
/// Optical depth of cold gas with a soot of 1, at a smoke opacity of 1.
const SMOKE: f32 = 14.0;
/// How far fine structure moves the gas, as a share of its size.
const WARP: f32 = 0.5;
/// Levels of the noise that are left out beyond those that texels cannot show.
const SHARPNESS: f32 = 0.5;
/// Longest time of exposure, for the way of an ember \[s\].
const EXPOSURE: f32 = 0.008;
/// How far above a floor that is seen gas ends softly, at most, in heights of the domain.
const SOFT: f32 = 0.04;
/// How much brighter an ember shines than gas: it is solid.
const EMBER: f32 = 12.0;

/// Kernels as wide as those that moved the gas.
pub(super) fn body(parameters: &Parameters) -> Body {
    let radius = RADII_PER_LENGTH * parameters.smoothing_length();
    let grain = (0.3 * Source::of(parameters).width).max(2.5 * parameters.spacing());
    Body {
        radius,
        grain,
        margin: radius + 2.0 * parameters.detail * WARP * grain,
    }
}

/// How long the gas carries a pattern of noise \[s\]: as long as it takes to rise
/// by a few source widths.
pub(super) fn period(parameters: &Parameters) -> f32 {
    Source::of(parameters).width.sqrt().clamp(0.25, 1.5) * 0.75
}

impl<G: Graphics> Fire<'_, G> {
    /// Gas to fields and to velocities: sums of smooth kernels.
    pub(super) fn gas(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            ..
        } = *self;
        let program = renderer.studio.passes.activate(gl, Pass::Gas);
        program.set(gl, "world", self.place.to_clip());
        gl.enable(glow::BLEND);
        gl.blend_func(glow::ONE, glow::ONE);
        let fields = renderer.studio.format.gas_range().map(|range| 1.0 / range);
        let passes = [
            (&targets.field, self.used, fields),
            (&targets.flow, targets.flow.size(), [1.0; 4]),
        ];
        let carries = renderer.studio.format == TargetFormat::Rgba16F;
        for (pass, (target, used, scale)) in passes.into_iter().enumerate() {
            if pass > 0 && !carries {
                break;
            }
            target.draw_here(gl, used);
            gl.clear(NOTHING);
            // A kernel narrower than the texels would flicker as it moves.
            let texel = self.place.metres[1] / used[1] as f32;
            let radius = self.body.radius.max(1.5 * texel);
            let peak = peak(radius);
            program.set(gl, "kernel", [radius, peak, pass as f32, 0.0]);
            program.set(gl, "scale", scale);
            renderer.particles.draw(gl, program);
        }
        gl.disable(glow::BLEND);
    }

    /// Velocities to how far they have carried the noise. Eight bits are too
    /// few for that; there the noise rises as a whole.
    pub(super) fn drift(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            ..
        } = *self;
        let [before, now] = [1 - renderer.newest, renderer.newest].map(|k| &targets.drift[k]);
        if renderer.studio.format == TargetFormat::Rgba8 {
            now.draw_here(gl, now.size());
            gl.clear(NOTHING);
            return;
        }
        let program = renderer.studio.passes.activate(gl, Pass::Drift);
        let [width, height] = self.place.metres;
        let elapsed = renderer.motion.drift.elapsed;
        let [a, b] = renderer.motion.drift.kept;
        program.set(gl, "carried", [elapsed / width, elapsed / height, a, b]);
        targets.flow.read_here(gl, 0);
        before.read_here(gl, 1);
        // All of it: where no fire was drawn before, some may be in the next picture.
        self.fill(now);
    }

    /// Fields to light.
    pub(super) fn flame(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            place,
            parameters,
            ..
        } = *self;
        let [width, height] = place.metres;
        let program = renderer.studio.passes.activate(gl, Pass::Flame);
        targets.light.draw_here(gl, targets.light.size());
        gl.clear(NOTHING);
        let source = Source::of(parameters);
        program.set(gl, "view", [width, height, source.foot.y, source.width]);
        program.set(gl, "origin", place.origin(source.foot.x));
        program.set(gl, "part", self.part());
        program.set(gl, "range", renderer.studio.format.gas_range());
        // Tongues are taller than wide. The tile repeats, also where the shader
        // reads it twice as fine, so whole hundreds make no difference.
        let tiles = [1.15, 0.75].map(|share| share / (noise::CELLS as f32 * self.body.grain));
        let risen = match renderer.studio.format {
            TargetFormat::Rgba16F => 0.0,
            TargetFormat::Rgba8 => {
                without_hundreds(renderer.motion.rise.distance * f64::from(tiles[1]))
            }
        };
        let warp = parameters.detail * WARP * self.body.grain;
        program.set(gl, "grain", [tiles[0], tiles[1], warp, parameters.detail]);
        program.set(gl, "start", renderer.motion.drift.places());
        let [a, b] = renderer.motion.drift.shares();
        let level = (noise::SIZE as f32).log2() + SHARPNESS;
        program.set(gl, "seen", [a, b, level, risen]);
        program.set(
            gl,
            "matter",
            [
                OPTICAL_DEPTH,
                SMOKE * smoke_opacity(parameters),
                parameters.ambient_temperature * 1e-3,
                1.0 / parameters.domain_width,
            ],
        );
        // Where the floor is seen, what is at it ends softly, and below the source.
        let [_, below] = place.shows_beyond();
        let mut shine = self.shine(BRIGHTNESS);
        let soft = (source.foot.y / parameters.domain_height).clamp(1e-3, SOFT);
        shine[3] = if below { 1.0 / soft } else { 1e6 };
        program.set(gl, "shine", shine);
        program.set(gl, "table", table_coordinates(fire_share(parameters)));
        targets.field.read_here(gl, 0);
        targets.drift[renderer.newest].read_here(gl, 1);
        bind(gl, 2, &renderer.studio.noise);
        bind(gl, 3, renderer.colours());
        self.cover(place.rectangle(self.reach, targets.light.size()));
    }

    /// Embers to light, behind the flame: in front of it they would be dots.
    pub(super) fn embers(&self) {
        let Fire { gl, renderer, .. } = *self;
        let program = renderer.studio.passes.activate(gl, Pass::Ember);
        program.set(gl, "world", self.place.to_clip());
        let texel = self.place.metres[1] / self.targets.light.size()[1] as f32;
        program.set(gl, "spark", [1.2 * texel, EXPOSURE, 0.0, 0.0]);
        program.set(gl, "shine", self.shine(EMBER));
        program.set(gl, "table", table_coordinates(1.0));
        bind(gl, 1, renderer.colours());
        gl.enable(glow::BLEND);
        gl.blend_func(glow::ONE_MINUS_DST_ALPHA, glow::ONE);
        renderer.embers.draw(gl, program);
        gl.disable(glow::BLEND);
    }

    /// What makes light of a temperature, times `brightness`.
    fn shine(&self, brightness: f32) -> [f32; 4] {
        [
            self.parameters.luminance_exponent,
            brightness * gain(self.parameters),
            1.0 / self.renderer.studio.format.light_range(),
            0.0,
        ]
    }
}

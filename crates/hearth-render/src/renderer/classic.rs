//! The classic model's passes: particles to fields to light.

use hearth_core::{Parameters, Source};

use super::fire::{Body, Fire};
use super::{NOTHING, fire_share, gain, smoke_opacity, table_coordinates, without_hundreds};
use crate::gl::Graphics;
use crate::noise;
use crate::passes::Pass;
use crate::target::bind;

/// A kernel is drawn out by the way that its particle moves in this time \[s\].
const STRETCH: f32 = 0.02;
/// Optical depth of the glow in the middle of one kernel.
const OPTICAL_DEPTH: f32 = 2.6;
/// Weight of the air that cools thin gas, in kernels.
const AIR: f32 = 0.6;
/// Optical depth of the smoke in the middle of one kernel, at a smoke opacity of 1.
const SMOKE: f32 = 2.2;
/// How far fine structure moves the gas, as a share of its size.
const WARP: f32 = 0.6;

/// The diameter of a kernel at half its height is 1.08 of its radius; this
/// radius makes that diameter the particle's size.
const RADII_PER_SIZE: f32 = 0.92;
/// The farthest that a drawn-out, widened kernel reaches, in its radii.
const REACH: f32 = 2.3;

/// Kernels that overlap at a place inside undisturbed gas where a kernel weighs 1.
const OVERLAP: f32 = 3.6;

/// What a kernel weighs. Small or few particles weigh more, so that the fire
/// keeps its body, but not so much more that their size makes no difference.
fn kernel_weight(radius: f32, parameters: &Parameters) -> f32 {
    let per_area = parameters.rest_density / parameters.particle_mass;
    // The kernel (1 − q²)² covers a third of its circle.
    let overlap = per_area * std::f32::consts::PI / 3.0 * radius * radius;
    (OVERLAP / overlap).sqrt().clamp(0.1, 4.0)
}

/// Kernels as wide as the particles.
pub(super) fn body(parameters: &Parameters) -> Body {
    let radius = RADII_PER_SIZE * parameters.particle_size;
    let grain = (0.35 * Source::of(parameters).width).max(parameters.particle_size);
    Body {
        radius,
        grain,
        margin: REACH * radius + 2.0 * parameters.detail * WARP * grain,
    }
}

impl<G: Graphics> Fire<'_, G> {
    /// Particles to fields: sums of smooth kernels.
    pub(super) fn splat(&self) {
        let Fire { gl, renderer, .. } = *self;
        let program = renderer.studio.passes.activate(gl, Pass::Splat);
        self.targets.field.draw_here(gl, self.used);
        gl.clear(NOTHING);
        program.set(gl, "world", self.place.to_clip());
        let weight = kernel_weight(self.body.radius, self.parameters);
        program.set(gl, "kernel", [self.body.radius, STRETCH, weight, 0.0]);
        let scale = renderer
            .studio
            .format
            .field_range()
            .map(|range| 1.0 / range);
        program.set(gl, "scale", scale);
        gl.enable(glow::BLEND);
        gl.blend_func(glow::ONE, glow::ONE);
        renderer.particles.draw(gl, program);
        gl.disable(glow::BLEND);
    }

    /// Fields to their view from farther away.
    pub(super) fn spread(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            ..
        } = *self;
        let program = renderer.studio.passes.activate(gl, Pass::Spread);
        let [width, height] = targets.field.size().map(|side| side as f32);
        let [across, up] = self.used.map(|side| side as f32);
        // Five reads each way span six radii of a kernel.
        let texels = 1.0 * self.body.radius / self.place.metres[1] * up;
        let reads = [texels / width, texels / height, across / width, up / height];
        program.set(gl, "reads", reads);
        targets.field.read_here(gl, 0);
        self.fill(&targets.wide);
    }

    /// Fields to light.
    pub(super) fn shade(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            place,
            parameters,
            ..
        } = *self;
        let [width, height] = place.metres;
        let program = renderer.studio.passes.activate(gl, Pass::Shade);
        targets.light.draw_here(gl, targets.light.size());
        gl.clear(NOTHING);

        let source = Source::of(parameters);
        let flame = renderer
            .motion
            .rise
            .flame_height(source.foot.y)
            .max(2.0 * self.body.grain);
        program.set(gl, "view", [width, height, source.foot.y, 1.0 / flame]);
        program.set(gl, "origin", place.origin(source.foot.x));
        program.set(gl, "part", self.part());
        program.set(gl, "range", renderer.studio.format.field_range());
        // The tile repeats, also where the shader scrolls it at 0.62 and 1.05
        // of the speed, so whole hundreds make no difference, and what the
        // shader gets stays small, however long the fire burns.
        let tiles = 1.0 / (noise::CELLS as f32 * self.body.grain);
        let risen = without_hundreds(renderer.motion.rise.distance * f64::from(tiles));
        let warp = parameters.detail * WARP * self.body.grain;
        program.set(gl, "rise", [tiles, risen, warp, parameters.detail]);
        program.set(
            gl,
            "matter",
            [
                OPTICAL_DEPTH,
                AIR,
                parameters.ambient_temperature * 1e-3,
                SMOKE * smoke_opacity(parameters),
            ],
        );
        program.set(
            gl,
            "shine",
            [
                parameters.luminance_exponent,
                gain(parameters),
                1.0 / renderer.studio.format.light_range(),
                2.0 / source.width,
            ],
        );
        let mut table = table_coordinates(fire_share(parameters));
        // Gas leaves at the top; where that is seen, it ends softly.
        let [above, _] = place.shows_beyond();
        table[3] = f32::from(above);
        program.set(gl, "table", table);
        targets.field.read_here(gl, 0);
        targets.wide.read_here(gl, 1);
        bind(gl, 2, &renderer.studio.noise);
        bind(gl, 3, renderer.colours());
        self.cover(self.place.rectangle(self.reach, targets.light.size()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::Model;

    #[test]
    fn larger_particles_weigh_less_but_cover_more() {
        let parameters = Parameters::new(Model::Classic);
        let body = |size: f32| {
            let radius = RADII_PER_SIZE * size;
            kernel_weight(radius, &parameters) * radius * radius
        };
        let sizes = [0.01, 0.02, 0.04, 0.08, 0.1];
        for pair in sizes.windows(2) {
            assert!(kernel_weight(pair[1], &parameters) < kernel_weight(pair[0], &parameters));
            assert!(body(pair[1]) > body(pair[0]));
        }
    }
}

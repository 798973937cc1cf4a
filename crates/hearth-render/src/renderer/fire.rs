//! The fire's own passes: fields, light, glow, picture.

use hearth_core::Parameters;

use super::{Renderer, background, clear_picture, gain, table_coordinates};
use crate::gl::Gl;
use crate::layout::{BLURS, Place, Rectangle};
use crate::noise;
use crate::target::{Target, bind};
use crate::targets::Targets;

/// The diameter of a kernel at half its height is 1.08 of its radius; this
/// radius makes that diameter the particle's size.
const RADII_PER_SIZE: f32 = 0.92;
/// A kernel is drawn out by the way that its particle moves in this time \[s\].
const STRETCH: f32 = 0.02;
/// The farthest that a drawn-out, widened kernel reaches, in its radii.
const REACH: f32 = 2.3;
/// Optical depth of the glow in the middle of one kernel.
const OPTICAL_DEPTH: f32 = 2.6;
/// Weight of the air that cools thin gas, in kernels.
const AIR: f32 = 0.6;
/// Optical depth of the smoke in the middle of one kernel, at a smoke opacity of 1.
const SMOKE: f32 = 2.2;
/// How far fine structure moves the gas, as a share of its size.
const WARP: f32 = 0.6;
/// How much of the next sharper copy joins a blurred one.
const SHARPER: f32 = 0.4;
/// How far glow reaches, in texels of its widest copy.
const HALO: f32 = 3.5;

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

/// Width of what of the source is inside the domain \[m\].
fn source_width(parameters: &Parameters) -> f32 {
    parameters.source_width.min(parameters.domain_width)
}

/// One frame of fire.
pub struct Fire<'a> {
    gl: Gl<'a>,
    renderer: &'a Renderer,
    targets: &'a Targets,
    place: Place,
    parameters: &'a Parameters,
    /// Radius of a kernel \[m\].
    radius: f32,
    /// Size of the broadest fine structure \[m\].
    grain: f32,
    /// The part of the field target that is used.
    used: [u32; 2],
    /// What the fire, but not its glow, can reach \[m\].
    reach: [f32; 4],
}

impl<'a> Fire<'a> {
    /// Works out what the passes have in common.
    pub fn new(
        gl: Gl<'a>,
        renderer: &'a Renderer,
        targets: &'a Targets,
        place: Place,
        parameters: &'a Parameters,
    ) -> Fire<'a> {
        let radius = RADII_PER_SIZE * parameters.particle_size;
        let used = targets
            .layout
            .used_field(renderer.particles.count(), radius, place.metres[1]);
        // A kernel narrower than the texels would flicker as it moves.
        let radius = radius.max(1.5 * place.metres[1] / used[1] as f32);
        let grain = (0.35 * source_width(parameters)).max(parameters.particle_size);
        let margin = REACH * radius + 2.0 * parameters.detail * WARP * grain;
        let [left, lower, right, upper] = renderer.survey.bounds;
        Fire {
            gl,
            renderer,
            targets,
            place,
            parameters,
            radius,
            grain,
            used,
            reach: [
                left - margin,
                lower - margin,
                right + margin,
                upper + margin,
            ],
        }
    }

    /// Particles to fields: sums of smooth kernels.
    pub fn splat(&self) {
        let Fire { gl, renderer, .. } = *self;
        let program = &renderer.passes.splat;
        self.targets.field.draw_here(gl, self.used);
        gl.clear_color(0.0, 0.0, 0.0, 0.0);
        gl.clear(glow::COLOR_BUFFER_BIT);
        program.activate(gl);
        program.set(gl, "world", self.place.to_clip());
        let weight = kernel_weight(self.radius, self.parameters);
        program.set(gl, "kernel", [self.radius, STRETCH, weight, 0.0]);
        let scale = renderer.format.field_range().map(|range| 1.0 / range);
        program.set(gl, "scale", scale);
        gl.enable(glow::BLEND);
        gl.blend_func(glow::ONE, glow::ONE);
        renderer.particles.draw(gl, program);
        gl.disable(glow::BLEND);
    }

    /// Fields to their view from farther away.
    pub fn spread(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            ..
        } = *self;
        let program = &renderer.passes.spread;
        program.activate(gl);
        let [width, height] = targets.field.size().map(|side| side as f32);
        let [across, up] = self.used.map(|side| side as f32);
        // Five reads each way span six radii of a kernel.
        let texels = 1.0 * self.radius / self.place.metres[1] * up;
        let step = [texels / width, texels / height, across / width, up / height];
        program.set(gl, "step", step);
        targets.field.read_here(gl, 0);
        self.fill(&targets.wide);
    }

    /// Fields to light.
    pub fn shade(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            place,
            parameters,
            ..
        } = *self;
        let [width, height] = place.metres;
        let program = &renderer.passes.shade;
        targets.light.draw_here(gl, targets.light.size());
        gl.clear(glow::COLOR_BUFFER_BIT);
        program.activate(gl);

        let flame = renderer
            .rise
            .flame_height(parameters.source_height)
            .max(2.0 * self.grain);
        program.set(
            gl,
            "view",
            [width, height, parameters.source_height, 1.0 / flame],
        );
        let whole = targets.field.size();
        let share = |axis: usize, inset: f32| (self.used[axis] as f32 - inset) / whole[axis] as f32;
        program.set(
            gl,
            "part",
            [share(0, 0.0), share(1, 0.0), share(0, 0.5), share(1, 0.5)],
        );
        program.set(gl, "range", renderer.format.field_range());
        // The tile repeats, also where the shader scrolls it at 0.62 and 1.05
        // of the speed, so whole hundreds make no difference, and what the
        // shader gets stays small, however long the fire burns.
        let tiles = 1.0 / (noise::CELLS as f32 * self.grain);
        let risen = (renderer.rise.distance * f64::from(tiles)).rem_euclid(100.0) as f32;
        let warp = parameters.detail * WARP * self.grain;
        program.set(gl, "rise", [tiles, risen, warp, parameters.detail]);
        program.set(
            gl,
            "matter",
            [
                OPTICAL_DEPTH,
                AIR,
                parameters.ambient_temperature * 1e-3,
                SMOKE * parameters.smoke_opacity,
            ],
        );
        program.set(
            gl,
            "shine",
            [
                parameters.luminance_exponent,
                gain(parameters),
                1.0 / renderer.format.light_range(),
                2.0 / source_width(parameters),
            ],
        );
        program.set(gl, "table", table_coordinates());
        targets.field.read_here(gl, 0);
        targets.wide.read_here(gl, 1);
        bind(gl, 2, renderer.noise);
        bind(gl, 3, renderer.black_body);
        self.cover(self.place.rectangle(self.reach, targets.light.size()));
    }

    /// Light to glow: ever wider copies, joined again into one.
    pub fn blur(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            ..
        } = *self;
        let texel = |size: [u32; 2]| size.map(|side| 1.0 / side as f32);
        let program = &renderer.passes.shrink;
        program.activate(gl);
        let mut source = &targets.light;
        for blur in &targets.blurs {
            let [x, y] = texel(source.size());
            program.set(gl, "texel", [x, y, 0.0, 0.0]);
            source.read_here(gl, 0);
            self.fill(blur);
            source = blur;
        }
        let program = &renderer.passes.widen;
        program.activate(gl);
        for (narrow, joined) in targets.blurs.iter().zip(&targets.joined).rev() {
            let [x, y] = texel(source.size());
            program.set(gl, "texel", [x, y, SHARPER, 0.0]);
            source.read_here(gl, 0);
            narrow.read_here(gl, 1);
            self.fill(joined);
            source = joined;
        }
    }

    /// Light and glow to colours as displayed.
    pub fn develop(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            parameters,
            ..
        } = *self;
        let program = &renderer.passes.develop;
        let range = renderer.format.light_range();
        program.activate(gl);
        // Encoded as for the screen: roughly a square root.
        let soot = parameters.exposure.min(0.0).exp2().sqrt();
        program.set(gl, "strength", [range, range * parameters.bloom, soot, 0.0]);
        targets.light.read_here(gl, 0);
        targets.joined[0].read_here(gl, 1);
        targets.shown.draw_here(gl, targets.shown.size());
        gl.clear_color(0.0, 0.0, 0.0, 0.0);
        gl.clear(glow::COLOR_BUFFER_BIT);
        self.cover(self.place.rectangle(self.halo(), targets.shown.size()));
    }

    /// Colours to the picture, in front of its background.
    pub fn present(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            parameters,
            ..
        } = *self;
        clear_picture(gl, targets.layout, parameters.background);
        let program = &renderer.passes.present;
        program.activate(gl);
        program.set(gl, "background", background(parameters.background));
        targets.shown.read_here(gl, 0);
        self.cover(self.place.rectangle(self.halo(), targets.layout.picture));
    }

    /// What the fire and its glow can reach \[m\]: the glow ends a few texels of
    /// its widest copy away from the fire.
    fn halo(&self) -> [f32; 4] {
        let lines = self.targets.blurs[BLURS - 1].size()[1] as f32;
        let halo = HALO * self.place.metres[1] / lines;
        let [left, lower, right, upper] = self.reach;
        [left - halo, lower - halo, right + halo, upper + halo]
    }

    /// Covers a whole target.
    fn fill(&self, target: &Target) {
        target.draw_here(self.gl, target.size());
        self.gl.draw_arrays(glow::TRIANGLES, 0, 3);
    }

    /// Covers a part of the current target.
    fn cover(&self, part: Rectangle) {
        let gl = self.gl;
        if part.width == 0 || part.height == 0 {
            return;
        }
        gl.enable(glow::SCISSOR_TEST);
        gl.scissor(part.x, part.y, part.width, part.height);
        gl.draw_arrays(glow::TRIANGLES, 0, 3);
        gl.disable(glow::SCISSOR_TEST);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn larger_particles_weigh_less_but_cover_more() {
        let parameters = Parameters::default();
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

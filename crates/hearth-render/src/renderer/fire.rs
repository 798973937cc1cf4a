//! What the fires of both models have in common: a frame, and its passes from
//! light to picture.

use hearth_core::Parameters;
use hearth_core::params::{Layers, Model};

use super::{NOTHING, Renderer, background, classic, clear_picture, combustion, doubled};
use crate::camera::{Place, Rectangle};
use crate::gl::Graphics;
use crate::palette::Tint;
use crate::passes::Pass;
use crate::target::Target;
use crate::targets::Targets;

/// Radius of a kernel (1 − q²)² that blurs as much as the cubic spline of the
/// same smoothing length, in smoothing lengths.
pub const RADII_PER_LENGTH: f32 = 1.6;
/// How much more light falls on smoke where it is alone.
const SOFTLY: f32 = 1.6;
/// How much more of the glow there is where smoke scatters it.
const SCATTERED: f32 = 4.0;
/// How far glow reaches, in texels of its widest copy.
const HALO: f32 = 3.5;

/// Value of that kernel in its middle, for it to add up to 1 over its disc.
pub fn peak(radius: f32) -> f32 {
    3.0 / (std::f32::consts::PI * radius * radius)
}

/// How a model's particles become fields.
#[derive(Clone, Copy)]
pub struct Body {
    /// Radius of a kernel \[m\].
    pub radius: f32,
    /// Size of the broadest fine structure \[m\].
    pub grain: f32,
    /// How far from a particle's place it can be seen, but for its glow \[m\].
    pub margin: f32,
}

/// One frame of fire.
pub struct Fire<'a, G: Graphics> {
    pub gl: &'a G,
    pub renderer: &'a Renderer<G>,
    pub targets: &'a Targets<G>,
    pub place: Place,
    pub parameters: &'a Parameters,
    pub body: Body,
    /// The part of the field target that is used.
    pub used: [u32; 2],
    /// What the fire, but not its glow, can reach \[m\].
    pub reach: [f32; 4],
}

impl<'a, G: Graphics> Fire<'a, G> {
    /// Works out what the passes have in common.
    pub fn new(
        gl: &'a G,
        renderer: &'a Renderer<G>,
        targets: &'a Targets<G>,
        place: Place,
        parameters: &'a Parameters,
    ) -> Fire<'a, G> {
        let mut body = match parameters.model() {
            Model::Classic => classic::body(parameters),
            Model::Combustion => combustion::body(parameters),
        };
        let used =
            targets
                .layout
                .used_field(renderer.particles.count(), body.radius, place.metres[1]);
        // A kernel narrower than the texels would flicker as it moves.
        body.radius = body.radius.max(1.5 * place.metres[1] / used[1] as f32);
        let margin = body.margin;
        let [left, lower, right, upper] = renderer.survey.bounds;
        Fire {
            gl,
            renderer,
            targets,
            place,
            parameters,
            body,
            used,
            reach: [
                left - margin,
                lower - margin,
                right + margin,
                upper + margin,
            ],
        }
    }

    /// Draws it, pass by pass.
    pub fn paint(&self, watch: &mut dyn FnMut(&'static str)) {
        let mut draw = |pass, draw: fn(&Self)| {
            draw(self);
            watch(pass);
        };
        match self.parameters.model() {
            Model::Classic => {
                draw("splat", Fire::splat);
                draw("spread", Fire::spread);
                draw("shade", Fire::shade);
            }
            Model::Combustion => {
                draw("gas", Fire::gas);
                draw("drift", Fire::drift);
                draw("flame", Fire::flame);
                if self.parameters.layers != Layers::Smoke {
                    draw("ember", Fire::embers);
                }
            }
        }
        let scenery = self.renderer.scenery.as_ref();
        if self.parameters.bloom > 0.0 || scenery.is_some() {
            draw("bloom", Fire::blur);
        }
        draw("develop", Fire::develop);
        match scenery {
            Some(scenery) => {
                self.present_before(scenery);
                watch("backdrop");
            }
            None => draw("present", Fire::present),
        }
    }

    /// The used part of the field target, and the largest coordinate in it.
    pub(super) fn part(&self) -> [f32; 4] {
        let whole = self.targets.field.size();
        let share = |axis: usize, inset: f32| (self.used[axis] as f32 - inset) / whole[axis] as f32;
        [share(0, 0.0), share(1, 0.0), share(0, 0.5), share(1, 0.5)]
    }

    /// What the field target's range took of each field.
    pub(super) fn field_range(&self) -> [f32; 4] {
        let format = self.renderer.studio.format;
        match self.parameters.model() {
            Model::Classic => format.field_range(),
            Model::Combustion => format.gas_range(),
        }
    }

    /// Light to glow: ever wider copies, joined again into one.
    fn blur(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            ..
        } = *self;
        let texel = |size: [u32; 2]| size.map(|side| 1.0 / side as f32);
        let program = renderer.studio.passes.activate(gl, Pass::Shrink);
        let mut source = &targets.light;
        for blur in &targets.blurs {
            let [x, y] = texel(blur.size());
            program.set(gl, "texel", [x, y, 0.0, 0.0]);
            source.read_here(gl, 0);
            self.fill(blur);
            source = blur;
        }
        let program = renderer.studio.passes.activate(gl, Pass::Widen);
        let pairs = targets.blurs.iter().zip(&targets.joined).rev();
        for ((narrow, joined), &share) in pairs.zip(targets.layout.fine.sharper) {
            let [x, y] = texel(source.size());
            program.set(gl, "texel", [x, y, share, 0.0]);
            source.read_here(gl, 0);
            narrow.read_here(gl, 1);
            self.fill(joined);
            source = joined;
        }
    }

    /// Light and glow to colours as displayed.
    fn develop(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            parameters,
            ..
        } = *self;
        let program = renderer.studio.passes.activate(gl, Pass::Develop);
        let range = renderer.studio.format.light_range();
        // Encoded as for the screen: roughly a square root.
        let mut soot = doubled(parameters.exposure.min(0.0)).sqrt();
        if parameters.layers == Layers::Smoke {
            soot *= SOFTLY;
        }
        let scattered = match parameters.model() {
            Model::Classic => 0.0,
            Model::Combustion => SCATTERED,
        };
        program.set(
            gl,
            "strength",
            [range, range * parameters.bloom, soot, scattered],
        );
        program.set(gl, "pale", Tint::of(parameters).pale());
        targets.light.read_here(gl, 0);
        targets.joined[0].read_here(gl, 1);
        targets.shown.draw_here(gl, targets.shown.size());
        gl.clear(NOTHING);
        self.cover(self.place.rectangle(self.halo(), targets.shown.size()));
    }

    /// Colours to the picture, in front of its background.
    pub(super) fn present(&self) {
        let Fire {
            gl,
            renderer,
            targets,
            parameters,
            ..
        } = *self;
        clear_picture(gl, targets.layout, parameters.background);
        let program = renderer.studio.passes.activate(gl, Pass::Present);
        program.set(gl, "background", background(parameters.background));
        targets.shown.read_here(gl, 0);
        self.cover(self.place.rectangle(self.halo(), targets.layout.picture));
    }

    /// What the fire and its glow can reach \[m\]: the glow ends a few texels of
    /// its widest copy away from the fire.
    fn halo(&self) -> [f32; 4] {
        let lines = self.targets.blurs.last().map_or(1, |blur| blur.size()[1]);
        let halo = HALO * self.place.metres[1] / lines as f32;
        let [left, lower, right, upper] = self.reach;
        [left - halo, lower - halo, right + halo, upper + halo]
    }

    /// Covers a whole target.
    #[inline(never)]
    pub fn fill(&self, target: &Target<G>) {
        target.draw_here(self.gl, target.size());
        self.gl.draw_triangle();
    }

    /// Covers a part of the current target.
    #[inline(never)]
    pub fn cover(&self, part: Rectangle) {
        let gl = self.gl;
        if part.width == 0 || part.height == 0 {
            return;
        }
        gl.enable(glow::SCISSOR_TEST);
        gl.scissor(part.x, part.y, part.width, part.height);
        gl.draw_triangle();
        gl.disable(glow::SCISSOR_TEST);
    }
}

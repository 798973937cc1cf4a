//! Display modes that are neither fire nor paper: a quantity of the gas as a field or
//! as discs, by colours; and sprites with a texture.

use hearth_core::params::{DisplayMode, Model};

use super::fire::{Fire, RADII_PER_LENGTH, peak};
use super::{NOTHING, clear_picture, gain, table_coordinates};
use crate::gl::Graphics;
use crate::palette::Tint;
use crate::passes::Pass;
use crate::program::Program;
use crate::target::bind;

/// Largest weight of gas, which a target of eight bits holds as one.
const MOST: f32 = 1.5;
/// Weight of gas that covers what is behind it: of a particle alone, for gas whose
/// rim is nothing but particles, and at the edge of a domain that is full.
const ALONE: f32 = 0.65;
const AT_AN_EDGE: f32 = 0.45;
/// Diameter of a disc in spacings.
const DISC: f32 = 0.8;
/// Radius of a sprite: in sizes of the classic model's particles, and in spacings.
const SIZES: f32 = 1.6;
const SPACINGS: f32 = 4.0;
/// Opacity of a sprite, and how much life, or soot, there must be for that.
const OF_LIFE: [f32; 2] = [0.45, 0.25];
const OF_SOOT: [f32; 2] = [0.9, 0.3];
/// Brightness of one, beside that of a fire's gas: many lie over each other.
const BRIGHTNESS: f32 = 0.16;
/// Seconds in which a sprite turns once, on average.
const TURN: f64 = 9.0;

impl<G: Graphics> Fire<'_, G> {
    /// Draws what the display mode shows at `time`, pass by pass.
    pub fn display(&mut self, time: f64, watch: &mut dyn FnMut(&'static str)) {
        let parameters = self.parameters;
        match parameters.display_mode {
            DisplayMode::Sprites => {
                let (radius, opacity) = match parameters.model() {
                    Model::Classic => (SIZES * parameters.particle_size, OF_LIFE),
                    Model::Combustion => (SPACINGS * parameters.spacing(), OF_SOOT),
                };
                self.reach_out(radius);
                self.sprites(opacity, time);
                watch("sprites");
                self.present();
                watch("present");
            }
            DisplayMode::Particles | DisplayMode::Neighbours => {
                self.discs();
                watch("discs");
            }
            _ => {
                self.reach_out(RADII_PER_LENGTH * parameters.smoothing_length());
                self.gather();
                watch("gather");
                self.chart();
                watch("chart");
            }
        }
    }

    /// Lets particles reach so far \[m\], if texels can show it.
    #[inline(never)]
    fn reach_out(&mut self, radius: f32) {
        let (height, count) = (self.place.metres[1], self.renderer.particles.count());
        self.used = self.targets.layout.used_field(count, radius, height);
        let radius = radius.max(1.5 * height / self.used[1] as f32);
        let [left, lower, right, upper] = self.renderer.survey.bounds;
        self.reach = [
            left - radius,
            lower - radius,
            right + radius,
            upper + radius,
        ];
        self.body.radius = radius;
    }

    /// The program of that pass, which knows what the colours stand for.
    #[inline(never)]
    fn measuring(&self, pass: Pass) -> &Program<G> {
        let Fire {
            gl,
            renderer,
            parameters,
            ..
        } = *self;
        let program = renderer.studio.passes.activate(gl, pass);
        let [least, most] = renderer.scale().map_or([0.0, 1.0], |(_, ends)| ends);
        let quantity = parameters.display_mode.quantity();
        let signed = f32::from(quantity.is_some_and(|quantity| quantity.signed));
        let solid = match parameters.model() {
            Model::Classic => ALONE,
            Model::Combustion => AT_AN_EDGE,
        };
        let span = [least, 1.0 / (most - least), signed, MOST / solid];
        program.set(gl, "span", span);
        program
    }

    /// Adds a quad for each particle; what is behind it stays as far as `kept` says.
    #[inline(never)]
    fn add(&self, program: &Program<G>, kept: u32) {
        let gl = self.gl;
        program.set(gl, "world", self.place.to_clip());
        gl.enable(glow::BLEND);
        gl.blend_func(glow::ONE, kept);
        self.renderer.particles.draw(gl, program);
        gl.disable(glow::BLEND);
    }

    /// Particles to sums of smooth kernels.
    fn gather(&self) {
        let gl = self.gl;
        let program = self.measuring(Pass::Gather);
        self.targets.field.draw_here(gl, self.used);
        gl.clear(NOTHING);
        let radius = self.body.radius;
        program.set(gl, "kernel", [radius, peak(radius) / MOST, 1.0, 0.0]);
        self.add(program, glow::ONE);
    }

    /// These to colours.
    fn chart(&self) {
        let Fire { gl, targets, .. } = *self;
        clear_picture(gl, targets.layout, self.parameters.background);
        let program = self.measuring(Pass::Chart);
        program.set(gl, "part", self.part());
        let width = self.place.metres[0];
        let edge = 0.5 * self.parameters.domain_width / width;
        let middle = self.place.floor[0];
        program.set(gl, "edge", [edge, width / self.body.radius, middle, 0.0]);
        targets.field.read_here(gl, 0);
        gl.enable(glow::BLEND);
        gl.blend_func(glow::ONE, glow::ONE_MINUS_SRC_ALPHA);
        self.cover(self.place.rectangle(self.reach, targets.layout.picture));
        gl.disable(glow::BLEND);
    }

    /// Particles to discs.
    fn discs(&self) {
        let Fire { gl, targets, .. } = *self;
        clear_picture(gl, targets.layout, self.parameters.background);
        let program = self.measuring(Pass::Disc);
        let pixel = self.place.metres[1] / targets.layout.picture[1] as f32;
        let pixels = (0.5 * DISC * self.parameters.spacing() / pixel).max(1.0);
        let kernel = [pixels * pixel, 0.0, 1.0 + 1.0 / pixels, pixels];
        program.set(gl, "kernel", kernel);
        self.add(program, glow::ONE_MINUS_SRC_ALPHA);
    }

    /// Particles to sprites.
    fn sprites(&self, [opacity, full]: [f32; 2], time: f64) {
        let Fire {
            gl,
            renderer,
            targets,
            parameters,
            ..
        } = *self;
        let program = renderer.studio.passes.activate(gl, Pass::Sprite);
        targets.shown.draw_here(gl, targets.shown.size());
        gl.clear(NOTHING);
        // Each makes a whole number of half turns to one of this, so two are a period.
        let turns = time / (2.0 * TURN);
        let turns = 2.0 * (turns - turns.floor()) as f32;
        program.set(gl, "sprite", [self.body.radius, turns, opacity, full]);
        let gain = BRIGHTNESS * gain(parameters);
        program.set(gl, "shine", [parameters.luminance_exponent, gain, 0.0, 0.0]);
        program.set(gl, "table", table_coordinates(1.0));
        program.set(gl, "pale", Tint::of(parameters).pale());
        bind(gl, 1, &renderer.studio.noise);
        bind(gl, 2, renderer.colours());
        // Light on light, channel by channel and alpha too: it does not matter which
        // sprite is drawn first, and no colour exceeds its alpha.
        self.add(program, glow::ONE_MINUS_SRC_COLOR);
    }
}

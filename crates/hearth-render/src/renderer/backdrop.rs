//! What the fire burns in front of: a backdrop of its own, which the fire lights and
//! makes shimmer. A page behind it cannot be made to.

use hearth_core::params::Backdrop;
use hearth_core::{Parameters, Source};

use super::fire::Fire;
use super::{Renderer, without_hundreds};
use crate::camera::Place;
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::layout::Layout;
use crate::noise;
use crate::passes::Pass;
use crate::target::{Target, bind};

/// Most lines of the backdrop: it is far away, and drawn once for each size.
const LINES: u32 = 1080;
/// Lines of the light that falls on it, and most columns: each reads all of the fire.
const LAMP: [u32; 2] = [16, 64];
/// How far hot gas bends what is seen through it, as a share of the domain's height.
const BEND: f32 = 0.035;
/// How far above the foot of the fire the wall meets the floor, as such a share.
const BEHIND: f32 = 0.1;
/// Highest foot of the fire that the floor reaches.
const HIGHEST: f32 = 0.6;
/// Waves of the haze in the height of the domain.
const WAVES: f32 = 3.5;

/// A backdrop that is drawn, and the light of the fire on it.
pub struct Scenery<G: Graphics> {
    /// Size of the picture that it is for.
    size: [u32; 2],
    /// How the wall stands that is drawn: its foot, then the picture's floor and size.
    drawn: Option<(f32, [f32; 4])>,
    /// Colours in plain light.
    seen: Target<G>,
    /// The light of the fire.
    lamp: Target<G>,
}

impl<G: Graphics> Scenery<G> {
    /// Room for one, in which nothing is drawn; no side is longer than `most`.
    fn new(
        gl: &G,
        format: TargetFormat,
        size: [u32; 2],
        most: u32,
    ) -> Result<Scenery<G>, RenderError> {
        let [width, height] = size;
        let lines = |lines: u32, columns: u32| {
            let lines = lines.min(height).min(most);
            let across = f64::from(width) * f64::from(lines) / f64::from(height);
            [(across as u32).clamp(1, columns.min(most)), lines]
        };
        let seen = Target::new(gl, "scenery", TargetFormat::Rgba8, lines(LINES, most))?;
        let [rows, columns] = LAMP;
        match Target::new(gl, "lamp", format, lines(rows, columns)) {
            Ok(lamp) => Ok(Scenery {
                size,
                drawn: None,
                seen,
                lamp,
            }),
            Err(error) => {
                seen.destroy(gl);
                Err(error)
            }
        }
    }

    /// Frees it.
    pub fn destroy(&self, gl: &G) {
        self.seen.destroy(gl);
        self.lamp.destroy(gl);
    }
}

/// Where the wall meets the floor, as a share of the domain: the fire stands on the
/// floor, a little in front of the wall.
fn foot(parameters: &Parameters) -> f32 {
    (Source::of(parameters).foot.y / parameters.domain_height).min(HIGHEST) + BEHIND
}

impl<G: Graphics> Renderer<G> {
    /// Draws the backdrop that is asked for, where it is not there yet.
    pub(super) fn fit_scenery(
        &mut self,
        gl: &G,
        layout: Layout,
        place: Place,
        parameters: &Parameters,
    ) -> Result<(), RenderError> {
        let size = layout.picture;
        let wanted = parameters.backdrop == Backdrop::Bricks;
        let old = self.scenery.take();
        let fits = |scenery: &Scenery<G>| wanted && scenery.size == size;
        if let Some(old) = old.as_ref().filter(|old| !fits(old)) {
            old.destroy(gl);
        }
        if !wanted {
            return Ok(());
        }
        let mut scenery = match old.filter(fits) {
            Some(old) => old,
            None => Scenery::new(gl, self.studio.format, size, self.studio.most)?,
        };
        let foot = foot(parameters);
        // The wall is as large as the world is seen.
        let ([x, y], zoom) = (place.floor, place.zoom);
        let origin = [x, y, place.aspect * zoom, zoom];
        if scenery.drawn != Some((foot, origin)) {
            scenery.drawn = Some((foot, origin));
            let program = self.studio.passes.activate(gl, Pass::Scenery);
            program.set(gl, "view", [place.aspect, foot, 0.0, 0.0]);
            program.set(gl, "origin", origin);
            bind(gl, 0, &self.studio.noise);
            scenery.seen.draw_here(gl, scenery.seen.size());
            gl.draw_triangle();
        }
        self.scenery = Some(scenery);
        Ok(())
    }
}

impl<G: Graphics> Fire<'_, G> {
    /// The fire in front of its backdrop, which it lights.
    pub(super) fn present_before(&self, scenery: &Scenery<G>) {
        let Fire {
            gl,
            renderer,
            targets,
            parameters,
            ..
        } = *self;
        let (aspect, zoom) = (self.place.aspect, self.place.zoom);
        let range = renderer.studio.format.light_range();

        let program = renderer.studio.passes.activate(gl, Pass::Lamp);
        let [across, up] = [aspect * zoom, zoom];
        program.set(gl, "view", [across, up, across * up, 0.0]);
        if let Some(widest) = targets.blurs.last() {
            widest.read_here(gl, 0);
        }
        self.fill(&scenery.lamp);

        let program = renderer.studio.passes.activate(gl, Pass::Backdrop);
        let [width, height] = targets.layout.picture;
        gl.bind_framebuffer(None);
        gl.viewport(width as i32, height as i32);
        let risen = renderer.motion.rise.distance / f64::from(self.place.metres[1]);
        let tiles = WAVES * zoom / noise::CELLS as f32;
        let risen = without_hundreds(risen * f64::from(tiles));
        let haze = parameters.heat_haze * BEND / zoom;
        program.set(gl, "haze", [tiles * aspect, tiles, risen, haze]);
        program.set(gl, "part", self.part());
        let [weight, heat, ..] = self.field_range();
        program.set(gl, "range", [weight, heat, range, 0.0]);
        targets.shown.read_here(gl, 0);
        scenery.seen.read_here(gl, 1);
        scenery.lamp.read_here(gl, 2);
        targets.field.read_here(gl, 3);
        bind(gl, 4, &renderer.studio.noise);
        gl.draw_triangle();
    }
}

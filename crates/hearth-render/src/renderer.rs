//! A frame, from particles to pixels.
//!
//! [`Renderer::paint`] reads as the picture is made: fields, light, glow,
//! picture. Only what the fire can reach is drawn; the rest is cleared.

mod backdrop;
mod classic;
mod combustion;
mod display;
mod fire;

use std::rc::Rc;

use hearth_core::Instance;
use hearth_core::Parameters;
use hearth_core::params::{Colour, DisplayMode, Layers, Model};

use crate::blackbody::{COOLEST, ENTRIES, HOTTEST};
use crate::camera::{Camera, Place};
use crate::drift::Drift;
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::layout::{Layout, Lines};
use crate::palette::Tint;
use crate::particles::Particles;
use crate::passes::Pass;
use crate::scale::{Scale, extremes};
use crate::studio::{Studio, colour_table};
use crate::survey::{Rise, Survey};
use crate::target::bind;
use crate::targets::Targets;
use backdrop::Scenery;
use fire::Fire;

/// Brightness of a flame of 1500 K at an exposure of 0.
const GAIN: f32 = 2.0;

/// What of the world is seen, and when.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct View {
    /// Width of the picture in device pixels.
    pub width: u32,
    /// Height of the picture in device pixels.
    pub height: u32,
    /// Seconds of fire, for structure that moves.
    pub time: f64,
    /// Which part of the world it shows.
    pub camera: Camera,
}

/// How far the fine structure has come, and the scale of what is measured. It outlives a renderer, whose context may be
/// lost: the next one goes on from there.
#[derive(Clone, Copy, Debug, Default)]
pub struct Motion {
    rise: Rise,
    drift: Drift,
    scale: Scale,
}

/// How far the gas had carried the fine structure in a picture that stood still: the
/// card's memory forgets it, and the gas does not carry it there again.
pub struct Carried {
    layout: Layout,
    texels: Vec<f32>,
}

/// Draws a fire into the default framebuffer, with premultiplied alpha.
pub struct Renderer<G: Graphics = glow::Context> {
    studio: Rc<Studio<G>>,
    lines: Lines,
    particles: Particles<G>,
    embers: Particles<G>,
    targets: Option<Targets<G>>,
    scenery: Option<Scenery<G>>,
    /// Colours that are not the black body's, which all fires share.
    tinted: Option<(Tint, G::Texture)>,
    survey: Survey,
    motion: Motion,
    carried: Option<Carried>,
    /// How the world was seen in the last picture.
    camera: Option<Camera>,
    /// Which of the two pictures of the drift is the newest.
    newest: usize,
    /// Least and most of what is measured of the particles.
    measured: Option<[f32; 2]>,
}

impl<G: Graphics> Renderer<G> {
    /// A renderer with a studio of its own, for a context with one fire.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture, a buffer or every format.
    pub fn new(gl: &G) -> Result<Renderer<G>, RenderError> {
        Renderer::within(gl, Rc::new(Studio::new(gl)?))
    }

    /// As [`new`](Renderer::new), with a given target format.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture, a buffer or this format.
    pub fn with_format(gl: &G, format: TargetFormat) -> Result<Renderer<G>, RenderError> {
        Renderer::within(gl, Rc::new(Studio::with_format(gl, format)?))
    }

    /// A renderer that shares what it can with others of the same context.
    ///
    /// # Errors
    /// The driver refuses a texture.
    pub fn within(gl: &G, studio: Rc<Studio<G>>) -> Result<Renderer<G>, RenderError> {
        let most = studio.most;
        Ok(Renderer {
            studio,
            lines: Lines::MEDIUM,
            particles: Particles::new(gl, most)?,
            embers: Particles::new(gl, most)?,
            targets: None,
            scenery: None,
            tinted: None,
            survey: Survey::of(&[], &[]),
            motion: Motion::default(),
            carried: None,
            camera: None,
            newest: 0,
            measured: None,
        })
    }

    /// The pixels of the off-screen targets.
    pub fn target_format(&self) -> TargetFormat {
        self.studio.format
    }

    /// How far the fine structure has come.
    pub fn motion(&self) -> Motion {
        self.motion
    }

    /// How far the gas has carried the fine structure, for a fire that stands still:
    /// reading it makes the processor wait for the card.
    pub fn carried(&self, gl: &G) -> Option<Carried> {
        let targets = self.targets.as_ref()?;
        (self.studio.format == TargetFormat::Rgba16F).then(|| Carried {
            layout: targets.layout,
            texels: targets.drift[self.newest].read(gl),
        })
    }

    /// Goes on where another renderer of the same fire was.
    pub fn resume(&mut self, motion: Motion, carried: Option<Carried>) {
        self.motion = motion;
        self.carried = carried;
    }

    /// The display of the last picture, and what its first and its last colour stand
    /// for, in the unit of [`DisplayMode::quantity`]; nothing where that measures nothing.
    pub fn scale(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.motion.scale.ends()
    }

    /// Draws with so many lines from the next picture on.
    pub fn set_lines(&mut self, lines: Lines) {
        self.lines = lines;
    }

    /// Sends the particles, as they are for that display mode, and the embers to the
    /// graphics card.
    pub fn upload(
        &mut self,
        gl: &G,
        mode: DisplayMode,
        instances: &[Instance],
        embers: &[Instance],
    ) {
        self.survey = Survey::of(instances, embers);
        self.measured = mode.quantity().and_then(|_| extremes(instances));
        self.particles.upload(gl, instances);
        self.embers.upload(gl, embers);
    }

    /// Draws the uploaded particles. A picture without a pixel is no trouble.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
    ) -> Result<(), RenderError> {
        self.paint_watched(gl, view, parameters, &mut |_| {})
    }

    /// As [`paint`](Renderer::paint); calls `watch` with the name of each pass
    /// when it has been handed over. The renderer itself never asks the time.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint_watched(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
        watch: &mut dyn FnMut(&'static str),
    ) -> Result<(), RenderError> {
        let size = [view.width, view.height];
        let Some(layout) = Layout::new(size, self.lines, self.studio.most) else {
            return Ok(());
        };
        let domain = [parameters.domain_width, parameters.domain_height];
        let place = Place::new(layout.picture, domain, view.camera);
        // What was carried in another part of the world is of no use in this one.
        if self
            .camera
            .replace(view.camera)
            .is_some_and(|before| before != view.camera)
        {
            self.motion.drift.forget();
        }
        for capability in [
            glow::DEPTH_TEST,
            glow::STENCIL_TEST,
            glow::CULL_FACE,
            glow::BLEND,
            glow::SCISSOR_TEST,
        ] {
            gl.disable(capability);
        }
        gl.bind_vertex_array(Some(&self.studio.nothing));
        let (mode, model) = (parameters.display_mode, parameters.model());
        self.fit_colours(gl, Tint::of(parameters))?;
        self.motion.scale.see(mode, model, self.measured);
        if mode == DisplayMode::Paper {
            self.paper(gl, layout, place, parameters);
            watch("paper");
        } else {
            self.fit_targets(gl, layout)?;
            let burns = mode == DisplayMode::Fire;
            if burns {
                self.fit_scenery(gl, layout, place, parameters)?;
                self.motion.rise.advance(&self.survey, view.time, model);
                self.motion
                    .drift
                    .advance(view.time, combustion::period(parameters));
                self.newest = 1 - self.newest;
            }
            if let Some(targets) = &self.targets {
                let mut fire = Fire::new(gl, self, targets, place, parameters);
                if burns {
                    fire.paint(watch);
                } else {
                    fire.display(view.time, watch);
                }
            }
        }
        gl.bind_vertex_array(None);
        Ok(())
    }

    /// Frees everything, what it shared too if it was the last one.
    pub fn destroy(self, gl: &G) {
        self.particles.destroy(gl);
        self.embers.destroy(gl);
        if let Some(targets) = &self.targets {
            targets.destroy(gl);
        }
        if let Some(scenery) = &self.scenery {
            scenery.destroy(gl);
        }
        if let Some((_, colours)) = &self.tinted {
            gl.delete_texture(colours);
        }
        if let Some(studio) = Rc::into_inner(self.studio) {
            studio.destroy(gl);
        }
    }

    /// The colours of the fire by its temperature.
    fn colours(&self) -> &G::Texture {
        match &self.tinted {
            Some((_, colours)) => colours,
            None => &self.studio.black_body,
        }
    }

    fn fit_colours(&mut self, gl: &G, tint: Tint) -> Result<(), RenderError> {
        if self
            .tinted
            .as_ref()
            .is_some_and(|(drawn, _)| *drawn == tint)
        {
            return Ok(());
        }
        if let Some((_, old)) = self.tinted.take() {
            gl.delete_texture(&old);
        }
        if !tint.is_black_body() {
            self.tinted = Some((tint, colour_table(gl, &tint.table())?));
        }
        Ok(())
    }

    fn fit_targets(&mut self, gl: &G, layout: Layout) -> Result<(), RenderError> {
        if self
            .targets
            .as_ref()
            .is_none_or(|targets| targets.layout != layout)
        {
            // The old ones go first: two sets may not fit a phone's memory.
            if let Some(old) = self.targets.take() {
                old.destroy(gl);
            }
            let targets = Targets::new(gl, self.studio.format, layout)?;
            match self.carried.take() {
                Some(carried) if carried.layout == layout => {
                    for drift in &targets.drift {
                        drift.write(gl, &carried.texels);
                    }
                }
                _ => self.motion.drift.forget(),
            }
            self.targets = Some(targets);
        }
        Ok(())
    }

    /// Draws the particles as the paper does.
    fn paper(&self, gl: &G, layout: Layout, place: Place, parameters: &Parameters) {
        let program = self.studio.passes.activate(gl, Pass::Paper);
        // The classic model's sprites have one size and one colour, as in the
        // paper; gas that burns shows how large and how hot it is.
        let (size, hottest) = match parameters.model() {
            Model::Classic => (
                parameters.particle_size,
                parameters.maximum_temperature * 1e-3,
            ),
            Model::Combustion => (parameters.spacing(), 0.0),
        };
        let radius = 0.5 * size;
        let pixels = radius / place.metres[1] * layout.picture[1] as f32;
        clear_picture(gl, layout, parameters.background);
        program.set(gl, "world", place.to_clip());
        program.set(gl, "sprite", [radius, pixels, 0.0, 0.0]);
        program.set(
            gl,
            "heat",
            [
                hottest,
                parameters.luminance_exponent,
                gain(parameters),
                0.0,
            ],
        );
        program.set(gl, "table", table_coordinates(1.0));
        program.set(gl, "pale", Tint::of(parameters).pale());
        bind(gl, 1, self.colours());
        gl.enable(glow::BLEND);
        gl.blend_func(glow::ONE, glow::ONE_MINUS_SRC_ALPHA);
        self.particles.draw(gl, program);
    }
}

/// Where a temperature in kK stands in the black body's table: scale, offset.
/// The first and the last entry stand in the middle of their texels. Third: how
/// much of the glow is seen.
fn table_coordinates(fire: f32) -> [f32; 4] {
    let entries = ENTRIES as f32;
    let scale = (entries - 1.0) / entries * 1e3 / (HOTTEST - COOLEST);
    [scale, 0.5 / entries - scale * COOLEST * 1e-3, fire, 0.0]
}

/// Two to the power of `times`.
fn doubled(times: f32) -> f32 {
    libm::expf(times * std::f32::consts::LN_2)
}

/// `distance` without whole hundreds, which the noise's tile does not notice.
fn without_hundreds(distance: f64) -> f32 {
    (distance - 100.0 * (distance / 100.0).floor()) as f32
}

/// Brightness of gas of 1500 K.
fn gain(parameters: &Parameters) -> f32 {
    GAIN * doubled(parameters.exposure)
}

/// Whether fire is seen: 1, or 0.
fn fire_share(parameters: &Parameters) -> f32 {
    f32::from(parameters.layers != Layers::Smoke)
}

/// How strongly smoke hides, if it is seen.
fn smoke_opacity(parameters: &Parameters) -> f32 {
    match parameters.layers {
        Layers::Fire => 0.0,
        Layers::Both | Layers::Smoke => parameters.smoke_opacity,
    }
}

/// What stands behind the fire: premultiplied, sRGB.
fn background(colour: Colour) -> [f32; 4] {
    let [r, g, b, a] = colour.rgba.map(|channel| f32::from(channel) / 255.0);
    [r * a, g * a, b * a, a]
}

/// What a target holds where nothing was drawn.
const NOTHING: [f32; 4] = [0.0; 4];

/// Fills the whole picture with what stands behind the fire.
fn clear_picture<G: Graphics>(gl: &G, layout: Layout, behind: Colour) {
    let [width, height] = layout.picture;
    gl.bind_framebuffer(None);
    gl.viewport(width as i32, height as i32);
    gl.clear(background(behind));
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::Model;

    #[test]
    fn the_ends_of_the_black_body_table_are_its_outer_texels() {
        let [scale, offset, ..] = table_coordinates(1.0);
        let half = 0.5 / ENTRIES as f32;
        let at = |kelvin: f32| kelvin * 1e-3 * scale + offset;
        assert!((at(COOLEST) - half).abs() < 1e-5);
        assert!((at(HOTTEST) - (1.0 - half)).abs() < 1e-5);
    }

    #[test]
    fn one_step_of_exposure_doubles_the_light() {
        let mut parameters = Parameters::new(Model::Classic);
        let before = gain(&parameters);
        let set = parameters.set("exposure", hearth_core::params::Input::Number(1.0));
        assert_eq!(set, Ok(()));
        assert!((gain(&parameters) / before - 2.0).abs() < 1e-6);
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

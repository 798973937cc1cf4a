//! A frame, from particles to pixels.
//!
//! [`Renderer::paint`] reads as the picture is made: fields, light, glow,
//! picture. Only what the fire can reach is drawn; the rest is cleared.

mod classic;
mod combustion;
mod fire;

use glow::Context;
use hearth_core::Instance;
use hearth_core::Parameters;
use hearth_core::params::{Colour, DisplayMode, Layers, Model};

use crate::blackbody::{self, COOLEST, ENTRIES, HOTTEST};
use crate::drift::Drift;
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Gl;
use crate::layout::{Layout, Place};
use crate::noise;
use crate::particles::Particles;
use crate::passes::Passes;
use crate::survey::{Rise, Survey};
use crate::target::{Target, bind, texture};
use crate::targets::Targets;
use fire::Fire;

/// Brightness of a flame of 1500 K at an exposure of 0.
const GAIN: f32 = 2.0;

/// What of the world is seen, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Width of the picture in device pixels.
    pub width: u32,
    /// Height of the picture in device pixels.
    pub height: u32,
    /// Seconds of fire, for structure that moves.
    pub time: f64,
}

/// Draws a fire into the default framebuffer, with premultiplied alpha.
pub struct Renderer {
    passes: Passes,
    format: TargetFormat,
    most: u32,
    noise: glow::Texture,
    black_body: glow::Texture,
    particles: Particles,
    embers: Particles,
    /// Without attributes: no pass reads a buffer, whatever else the context holds.
    nothing: glow::VertexArray,
    targets: Option<Targets>,
    survey: Survey,
    rise: Rise,
    drift: Drift,
    /// Which of the two pictures of the drift is the newest.
    newest: usize,
}

impl Renderer {
    /// Compiles every pass and chooses the target format.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture, a buffer or every format.
    pub fn new(gl: &Context) -> Result<Renderer, RenderError> {
        let mut last = RenderError::NoTarget;
        for &format in TargetFormat::candidates(Gl(gl)) {
            match Renderer::with_format(gl, format) {
                Ok(renderer) => return Ok(renderer),
                Err(error) => last = error,
            }
        }
        Err(last)
    }

    /// As [`new`](Renderer::new), with a given target format.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture, a buffer or this format.
    pub fn with_format(gl: &Context, format: TargetFormat) -> Result<Renderer, RenderError> {
        let gl = Gl(gl);
        // Whether a format can be drawn into is known only once it was tried.
        Target::new(gl, "splat", format, [4, 4])?.destroy(gl);
        let refuse = |log| RenderError::Resource { pass: "splat", log };
        let table = blackbody::table();
        let (internal, _) = TargetFormat::Rgba16F.constants();
        let most = gl.get_parameter_i32(glow::MAX_TEXTURE_SIZE).max(1) as u32;
        Ok(Renderer {
            passes: Passes::new(gl)?,
            format,
            most,
            noise: {
                let noise = texture(gl, glow::REPEAT).map_err(refuse)?;
                let size = [noise::SIZE as u32; 2];
                gl.texels(glow::RGBA8, glow::UNSIGNED_BYTE, size, Some(&noise::tile()));
                gl.mipmaps();
                noise
            },
            black_body: {
                let black_body = texture(gl, glow::CLAMP_TO_EDGE).map_err(refuse)?;
                let texels = Some(bytemuck::cast_slice(&table));
                gl.texels(internal, glow::FLOAT, [ENTRIES as u32, 1], texels);
                black_body
            },
            particles: Particles::new(gl, most)?,
            embers: Particles::new(gl, most)?,
            nothing: gl.create_vertex_array().map_err(refuse)?,
            targets: None,
            survey: Survey::of(&[], &[]),
            rise: Rise::default(),
            drift: Drift::default(),
            newest: 0,
        })
    }

    /// The pixels of the off-screen targets.
    pub fn target_format(&self) -> TargetFormat {
        self.format
    }

    /// Sends the particles and the embers to the graphics card.
    pub fn upload(&mut self, gl: &Context, instances: &[Instance], embers: &[Instance]) {
        self.survey = Survey::of(instances, embers);
        self.particles.upload(Gl(gl), instances);
        self.embers.upload(Gl(gl), embers);
    }

    /// Draws the uploaded particles. A picture without a pixel is no trouble.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint(
        &mut self,
        gl: &Context,
        view: &View,
        parameters: &Parameters,
    ) -> Result<(), RenderError> {
        let gl = Gl(gl);
        let Some(layout) = Layout::new([view.width, view.height], self.most) else {
            return Ok(());
        };
        self.rise
            .advance(&self.survey, view.time, parameters.model());
        let place = Place::new(layout.picture, parameters.domain_height);
        for capability in [
            glow::DEPTH_TEST,
            glow::STENCIL_TEST,
            glow::CULL_FACE,
            glow::BLEND,
            glow::SCISSOR_TEST,
        ] {
            gl.disable(capability);
        }
        gl.bind_vertex_array(Some(self.nothing));
        match parameters.display_mode {
            DisplayMode::Fire => {
                self.fit_targets(gl, layout)?;
                self.drift
                    .advance(view.time, combustion::period(parameters));
                self.newest = 1 - self.newest;
                if let Some(targets) = &self.targets {
                    Fire::new(gl, self, targets, place, parameters).paint();
                }
            }
            DisplayMode::Paper => self.paper(gl, layout, place, parameters),
        }
        gl.bind_vertex_array(None);
        Ok(())
    }

    /// Frees everything.
    pub fn destroy(self, gl: &Context) {
        let gl = Gl(gl);
        self.passes.destroy(gl);
        self.particles.destroy(gl);
        self.embers.destroy(gl);
        if let Some(targets) = &self.targets {
            targets.destroy(gl);
        }
        gl.delete_texture(self.noise);
        gl.delete_texture(self.black_body);
        gl.delete_vertex_array(self.nothing);
    }

    fn fit_targets(&mut self, gl: Gl<'_>, layout: Layout) -> Result<(), RenderError> {
        if self
            .targets
            .as_ref()
            .is_none_or(|targets| targets.layout != layout)
        {
            // The old ones go first: two sets may not fit a phone's memory.
            if let Some(old) = self.targets.take() {
                old.destroy(gl);
            }
            self.targets = Some(Targets::new(gl, self.format, layout)?);
            self.drift.forget();
        }
        Ok(())
    }

    /// Draws the particles as the paper does.
    fn paper(&self, gl: Gl<'_>, layout: Layout, place: Place, parameters: &Parameters) {
        let program = &self.passes.paper;
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
        program.activate(gl);
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
        bind(gl, 1, self.black_body);
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

/// Brightness of gas of 1500 K.
fn gain(parameters: &Parameters) -> f32 {
    GAIN * parameters.exposure.exp2()
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

/// Fills the whole picture with what stands behind the fire.
fn clear_picture(gl: Gl<'_>, layout: Layout, behind: Colour) {
    let [r, g, b, a] = background(behind);
    let [width, height] = layout.picture;
    gl.bind_framebuffer(glow::FRAMEBUFFER, None);
    gl.viewport(0, 0, width as i32, height as i32);
    gl.clear_color(r, g, b, a);
    gl.clear(glow::COLOR_BUFFER_BIT);
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

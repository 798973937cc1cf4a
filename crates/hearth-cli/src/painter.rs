//! Draws the pictures of a fire offscreen.

use std::rc::Rc;

use hearth_core::Instance;
use hearth_core::resolution::Level;
use hearth_render::{
    Camera, Renderer, ResolutionLimits, SharedResources, TargetFormat, View,
    memory as target_memory,
};

use crate::error::{Error, need_memory};
use crate::{Fire, Offscreen, Picture};

/// Pictures of one fire: their size, quality and camera.
#[derive(Clone, Copy, Debug)]
pub struct PictureOptions {
    /// Width and height \[pixels\].
    pub size: [u32; 2],
    /// The drawn pixels of a pixel, along each side: 1 to 4.
    pub supersampling: u32,
    /// Level of quality.
    pub level: Level,
    /// Part of the world in the picture.
    pub camera: Camera,
}

/// Draws one fire, picture after picture.
pub struct Painter<'a> {
    offscreen: &'a Offscreen,
    options: PictureOptions,
    /// It is there until the painter is dropped.
    renderer: Option<Renderer>,
}

impl<'a> Painter<'a> {
    /// A painter of pictures with these options.
    ///
    /// # Errors
    /// The driver has no such pictures.
    pub fn new(
        offscreen: &'a Offscreen,
        shared: &Rc<SharedResources>,
        options: PictureOptions,
    ) -> Result<Painter<'a>, Error> {
        let target = offscreen.target(drawn(&options))?;
        let mut renderer = Renderer::within(offscreen.gl(), Rc::clone(shared))?;
        renderer.set_limits(ResolutionLimits::of(options.level));
        renderer.set_output(Some(target));
        Ok(Painter {
            offscreen,
            options,
            renderer: Some(renderer),
        })
    }

    /// Draws a picture of a fire as it burns now.
    ///
    /// # Errors
    /// The driver has no memory.
    pub fn paint(&mut self, fire: &mut Fire) -> Result<Picture, Error> {
        self.draw(fire, &mut |_| {})?;
        self.read()
    }

    /// Draws a picture of a fire with other embers than its own.
    ///
    /// # Errors
    /// The driver has no memory.
    pub(crate) fn paint_with(
        &mut self,
        fire: &mut Fire,
        embers: &[Instance],
    ) -> Result<Picture, Error> {
        fire.write();
        fire.embers = embers.to_vec();
        self.draw_written(fire, &mut |_| {})?;
        self.read()
    }

    fn read(&self) -> Result<Picture, Error> {
        let [width, height] = drawn(&self.options);
        // The pixels, half of them again without alpha, and the file.
        need_memory(3 * 4 * width as usize * height as usize)?;
        let picture = Picture::premultiplied(width, height, self.offscreen.pixels());
        Ok(picture.downsampled(self.options.supersampling))
    }

    /// Draws a picture without reading it; calls `on_pass` with the name of each submitted pass.
    ///
    /// # Errors
    /// The driver has no memory.
    pub fn draw(
        &mut self,
        fire: &mut Fire,
        on_pass: &mut dyn FnMut(&'static str),
    ) -> Result<(), Error> {
        fire.write();
        self.draw_written(fire, on_pass)
    }

    fn draw_written(
        &mut self,
        fire: &Fire,
        on_pass: &mut dyn FnMut(&'static str),
    ) -> Result<(), Error> {
        // Another painter of the context may have replaced the target.
        let target = self.offscreen.target(drawn(&self.options))?;
        let view = self.upload(fire);
        if let Some(renderer) = &mut self.renderer {
            renderer.set_output(Some(target));
            let scene = fire.simulation.scene();
            renderer.paint_in_passes(self.offscreen.gl(), &view, scene, &fire.history, on_pass)?;
        }
        Ok(())
    }

    fn upload(&mut self, fire: &Fire) -> View {
        let (gl, simulation) = (self.offscreen.gl(), &fire.simulation);
        if let Some(renderer) = &mut self.renderer {
            let mode = simulation.parameters().display_mode;
            renderer.upload(gl, mode, &fire.instances, &fire.embers);
            let temperatures: Vec<_> = simulation.solid_temperatures().collect();
            let (scene, poses) = (simulation.scene(), simulation.poses());
            renderer.upload_solids(gl, scene, &poses, &temperatures, &fire.charred);
        }
        let [width, height] = drawn(&self.options);
        View {
            width,
            height,
            time: simulation.time(),
            camera: self.options.camera,
            is_paused: false,
            sheets: false,
        }
    }
}

impl Drop for Painter<'_> {
    fn drop(&mut self) {
        if let Some(renderer) = self.renderer.take() {
            renderer.destroy(self.offscreen.gl());
        }
    }
}

/// The resources that all fires of a context share, with targets of that format or, without one,
/// of half floats if the driver has them.
///
/// # Errors
/// The driver rejects a shader or the format.
pub fn resources(
    offscreen: &Offscreen,
    format: Option<TargetFormat>,
) -> Result<Rc<SharedResources>, Error> {
    let gl = offscreen.gl();
    Ok(Rc::new(match format {
        Some(format) => SharedResources::with_format(gl, format)?,
        None => SharedResources::new(gl)?,
    }))
}

/// Memory that pictures take while they are drawn \[bytes\]: the targets, and the picture as it is drawn and read.
pub fn memory(options: &PictureOptions) -> u64 {
    const TARGET_AND_COPIES: u64 = 4;
    let size = drawn(options);
    let picture = 4 * u64::from(size[0]) * u64::from(size[1]);
    TARGET_AND_COPIES * picture + target_memory(size, ResolutionLimits::of(options.level), u32::MAX)
}

/// The drawn size of a picture.
fn drawn(options: &PictureOptions) -> [u32; 2] {
    options
        .size
        .map(|side| side.saturating_mul(options.supersampling))
}

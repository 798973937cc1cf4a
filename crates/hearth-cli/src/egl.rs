//! An OpenGL ES 3 context without a window, through EGL, and what native drivers add to the calls
//! of WebGL2: the read-back of a picture, names of the driver, timer queries.
//!
//! This module contains the crate's only `unsafe`. EGL is a C library that is loaded at run time, and
//! `glow` marks each call `unsafe`, because native drivers trust pointers, sizes and the current
//! context. The calls here pass handles of one display, attribute lists that end with
//! [`egl::NONE`](khronos_egl::NONE), null for the parameters that allow it, and slices of the size that
//! the call writes. An [`Offscreen`] stays on the thread that made it (it is not `Send`), and a
//! thread has one at a time: so its context is the current one in every call.

#![allow(unsafe_code)]

mod error;
mod library;

use std::cell::{Cell, RefCell};
use std::ffi::c_void;
use std::marker::PhantomData;
use std::ptr::null_mut;

use hearth_render::Graphics;
use khronos_egl as egl;

pub use error::{OffscreenError, PACKAGES};
pub use library::device_count;
use library::{Egl, devices, has, library};

const PLATFORM_SURFACELESS: egl::Enum = 0x31dd;
const PLATFORM_DEVICE: egl::Enum = 0x313f;
const TIME_ELAPSED: u32 = 0x88bf;
const GPU_DISJOINT: u32 = 0x8fbb;

/// Names and limits of a driver.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    /// Who made the driver.
    pub vendor: String,
    /// The graphics card, or the software renderer.
    pub renderer: String,
    /// Version of OpenGL ES and of the driver.
    pub version: String,
    /// The EGL platform: `surfaceless`, `device N` or `default`.
    pub platform: String,
    /// Longest side of a picture \[pixels\].
    pub max_side: u32,
    /// Whether the driver draws into half floats.
    pub half_float: bool,
    /// Whether the driver measures times of passes.
    pub timer_queries: bool,
}

struct Target {
    size: [u32; 2],
    texture: glow::Texture,
    framebuffer: glow::Framebuffer,
}

/// A context without a window, current on its thread, and its target.
pub struct Offscreen {
    egl: &'static Egl,
    display: egl::Display,
    context: egl::Context,
    gl: glow::Context,
    platform: String,
    max_side: u32,
    target: RefCell<Option<Target>>,
    /// The running timer query.
    query: Cell<Option<glow::Query>>,
    /// A context is current on one thread.
    _thread: PhantomData<*const ()>,
}

impl Offscreen {
    /// A context of the first driver that has OpenGL ES 3: Mesa's surfaceless platform, the devices of
    /// vendors' drivers, the default display.
    ///
    /// # Errors
    /// EGL does not load, no display has such a context, or this thread has one already.
    pub fn new() -> Result<Offscreen, OffscreenError> {
        Offscreen::on(None)
    }

    /// As [`new`](Offscreen::new), on the device with that number, counted from 0.
    ///
    /// # Errors
    /// As those of [`new`](Offscreen::new), or there is no such device.
    pub fn on(device: Option<usize>) -> Result<Offscreen, OffscreenError> {
        let egl = library()?;
        if egl.get_current_context().is_some() {
            return Err(OffscreenError::InUse);
        }
        let devices = devices(egl);
        let mut displays = Vec::new();
        if let Some(requested) = device {
            let none = OffscreenError::NoDevice {
                requested,
                devices: devices.len(),
            };
            let device = *devices.get(requested).ok_or(none)?;
            displays.push((format!("device {requested}"), PLATFORM_DEVICE, device));
        } else {
            displays.push(("surfaceless".to_owned(), PLATFORM_SURFACELESS, null_mut()));
            for (number, device) in devices.into_iter().enumerate() {
                displays.push((format!("device {number}"), PLATFORM_DEVICE, device));
            }
            displays.push(("default".to_owned(), 0, null_mut()));
        }
        let mut reasons = Vec::new();
        for (platform, kind, native) in displays {
            match Offscreen::of(egl, kind, native, &platform) {
                Ok(offscreen) => return Ok(offscreen),
                Err(reason) => reasons.push(format!("{platform}: {reason}")),
            }
        }
        Err(OffscreenError::NoContext(reasons.join(", ")))
    }

    fn of(
        egl: &'static Egl,
        kind: egl::Enum,
        native: *mut c_void,
        platform: &str,
    ) -> Result<Offscreen, String> {
        // SAFETY: see the module's documentation; `native` is null or a device that EGL returned.
        let display = unsafe {
            match kind {
                0 => egl.get_display(egl::DEFAULT_DISPLAY),
                _ => egl
                    .get_platform_display(kind, native, &[egl::ATTRIB_NONE])
                    .ok(),
            }
        };
        let words = |error: egl::Error| error.to_string();
        let display = display.ok_or("no display")?;
        egl.initialize(display).map_err(words)?;
        let extensions = egl.query_string(Some(display), egl::EXTENSIONS);
        let extensions = extensions.map_err(words)?.to_string_lossy();
        if !has(&extensions, "EGL_KHR_surfaceless_context") {
            return Err("no EGL_KHR_surfaceless_context".to_owned());
        }
        egl.bind_api(egl::OPENGL_ES_API).map_err(words)?;
        let wanted = [
            egl::SURFACE_TYPE,
            0,
            egl::RENDERABLE_TYPE,
            egl::OPENGL_ES3_BIT,
            egl::NONE,
        ];
        let config = egl.choose_first_config(display, &wanted).map_err(words)?;
        let config = config.ok_or("no configuration with OpenGL ES 3")?;
        let version = [
            egl::CONTEXT_MAJOR_VERSION,
            3,
            egl::CONTEXT_MINOR_VERSION,
            0,
            egl::NONE,
        ];
        let context = egl.create_context(display, config, None, &version);
        let context = context.map_err(words)?;
        if let Err(error) = egl.make_current(display, None, None, Some(context)) {
            // The error of the attempt is the one that counts.
            let _ = egl.destroy_context(display, context);
            return Err(words(error));
        }
        // SAFETY: the context is current, and EGL returns its functions or null.
        let gl = unsafe {
            glow::Context::from_loader_function(|name| {
                let function = egl.get_proc_address(name);
                function.map_or(null_mut(), |function| function as *mut c_void)
            })
        };
        // SAFETY: see the module's documentation.
        let viewport =
            unsafe { glow::HasContext::get_parameter_i32(&gl, glow::MAX_RENDERBUFFER_SIZE) };
        Ok(Offscreen {
            egl,
            display,
            context,
            platform: platform.to_owned(),
            max_side: gl.largest_texture().min(viewport.max(0) as u32),
            gl,
            target: RefCell::default(),
            query: Cell::default(),
            _thread: PhantomData,
        })
    }

    /// The calls of OpenGL.
    pub fn gl(&self) -> &glow::Context {
        &self.gl
    }

    /// Longest side of a picture \[pixels\].
    pub fn max_side(&self) -> u32 {
        self.max_side
    }

    /// The target of pictures of that size: eight bits for each of red, green, blue and alpha. One of
    /// another size is replaced.
    ///
    /// # Errors
    /// The driver has no target of this size.
    pub fn target(&self, size: [u32; 2]) -> Result<glow::Framebuffer, OffscreenError> {
        if let Some(target) = &*self.target.borrow()
            && target.size == size
        {
            return Ok(target.framebuffer);
        }
        self.free_target();
        let max_side = self.max_side;
        let none = OffscreenError::NoTarget { size, max_side };
        if size.iter().any(|&side| side == 0 || side > max_side) {
            return Err(none);
        }
        let gl = &self.gl;
        let Some(texture) = gl.create_texture() else {
            return Err(none);
        };
        let Some(framebuffer) = gl.create_framebuffer() else {
            gl.delete_texture(&texture);
            return Err(none);
        };
        gl.active_texture(0);
        gl.bind_texture(&texture);
        gl.tex_parameter(glow::TEXTURE_MIN_FILTER, glow::NEAREST);
        gl.allocate_texture(glow::RGBA8, glow::UNSIGNED_BYTE, size);
        gl.bind_framebuffer(Some(&framebuffer));
        let status = gl.attach_texture(&texture);
        gl.bind_framebuffer(None);
        self.target.replace(Some(Target {
            size,
            texture,
            framebuffer,
        }));
        // SAFETY: see the module's documentation.
        let error = unsafe { glow::HasContext::get_error(gl) };
        if status != glow::FRAMEBUFFER_COMPLETE || error == glow::OUT_OF_MEMORY {
            self.free_target();
            return Err(none);
        }
        Ok(framebuffer)
    }

    fn free_target(&self) {
        if let Some(target) = self.target.take() {
            self.gl.delete_framebuffer(&target.framebuffer);
            self.gl.delete_texture(&target.texture);
        }
    }

    /// The picture in the target: premultiplied sRGB and alpha, from its upper left; empty without a
    /// target.
    pub fn pixels(&self) -> Vec<u8> {
        let target = self.target.borrow();
        let Some(Target {
            size: [width, height],
            framebuffer,
            ..
        }) = &*target
        else {
            return Vec::new();
        };
        let row = *width as usize * 4;
        let mut rgba = vec![0; row * *height as usize];
        self.gl.bind_framebuffer(Some(framebuffer));
        // SAFETY: the slice has the size that the call writes, and rows of four bytes a pixel have no gaps.
        unsafe {
            glow::HasContext::read_pixels(
                &self.gl,
                0,
                0,
                *width as i32,
                *height as i32,
                glow::RGBA,
                glow::UNSIGNED_BYTE,
                glow::PixelPackData::Slice(Some(&mut rgba)),
            );
        }
        self.gl.bind_framebuffer(None);
        // OpenGL's first row is the lowest.
        let (mut low, mut high) = (0, rgba.len());
        while low + row < high {
            high -= row;
            let (lower, upper) = rgba.split_at_mut(high);
            lower[low..low + row].swap_with_slice(&mut upper[..row]);
            low += row;
        }
        rgba
    }

    /// Names and limits of the driver.
    pub fn driver(&self) -> Driver {
        // SAFETY: see the module's documentation.
        let text = |name| unsafe { glow::HasContext::get_parameter_string(&self.gl, name) };
        Driver {
            vendor: text(glow::VENDOR),
            renderer: text(glow::RENDERER),
            version: text(glow::VERSION),
            platform: self.platform.clone(),
            max_side: self.max_side,
            half_float: ["EXT_color_buffer_float", "EXT_color_buffer_half_float"]
                .iter()
                .any(|name| self.gl.has_extension(name)),
            timer_queries: self.has_timer(),
        }
    }

    /// Whether the driver measures times of passes.
    pub fn has_timer(&self) -> bool {
        self.gl.has_extension("EXT_disjoint_timer_query")
    }

    /// Begins to measure the time of the next calls on the graphics card, unless a measurement runs.
    pub fn begin_timer(&self) {
        if !self.has_timer() || self.query.get().is_some() {
            return;
        }
        // SAFETY: the extension is there, and no query runs.
        unsafe {
            if let Ok(query) = glow::HasContext::create_query(&self.gl) {
                glow::HasContext::begin_query(&self.gl, TIME_ELAPSED, query);
                self.query.set(Some(query));
            }
        }
    }

    /// Ends the measurement and waits for the time \[ms\]; `None` without one, or if the driver was
    /// interrupted.
    pub fn end_timer(&self) -> Option<f64> {
        let query = self.query.take()?;
        // SAFETY: the extension is there, and this query runs.
        unsafe {
            glow::HasContext::end_query(&self.gl, TIME_ELAPSED);
            let nanoseconds =
                glow::HasContext::get_query_parameter_u32(&self.gl, query, glow::QUERY_RESULT);
            let disjoint = glow::HasContext::get_parameter_i32(&self.gl, GPU_DISJOINT);
            glow::HasContext::delete_query(&self.gl, query);
            (disjoint == 0).then_some(f64::from(nanoseconds) * 1e-6)
        }
    }

    /// Waits until all submitted calls are done.
    pub fn finish(&self) {
        // SAFETY: see the module's documentation.
        unsafe { glow::HasContext::finish(&self.gl) }
    }
}

impl Drop for Offscreen {
    fn drop(&mut self) {
        self.end_timer();
        self.free_target();
        // Another thread may use the display, so it stays. Errors are ignored: the process is about to drop the
        // display.
        let _ = self.egl.make_current(self.display, None, None, None);
        let _ = self.egl.destroy_context(self.display, self.context);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn too_few_texels_replace_nothing() -> Result<(), OffscreenError> {
        let offscreen = Offscreen::new()?;
        let gl = offscreen.gl();
        let size = [64, 64];
        // Its texture stays bound.
        offscreen.target(size)?;
        gl.replace_bytes(size, &[255; 64 * 64 * 4]);
        let white = offscreen.pixels();
        assert_eq!(white, [255; 64 * 64 * 4]);
        gl.replace_bytes(size, &[]);
        gl.replace_bytes(size, &[0; 64 * 64 * 4 - 1]);
        gl.replace_bytes([u32::MAX; 2], &[0; 64]);
        gl.replace_floats([0, 0], size, &[0.0; 64 * 64]);
        gl.replace_halves([0, 0], size, &[0; 64 * 64]);
        assert_eq!(offscreen.pixels(), white);
        Ok(())
    }
}

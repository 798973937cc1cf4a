//! Calls of OpenGL that the renderer does not make: states in which foreign code may leave a context,
//! and queries of tests.
//!
//! `glow` marks every call `unsafe`. Those here pass handles of the current context and plain
//! numbers, as the renderer's own calls do.

#![allow(unsafe_code)]

use glow::{Context, HasContext as _};

use crate::Failure;

/// A state in which foreign code may leave a context.
type Disturbance = unsafe fn(&Context) -> Result<(), String>;

/// The states by their names.
pub const DISTURBANCES: [(&str, Disturbance); 6] = [
    ("tests on", tests_on),
    ("blending", blending),
    ("another target, view and colour", another_target),
    ("other textures", other_textures),
    ("another program and its arrays", another_program),
    // The state that every host restores: the renderer does not query it.
    ("a colour without two channels", colour_mask),
];

/// Leaves a context in the state of that name.
///
/// # Errors
/// There is no such state, or the driver refuses a resource.
pub fn disturb(gl: &Context, name: &str) -> Result<(), Failure> {
    let known = DISTURBANCES.iter().find(|(known, _)| *known == name);
    let (_, leave) = known.ok_or_else(|| format!("no disturbance `{name}`"))?;
    // SAFETY: see the module's documentation.
    Ok(unsafe { leave(gl) }?)
}

/// Width and height of the view.
pub fn view(gl: &Context) -> [u32; 2] {
    let mut view = [0; 4];
    // SAFETY: the view has four numbers.
    unsafe { gl.get_parameter_i32_slice(glow::VIEWPORT, &mut view) };
    [view[2], view[3]].map(|side| side.max(0) as u32)
}

/// The lower left texels of the bound framebuffer.
pub fn read(gl: &Context, [width, height]: [u32; 2]) -> Vec<f32> {
    let mut bytes = vec![0; 16 * (width * height) as usize];
    let into = glow::PixelPackData::Slice(Some(&mut bytes));
    let [columns, lines] = [width, height].map(|side| side as i32);
    // SAFETY: the slice has the size of the read part.
    unsafe { gl.read_pixels(0, 0, columns, lines, glow::RGBA, glow::FLOAT, into) };
    let floats = bytes.as_chunks::<4>().0;
    floats
        .iter()
        .map(|bytes| f32::from_ne_bytes(*bytes))
        .collect()
}

/// Fails if OpenGL has refused a call.
pub fn report(gl: &Context) -> Result<(), Failure> {
    // SAFETY: see the module's documentation.
    match unsafe { gl.get_error() } {
        glow::NO_ERROR => Ok(()),
        error => Err(format!("OpenGL error {error:#x}").into()),
    }
}

unsafe fn tests_on(gl: &Context) -> Result<(), String> {
    // SAFETY: see the module's documentation.
    unsafe {
        for test in [
            glow::DEPTH_TEST,
            glow::STENCIL_TEST,
            glow::SCISSOR_TEST,
            glow::CULL_FACE,
        ] {
            gl.enable(test);
        }
        gl.scissor(3, 3, 5, 5);
        gl.cull_face(glow::FRONT_AND_BACK);
        gl.depth_func(glow::NEVER);
        gl.stencil_func(glow::NEVER, 1, 255);
    }
    Ok(())
}

unsafe fn blending(gl: &Context) -> Result<(), String> {
    // SAFETY: see the module's documentation.
    unsafe {
        gl.enable(glow::BLEND);
        gl.blend_func(glow::DST_COLOR, glow::ZERO);
    }
    Ok(())
}

unsafe fn another_target(gl: &Context) -> Result<(), String> {
    // SAFETY: see the module's documentation.
    unsafe {
        let texture = gl.create_texture()?;
        gl.bind_texture(glow::TEXTURE_2D, Some(texture));
        texels(gl, 4, None);
        gl.bind_framebuffer(glow::FRAMEBUFFER, Some(gl.create_framebuffer()?));
        gl.framebuffer_texture_2d(
            glow::FRAMEBUFFER,
            glow::COLOR_ATTACHMENT0,
            glow::TEXTURE_2D,
            Some(texture),
            0,
        );
        gl.viewport(1, 1, 2, 2);
        gl.clear_color(1.0, 0.0, 1.0, 1.0);
    }
    Ok(())
}

unsafe fn other_textures(gl: &Context) -> Result<(), String> {
    // SAFETY: see the module's documentation.
    unsafe {
        let texture = gl.create_texture()?;
        for unit in 0..8 {
            gl.active_texture(glow::TEXTURE0 + unit);
            gl.bind_texture(glow::TEXTURE_2D, Some(texture));
        }
        texels(gl, 1, Some(&[255, 0, 255, 255]));
    }
    Ok(())
}

unsafe fn another_program(gl: &Context) -> Result<(), String> {
    // SAFETY: see the module's documentation.
    unsafe {
        let program = gl.create_program()?;
        for (kind, source) in [
            (
                glow::VERTEX_SHADER,
                "in vec4 at;\nvoid main() { gl_Position = at; }",
            ),
            (
                glow::FRAGMENT_SHADER,
                "precision highp float;\nout vec4 c;\nvoid main() { c = vec4(1.0); }",
            ),
        ] {
            let shader = gl.create_shader(kind)?;
            gl.shader_source(shader, &format!("#version 300 es\n{source}"));
            gl.compile_shader(shader);
            gl.attach_shader(program, shader);
        }
        gl.link_program(program);
        gl.use_program(Some(program));
        gl.bind_vertex_array(Some(gl.create_vertex_array()?));
        gl.bind_buffer(glow::ARRAY_BUFFER, Some(gl.create_buffer()?));
        gl.buffer_data_size(glow::ARRAY_BUFFER, 12, glow::STATIC_DRAW);
        gl.enable_vertex_attrib_array(0);
        gl.vertex_attrib_pointer_f32(0, 3, glow::FLOAT, false, 0, 0);
    }
    Ok(())
}

unsafe fn colour_mask(gl: &Context) -> Result<(), String> {
    // SAFETY: see the module's documentation.
    unsafe { gl.color_mask(true, false, true, true) };
    Ok(())
}

/// Allocates the bound texture as a square of that side, with these texels.
unsafe fn texels(gl: &Context, side: i32, bytes: Option<&[u8]>) {
    let (format, kind) = (glow::RGBA, glow::UNSIGNED_BYTE);
    let data = glow::PixelUnpackData::Slice(bytes);
    // SAFETY: the bytes are those of all texels.
    unsafe {
        let (target, internal) = (glow::TEXTURE_2D, glow::RGBA8 as i32);
        gl.tex_image_2d(target, 0, internal, side, side, 0, format, kind, data);
    }
}

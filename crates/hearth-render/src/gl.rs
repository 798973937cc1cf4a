//! The calls of WebGL2 that the renderer makes, as the trait [`Graphics`], and that trait for
//! `glow`.
//!
//! The renderer does not depend on a browser. `glow` supports any driver; the engine implements
//! the trait for the page's context.
//!
//! `glow` marks every call `unsafe`, because native drivers trust pointers and sizes. WebGL checks
//! them all, and this file passes only handles of one context, slices of the size that the call reads
//! and plain numbers. So `unsafe` ends here.

#![allow(unsafe_code)]

use glow::HasContext as Gl;

/// A WebGL2 context. Each method is the call of that name, with handles of the same context.
#[allow(missing_docs)]
pub trait Graphics {
    type Program;
    type Shader;
    type Texture;
    type Framebuffer;
    type VertexArray;
    /// Location of a uniform.
    type Location;

    fn create_program(&self) -> Option<Self::Program>;
    fn attach_shader(&self, program: &Self::Program, shader: &Self::Shader);
    fn link_program(&self, program: &Self::Program);
    fn is_linked(&self, program: &Self::Program) -> bool;
    fn program_log(&self, program: &Self::Program) -> String;
    fn delete_program(&self, program: &Self::Program);
    fn use_program(&self, program: &Self::Program);
    fn create_shader(&self, kind: u32) -> Option<Self::Shader>;
    fn shader_source(&self, shader: &Self::Shader, source: &str);
    fn compile_shader(&self, shader: &Self::Shader);
    fn shader_log(&self, shader: &Self::Shader) -> String;
    fn delete_shader(&self, shader: &Self::Shader);
    fn uniform_location(&self, program: &Self::Program, name: &str) -> Option<Self::Location>;
    fn set_sampler(&self, location: Option<&Self::Location>, unit: i32);
    /// Sets an array of `vec4`.
    fn set_uniforms(&self, location: Option<&Self::Location>, values: &[f32]);

    fn create_texture(&self) -> Option<Self::Texture>;
    fn delete_texture(&self, texture: &Self::Texture);
    fn active_texture(&self, unit: u32);
    /// Binds a 2D texture, as everywhere in the renderer.
    fn bind_texture(&self, texture: &Self::Texture);
    fn tex_parameter(&self, name: u32, value: u32);
    /// Allocates the bound texture.
    fn allocate_texture(&self, internal: u32, kind: u32, size: [u32; 2]);
    /// Replaces a part of the bound texture, whose texels are four bytes. Too few texels replace nothing.
    fn replace_bytes(&self, size: [u32; 2], texels: &[u8]);
    /// Replaces a part of the bound texture, whose texels are four floats.
    fn replace_floats(&self, from: [u32; 2], size: [u32; 2], texels: &[f32]);
    /// The same of a texture of half floats, by their bits.
    fn replace_halves(&self, from: [u32; 2], size: [u32; 2], texels: &[u16]);
    fn generate_mipmap(&self);

    fn create_framebuffer(&self) -> Option<Self::Framebuffer>;
    fn delete_framebuffer(&self, framebuffer: &Self::Framebuffer);
    /// `None`: that of the canvas or window.
    fn bind_framebuffer(&self, framebuffer: Option<&Self::Framebuffer>);
    /// Attaches `texture` to the bound framebuffer; returns the framebuffer's status.
    fn attach_texture(&self, texture: &Self::Texture) -> u32;

    fn create_vertex_array(&self) -> Option<Self::VertexArray>;
    fn delete_vertex_array(&self, array: &Self::VertexArray);
    fn bind_vertex_array(&self, array: Option<&Self::VertexArray>);

    fn enable(&self, capability: u32);
    fn disable(&self, capability: u32);
    fn blend_func(&self, source: u32, destination: u32);
    fn blend_equation(&self, mode: u32);
    fn viewport(&self, from: [u32; 2], size: [u32; 2]);
    fn scissor(&self, x: i32, y: i32, width: i32, height: i32);
    fn clear(&self, colour: [f32; 4]);
    /// Draws one triangle that covers the target.
    fn draw_triangle(&self);
    fn draw_instances(&self, vertices: i32, instances: i32);
    fn largest_texture(&self) -> u32;
    /// `name`: as in WebGL, without the prefix `GL_`.
    fn has_extension(&self, name: &str) -> bool;
}

macro_rules! forward {
    ($( fn $name:ident ( $($arg:ident : $type:ty),* ) $(-> $out:ty)? = $gl:ident => $call:expr; )+) => {
        $( fn $name(&self, $($arg: $type),*) $(-> $out)? {
            let $gl = self;
            // SAFETY: see the module's documentation.
            unsafe { $call }
        } )+
    };
}

impl Graphics for glow::Context {
    type Program = glow::Program;
    type Shader = glow::Shader;
    type Texture = glow::Texture;
    type Framebuffer = glow::Framebuffer;
    type VertexArray = glow::VertexArray;
    type Location = glow::UniformLocation;

    forward! {
        fn create_program() -> Option<glow::Program> = gl => Gl::create_program(gl).ok();
        fn attach_shader(program: &glow::Program, shader: &glow::Shader) = gl => Gl::attach_shader(gl, *program, *shader);
        fn link_program(program: &glow::Program) = gl => Gl::link_program(gl, *program);
        fn is_linked(program: &glow::Program) -> bool = gl => Gl::get_program_link_status(gl, *program);
        fn program_log(program: &glow::Program) -> String = gl => Gl::get_program_info_log(gl, *program);
        fn delete_program(program: &glow::Program) = gl => Gl::delete_program(gl, *program);
        fn use_program(program: &glow::Program) = gl => Gl::use_program(gl, Some(*program));
        fn create_shader(kind: u32) -> Option<glow::Shader> = gl => Gl::create_shader(gl, kind).ok();
        fn shader_source(shader: &glow::Shader, source: &str) = gl => Gl::shader_source(gl, *shader, source);
        fn compile_shader(shader: &glow::Shader) = gl => Gl::compile_shader(gl, *shader);
        fn shader_log(shader: &glow::Shader) -> String = gl => Gl::get_shader_info_log(gl, *shader);
        fn delete_shader(shader: &glow::Shader) = gl => Gl::delete_shader(gl, *shader);
        fn uniform_location(program: &glow::Program, name: &str) -> Option<glow::UniformLocation> = gl => Gl::get_uniform_location(gl, *program, name);
        fn set_sampler(location: Option<&glow::UniformLocation>, unit: i32) = gl => Gl::uniform_1_i32(gl, location, unit);
        fn set_uniforms(location: Option<&glow::UniformLocation>, values: &[f32]) = gl => Gl::uniform_4_f32_slice(gl, location, values);

        fn create_texture() -> Option<glow::Texture> = gl => Gl::create_texture(gl).ok();
        fn delete_texture(texture: &glow::Texture) = gl => Gl::delete_texture(gl, *texture);
        fn active_texture(unit: u32) = gl => Gl::active_texture(gl, glow::TEXTURE0 + unit);
        fn bind_texture(texture: &glow::Texture) = gl => Gl::bind_texture(gl, glow::TEXTURE_2D, Some(*texture));
        fn tex_parameter(name: u32, value: u32) = gl => Gl::tex_parameter_i32(gl, glow::TEXTURE_2D, name, value as i32);
        fn generate_mipmap() = gl => Gl::generate_mipmap(gl, glow::TEXTURE_2D);

        fn create_framebuffer() -> Option<glow::Framebuffer> = gl => Gl::create_framebuffer(gl).ok();
        fn delete_framebuffer(framebuffer: &glow::Framebuffer) = gl => Gl::delete_framebuffer(gl, *framebuffer);
        fn bind_framebuffer(framebuffer: Option<&glow::Framebuffer>) = gl => Gl::bind_framebuffer(gl, glow::FRAMEBUFFER, framebuffer.copied());

        fn create_vertex_array() -> Option<glow::VertexArray> = gl => Gl::create_vertex_array(gl).ok();
        fn delete_vertex_array(array: &glow::VertexArray) = gl => Gl::delete_vertex_array(gl, *array);
        fn bind_vertex_array(array: Option<&glow::VertexArray>) = gl => Gl::bind_vertex_array(gl, array.copied());

        fn enable(capability: u32) = gl => Gl::enable(gl, capability);
        fn disable(capability: u32) = gl => Gl::disable(gl, capability);
        fn blend_func(source: u32, destination: u32) = gl => Gl::blend_func(gl, source, destination);
        fn blend_equation(mode: u32) = gl => Gl::blend_equation(gl, mode);
        fn viewport(from: [u32; 2], size: [u32; 2]) = gl => Gl::viewport(gl, from[0] as i32, from[1] as i32, size[0] as i32, size[1] as i32);
        fn scissor(x: i32, y: i32, width: i32, height: i32) = gl => Gl::scissor(gl, x, y, width, height);
        fn draw_triangle() = gl => Gl::draw_arrays(gl, glow::TRIANGLES, 0, 3);
        fn draw_instances(vertices: i32, instances: i32) = gl => Gl::draw_arrays_instanced(gl, glow::TRIANGLES, 0, vertices, instances);
        fn largest_texture() -> u32 = gl => Gl::get_parameter_i32(gl, glow::MAX_TEXTURE_SIZE).max(0) as u32;
    }

    fn has_extension(&self, name: &str) -> bool {
        let supported = Gl::supported_extensions(self);
        // Native drivers list extensions with the prefix that the names of WebGL lack.
        supported.contains(name) || supported.contains(&format!("GL_{name}"))
    }

    fn allocate_texture(&self, internal: u32, kind: u32, [width, height]: [u32; 2]) {
        // SAFETY: see the module's documentation.
        unsafe {
            Gl::tex_image_2d(
                self,
                glow::TEXTURE_2D,
                0,
                internal as i32,
                width as i32,
                height as i32,
                0,
                glow::RGBA,
                kind,
                glow::PixelUnpackData::Slice(None),
            );
        }
    }

    fn replace_bytes(&self, size: [u32; 2], texels: &[u8]) {
        replace(self, [0, 0], size, glow::UNSIGNED_BYTE, texels);
    }

    fn replace_floats(&self, from: [u32; 2], size: [u32; 2], texels: &[f32]) {
        replace(self, from, size, glow::FLOAT, bytemuck::cast_slice(texels));
    }

    fn replace_halves(&self, from: [u32; 2], size: [u32; 2], texels: &[u16]) {
        replace(
            self,
            from,
            size,
            glow::HALF_FLOAT,
            bytemuck::cast_slice(texels),
        );
    }

    fn attach_texture(&self, texture: &glow::Texture) -> u32 {
        // SAFETY: see the module's documentation.
        unsafe {
            Gl::framebuffer_texture_2d(
                self,
                glow::FRAMEBUFFER,
                glow::COLOR_ATTACHMENT0,
                glow::TEXTURE_2D,
                Some(*texture),
                0,
            );
            Gl::check_framebuffer_status(self, glow::FRAMEBUFFER)
        }
    }

    fn clear(&self, [r, g, b, a]: [f32; 4]) {
        // SAFETY: see the module's documentation.
        unsafe {
            Gl::clear_color(self, r, g, b, a);
            Gl::clear(self, glow::COLOR_BUFFER_BIT);
        }
    }
}

/// Replaces a part of the bound texture. A native driver would read beyond too few texels.
fn replace(
    gl: &glow::Context,
    [x, y]: [u32; 2],
    [width, height]: [u32; 2],
    kind: u32,
    texels: &[u8],
) {
    let texel = match kind {
        glow::UNSIGNED_BYTE => 4,
        glow::HALF_FLOAT => 8,
        _ => 16,
    };
    let count = texels.len() / texel;
    if (count as u64) < u64::from(width) * u64::from(height) {
        return;
    }
    // SAFETY: see the module's documentation.
    unsafe {
        gl.tex_sub_image_2d(
            glow::TEXTURE_2D,
            0,
            x as i32,
            y as i32,
            width as i32,
            height as i32,
            glow::RGBA,
            kind,
            glow::PixelUnpackData::Slice(Some(texels)),
        );
    }
}

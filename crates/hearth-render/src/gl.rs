//! The one place that calls WebGL.
//!
//! `glow` marks every call `unsafe`, because a native driver trusts the
//! pointers and sizes it is given. WebGL checks them all, and what passes
//! through here is only handles of the same context, whole slices and plain
//! numbers. So the marks end in this file and the rest of the crate stays
//! free of them.

#![allow(unsafe_code)]

use glow::HasContext as _;

/// A borrowed context.
#[derive(Clone, Copy)]
pub struct Gl<'a>(pub &'a glow::Context);

macro_rules! forward {
    ($( fn $name:ident ( $($arg:ident : $type:ty),* ) $(-> $out:ty)?; )+) => {
        $( pub fn $name(self, $($arg: $type),*) $(-> $out)? {
            // SAFETY: see the module's text.
            unsafe { self.0.$name($($arg),*) }
        } )+
    };
}

impl Gl<'_> {
    forward! {
        fn create_program() -> Result<glow::Program, String>;
        fn attach_shader(program: glow::Program, shader: glow::Shader);
        fn link_program(program: glow::Program);
        fn get_program_link_status(program: glow::Program) -> bool;
        fn get_program_info_log(program: glow::Program) -> String;
        fn delete_program(program: glow::Program);
        fn use_program(program: Option<glow::Program>);
        fn create_shader(kind: u32) -> Result<glow::Shader, String>;
        fn shader_source(shader: glow::Shader, source: &str);
        fn compile_shader(shader: glow::Shader);
        fn get_shader_info_log(shader: glow::Shader) -> String;
        fn delete_shader(shader: glow::Shader);
        fn get_uniform_location(program: glow::Program, name: &str) -> Option<glow::UniformLocation>;
        fn uniform_1_i32(location: Option<&glow::UniformLocation>, value: i32);

        fn create_texture() -> Result<glow::Texture, String>;
        fn delete_texture(texture: glow::Texture);
        fn active_texture(unit: u32);
        fn bind_texture(target: u32, texture: Option<glow::Texture>);
        fn tex_parameter_i32(target: u32, name: u32, value: i32);

        fn create_framebuffer() -> Result<glow::Framebuffer, String>;
        fn delete_framebuffer(framebuffer: glow::Framebuffer);
        fn bind_framebuffer(target: u32, framebuffer: Option<glow::Framebuffer>);
        fn framebuffer_texture_2d(target: u32, attachment: u32, texture_target: u32, texture: Option<glow::Texture>, level: i32);
        fn check_framebuffer_status(target: u32) -> u32;


        fn create_vertex_array() -> Result<glow::VertexArray, String>;
        fn delete_vertex_array(array: glow::VertexArray);
        fn bind_vertex_array(array: Option<glow::VertexArray>);

        fn enable(capability: u32);
        fn disable(capability: u32);
        fn blend_func(source: u32, destination: u32);
        fn viewport(x: i32, y: i32, width: i32, height: i32);
        fn scissor(x: i32, y: i32, width: i32, height: i32);
        fn clear_color(r: f32, g: f32, b: f32, a: f32);
        fn clear(mask: u32);
        fn draw_arrays(mode: u32, first: i32, count: i32);
        fn draw_arrays_instanced(mode: u32, first: i32, count: i32, instances: i32);
        fn get_parameter_i32(name: u32) -> i32;
    }

    pub fn has_extension(self, name: &str) -> bool {
        self.0.supported_extensions().contains(name)
    }

    pub fn uniform(self, location: Option<&glow::UniformLocation>, [x, y, z, w]: [f32; 4]) {
        // SAFETY: see the module's text.
        unsafe { self.0.uniform_4_f32(location, x, y, z, w) }
    }

    /// Gives the bound texture its size and, where there are any, its texels.
    pub fn texels(
        self,
        internal: u32,
        kind: u32,
        [width, height]: [u32; 2],
        texels: Option<&[u8]>,
    ) {
        // SAFETY: see the module's text.
        unsafe {
            self.0.tex_image_2d(
                glow::TEXTURE_2D,
                0,
                internal as i32,
                width as i32,
                height as i32,
                0,
                glow::RGBA,
                kind,
                glow::PixelUnpackData::Slice(texels),
            );
        }
    }

    /// Makes ever smaller copies of the bound texture, to be read where it is
    /// seen from farther away.
    pub fn mipmaps(self) {
        let filter = glow::LINEAR_MIPMAP_NEAREST as i32;
        self.tex_parameter_i32(glow::TEXTURE_2D, glow::TEXTURE_MIN_FILTER, filter);
        // SAFETY: see the module's text.
        unsafe { self.0.generate_mipmap(glow::TEXTURE_2D) }
    }

    /// Replaces a part of the bound texture of four floats a texel.
    pub fn replace_texels(self, [x, y]: [u32; 2], [width, height]: [u32; 2], texels: &[f32]) {
        debug_assert_eq!(texels.len(), (width * height * 4) as usize);
        // SAFETY: see the module's text.
        unsafe {
            self.0.tex_sub_image_2d(
                glow::TEXTURE_2D,
                0,
                x as i32,
                y as i32,
                width as i32,
                height as i32,
                glow::RGBA,
                glow::FLOAT,
                glow::PixelUnpackData::Slice(Some(bytemuck::cast_slice(texels))),
            );
        }
    }
}

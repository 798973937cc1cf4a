//! The renderer's [`Graphics`] for a WebGL2 context of the page.
//!
//! A frame creates no JavaScript object. Particles and uniforms are uploaded through views
//! of wasm's whole memory, which are replaced only after that memory has grown. The bindings of
//! web-sys that return a `Result` create an object per call, so a frame uses bindings without
//! one.

use std::cell::RefCell;

use hearth_render::Graphics;
use js_sys::{Float32Array, Uint16Array, WebAssembly};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{
    WebGl2RenderingContext as Context, WebGlFramebuffer, WebGlProgram, WebGlShader, WebGlTexture,
    WebGlUniformLocation, WebGlVertexArrayObject,
};

// These throw only if an argument has the wrong type.
#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(extends = Context)]
    pub type Calls;

    #[wasm_bindgen(method, js_name = texSubImage2D)]
    #[allow(clippy::too_many_arguments)]
    fn replace(
        this: &Calls,
        target: u32,
        level: i32,
        x: u32,
        y: u32,
        width: u32,
        height: u32,
        format: u32,
        kind: u32,
        from: &Float32Array,
        offset: u32,
    );

    #[wasm_bindgen(method, js_name = uniform4fv)]
    fn uniform(
        this: &Calls,
        location: Option<&WebGlUniformLocation>,
        from: &Float32Array,
        offset: u32,
        length: u32,
    );

    #[wasm_bindgen(method, js_name = texSubImage2D)]
    #[allow(clippy::too_many_arguments)]
    fn replace_halves(
        this: &Calls,
        target: u32,
        level: i32,
        x: u32,
        y: u32,
        width: u32,
        height: u32,
        format: u32,
        kind: u32,
        from: &Uint16Array,
        offset: u32,
    );

    #[wasm_bindgen(method, js_name = clearBufferfv)]
    fn clear_buffer(this: &Calls, buffer: u32, number: i32, from: &Float32Array, offset: u32);

    #[wasm_bindgen(method, js_name = getParameter)]
    pub fn parameter(this: &Calls, name: u32) -> JsValue;
}

impl Calls {
    /// The bindings without a `Result` of a context.
    pub fn of(context: &Context) -> &Calls {
        context.unchecked_ref()
    }
}

/// A context and the views of memory that it reads.
pub struct WebGl {
    /// The context.
    pub context: Context,
    memory: RefCell<Memory>,
}

impl WebGl {
    /// Wraps a context.
    pub fn new(context: Context) -> WebGl {
        WebGl {
            context,
            memory: RefCell::new(Memory::now()),
        }
    }
}

/// Views of wasm's memory.
struct Memory {
    floats: Float32Array,
    halves: Uint16Array,
    /// Size of the memory when the views were created.
    pages: usize,
}

impl Memory {
    fn pages() -> usize {
        core::arch::wasm32::memory_size(0)
    }

    /// Offset of these numbers in their view.
    fn find<T>(&mut self, numbers: &[T]) -> u32 {
        // Growing the memory empties its views. Creating a view may make the memory grow again.
        while self.pages != Memory::pages() {
            *self = Memory::now();
        }
        (numbers.as_ptr() as usize / size_of::<T>()) as u32
    }

    fn now() -> Memory {
        let pages = Memory::pages();
        let memory: WebAssembly::Memory = wasm_bindgen::memory().unchecked_into();
        Memory {
            floats: Float32Array::new(&memory.buffer()),
            halves: Uint16Array::new(&memory.buffer()),
            pages,
        }
    }
}

const TEXTURE_2D: u32 = Context::TEXTURE_2D;

macro_rules! forward {
    ($( fn $name:ident ( $($arg:ident : $type:ty),* ) $(-> $out:ty)? = $gl:ident => $call:expr; )+) => {
        $( fn $name(&self, $($arg: $type),*) $(-> $out)? {
            let $gl = &self.context;
            $call
        } )+
    };
}

impl Graphics for WebGl {
    type Program = WebGlProgram;
    type Shader = WebGlShader;
    type Texture = WebGlTexture;
    type Framebuffer = WebGlFramebuffer;
    type VertexArray = WebGlVertexArrayObject;
    type Location = WebGlUniformLocation;

    forward! {
        fn create_program() -> Option<WebGlProgram> = gl => gl.create_program();
        fn attach_shader(program: &WebGlProgram, shader: &WebGlShader) = gl => gl.attach_shader(program, shader);
        fn link_program(program: &WebGlProgram) = gl => gl.link_program(program);
        fn is_linked(program: &WebGlProgram) -> bool = gl => gl.get_program_parameter(program, Context::LINK_STATUS).is_truthy();
        fn program_log(program: &WebGlProgram) -> String = gl => gl.get_program_info_log(program).unwrap_or_default();
        fn delete_program(program: &WebGlProgram) = gl => gl.delete_program(Some(program));
        fn use_program(program: &WebGlProgram) = gl => gl.use_program(Some(program));
        fn create_shader(kind: u32) -> Option<WebGlShader> = gl => gl.create_shader(kind);
        fn shader_source(shader: &WebGlShader, source: &str) = gl => gl.shader_source(shader, source);
        fn compile_shader(shader: &WebGlShader) = gl => gl.compile_shader(shader);
        fn shader_log(shader: &WebGlShader) -> String = gl => gl.get_shader_info_log(shader).unwrap_or_default();
        fn delete_shader(shader: &WebGlShader) = gl => gl.delete_shader(Some(shader));
        fn uniform_location(program: &WebGlProgram, name: &str) -> Option<WebGlUniformLocation> = gl => gl.get_uniform_location(program, name);
        fn set_sampler(location: Option<&WebGlUniformLocation>, unit: i32) = gl => gl.uniform1i(location, unit);

        fn create_texture() -> Option<WebGlTexture> = gl => gl.create_texture();
        fn delete_texture(texture: &WebGlTexture) = gl => gl.delete_texture(Some(texture));
        fn active_texture(unit: u32) = gl => gl.active_texture(Context::TEXTURE0 + unit);
        fn bind_texture(texture: &WebGlTexture) = gl => gl.bind_texture(TEXTURE_2D, Some(texture));
        fn tex_parameter(name: u32, value: u32) = gl => gl.tex_parameteri(TEXTURE_2D, name, value as i32);
        fn generate_mipmap() = gl => gl.generate_mipmap(TEXTURE_2D);

        fn create_framebuffer() -> Option<WebGlFramebuffer> = gl => gl.create_framebuffer();
        fn delete_framebuffer(framebuffer: &WebGlFramebuffer) = gl => gl.delete_framebuffer(Some(framebuffer));
        fn bind_framebuffer(framebuffer: Option<&WebGlFramebuffer>) = gl => gl.bind_framebuffer(Context::FRAMEBUFFER, framebuffer);

        fn create_vertex_array() -> Option<WebGlVertexArrayObject> = gl => gl.create_vertex_array();
        fn delete_vertex_array(array: &WebGlVertexArrayObject) = gl => gl.delete_vertex_array(Some(array));
        fn bind_vertex_array(array: Option<&WebGlVertexArrayObject>) = gl => gl.bind_vertex_array(array);

        fn enable(capability: u32) = gl => gl.enable(capability);
        fn disable(capability: u32) = gl => gl.disable(capability);
        fn blend_func(source: u32, destination: u32) = gl => gl.blend_func(source, destination);
        fn blend_equation(mode: u32) = gl => gl.blend_equation(mode);
        fn viewport(from: [u32; 2], size: [u32; 2]) = gl => gl.viewport(from[0] as i32, from[1] as i32, size[0] as i32, size[1] as i32);
        fn scissor(x: i32, y: i32, width: i32, height: i32) = gl => gl.scissor(x, y, width, height);
        fn draw_triangle() = gl => gl.draw_arrays(Context::TRIANGLES, 0, 3);
        fn draw_instances(vertices: i32, instances: i32) = gl => gl.draw_arrays_instanced(Context::TRIANGLES, 0, vertices, instances);
    }

    fn set_uniforms(&self, location: Option<&WebGlUniformLocation>, values: &[f32]) {
        let mut memory = self.memory.borrow_mut();
        let offset = memory.find(values);
        let length = values.len() as u32;
        Calls::of(&self.context).uniform(location, &memory.floats, offset, length);
    }

    // A context that rejects one of the following calls draws nothing.

    fn allocate_texture(&self, internal: u32, kind: u32, [width, height]: [u32; 2]) {
        let _ = self
            .context
            .tex_image_2d_with_i32_and_i32_and_i32_and_format_and_type_and_opt_array_buffer_view(
                TEXTURE_2D,
                0,
                internal as i32,
                width as i32,
                height as i32,
                0,
                Context::RGBA,
                kind,
                None,
            );
    }

    fn replace_bytes(&self, [width, height]: [u32; 2], texels: &[u8]) {
        let _ = self
            .context
            .tex_sub_image_2d_with_i32_and_i32_and_u32_and_type_and_u8_array_and_src_offset(
                TEXTURE_2D,
                0,
                0,
                0,
                width as i32,
                height as i32,
                Context::RGBA,
                Context::UNSIGNED_BYTE,
                texels,
                0,
            );
    }

    fn replace_floats(&self, [x, y]: [u32; 2], [width, height]: [u32; 2], texels: &[f32]) {
        let mut memory = self.memory.borrow_mut();
        let offset = memory.find(texels);
        let (rgba, float) = (Context::RGBA, Context::FLOAT);
        Calls::of(&self.context).replace(
            TEXTURE_2D,
            0,
            x,
            y,
            width,
            height,
            rgba,
            float,
            &memory.floats,
            offset,
        );
    }

    fn replace_halves(&self, [x, y]: [u32; 2], [width, height]: [u32; 2], texels: &[u16]) {
        let mut memory = self.memory.borrow_mut();
        let offset = memory.find(texels);
        let (rgba, half) = (Context::RGBA, Context::HALF_FLOAT);
        Calls::of(&self.context).replace_halves(
            TEXTURE_2D,
            0,
            x,
            y,
            width,
            height,
            rgba,
            half,
            &memory.halves,
            offset,
        );
    }

    fn attach_texture(&self, texture: &WebGlTexture) -> u32 {
        self.context.framebuffer_texture_2d(
            Context::FRAMEBUFFER,
            Context::COLOR_ATTACHMENT0,
            TEXTURE_2D,
            Some(texture),
            0,
        );
        self.context.check_framebuffer_status(Context::FRAMEBUFFER)
    }

    fn clear(&self, colour: [f32; 4]) {
        let mut memory = self.memory.borrow_mut();
        let offset = memory.find(&colour);
        Calls::of(&self.context).clear_buffer(Context::COLOR, 0, &memory.floats, offset);
    }

    fn largest_texture(&self) -> u32 {
        let max = Calls::of(&self.context).parameter(Context::MAX_TEXTURE_SIZE);
        max.as_f64().unwrap_or_default() as u32
    }

    /// Getting an extension enables it.
    fn has_extension(&self, name: &str) -> bool {
        matches!(self.context.get_extension(name), Ok(Some(_)))
    }
}

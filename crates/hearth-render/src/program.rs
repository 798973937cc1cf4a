//! A compiled pair of shaders with the places of its uniforms.
//!
//! Every uniform is a `vec4` or a sampler, so two ways of setting one are
//! enough. Places are looked up once; a frame only compares short names.

use crate::error::RenderError;
use crate::gl::Graphics;

/// What every shader starts with: one version, one precision. Phones round
/// `mediump` to eleven bits, too few for a position in the picture, and a
/// sampler is `lowp` unless it is told otherwise.
pub const HEADER: &str = "#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
";

/// The source of one pass.
pub struct Source {
    /// Name of the pass.
    pub pass: &'static str,
    /// The vertex shader, in pieces that follow each other.
    pub vertex: &'static [&'static str],
    /// The fragment shader, in such pieces.
    pub fragment: &'static [&'static str],
    /// Its samplers: the first reads texture unit 0, and so on.
    pub samplers: &'static [&'static str],
    /// Its `vec4`s.
    pub uniforms: &'static [&'static str],
}

/// A program that the driver compiles, on threads of its own where it has such.
pub struct Compiling<'a, G: Graphics> {
    source: &'a Source,
    handle: G::Program,
    shaders: [Option<G::Shader>; 2],
}

impl<G: Graphics> Compiling<'_, G> {
    /// Begins to compile and link, and waits for neither.
    pub fn begin<'a>(gl: &G, source: &'a Source) -> Result<Compiling<'a, G>, RenderError> {
        let handle = gl.create_program().ok_or(RenderError::none(source.pass))?;
        let stages = [
            (glow::VERTEX_SHADER, source.vertex),
            (glow::FRAGMENT_SHADER, source.fragment),
        ];
        let mut shaders = [None, None];
        for (slot, (kind, pieces)) in shaders.iter_mut().zip(stages) {
            if let Some(shader) = gl.create_shader(kind) {
                gl.shader_source(&shader, &(HEADER.to_owned() + &pieces.concat()));
                gl.compile_shader(&shader);
                gl.attach_shader(&handle, &shader);
                *slot = Some(shader);
            }
        }
        gl.link_program(&handle);
        Ok(Compiling {
            source,
            handle,
            shaders,
        })
    }

    /// Waits until the program is linked.
    pub fn finish(self, gl: &G) -> Result<Program<G>, RenderError> {
        let Compiling {
            source,
            handle,
            shaders,
        } = self;
        let linked = gl.is_linked(&handle);
        // Logs are read only where something went wrong: reading one makes a
        // browser wait for its shader compiler.
        let log = (!linked).then(|| {
            let mut log = gl.program_log(&handle);
            for shader in shaders.iter().flatten() {
                log += &gl.shader_log(shader);
            }
            log
        });
        for shader in shaders.iter().flatten() {
            gl.delete_shader(shader);
        }
        if let Some(log) = log {
            gl.delete_program(&handle);
            let pass = source.pass;
            return Err(RenderError::Program { pass, log });
        }
        gl.use_program(&handle);
        for (unit, name) in source.samplers.iter().enumerate() {
            gl.set_sampler(gl.uniform_place(&handle, name).as_ref(), unit as i32);
        }
        let uniforms = source
            .uniforms
            .iter()
            .map(|&name| (name, gl.uniform_place(&handle, name)))
            .collect();
        Ok(Program { handle, uniforms })
    }
}

/// A linked program.
pub struct Program<G: Graphics> {
    handle: G::Program,
    uniforms: Vec<(&'static str, Option<G::Place>)>,
}

impl<G: Graphics> Program<G> {
    /// Makes this the current program.
    pub fn activate(&self, gl: &G) {
        gl.use_program(&self.handle);
    }

    /// Sets the `vec4` of that name in the current program.
    // As wherever this is said in this crate: many callers, and code is download.
    #[inline(never)]
    pub fn set(&self, gl: &G, name: &str, value: [f32; 4]) {
        let place = self.uniforms.iter().find(|(known, _)| *known == name);
        debug_assert!(place.is_some(), "no uniform {name} is declared");
        gl.set_uniform(place.and_then(|(_, place)| place.as_ref()), value);
    }

    /// Frees the program.
    pub fn destroy(&self, gl: &G) {
        gl.delete_program(&self.handle);
    }
}

//! Shader programs.

use std::cell::OnceCell;

use crate::error::RenderError;
use crate::gl::Graphics;
use crate::shaders::{HEADER, SOURCES, Shader, Source, UNIFORMS};

/// A program that the driver compiles, possibly on other threads.
struct Compiling<G: Graphics> {
    source: &'static Source,
    handle: Option<G::Program>,
    shaders: [Option<G::Shader>; 2],
}

impl<G: Graphics> Compiling<G> {
    /// Starts to compile and link without waiting.
    fn begin(gl: &G, source: &'static Source) -> Compiling<G> {
        let mut shaders = [None, None];
        let handle = gl.create_program();
        if let Some(handle) = &handle {
            let stages = [
                (glow::VERTEX_SHADER, source.vertex),
                (glow::FRAGMENT_SHADER, source.fragment),
            ];
            for (slot, (kind, text)) in shaders.iter_mut().zip(stages) {
                if let Some(shader) = gl.create_shader(kind) {
                    gl.shader_source(&shader, &(HEADER.to_owned() + text));
                    gl.compile_shader(&shader);
                    gl.attach_shader(handle, &shader);
                    *slot = Some(shader);
                }
            }
            gl.link_program(handle);
        }
        Compiling {
            source,
            handle,
            shaders,
        }
    }

    /// Waits until the program is linked.
    fn finish(self, gl: &G) -> Result<Program<G>, RenderError> {
        let Compiling {
            source,
            handle,
            shaders,
        } = self;
        let pass = source.name;
        let handle = handle.ok_or(RenderError::Resource { pass })?;
        let linked = gl.is_linked(&handle);
        let uniforms = gl.uniform_location(&handle, UNIFORMS);
        // Without its uniforms a pass would draw nothing, and there would be no error.
        let usable = linked && (uniforms.is_some() || source.floats == 0);
        // Reading a log waits for the compiler, so only failed programs do.
        let log = (!usable).then(|| {
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
            return Err(RenderError::Program { pass, log });
        }
        gl.use_program(&handle);
        for (unit, (name, _)) in source.samplers.iter().enumerate() {
            gl.set_sampler(gl.uniform_location(&handle, name).as_ref(), unit as i32);
        }
        Ok(Program { handle, uniforms })
    }
}

/// A linked program.
struct Program<G: Graphics> {
    handle: G::Program,
    uniforms: Option<G::Location>,
}

/// Pairs of shaders that are compiled when a frame first needs them: most fires have no solids and no wall.
const COMPILED_ON_DEMAND: [Shader; 3] = [Shader::Solid, Shader::Outline, Shader::Enlarge];

/// The programs, in the order of [`SOURCES`].
pub struct Programs<G: Graphics>(Vec<OnceCell<Program<G>>>);

impl<G: Graphics> Programs<G> {
    /// Compiles all shaders that every context needs, or returns the first error.
    pub fn new(gl: &G) -> Result<Programs<G>, RenderError> {
        // All start before the first wait, so that drivers compile them in parallel.
        let compiling: Vec<_> = SOURCES
            .iter()
            .enumerate()
            .map(|(at, source)| {
                let is_late = COMPILED_ON_DEMAND.iter().any(|late| *late as usize == at);
                (!is_late).then(|| Compiling::begin(gl, source))
            })
            .collect();
        let mut programs = Programs(Vec::with_capacity(SOURCES.len()));
        let mut first_error = None;
        for program in compiling {
            let cell = OnceCell::new();
            match program.map(|program| program.finish(gl)) {
                Some(Ok(program)) => drop(cell.set(program)),
                Some(Err(error)) => first_error = first_error.or(Some(error)),
                None => {}
            }
            programs.0.push(cell);
        }
        match first_error {
            None => Ok(programs),
            Some(error) => {
                programs.destroy(gl);
                Err(error)
            }
        }
    }

    /// Compiles a pair of shaders unless it is compiled.
    pub fn need(&self, gl: &G, shader: Shader) -> Result<(), RenderError> {
        let cell = &self.0[shader as usize];
        if cell.get().is_none() {
            let program = Compiling::begin(gl, &SOURCES[shader as usize]).finish(gl)?;
            drop(cell.set(program));
        }
        Ok(())
    }

    /// Activates a compiled program and sets its uniforms.
    pub fn activate(&self, gl: &G, shader: Shader, uniforms: &[f32]) {
        if let Some(program) = self.0[shader as usize].get() {
            gl.use_program(&program.handle);
            gl.set_uniforms(program.uniforms.as_ref(), uniforms);
        }
    }

    /// Frees all programs.
    pub fn destroy(&self, gl: &G) {
        for program in self.0.iter().filter_map(OnceCell::get) {
            gl.delete_program(&program.handle);
        }
    }
}

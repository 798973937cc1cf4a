//! A compiler from GLSL ES 3.00 with includes to plain GLSL.
//!
//! It resolves `#include`, inlines constants, removes unused declarations, and packs the uniforms
//! of a pass into one array of `vec4`, which one call sets. Undeclared names, components that a
//! uniform does not have, and unused declarations fail the build.

mod files;
mod items;
mod pack;
mod tokens;

#[cfg(test)]
mod tests;

pub use files::Files;
pub use pack::Uniform;

use items::{Item, Kind};
use tokens::Token;

/// A vertex and a fragment shader of a pass.
#[derive(Clone)]
pub struct Program {
    /// Name of the files.
    pub name: String,
    /// Vertex, then fragment stage.
    pub stages: [Stage; 2],
    /// Numbers and vectors among the uniforms, in the order of their declarations.
    pub uniforms: Vec<Uniform>,
    /// Length of their array.
    pub vectors: usize,
    /// Names of the samplers, in the order of their texture units.
    pub samplers: Vec<String>,
}

/// A stage.
#[derive(Clone)]
pub struct Stage {
    /// The declarations.
    items: Vec<Vec<Token>>,
}

impl Stage {
    /// The source for a driver.
    pub fn text(&self) -> String {
        tokens::text(&self.items.concat())
    }
}

/// All programs, one per fragment shader. The vertex shader is the file of the same name or
/// `screen.vert`, which covers the target.
///
/// # Errors
/// The first error with the name of its file.
pub fn programs(files: &Files, shared: &[(&str, String)]) -> Result<Vec<Program>, String> {
    let fragments = files.names().filter_map(|file| file.strip_suffix(".frag"));
    fragments
        .map(|name| {
            let own = format!("{name}.vert");
            let vertex = if files.has(&own) { &own } else { "screen.vert" };
            program(files, name, [vertex, &format!("{name}.frag")], shared)
        })
        .collect()
}

fn program(
    files: &Files,
    name: &str,
    stages: [&str; 2],
    shared: &[(&str, String)],
) -> Result<Program, String> {
    let [vertex, fragment] = stages.map(|file| stage(files, file, shared));
    let mut stages = [vertex?, fragment?];
    let uniforms = pack::uniforms(stages.iter().flatten())?;
    let samplers = items::samplers(stages.iter().flatten());
    let vectors = pack::vectors(&uniforms);
    for items in &mut stages {
        pack::apply(items, &uniforms, vectors)?;
    }
    Ok(Program {
        name: name.to_owned(),
        stages: stages.map(|items| Stage {
            items: items.into_iter().map(|item| item.tokens).collect(),
        }),
        uniforms,
        vectors,
        samplers,
    })
}

/// The used declarations of a stage with inlined constants.
fn stage(files: &Files, file: &str, shared: &[(&str, String)]) -> Result<Vec<Item>, String> {
    let mut items = items::parse(files.folded(file)?)?;
    items::check_names(&items, shared).map_err(|error| format!("{file}: {error}"))?;
    let used = items::used(&items);
    for (item, used) in items.iter().zip(&used) {
        if !used && item.file == file {
            return Err(format!("{file}: {} is declared and never used", item.name));
        }
    }
    let mut used = used.into_iter();
    items.retain(|_| used.next().unwrap_or_default());
    items::inline(&mut items, shared);
    items.retain(|item| item.kind != Kind::Inlined);
    Ok(items)
}

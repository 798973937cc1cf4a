//! A compiler from annotated GLSL ES 3.00 to the GLSL that drivers get.
//!
//! It folds `#include` in, replaces constants by their values, drops what a stage does not
//! use, and packs a pass's uniforms of any type into one array of `vec4`, which one call sets.
//! Names that are nowhere declared, components that a uniform does not have and declarations
//! that nothing uses are errors, so that they fail the build.

mod files;
mod items;
mod names;
mod pack;
mod tokens;

#[cfg(test)]
mod tests;

pub use files::Files;
pub use names::shorten;
pub use pack::Uniform;

use items::{Item, Kind};
use tokens::Token;

/// A vertex and a fragment shader that belong together.
#[derive(Clone)]
pub struct Program {
    /// Name of the pass and of its files.
    pub name: String,
    /// The stages: vertex, then fragment.
    pub stages: [Stage; 2],
    /// Uniforms that are numbers, in the order of their declarations.
    pub uniforms: Vec<Uniform>,
    /// Length of the array that holds them.
    pub vectors: usize,
    /// Names of the samplers in the files, in the order of their texture units, and in the text.
    pub samplers: Vec<(String, String)>,
}

/// The code of one stage.
#[derive(Clone)]
pub struct Stage {
    /// Its declarations.
    items: Vec<Vec<Token>>,
}

impl Stage {
    /// The text for a driver: lines, or as short as it can be.
    pub fn text(&self, short: bool) -> String {
        tokens::text(&self.items.concat(), short)
    }
}

/// Every program: one for each fragment shader. Its vertex shader is the file of the same name,
/// or `screen.vert`, which covers the target.
///
/// # Errors
/// What is wrong, with the file's name.
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
        samplers: samplers
            .into_iter()
            .map(|name| (name.clone(), name))
            .collect(),
    })
}

/// What a stage declares and uses, with constants replaced by their values.
fn stage(files: &Files, file: &str, shared: &[(&str, String)]) -> Result<Vec<Item>, String> {
    let mut items = items::parse(files.folded(file)?)?;
    items::check_names(&items, shared).map_err(|said| format!("{file}: {said}"))?;
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

//! Writes the Rust module of the compiled shaders.

use std::fmt::Write;

use crate::glsl::{Program, Uniform};

/// The source of the module.
pub fn module(programs: &[Program]) -> String {
    let mut text = String::new();
    // Writing to a string never fails.
    let _ = write(programs, &mut text);
    text
}

fn write(programs: &[Program], text: &mut String) -> std::fmt::Result {
    writeln!(
        text,
        "/// A compiled pair of shaders.\n#[derive(Clone, Copy, Debug, PartialEq, Eq)]\npub enum Shader {{"
    )?;
    for program in programs {
        let name = camel(&program.name);
        writeln!(text, "    /// `{}`.\n    {name},", program.name)?;
    }
    writeln!(text, "}}\n")?;
    let largest = programs.iter().map(|program| program.vectors).max();
    writeln!(
        text,
        "/// Floats of the largest block of uniforms.\npub const FLOATS: usize = {};\n",
        4 * largest.unwrap_or(0)
    )?;
    writeln!(
        text,
        "/// All pairs in the order of [`Shader`].\npub static SOURCES: [Source; {}] = [",
        programs.len()
    )?;
    for program in programs {
        let [vertex, fragment] = program.stages.each_ref().map(|stage| stage.text());
        writeln!(text, "    Source {{\n        name: {:?},", program.name)?;
        writeln!(
            text,
            "        vertex: {vertex:?},\n        fragment: {fragment:?},"
        )?;
        writeln!(text, "        samplers: &[")?;
        for name in &program.samplers {
            writeln!(text, "            ({name:?}, Image::{}),", camel(name))?;
        }
        writeln!(
            text,
            "        ],\n        floats: {},\n    }},",
            4 * program.vectors
        )?;
    }
    writeln!(text, "];\n")?;
    writeln!(
        text,
        "/// A struct of uniforms for each pair.\npub mod uniforms {{\n    use super::{{FLOATS, Shader, Uniforms}};\n"
    )?;
    for program in programs {
        block(program, text)?;
    }
    writeln!(text, "}}")
}

/// Writes the struct of a program's uniforms.
fn block(program: &Program, text: &mut String) -> std::fmt::Result {
    let name = camel(&program.name);
    writeln!(
        text,
        "/// Uniforms of `{}`.\npub struct {name} {{",
        program.name
    )?;
    for uniform in &program.uniforms {
        let comment = uniform.comment.replace('[', "\\[").replace(']', "\\]");
        let kind = match uniform.size {
            1 => "f32".to_owned(),
            size => format!("[f32; {size}]"),
        };
        writeln!(text, "    /// {comment}\n    pub {}: {kind},", uniform.name)?;
    }
    writeln!(text, "}}\n\nimpl Uniforms for {name} {{")?;
    writeln!(text, "    const SHADER: Shader = Shader::{name};\n")?;
    let to = if program.uniforms.is_empty() {
        "_"
    } else {
        "to"
    };
    writeln!(
        text,
        "    #[inline]\n    fn write(self, {to}: &mut [f32; FLOATS]) {{"
    )?;
    for Uniform { name, size, at, .. } in &program.uniforms {
        if *size == 1 {
            writeln!(text, "        to[{at}] = self.{name};")?;
        }
        if *size > 4 {
            writeln!(
                text,
                "        to[{at}..{}].copy_from_slice(&self.{name});",
                at + size
            )?;
        }
        for component in (0..*size).filter(|_| (2..=4).contains(size)) {
            writeln!(
                text,
                "        to[{}] = self.{name}[{component}];",
                at + component
            )?;
        }
    }
    writeln!(text, "    }}\n}}\n")
}

/// `tone_map` as `ToneMap`.
fn camel(name: &str) -> String {
    let words = name.split('_').map(|word| {
        let (first, rest) = word.split_at(1);
        first.to_uppercase() + rest
    });
    words.collect()
}

//! The passes of a frame: which shaders they are made of and what these want.

use crate::error::RenderError;
use crate::gl::Gl;
use crate::program::{Program, Source};

macro_rules! shader {
    ($name:literal) => {
        include_str!(concat!("../../../shaders/", $name))
    };
}

/// All passes, compiled.
pub struct Passes {
    /// Particles to fields.
    pub splat: Program,
    /// Fields to their view from farther away.
    pub spread: Program,
    /// Fields to light.
    pub shade: Program,
    /// Light to a blurred copy a quarter as wide, and that to ones of half its size.
    pub shrink: Program,
    /// Blurred copies joined, from the widest to the sharpest.
    pub widen: Program,
    /// Light and glow to displayed colours.
    pub develop: Program,
    /// Displayed colours to the picture, in front of its background.
    pub present: Program,
    /// Particles to the picture, as in the paper.
    pub paper: Program,
}

const SPLAT: Source = Source {
    pass: "splat",
    vertex: &[shader!("particle.glsl"), shader!("splat.vert")],
    fragment: &[shader!("splat.frag")],
    samplers: &["particles"],
    uniforms: &["world", "count", "kernel", "scale"],
};

const SPREAD: Source = Source {
    pass: "spread",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("spread.frag")],
    samplers: &["field"],
    uniforms: &["step"],
};

const SHADE: Source = Source {
    pass: "shade",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("shade.frag")],
    samplers: &["field", "wide", "noise", "black_body"],
    uniforms: &["view", "part", "range", "rise", "matter", "shine", "table"],
};

const SHRINK: Source = Source {
    pass: "shrink",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("shrink.frag")],
    samplers: &["source"],
    uniforms: &["texel"],
};

const WIDEN: Source = Source {
    pass: "widen",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("widen.frag")],
    samplers: &["wide", "narrow"],
    uniforms: &["texel"],
};

const DEVELOP: Source = Source {
    pass: "develop",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("colour.glsl"), shader!("develop.frag")],
    samplers: &["light", "glow"],
    uniforms: &["strength"],
};

const PRESENT: Source = Source {
    pass: "present",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("present.frag")],
    samplers: &["fire"],
    uniforms: &["background"],
};

const PAPER: Source = Source {
    pass: "paper",
    vertex: &[shader!("particle.glsl"), shader!("paper.vert")],
    fragment: &[shader!("colour.glsl"), shader!("paper.frag")],
    samplers: &["particles", "black_body"],
    uniforms: &["world", "count", "sprite", "heat", "table"],
};

impl Passes {
    /// Compiles every pass, or says which one the driver refuses.
    pub fn new(gl: Gl<'_>) -> Result<Passes, RenderError> {
        let compiled = [SPLAT, SPREAD, SHADE, SHRINK, WIDEN, DEVELOP, PRESENT, PAPER]
            .map(|source| Program::new(gl, &source));
        match compiled {
            [
                Ok(splat),
                Ok(spread),
                Ok(shade),
                Ok(shrink),
                Ok(widen),
                Ok(develop),
                Ok(present),
                Ok(paper),
            ] => Ok(Passes {
                splat,
                spread,
                shade,
                shrink,
                widen,
                develop,
                present,
                paper,
            }),
            compiled => {
                let mut first = RenderError::NoTarget;
                for program in compiled.into_iter().rev() {
                    match program {
                        Ok(program) => program.destroy(gl),
                        Err(error) => first = error,
                    }
                }
                Err(first)
            }
        }
    }

    /// Frees every program.
    pub fn destroy(&self, gl: Gl<'_>) {
        let Passes {
            splat,
            spread,
            shade,
            shrink,
            widen,
            develop,
            present,
            paper,
        } = self;
        for program in [splat, spread, shade, shrink, widen, develop, present, paper] {
            program.destroy(gl);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pass_declares_exactly_what_is_set() {
        for source in [SPLAT, SPREAD, SHADE, SHRINK, WIDEN, DEVELOP, PRESENT, PAPER] {
            let text = source.vertex.concat() + &source.fragment.concat();
            // A uniform that both stages read is declared in both.
            let mut declared: Vec<&str> = text
                .lines()
                .filter_map(|line| line.strip_prefix("uniform "))
                .filter_map(|line| line.split(';').next()?.split(' ').next_back())
                .collect();
            let mut set = [source.samplers, source.uniforms].concat();
            declared.sort_unstable();
            declared.dedup();
            set.sort_unstable();
            assert_eq!(declared, set, "{}", source.pass);
        }
    }
}

//! The passes of a frame: which shaders they are made of and what these want.

use crate::error::RenderError;
use crate::gl::Graphics;
use crate::program::{Compiling, Program, Source};

macro_rules! shader {
    ($name:literal) => {
        include_str!(concat!(env!("OUT_DIR"), "/", $name))
    };
}

macro_rules! passes {
    ($( $(#[$doc:meta])* $name:ident = $source:ident, )+) => {
        /// A pass; `shaders/` has a pair for each.
        #[derive(Clone, Copy)]
        pub enum Pass { $( $(#[$doc])* $name, )+ }

        pub(crate) const SOURCES: &[Source] = &[$($source),+];
    };
}

passes! {
    /// Particles of the classic model to fields.
    Splat = SPLAT,
    /// Fields to their view from farther away.
    Spread = SPREAD,
    /// Fields to light.
    Shade = SHADE,
    /// Gas of the combustion model to fields, or to velocities.
    Gas = GAS,
    /// Velocities to how far the fine structure was carried.
    Drift = DRIFT,
    /// Fields of burning gas to light.
    Flame = FLAME,
    /// Embers to light.
    Ember = EMBER,
    /// Light to a blurred copy of so many lines, and that to ones of half its size.
    Shrink = SHRINK,
    /// Blurred copies joined, from the widest to the sharpest.
    Widen = WIDEN,
    /// Light and glow to displayed colours.
    Develop = DEVELOP,
    /// Displayed colours to the picture, in front of its background.
    Present = PRESENT,
    /// A backdrop, from nothing.
    Scenery = SCENERY,
    /// Glow to the light that falls on the backdrop.
    Lamp = LAMP,
    /// Displayed colours to the picture, in front of the backdrop.
    Backdrop = BACKDROP,
    /// Particles to the picture, as in the paper.
    Paper = PAPER,
    /// What is measured of particles to a field.
    Gather = GATHER,
    /// That to colours.
    Chart = CHART,
    /// What is measured of particles to discs.
    Disc = DISC,
    /// Particles to sprites with a texture.
    Sprite = SPRITE,
}

/// All passes, compiled.
pub struct Passes<G: Graphics>(Vec<Program<G>>);

impl<G: Graphics> Passes<G> {
    /// Compiles every pass, or says which one the driver refuses.
    pub fn new(gl: &G) -> Result<Passes<G>, RenderError> {
        // All are begun before the first is waited for, so that a driver with many threads
        // compiles them side by side.
        let begun: Vec<_> = SOURCES
            .iter()
            .map(|source| Compiling::begin(gl, source))
            .collect();
        let mut passes = Passes(Vec::with_capacity(SOURCES.len()));
        let mut refused = None;
        for begun in begun {
            match begun.and_then(|compiling| compiling.finish(gl)) {
                Ok(program) => passes.0.push(program),
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        match refused {
            None => Ok(passes),
            Some(error) => {
                passes.destroy(gl);
                Err(error)
            }
        }
    }

    /// Makes the shaders of that pass the current program.
    pub fn activate(&self, gl: &G, pass: Pass) -> &Program<G> {
        let program = &self.0[pass as usize];
        program.activate(gl);
        program
    }

    /// Frees every program.
    pub fn destroy(&self, gl: &G) {
        for program in &self.0 {
            program.destroy(gl);
        }
    }
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
    uniforms: &["reads"],
};

const SHADE: Source = Source {
    pass: "shade",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("shade.frag")],
    samplers: &["field", "wide", "noise", "black_body"],
    uniforms: &[
        "view", "origin", "part", "range", "rise", "matter", "shine", "table",
    ],
};

const GAS: Source = Source {
    pass: "gas",
    vertex: &[shader!("particle.glsl"), shader!("gas.vert")],
    fragment: &[shader!("splat.frag")],
    samplers: &["particles"],
    uniforms: &["world", "count", "kernel", "scale"],
};

const DRIFT: Source = Source {
    pass: "drift",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("drift.frag")],
    samplers: &["flow", "before"],
    uniforms: &["carried"],
};

const FLAME: Source = Source {
    pass: "flame",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("flame.frag")],
    samplers: &["field", "drift", "noise", "black_body"],
    uniforms: &[
        "view", "origin", "part", "range", "grain", "start", "seen", "matter", "shine", "table",
    ],
};

const EMBER: Source = Source {
    pass: "ember",
    vertex: &[shader!("particle.glsl"), shader!("ember.vert")],
    fragment: &[shader!("ember.frag")],
    samplers: &["particles", "black_body"],
    uniforms: &["world", "count", "spark", "shine", "table"],
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
    uniforms: &["strength", "pale"],
};

const PRESENT: Source = Source {
    pass: "present",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("present.frag")],
    samplers: &["fire"],
    uniforms: &["background"],
};

const SCENERY: Source = Source {
    pass: "scenery",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("scenery.frag")],
    samplers: &["noise"],
    uniforms: &["view", "origin"],
};

const LAMP: Source = Source {
    pass: "lamp",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("lamp.frag")],
    samplers: &["glow"],
    uniforms: &["view"],
};

const BACKDROP: Source = Source {
    pass: "backdrop",
    vertex: &[shader!("screen.vert")],
    fragment: &[shader!("colour.glsl"), shader!("backdrop.frag")],
    samplers: &["fire", "scenery", "lamp", "field", "noise"],
    uniforms: &["haze", "part", "range"],
};

const PAPER: Source = Source {
    pass: "paper",
    vertex: &[shader!("particle.glsl"), shader!("paper.vert")],
    fragment: &[shader!("colour.glsl"), shader!("paper.frag")],
    samplers: &["particles", "black_body"],
    uniforms: &["world", "count", "sprite", "heat", "table", "pale"],
};

const GATHER: Source = Source {
    pass: "gather",
    vertex: &[shader!("particle.glsl"), shader!("gather.vert")],
    fragment: &[shader!("splat.frag")],
    samplers: &["particles"],
    uniforms: &["world", "count", "kernel", "span"],
};

const CHART: Source = Source {
    pass: "chart",
    vertex: &[shader!("screen.vert")],
    fragment: &[
        shader!("colour.glsl"),
        shader!("scale.glsl"),
        shader!("chart.frag"),
    ],
    samplers: &["field"],
    uniforms: &["part", "edge", "span"],
};

const DISC: Source = Source {
    pass: "disc",
    vertex: &[shader!("particle.glsl"), shader!("gather.vert")],
    fragment: &[
        shader!("colour.glsl"),
        shader!("scale.glsl"),
        shader!("disc.frag"),
    ],
    samplers: &["particles"],
    uniforms: &["world", "count", "kernel", "span"],
};

const SPRITE: Source = Source {
    pass: "sprite",
    vertex: &[shader!("particle.glsl"), shader!("sprite.vert")],
    fragment: &[shader!("colour.glsl"), shader!("sprite.frag")],
    samplers: &["particles", "noise", "black_body"],
    uniforms: &["world", "count", "sprite", "shine", "table", "pale"],
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pass_declares_exactly_what_is_set() {
        for source in SOURCES {
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

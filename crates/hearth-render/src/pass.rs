//! A pass: a pair of shaders, their uniforms, a target and its state.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::shaders::{FLOATS, Shader, Uniforms};

/// A pass of a frame.
pub trait Pass {
    /// Target.
    const TARGET: Image;
    /// Content of the target before the pass.
    const LOAD: Load = Load::Keep;
    /// Blending with the target.
    const BLEND: Blend = Blend::Replace;
    /// Geometry.
    const DRAW: Draw;
    /// How often it draws.
    const PER: Per = Per::Frame;
    /// Levels of the bloom that it draws.
    const LEVELS: Levels = Levels::Once;
    /// The uniforms of its shaders.
    type Uniforms: Uniforms;

    /// Whether a frame includes this pass.
    fn applies(frame: &FrameUniforms) -> bool;

    /// Values of the uniforms at a level of the bloom.
    fn uniforms(frame: &FrameUniforms, level: usize) -> Self::Uniforms;
}

/// Content of a target before a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Load {
    /// The previous content.
    Keep,
    /// Transparent black or, for the picture, its background.
    Clear,
}

/// Blending of colours with those of the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blend {
    /// Replaces the target.
    Replace,
    /// Sum of both.
    Add,
    /// In front of the target, premultiplied.
    Over,
    /// Behind the target, premultiplied.
    Under,
    /// Screen blending of all four channels: the order does not matter, and no colour exceeds
    /// its alpha.
    Screen,
}

impl Blend {
    /// Factors of the source and of the destination; `None` without blending.
    pub fn factors(self) -> Option<(u32, u32)> {
        match self {
            Blend::Replace => None,
            Blend::Add => Some((glow::ONE, glow::ONE)),
            Blend::Over => Some((glow::ONE, glow::ONE_MINUS_SRC_ALPHA)),
            Blend::Under => Some((glow::ONE_MINUS_DST_ALPHA, glow::ONE)),
            Blend::Screen => Some((glow::ONE, glow::ONE_MINUS_SRC_COLOR)),
        }
    }

    /// What joins both: their sum; or the larger where a target stores roots of light, since the sum of roots is the root
    /// of more than both.
    pub fn equation(self, is_rooted: bool) -> u32 {
        if self == Blend::Under && is_rooted {
            glow::MAX
        } else {
            glow::FUNC_ADD
        }
    }
}

/// Geometry of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Draw {
    /// The whole target.
    All,
    /// The bounds of the fire.
    Reach,
    /// The bounds of the slices behind the front one.
    Behind,
    /// The bounds of the fire and its glow.
    Halo,
    /// The wall, or the ground alone.
    Backdrop,
    /// A quad for each particle.
    Particles,
    /// A quad for each ember.
    Embers,
    /// A quad for each solid, or for parts of it.
    Solids,
    /// The same of the solids that are drawn with the lit wall.
    Cladding,
    /// A quad for each solid on the ground.
    Shadows,
}

/// How often a pass draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Per {
    /// Once in a frame.
    Frame,
    /// For each visible slice.
    Slice,
    /// For each sample of the history that a visible slice has reached.
    Sample,
}

/// Levels of the bloom that a pass draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Levels {
    /// None: the pass draws once.
    Once,
    /// Each blurred copy, sharpest first.
    Down,
    /// Each blended copy, widest first.
    Up,
}

impl Levels {
    /// The levels in drawing order, for a bloom with `widest + 1` levels.
    pub fn of(self, widest: usize) -> impl Iterator<Item = usize> {
        let (count, last) = match self {
            Levels::Once => (1, 0),
            Levels::Down => (widest + 1, 0),
            Levels::Up => (widest, widest - 1),
        };
        (0..count).map(move |step| step.abs_diff(last))
    }
}

/// A row of the table of passes.
pub struct Row {
    /// Name in `stats.passes`.
    pub name: &'static str,
    pub shader: Shader,
    pub target: Image,
    pub load: Load,
    pub blend: Blend,
    pub draw: Draw,
    pub per: Per,
    pub levels: Levels,
    pub applies: fn(&FrameUniforms) -> bool,
    pub uniforms: fn(&FrameUniforms, usize, &mut [f32; FLOATS]),
}

impl Row {
    /// The row of a pass with that name.
    pub const fn of<P: Pass>(name: &'static str) -> Row {
        Row {
            name,
            shader: P::Uniforms::SHADER,
            target: P::TARGET,
            load: P::LOAD,
            blend: P::BLEND,
            draw: P::DRAW,
            per: P::PER,
            levels: P::LEVELS,
            applies: P::applies,
            uniforms: |frame, level, to| P::uniforms(frame, level).write(to),
        }
    }
}

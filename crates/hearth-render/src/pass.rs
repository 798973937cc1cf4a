//! What a pass is: a pair of shaders with their uniforms, what it draws into, and how.

use crate::frame::Frame;
use crate::image::Image;
use crate::shaders::{FLOATS, Shader, Uniforms};

/// A pass of a frame.
pub trait Pass {
    /// Key in `stats.passes`, as published. Consecutive passes of one key are told as one.
    const KEY: &'static str;
    /// What it draws into.
    const TARGET: Image;
    /// What the target holds before.
    const LOAD: Load = Load::Keep;
    /// How its colours join those of the target.
    const BLEND: Blend = Blend::Replace;
    /// What it draws.
    const DRAW: Draw;
    /// How often it draws.
    const LEVELS: Levels = Levels::Once;
    /// The uniforms of its shaders.
    type Uniforms: Uniforms;

    /// Whether a frame has this pass.
    fn applies(frame: &Frame) -> bool;

    /// What its shaders get, at that level of the bloom.
    fn uniforms(frame: &Frame, level: usize) -> Self::Uniforms;
}

/// What a target holds before a pass draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Load {
    /// What it held.
    Keep,
    /// Nothing, or the background of the picture.
    Clear,
}

/// How colours join those of the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blend {
    /// They replace them.
    Replace,
    /// Both are added.
    Add,
    /// In front of them, premultiplied.
    Over,
    /// Behind them, premultiplied.
    Under,
    /// Light on light, channel by channel and alpha too: the order does not matter, and no
    /// colour exceeds its alpha.
    Screen,
}

impl Blend {
    /// The factors of what is drawn and of what is there; none where nothing is blended.
    pub fn factors(self) -> Option<(u32, u32)> {
        match self {
            Blend::Replace => None,
            Blend::Add => Some((glow::ONE, glow::ONE)),
            Blend::Over => Some((glow::ONE, glow::ONE_MINUS_SRC_ALPHA)),
            Blend::Under => Some((glow::ONE_MINUS_DST_ALPHA, glow::ONE)),
            Blend::Screen => Some((glow::ONE, glow::ONE_MINUS_SRC_COLOR)),
        }
    }
}

/// What a pass draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Draw {
    /// The whole target.
    All,
    /// The part that the fire can reach.
    Reach,
    /// The part that the fire and its glow can reach.
    Halo,
    /// A quad for each particle.
    Particles,
    /// A quad for each ember.
    Embers,
}

/// How often a pass draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Levels {
    /// Once.
    Once,
    /// Once for each blurred copy, from the sharpest on.
    Down,
    /// Once for each joined copy, from the widest on.
    Up,
}

impl Levels {
    /// The levels, in their order, of a bloom of `widest + 1`.
    pub fn of(self, widest: usize) -> impl Iterator<Item = usize> {
        let (count, last) = match self {
            Levels::Once => (1, 0),
            Levels::Down => (widest + 1, 0),
            Levels::Up => (widest, widest - 1),
        };
        (0..count).map(move |step| step.abs_diff(last))
    }
}

/// A pass as a row of the table.
pub struct Row {
    pub key: &'static str,
    pub shader: Shader,
    pub target: Image,
    pub load: Load,
    pub blend: Blend,
    pub draw: Draw,
    pub levels: Levels,
    pub applies: fn(&Frame) -> bool,
    pub uniforms: fn(&Frame, usize, &mut [f32; FLOATS]),
}

impl Row {
    /// The row of that pass.
    pub const fn of<P: Pass>() -> Row {
        Row {
            key: P::KEY,
            shader: P::Uniforms::SHADER,
            target: P::TARGET,
            load: P::LOAD,
            blend: P::BLEND,
            draw: P::DRAW,
            levels: P::LEVELS,
            applies: P::applies,
            uniforms: |frame, level, to| P::uniforms(frame, level).write(to),
        }
    }
}

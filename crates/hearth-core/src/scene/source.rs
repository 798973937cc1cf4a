//! A source as solvers and pictures read it.

use crate::params::{AnyValue, PARAMETERS, Param, Parameters, Source, SourceShape};
use std::ops::Deref;

/// Distance of the seeds of two sources, so that sources flicker independently.
const SEED_STRIDE: u32 = 0x9E37_79B9;

/// A source of a scene.
#[derive(Clone, Copy, Debug)]
pub struct SceneSource<'a> {
    own: &'a Source,
    /// The values of the world.
    pub world: &'a Parameters,
    /// Its seed, which no other source of the scene has.
    pub seed: u32,
}

impl Deref for SceneSource<'_> {
    type Target = Source;
    fn deref(&self) -> &Source {
        self.own
    }
}

impl<'a> SceneSource<'a> {
    /// The source at this index among the sources.
    pub(crate) fn new(own: &'a Source, world: &'a Parameters, index: usize) -> SceneSource<'a> {
        let seed = world.seed ^ (index as u32).wrapping_mul(SEED_STRIDE);
        SceneSource { own, world, seed }
    }

    /// The id of the solid whose surface is the source; `None` for a line.
    pub fn solid_id(&self) -> Option<u32> {
        (self.shape == SourceShape::Solid).then_some(self.solid)
    }

    /// The values of the world and of the source that differ from the defaults of the model.
    pub(crate) fn changed(self) -> impl Iterator<Item = (&'static Param, AnyValue<'static>)> {
        PARAMETERS.iter().filter_map(move |param| {
            let default = param.domain(self.world.model)?.default;
            let value = self.own.get(param).or_else(|| self.world.get(param.id))?;
            (value != default).then_some((param, value))
        })
    }
}

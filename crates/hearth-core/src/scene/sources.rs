//! The sources of a scene.

use super::source::SceneSource;
use super::{Scene, Surface};
use crate::params::{Solid, Source};

impl Scene {
    /// All sources, also those that are off, in the order of the objects.
    pub(super) fn all_sources(&self) -> impl Iterator<Item = SceneSource<'_>> {
        let own = self
            .objects
            .iter()
            .filter_map(|object| object.values.source());
        let all = own.enumerate();
        all.map(|(index, own)| SceneSource::new(own, &self.world, index))
    }

    /// Each source that is on, in the order of the objects. A source on a solid that is off is off, too.
    pub fn sources(&self) -> impl Iterator<Item = SceneSource<'_>> {
        self.all_sources().filter(|source| {
            let solid = source.solid_id();
            let mut all = self.objects.iter();
            let is_off = all.any(|object| Some(object.id) == solid && object.is_off());
            source.enabled && !is_off
        })
    }

    /// The first source, whose properties have ids of parameters. It may be off.
    pub fn first_source(&self) -> Option<SceneSource<'_>> {
        self.all_sources().next()
    }

    /// The id of the first source.
    pub fn first_source_id(&self) -> Option<u32> {
        let mut sources = self.objects.iter();
        let first = sources.find(|object| object.values.source().is_some());
        first.map(|source| source.id)
    }

    /// Reads the first source or, without one, a source with the defaults.
    pub fn read_first_source<T>(&self, read: impl FnOnce(&SceneSource<'_>) -> T) -> T {
        match self.first_source() {
            Some(source) => read(&source),
            None => read(&SceneSource::new(
                &Source::new(self.model()),
                &self.world,
                0,
            )),
        }
    }

    /// The solid that a source is on and its surface; `None` if the source is a line.
    pub fn solid_of(&self, source: &SceneSource<'_>) -> Option<(&Solid, &Surface)> {
        let id = source.solid_id()?;
        let (_, solid, surface) = self.surfaces().find(|(known, ..)| *known == id)?;
        Some((solid, surface))
    }

    /// Total power of the sources [kW/m], in the combustion model.
    pub fn power(&self) -> f32 {
        self.sources().map(|source| source.power).sum()
    }
}

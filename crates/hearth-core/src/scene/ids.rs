//! Other ids for the objects of a scene.

use super::kinds::Values;
use super::{MAX_ID, Scene};
use crate::params::Input;

impl Scene {
    /// Gives each object the id that follows from its present one. Sources stay on their solids, solids hang from theirs,
    /// and what names an object that is gone gets no other one.
    pub fn renumber(&mut self, follows: &dyn Fn(u32) -> u32) {
        let renamed = |id: u32| match id {
            0 => 0,
            id => follows(id).min(MAX_ID as u32),
        };
        let mut sources = vec![&mut self.settings];
        for object in &mut self.objects {
            object.id = follows(object.id);
            match &mut object.values {
                Values::Source(source) => sources.push(source),
                Values::Solid(solid) => solid.0.hangs_from = renamed(solid.0.hangs_from),
                Values::FirstSource => {}
            }
        }
        for source in sources {
            let solid = Input::Number(renamed(source.source_solid).into());
            let set = source.set("source_solid", solid);
            debug_assert_eq!(set, Ok(()));
        }
    }
}

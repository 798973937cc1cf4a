//! Other ids for the objects of a scene.

use super::Scene;
use super::kinds::Values;
use crate::params::Input;

impl Scene {
    /// Gives each object the id that follows from its present one. Sources stay on their solids, and one whose solid is
    /// gone gets no other one.
    pub fn renumber(&mut self, follows: &dyn Fn(u32) -> u32) {
        let mut sources = vec![&mut self.settings];
        for object in &mut self.objects {
            object.id = follows(object.id);
            if let Values::Source(source) = &mut object.values {
                sources.push(source);
            }
        }
        for source in sources {
            if source.source_solid > 0 {
                let solid = Input::Number(follows(source.source_solid).into());
                // Beyond the largest id there is no solid, either.
                source.set("source_solid", solid).ok();
            }
        }
    }
}

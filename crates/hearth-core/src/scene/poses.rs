//! Where the solids of a scene are at a time.

use super::{Pose, Scene};

impl Scene {
    /// Where the solids that are on are at a time of the fire \[s\], in the order of the objects. Those
    /// that forces move are where they start.
    pub fn poses(&self, time: f64) -> Vec<Pose> {
        let surfaces = self.surfaces();
        let poses = surfaces.map(|(id, solid, surface)| Pose {
            id,
            frame: solid.frame_at(surface, time),
        });
        poses.collect()
    }
}

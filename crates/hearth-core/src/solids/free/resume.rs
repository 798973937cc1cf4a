//! Free bodies of a saved fire.

use glam::Vec2;

use super::body::Rigid;
use super::sleep::TIME_TO_SLEEP;
use super::state::FreeBodies;
use crate::extremes::fast_max;
use crate::solids::Solids;

impl FreeBodies {
    /// Moves the bodies to the states in these numbers, in the order of the objects: for each its place \[m\], the
    /// cosine and the sine of its angle, its velocity [m/s], its spin [1/s], and 1 if it sleeps.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn resume(solids: &mut Solids, numbers: &[f32]) {
        if let Some(mut free) = solids.free.take() {
            let bodies = free.all.iter_mut().filter(|body| body.is_free);
            let (all, _) = numbers.as_chunks();
            for (body, numbers) in bodies.zip(all) {
                body.resume(numbers);
            }
            free.let_go_apart();
            free.place(solids);
            solids.free = Some(free);
        }
    }
}

impl Rigid {
    fn resume(&mut self, &[x, y, cosine, sine, u, v, spin, asleep]: &[f32; 8]) {
        let axis = Vec2::new(cosine, sine);
        let axis = axis / fast_max(axis.length(), 0.5);
        self.surface.frame.axis = axis;
        self.surface.frame.centre = Vec2::new(x, y) + axis.rotate(self.middle);
        self.centre = self.surface.frame.centre + axis.rotate(self.offset);
        (self.velocity, self.spin) = (Vec2::new(u, v), spin);
        self.asleep = asleep > 0.0;
        self.touches = self.asleep;
        self.still = if self.asleep { TIME_TO_SLEEP } else { 0.0 };
    }
}

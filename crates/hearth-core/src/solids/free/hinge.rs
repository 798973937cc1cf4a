//! A hinge between two bodies.

use glam::Vec2;

use super::body::Rigid;
use super::contact::Pair;
use crate::scene::RoundedBox;

/// A hinge.
#[derive(Clone, Debug)]
pub(super) struct Hinge {
    /// At the body that hangs, and at the solid that it hangs from.
    pub ends: [End; 2],
    pub is_broken: bool,
    /// The bodies and their arms; `None` without either body, or where it has let go. And whether
    /// one of them is awake.
    pub pair: Option<Pair>,
    pub is_live: bool,
    /// From the place of the other to that of the one \[m\].
    pub error: Vec2,
    /// The impulse on the one [N·s/m].
    pub impulse: Vec2,
    /// What an impulse changes: xx, yy and xy [m/kg].
    pub inverse: [f32; 3],
}

/// An end of a hinge.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// The ids of the solid, and of the part of it that has the place.
    pub object: u32,
    pub part: u32,
    /// The place in the frame of the solid \[m\].
    pub at: Vec2,
}

crate::state! { Hinge: ends is_broken pair is_live error impulse inverse, End: object part at }

impl Hinge {
    /// The hinge of a body and the solid that it hangs from, as they are at their start.
    pub fn of(hanging: &Rigid, support: &Rigid) -> Hinge {
        let place = hanging.first.centre + hanging.first.axis.rotate(upper(&hanging.first));
        let ends = [hanging, support].map(|body| End {
            object: body.id,
            part: body.id,
            at: body.first.local(place) + body.middle,
        });
        Hinge {
            ends,
            is_broken: false,
            pair: None,
            is_live: false,
            error: Vec2::ZERO,
            impulse: Vec2::ZERO,
            inverse: [0.0; 3],
        }
    }

    /// The two bodies, unless it has let go.
    pub fn bodies(&self) -> Option<[usize; 2]> {
        self.pair.map(|pair| pair.bodies)
    }

    /// Finds its bodies. Without the part of a solid it is at the solid.
    pub fn find(&mut self, all: &[Rigid]) {
        let found = self.ends.each_mut().map(|end| {
            let of = |id: u32| all.iter().position(|body| body.id == id);
            let part = of(end.part);
            if part.is_none() {
                end.part = end.object;
            }
            part.or_else(|| of(end.object))
        });
        self.pair = match found {
            [Some(first), Some(second)] if !self.is_broken => {
                self.is_broken = all[first].is_gone() || all[second].is_gone();
                let arms = [Vec2::ZERO; 2];
                let bodies = [first, second];
                (!self.is_broken).then_some(Pair { bodies, arms })
            }
            _ => None,
        };
    }

    /// Keeps its impulse for a substep that is so many times as long as that before.
    pub fn continue_from(&mut self, scale: f32) {
        self.impulse *= scale;
    }
}

/// The place by which a body hangs, in its frame: the highest of the middles of the sides of the box
/// that its radius surrounds.
fn upper(frame: &RoundedBox) -> Vec2 {
    let RoundedBox { axis, half, .. } = frame;
    let (side, top) = (half.x * axis.y, half.y * axis.x);
    if side.abs() > top.abs() {
        Vec2::new(half.x.copysign(side), 0.0)
    } else {
        Vec2::new(0.0, half.y.copysign(top))
    }
}

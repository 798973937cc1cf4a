//! Where the domain ends, and which of its edges are the same place.

use glam::Vec2;

/// The rectangle in which the fire burns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub width: f32,
    pub height: f32,
    /// Whether the left and the right edge are the same place.
    pub periodic: bool,
    /// Whether the lower and the upper edge are the same place.
    pub endless: bool,
}

impl Bounds {
    /// Whether `position` is inside; NaN is not.
    #[inline]
    pub fn hold(&self, position: Vec2) -> bool {
        position.x.abs() <= 0.5 * self.width && (0.0..=self.height).contains(&position.y)
    }

    /// Brings a position that has left over a periodic edge back in.
    #[inline]
    pub fn wrap(&self, position: Vec2) -> Vec2 {
        let mut inside = position;
        if self.periodic {
            inside.x = wrap(position.x + 0.5 * self.width, self.width) - 0.5 * self.width;
        }
        if self.endless {
            inside.y = wrap(position.y, self.height);
        }
        inside
    }
}

#[cfg(test)]
impl Bounds {
    /// The offset from `b` to `a`, the short way round.
    pub fn offset(&self, a: Vec2, b: Vec2) -> Vec2 {
        let short_way = |offset: f32, turn: f32| offset - turn * (offset / turn).round();
        let mut offset = a - b;
        if self.periodic {
            offset.x = short_way(offset.x, self.width);
        }
        if self.endless {
            offset.y = short_way(offset.y, self.height);
        }
        offset
    }
}

/// `x` modulo `turn`, from 0 to it; rounding may give the end itself.
#[inline]
fn wrap(x: f32, turn: f32) -> f32 {
    if (0.0..=turn).contains(&x) {
        return x;
    }
    // `clamp` would bring the code that prints both ends where they are the wrong
    // way round: 20 KB.
    (x - turn * (x / turn).floor()).max(0.0).min(turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_keeps_the_place_modulo_the_turn() {
        let bounds = Bounds {
            width: 1.2,
            height: 0.7,
            periodic: true,
            endless: true,
        };
        for x in [-1.7_f32, -0.6, -0.5999, -1e-9, 0.0, 0.31, 0.6, 0.61, 1.9] {
            let wrapped = bounds.wrap(Vec2::new(x, x));
            assert!(bounds.hold(wrapped), "{x} -> {wrapped}");
            for turns in [(x - wrapped.x) / 1.2, (x - wrapped.y) / 0.7] {
                assert!((turns - turns.round()).abs() < 1e-5, "{x} -> {wrapped}");
            }
        }
    }
}

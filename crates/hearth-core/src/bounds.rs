//! The rectangular domain and its periodic edges.

use glam::Vec2;

/// The rectangle in which the fire burns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    /// The middle of the lower edge is at x = 0 and this height \[m\]; 0 with a periodic lower
    /// edge.
    pub bottom: f32,
    pub width: f32,
    pub height: f32,
    /// Whether the left and the right edge are identified.
    pub periodic_x: bool,
    /// Whether the lower and the upper edge are identified.
    pub periodic_y: bool,
}

crate::state! { Bounds: bottom width height periodic_x periodic_y }

impl Bounds {
    /// Whether `position` is inside. NaN is outside.
    #[inline]
    pub fn contains(&self, position: Vec2) -> bool {
        position.x.abs() <= 0.5 * self.width
            && (0.0..=self.height).contains(&(position.y - self.bottom))
    }

    /// Whether a rectangle with these corners overlaps it.
    pub fn overlaps(&self, low: Vec2, high: Vec2) -> bool {
        let half = 0.5 * self.width;
        low.x < half && high.x > -half && low.y < self.bottom + self.height && high.y > self.bottom
    }

    /// Maps a position beyond a periodic edge back into the domain.
    #[inline]
    pub fn wrap(&self, position: Vec2) -> Vec2 {
        let mut inside = position;
        if self.periodic_x {
            inside.x = wrap(position.x + 0.5 * self.width, self.width) - 0.5 * self.width;
        }
        if self.periodic_y {
            inside.y = wrap(position.y, self.height);
        }
        inside
    }
}

#[cfg(test)]
impl Bounds {
    /// The shortest offset from `b` to `a`.
    pub fn offset(&self, a: Vec2, b: Vec2) -> Vec2 {
        let shortest = |offset: f32, period: f32| offset - period * (offset / period).round();
        let mut offset = a - b;
        if self.periodic_x {
            offset.x = shortest(offset.x, self.width);
        }
        if self.periodic_y {
            offset.y = shortest(offset.y, self.height);
        }
        offset
    }
}

/// `x` modulo `period`, from 0 to `period`; rounding may give `period` itself.
#[inline]
fn wrap(x: f32, period: f32) -> f32 {
    if (0.0..=period).contains(&x) {
        return x;
    }
    // Unlike `clamp`, a place in the domain for what is no number too.
    (x - period * (x / period).floor()).max(0.0).min(period)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_keeps_the_position_modulo_the_period() {
        let bounds = Bounds {
            bottom: 0.0,
            width: 1.2,
            height: 0.7,
            periodic_x: true,
            periodic_y: true,
        };
        for x in [-1.7_f32, -0.6, -0.5999, -1e-9, 0.0, 0.31, 0.6, 0.61, 1.9] {
            let wrapped = bounds.wrap(Vec2::new(x, x));
            assert!(bounds.contains(wrapped), "{x} -> {wrapped}");
            for turns in [(x - wrapped.x) / 1.2, (x - wrapped.y) / 0.7] {
                assert!((turns - turns.round()).abs() < 1e-5, "{x} -> {wrapped}");
            }
        }
    }
}

//! Slices: moments of a fire's past that a picture shows behind the present one, so that a plane
//! flow has depth. `docs/look.md` has the equations.

use hearth_core::SourcePlace;

use crate::bounds::Bounds;

/// Maximum number of slices of a picture.
pub const MAX_SLICES: usize = 5;

/// How a slice differs from the present fire.
struct Layer {
    /// Its lag in periods of puffing. The first layers have evenly spread phases, so that at every moment
    /// one of them flares at the base.
    lag: f64,
    /// Whether it is mirrored, which hides that it is the same fire.
    mirrored: bool,
    /// Its offset to the right in widths of the source.
    offset: f32,
    /// Its scale.
    scale: f32,
}

/// The layers, from the front.
const LAYERS: [Layer; MAX_SLICES] = [
    Layer {
        lag: 0.0,
        mirrored: false,
        offset: 0.0,
        scale: 1.0,
    },
    Layer {
        lag: 1.6,
        mirrored: true,
        offset: 0.14,
        scale: 0.95,
    },
    Layer {
        lag: 3.2,
        mirrored: false,
        offset: -0.20,
        scale: 0.90,
    },
    Layer {
        lag: 0.8,
        mirrored: true,
        offset: -0.25,
        scale: 1.04,
    },
    Layer {
        lag: 2.4,
        mirrored: false,
        offset: 0.24,
        scale: 0.93,
    },
];

/// Frequency of puffing of a fire of 1 m \[Hz\]; of another width b it is this divided by √b
/// (Cetegen and Ahmed 1993).
const PUFFING_HERTZ: f64 = 1.5;
/// Maximum lag \[s\].
const MAX_LAG: f64 = 1.7;
/// Duration of a slice's fade \[s\].
const FADE_SECONDS: f32 = 0.25;

/// The lag of a slice behind a source of that width \[s\].
pub fn lag(index: usize, source_width: f32) -> f64 {
    (LAYERS[index].lag * f64::from(source_width).sqrt() / PUFFING_HERTZ).min(MAX_LAG)
}

/// Which differences from the present fire a scene allows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Arrangement {
    /// Whether the scene is the same when it is mirrored.
    pub mirrors: bool,
    /// Whether gas may be displaced and scaled. Beside solids it would enter them.
    pub spreads: bool,
}

/// The visibility of a slice. It changes at samples of the history, so it is a function of the
/// moment at every frame rate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fade {
    weight: f32,
    /// Change of the weight [1/s].
    rate: f32,
    arrangement: Arrangement,
}

hearth_core::state! { Fade: weight rate arrangement, Arrangement: mirrors spreads }

impl Fade {
    /// Advances by the time since the last sample \[s\]. `wanted`: the arrangement of the scene, or
    /// `None` while the slice must not be seen. The arrangement changes while the slice is invisible.
    pub fn advance(&mut self, elapsed: f32, wanted: Option<Arrangement>) {
        self.weight = self.after(elapsed);
        if let (true, Some(arrangement)) = (self.weight == 0.0, wanted) {
            self.arrangement = arrangement;
        }
        let is_wanted = wanted == Some(self.arrangement);
        self.rate = if is_wanted { 1.0 } else { -1.0 } / FADE_SECONDS;
    }

    /// The weight a time after the last sample \[s\], 0 to 1.
    pub fn after(&self, elapsed: f32) -> f32 {
        (self.weight + self.rate * elapsed).clamp(0.0, 1.0)
    }
}

/// The number of slices of a picture. It follows the wanted number with the time of the fire, so that slices beyond
/// it fade.
#[derive(Clone, Copy, Debug, Default)]
pub struct Count {
    /// The number and the time of the last picture \[s\].
    last: Option<(f32, f64)>,
}

impl Count {
    /// The number at a moment \[s\]; its fraction is the weight of the last slice. In the first picture and while the fire
    /// is paused it is the wanted number.
    pub fn advance(&mut self, time: f64, wanted: usize, is_paused: bool) -> f32 {
        let mut count = wanted as f32;
        if let Some((last, then)) = self.last.filter(|_| !is_paused) {
            let change = ((time - then).max(0.0) / f64::from(FADE_SECONDS)) as f32;
            // `clamp` prints its limits if they are no numbers: the code for that takes 9 KB of the download.
            count = last + (count - last).max(-change).min(change);
        }
        self.last = Some((count, time));
        count
    }
}

/// A visible slice of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice {
    /// Its number from the front.
    pub index: usize,
    /// The moment that it shows \[s\].
    pub moment: f64,
    /// Scale of its positions. That of x is negative if it is mirrored.
    pub scale: [f32; 2],
    /// Offset of its scaled positions \[m\].
    pub offset: [f32; 2],
    /// Displacement of its base to the right \[m\].
    pub shift: f32,
    /// Its share of the optical depth of one slice.
    pub depth: f32,
    /// Its share of the smoke of one slice.
    pub smoke: f32,
}

impl Slice {
    /// The slice of the present.
    pub fn present(time: f64) -> Slice {
        Slice {
            index: 0,
            moment: time,
            scale: [1.0; 2],
            offset: [0.0; 2],
            shift: 0.0,
            depth: 1.0,
            smoke: 1.0,
        }
    }

    /// A slice behind the present one. `weight`: how far it has faded in. `base_then`: the base of the source at its moment.
    /// `None` while it is invisible. Its depth and smoke are its weight.
    pub fn behind(
        index: usize,
        moment: f64,
        fade: &Fade,
        weight: f32,
        source: &SourcePlace,
        base_then: [f32; 2],
    ) -> Option<Slice> {
        let layer = &LAYERS[index];
        let Arrangement { mirrors, spreads } = fade.arrangement;
        let (offset, scale) = if spreads {
            (layer.offset, layer.scale)
        } else {
            (0.0, 1.0)
        };
        let side = if mirrors && layer.mirrored {
            -scale
        } else {
            scale
        };
        let shift = offset * source.width;
        let [x, y] = base_then;
        // An even start and end of the fade.
        let weight = weight * weight * (3.0 - 2.0 * weight);
        (weight > 0.0).then_some(Slice {
            index,
            moment,
            scale: [side, scale],
            offset: [source.base.x + shift - side * x, source.base.y - scale * y],
            shift,
            depth: weight,
            smoke: weight,
        })
    }

    /// The bounds of moved gas.
    pub fn moved(&self, mut bounds: Bounds) -> Bounds {
        let to = |at: f32, axis: usize| at * self.scale[axis] + self.offset[axis];
        bounds.heights = bounds.heights.map(|y| to(y, 1));
        for row in &mut bounds.rows {
            *row = row.map(|x| to(x, 0));
            if self.scale[0] < 0.0 {
                row.reverse();
            }
        }
        bounds
    }
}

/// Shares depth and smoke among visible slices of those weights. K slices have √K times the optical depth of
/// one, because a real fire is deeper than one sheet and its sheets hide each other, but the smoke of
/// one.
pub fn share(slices: &mut [Slice]) {
    let sum: f32 = slices.iter().map(|slice| slice.depth).sum();
    for slice in slices {
        slice.smoke = slice.depth / sum;
        slice.depth /= sum.sqrt();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::tests::{bounds_of, has};
    use hearth_core::Vec2;

    const FREE: Arrangement = Arrangement {
        mirrors: true,
        spreads: true,
    };

    fn source(x: f32) -> SourcePlace {
        SourcePlace {
            base: Vec2::new(x, 0.1),
            width: 0.3,
            on_solid: false,
        }
    }

    fn visible(arrangement: Arrangement) -> Fade {
        let mut fade = Fade::default();
        fade.advance(0.0, Some(arrangement));
        fade.advance(1.0, Some(arrangement));
        fade
    }

    #[test]
    fn the_first_one_three_and_five_layers_have_evenly_spread_phases() {
        for count in [1, 3, 5] {
            let mut phases: Vec<f64> = LAYERS[..count].iter().map(|l| l.lag.fract()).collect();
            phases.sort_by(f64::total_cmp);
            phases.push(1.0);
            for pair in phases.windows(2) {
                let gap = (pair[1] - pair[0]) * count as f64;
                assert!((0.55..=1.25).contains(&gap), "{phases:?}");
            }
        }
    }

    #[test]
    fn the_base_stays_at_the_source_in_every_arrangement() {
        for mirrors in [false, true] {
            for spreads in [false, true] {
                let fade = visible(Arrangement { mirrors, spreads });
                for index in 1..MAX_SLICES {
                    let then = [-0.2, 0.3];
                    let slice = Slice::behind(index, 1.0, &fade, 1.0, &source(0.4), then)
                        .expect("a visible slice");
                    let moved = slice.moved(bounds_of([then]));
                    let ([x, _], [y, _]) = (moved.rows[0], moved.heights);
                    assert!((x - 0.4 - slice.shift).abs() < 1e-6 && (y - 0.1).abs() < 1e-6);
                    assert!(spreads || slice.shift == 0.0);
                }
            }
        }
    }

    #[test]
    fn moved_bounds_enclose_moved_gas() {
        let slice = Slice::behind(1, 1.0, &visible(FREE), 1.0, &source(0.0), [0.0, 0.1]);
        let (slice, places) = (
            slice.expect("visible"),
            [[-0.1, 0.0], [0.5, 0.1], [0.2, 1.0]],
        );
        let moved = slice.moved(bounds_of(places));
        for place in places {
            let place = [0, 1].map(|axis| place[axis] * slice.scale[axis] + slice.offset[axis]);
            assert!(
                has(&Bounds::around(&[moved], 1e-6), place),
                "{place:?} in {moved:?}"
            );
        }
        assert!(slice.scale[0] < 0.0 && moved.rows[1][0] < -0.4);
    }

    #[test]
    fn a_slice_fades_in_and_out_and_changes_its_arrangement_unseen() {
        let mut fade = Fade::default();
        fade.advance(0.0, Some(FREE));
        let mut weights = Vec::new();
        for step in 0..40 {
            let wanted = match step {
                0..20 => FREE,
                _ => Arrangement::default(),
            };
            let before = fade;
            fade.advance(1.0 / 30.0, Some(wanted));
            assert!((fade.weight - before.weight).abs() <= 1.0 / 30.0 / FADE_SECONDS + 1e-6);
            assert!(fade.arrangement == before.arrangement || fade.weight == 0.0);
            weights.push(fade.weight);
        }
        assert_eq!(
            (weights[19], fade.arrangement),
            (1.0, Arrangement::default())
        );
        assert!(weights[20..].contains(&0.0) && weights[39] == 1.0);
        fade.advance(0.0, None);
        assert_eq!(fade.after(FADE_SECONDS), 0.0);
    }

    #[test]
    fn another_number_of_slices_is_reached_as_each_fades() {
        let mut count = Count::default();
        assert_eq!(count.advance(7.0, 5, false), 5.0);
        let (mut time, mut last) = (7.0, 5.0);
        for wanted in [1, 5] {
            for _ in 0..40 {
                time += 1.0 / 30.0;
                let next = count.advance(time, wanted, false);
                assert!((next - last).abs() <= 1.0 / 30.0 / FADE_SECONDS + 1e-4);
                assert_eq!(count.advance(time, wanted, false), next);
                last = next;
            }
            assert_eq!(last, wanted as f32);
        }
        assert_eq!(count.advance(time, 3, true), 3.0);
    }

    #[test]
    fn slices_that_fade_leave_their_depth_to_the_others() {
        for weights in [&[1.0_f32][..], &[1.0, 0.0001], &[1.0, 1.0, 1.0, 0.4, 1.0]] {
            let mut slices: Vec<Slice> = weights
                .iter()
                .map(|&depth| Slice {
                    depth,
                    ..Slice::present(0.0)
                })
                .collect();
            let sum: f32 = weights.iter().sum();
            share(&mut slices);
            let depth: f32 = slices.iter().map(|slice| slice.depth).sum();
            let smoke: f32 = slices.iter().map(|slice| slice.smoke).sum();
            assert!((depth - sum.sqrt()).abs() < 1e-5 && (smoke - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn lags_grow_with_the_source_up_to_a_maximum() {
        assert!((lag(1, 0.36) - 0.64).abs() < 1e-6);
        assert_eq!((lag(0, 0.3), lag(2, 4.0)), (0.0, MAX_LAG));
    }
}

//! Points of a surface: the middles of discs inside of a solid, whose edges are its outermost
//! places. A disc, not a corner, meets another solid: the direction of its distance is certain where
//! two corners meet.

use glam::Vec2;

use crate::direction::direction;
use crate::extremes::{fast_max, fast_min};
use crate::scene::{Field, Surface};

/// Directions in which the outermost place of a sampled surface is sought.
const DIRECTIONS: usize = 24;
/// Radius of the discs in the corners of a solid, in halves of its thickness, and at most \[m\].
const CORNER_RATIO: f32 = 0.1;
const MAX_CORNER: f32 = 0.004;
/// Smallest radius of the discs of a sampled surface \[m\]: thinner parts of what is left of a fire
/// stick into other solids.
const MIN_RADIUS: f32 = 5e-4;
/// Parts between two nodes of a field along a side at most, and places that are looked at then.
const MAX_PARTS: f32 = 8.0;
const MAX_PLACES: f32 = 40_000.0;

/// A disc, in the frame of the solid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sample {
    pub at: Vec2,
    pub radius: f32,
}

/// The discs of a solid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Samples {
    all: [Sample; DIRECTIONS],
    count: usize,
}

crate::state! { Sample: at radius, Samples: all count }

impl Samples {
    /// Those of a surface.
    pub fn of(surface: &Surface) -> Samples {
        let mut samples = Samples::default();
        match &surface.field {
            None => {
                let frame = &surface.frame;
                let thinnest = fast_min(frame.half.x, frame.half.y) + frame.radius;
                let radius = fast_max(frame.radius, fast_min(CORNER_RATIO * thinnest, MAX_CORNER));
                let inner = frame.half + frame.radius - radius;
                let (x, y) = (fast_max(inner.x, 0.0), fast_max(inner.y, 0.0));
                for at in [(-x, -y), (x, -y), (x, y), (-x, y)] {
                    samples.add(Sample {
                        at: at.into(),
                        radius,
                    });
                }
            }
            Some(field) => samples.find(field),
        }
        samples
    }

    /// Those of a sampled surface.
    pub fn of_field(field: &Field) -> Samples {
        let mut samples = Samples::default();
        samples.find(field);
        samples
    }

    /// All of them.
    pub fn all(&self) -> &[Sample] {
        &self.all[..self.count]
    }

    fn add(&mut self, sample: Sample) {
        if self.count < DIRECTIONS && !self.all().contains(&sample) {
            self.all[self.count] = sample;
            self.count += 1;
        }
    }

    /// Finds the outermost nodes of a field at a small depth. Where the nodes are far apart, as the
    /// pixels of a small mask, places between them count too.
    fn find(&mut self, field: &Field) {
        let cells = Vec2::new(field.columns as f32 - 1.0, field.rows as f32 - 1.0);
        let step = 2.0 * field.half / cells;
        let parts = (fast_max(step.x, step.y) / MAX_CORNER).ceil();
        let most = (MAX_PLACES / field.distances.len() as f32).sqrt();
        let parts = fast_max(fast_min(fast_min(parts, MAX_PARTS), most), 1.0) as usize;
        let step = step / parts as f32;
        let columns = (field.columns - 1) * parts + 1;
        let rows = (field.rows - 1) * parts + 1;
        let cell = fast_max(step.x, step.y);
        let radius = fast_min(fast_max(MIN_RADIUS, 0.25 * cell), 0.5 * field.depth);
        let mut best = [(f32::MIN, Sample::default()); DIRECTIONS];
        let mut directions = [Vec2::ZERO; DIRECTIONS];
        for (number, unit) in directions.iter_mut().enumerate() {
            *unit = direction(360.0 / DIRECTIONS as f32 * number as f32);
        }
        for index in 0..columns * rows {
            let (column, row) = (index % columns, index / columns);
            let at = Vec2::new(column as f32, row as f32) * step - field.half;
            let depth = match parts {
                1 => -field.distances[index],
                _ => -field.distance(at).0,
            };
            if depth < radius || depth > radius + 2.0 * cell || depth <= 0.0 {
                continue;
            }
            for (best, direction) in best.iter_mut().zip(&directions) {
                let far = at.dot(*direction) + depth;
                if far > best.0 {
                    *best = (far, Sample { at, radius: depth });
                }
            }
        }
        for (far, sample) in best {
            if far > f32::MIN {
                self.add(sample);
            }
        }
    }
}

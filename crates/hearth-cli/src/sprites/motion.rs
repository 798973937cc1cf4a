//! Motion vectors between two moments of a fire, which a game engine uses to blend pictures along the flow.

use std::collections::HashMap;

use hearth_core::params::Model;
use hearth_core::{Simulation, Vec2};
use hearth_render::{Viewport, luminance};

/// Radius of a particle's kernel in smoothing lengths: wider ones mix the paths of both sides of a flame.
const RADIUS: f32 = 0.7;
/// Weight of gas that does not glow beside that which does, so that vectors go on around the flame.
const DARK: f32 = 1e-4;

/// A moment of a fire.
pub struct Moment {
    ids: Vec<u64>,
    positions: Vec<Vec2>,
    velocities: Vec<Vec2>,
    emission: Vec<f32>,
    length: f32,
    time: f64,
}

impl Moment {
    /// The present of a simulation.
    pub fn of(fire: &Simulation) -> Moment {
        let is_hot = fire.parameters().model == Model::Combustion;
        let emission = fire.particles().into_iter().map(|particle| match is_hot {
            true => particle.soot * luminance(particle.temperature.into()) as f32,
            false => 1.0,
        });
        Moment {
            ids: fire.ids(),
            positions: fire.positions(),
            velocities: fire.velocities(),
            emission: emission.collect(),
            length: fire.parameters().smoothing_length(),
            time: fire.time(),
        }
    }

    /// Displacements of the gas from this moment to a later one, a vector for each pixel of a picture: to the right and
    /// downwards \[pixels\]. A particle that is in both has its own path, another one its velocity times the time. The
    /// vector of a pixel is the mean of the particles that come to it, weighted by their emission.
    pub fn displacements(
        &self,
        later: &Moment,
        viewport: Viewport,
        size: [u32; 2],
    ) -> Vec<[f32; 2]> {
        let [width, height] = size.map(|side| side as usize);
        let [[left, bottom], [right, top]] = viewport.corners();
        let scale = [
            width as f32 / (right - left),
            height as f32 / (top - bottom),
        ];
        let moved: HashMap<_, _> = later.ids.iter().zip(&later.positions).collect();
        let elapsed = (later.time - self.time) as f32;
        let brightest = self
            .emission
            .iter()
            .fold(f32::MIN_POSITIVE, |a, &b| a.max(b));
        let reach = [0, 1].map(|axis| RADIUS * self.length * scale[axis]);
        let mut sums = vec![[0.0; 3]; width * height];
        let particles = self.ids.iter().zip(&self.positions).zip(&self.velocities);
        for (((id, from), velocity), emission) in particles.zip(&self.emission) {
            let path = moved.get(id).map_or(*velocity * elapsed, |to| **to - *from);
            let path = [path.x * scale[0], -path.y * scale[1]];
            let weight = emission / brightest + DARK;
            let centre = [
                (from.x - left) * scale[0] + path[0],
                (top - from.y) * scale[1] + path[1],
            ];
            let span = |axis: usize, end: usize| {
                let low = (centre[axis] - reach[axis]).max(0.0) as usize;
                low..end.min((centre[axis] + reach[axis]).max(0.0) as usize + 1)
            };
            for y in span(1, height) {
                for x in span(0, width) {
                    let away = [
                        (x as f32 + 0.5 - centre[0]) / reach[0],
                        (y as f32 + 0.5 - centre[1]) / reach[1],
                    ];
                    let kernel = 1.0 - away[0] * away[0] - away[1] * away[1];
                    if let (true, Some(sum)) = (kernel > 0.0, sums.get_mut(y * width + x)) {
                        let share = weight * kernel * kernel;
                        sum[0] += share * path[0];
                        sum[1] += share * path[1];
                        sum[2] += share;
                    }
                }
            }
        }
        let mean = |[x, y, weight]: [f32; 3]| match weight > 0.0 {
            true => [x / weight, y / weight],
            false => [0.0; 2],
        };
        sums.into_iter().map(mean).collect()
    }
}

/// The largest component of vectors \[pixels\].
pub fn largest<'a>(vectors: impl IntoIterator<Item = &'a [f32; 2]>) -> f32 {
    let components = vectors.into_iter().flatten();
    components.fold(1.0, |largest: f32, component| largest.max(component.abs()))
}

/// Vectors as opaque pixels: red to the right, green downwards, 128 is none, and 1 and 255 are `largest` \[pixels\].
pub fn encoded(vectors: &[[f32; 2]], largest: f32) -> Vec<u8> {
    let byte = |component: f32| (128.0 + (component / largest * 127.0).round()) as u8;
    let pixels = vectors
        .iter()
        .flat_map(|[x, y]| [byte(*x), byte(*y), 128, 255]);
    pixels.collect()
}

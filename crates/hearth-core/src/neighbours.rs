//! The pairs of particles within each other's kernel.
//!
//! One pass over the grid finds each pair once, sums what its caller wants
//! summed over neighbours, and writes the pair down, so that the forces need no
//! search of their own. The list keeps its memory and is bounded.

use glam::Vec2;

use crate::grid::Grid;
use crate::kernel::Kernel;

/// Most pairs that are written down. It is a net for a browser's memory: many
/// particles within a large smoothing radius would have thousands of
/// neighbours each. A hundred thousand particles reach it at 335 neighbours.
const MOST_PAIRS: usize = 1 << 24;

/// Two particles within each other's kernel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// The other particle.
    pub j: u32,
    /// Offset from j to i \[m\].
    pub offset: Vec2,
    /// W'(r)/r [1/m⁴].
    pub gradient: f32,
}

/// The pairs of all particles, each pair once; one array a property.
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbours {
    j: Vec<u32>,
    offset: Vec<Vec2>,
    gradient: Vec<f32>,
    /// How many pairs the arrays hold; they themselves may be longer.
    found: usize,
    /// Where each particle's pairs end.
    ends: Vec<u32>,
    /// How many neighbours each particle has, whichever end wrote the pair down.
    pub count: Vec<u32>,
    /// W of the pairs of one particle [1/m²].
    weight: Vec<f32>,
}

impl Neighbours {
    pub fn pair_count(&self) -> usize {
        self.found
    }

    /// Every particle that wrote pairs down, with these.
    pub fn iter(&self) -> impl Iterator<Item = (usize, impl Iterator<Item = Pair>)> {
        let mut begin = 0;
        self.ends.iter().enumerate().map(move |(i, &end)| {
            let range = begin..end as usize;
            begin = range.end;
            let pairs = self.j[range.clone()]
                .iter()
                .zip(&self.offset[range.clone()])
                .zip(&self.gradient[range]);
            let pairs = pairs.map(|((&j, &offset), &gradient)| Pair {
                j,
                offset,
                gradient,
            });
            (i, pairs)
        })
    }

    /// Finds all pairs of particles that lie in the order of `grid`, and sets
    /// `sums[i]` to what each particle gets from its neighbours, itself
    /// included: Σⱼ yⱼ Wᵢⱼ, where `shares[j]` is yⱼ.
    pub fn find(
        &mut self,
        positions: &[Vec2],
        grid: &Grid,
        kernel: &Kernel,
        shares: &[f32],
        sums: &mut [f32],
    ) {
        self.found = 0;
        self.ends.clear();
        self.count.clear();
        self.count.resize(positions.len(), 0);
        let reach = kernel.support() * kernel.support();
        let middle = kernel.value(0.0);
        for (sum, &share) in sums.iter_mut().zip(shares) {
            *sum = share * middle;
        }
        for (i, &here) in positions.iter().enumerate() {
            if self.found < MOST_PAIRS {
                let begin = self.found;
                grid.later_candidates(i, here, |run, shift| {
                    self.sift(run.start, &positions[run], here - shift, reach);
                });
                sums[i] += self.weigh(begin, kernel, shares, shares[i], sums);
                self.count[i] += (self.found - begin) as u32;
            }
            self.ends.push(self.found as u32);
        }
    }

    /// Writes down which of `candidates`, numbered from `first` on, are within
    /// reach, the square of a distance, of `here`.
    ///
    /// Of three candidates one is a neighbour, in no order that a processor could
    /// foresee. So each is written down where the next neighbour belongs, and that
    /// place moves on only if it is one: a wrong guess costs more than the writing.
    #[inline]
    fn sift(&mut self, first: usize, candidates: &[Vec2], here: Vec2, reach: f32) {
        let room = self.found + candidates.len();
        if room > self.j.len() {
            // By half as much again, so that a growing fire seldom asks for more.
            let room = room.max(self.j.len() / 2 * 3);
            self.j.resize(room, 0);
            self.offset.resize(room, Vec2::ZERO);
            self.gradient.resize(room, 0.0);
        }
        let (js, offsets) = (&mut self.j[..room], &mut self.offset[..room]);
        let mut found = self.found;
        for (at, &there) in candidates.iter().enumerate() {
            let offset = here - there;
            js[found] = (first + at) as u32;
            offsets[found] = offset;
            found += usize::from(offset.length_squared() < reach);
        }
        self.found = found;
    }

    /// Fills in the kernel of the pairs from `begin` on, which are one particle's.
    /// Adds its share to the sums of the others; returns theirs.
    #[inline]
    fn weigh(
        &mut self,
        begin: usize,
        kernel: &Kernel,
        shares: &[f32],
        own: f32,
        sums: &mut [f32],
    ) -> f32 {
        let offsets = &self.offset[begin..self.found];
        let gradients = &mut self.gradient[begin..self.found];
        if self.weight.len() < offsets.len() {
            self.weight.resize(offsets.len(), 0.0);
        }
        let weights = &mut self.weight[..offsets.len()];
        for ((offset, weight), gradient) in offsets.iter().zip(&mut *weights).zip(gradients) {
            let distance = offset.length();
            *weight = kernel.value(distance);
            *gradient = kernel.gradient_over_r(distance);
        }
        let mut sum = 0.0;
        for (&j, &weight) in self.j[begin..self.found].iter().zip(&*weights) {
            let j = j as usize;
            sum += shares[j] * weight;
            sums[j] += own * weight;
            self.count[j] += 1;
        }
        sum
    }

    /// Neighbours of a particle, on average, and the most of one.
    pub fn mean_and_most(&self) -> (f32, u32) {
        let mean = 2.0 * self.pair_count() as f32 / self.count.len().max(1) as f32;
        (mean, self.count.iter().copied().max().unwrap_or(0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Bounds;
    use crate::random::Random;

    #[test]
    fn it_sums_what_comparing_all_with_all_sums() {
        for (seed, periodic, endless) in [(1, false, false), (2, true, false), (3, true, true)] {
            let bounds = Bounds {
                width: 0.8,
                height: 0.6,
                periodic,
                endless,
            };
            let mut random = Random::new(seed);
            let mut place = || Vec2::new(random.between(-0.4, 0.4), random.between(0.0, 0.6));
            let cloud: Vec<Vec2> = (0..500).map(|_| place()).collect();
            let kernel = Kernel::new(0.03);
            let (mut grid, mut neighbours) = (Grid::default(), Neighbours::default());
            let order = grid.sort(&cloud, &bounds, kernel.support());
            let positions: Vec<Vec2> = order.iter().map(|&i| cloud[i as usize]).collect();
            let shares: Vec<f32> = positions
                .iter()
                .map(|at| 1e-3 * (1.0 + at.x.abs()))
                .collect();
            let mut sums = vec![0.0; positions.len()];
            neighbours.find(&positions, &grid, &kernel, &shares, &mut sums);
            for (i, &here) in positions.iter().enumerate() {
                let distance = |j: usize| bounds.offset(here, positions[j]).length();
                let all = 0..positions.len();
                let expected: f32 = all
                    .clone()
                    .map(|j| shares[j] * kernel.value(distance(j)))
                    .sum();
                assert!((sums[i] / expected - 1.0).abs() < 1e-5);
                let others = all.filter(|&j| distance(j) < kernel.support()).count() - 1;
                assert_eq!(neighbours.count[i] as usize, others);
            }
        }
    }

    #[test]
    fn what_memory_cannot_hold_is_not_written_down() {
        let n = 6000;
        let positions = vec![Vec2::new(0.0, 0.5); n];
        let bounds = Bounds {
            width: 1.0,
            height: 1.0,
            periodic: false,
            endless: false,
        };
        let kernel = Kernel::new(0.02);
        let (mut grid, mut neighbours) = (Grid::default(), Neighbours::default());
        grid.sort(&positions, &bounds, kernel.support());
        let mut sums = vec![0.0; n];
        neighbours.find(&positions, &grid, &kernel, &vec![1.0; n], &mut sums);
        assert!((MOST_PAIRS..MOST_PAIRS + n).contains(&neighbours.pair_count()));
        assert_eq!(neighbours.iter().count(), n);
    }
}

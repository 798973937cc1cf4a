//! A plain solver of both models, the reference for the fast one.
//!
//! It computes the equations of `docs/physics.md` literally, in double
//! precision. It compares every particle with every other one and computes every force
//! separately: it has no grid, no lanes and no symmetric pairs. Of hearth-core it uses only the
//! parameters and the particles.
//!
//! It has no births, embers, turbulence and emission noise.
//!
//! The fast solver computes in single precision, so the two differ by rounding. A [`Sum`] bounds
//! the difference: rounding is a share of the summed terms, even if they cancel.

mod classic;
mod combustion;

use std::ops::{AddAssign, Mul};

use glam::{DVec2, Vec2};
use hearth_core::Particle;

pub use classic::Classic;
pub use combustion::{Combustion, PARTS};

/// Temperature, fuel, oxygen and soot, each by itself.
pub type Mixture = [Sum<f64>; 4];

/// A particle as the plain solver has it after a step.
#[derive(Clone, Copy, Debug)]
pub struct Plain {
    /// Position \[m\].
    pub position: Sum<DVec2>,
    /// Velocity [m/s].
    pub velocity: Sum<DVec2>,
    /// Temperature \[K\], fuel, oxygen and soot.
    pub mixture: Mixture,
    /// Time since birth \[s\].
    pub age: f64,
    /// Age at which it dies \[s\].
    pub lifetime: f64,
    /// Density as the step found it [kg/m³].
    pub density: Sum<f64>,
    /// Pressure as the step found it \[Pa\].
    pub pressure: Sum<f64>,
    /// Fuel burnt in a second [1/s].
    pub burn: Sum<f64>,
}

impl Plain {
    /// A particle as it was put in.
    pub fn new(particle: &Particle) -> Plain {
        let p = particle;
        let mixture = [p.temperature, p.fuel, p.oxygen, p.soot];
        Plain {
            position: Sum::new(double(p.position)),
            velocity: Sum::new(double(p.velocity)),
            mixture: mixture.map(|share| Sum::new(share.into())),
            age: p.age.into(),
            lifetime: p.lifetime.into(),
            density: Sum::default(),
            pressure: Sum::default(),
            burn: Sum::default(),
        }
    }

    fn temperature(&self) -> f64 {
        self.mixture[0].value
    }
}

fn double(vector: Vec2) -> DVec2 {
    vector.as_dvec2()
}

/// What terms sum to, and what they come to if none cancels another.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum<T> {
    /// The sum.
    pub value: T,
    /// The sum of the sizes of the terms.
    pub size: f64,
}

/// What has a size, whichever way it points.
pub trait Size {
    /// How large it is.
    fn size(&self) -> f64;
}

impl Size for f64 {
    fn size(&self) -> f64 {
        self.abs()
    }
}

impl Size for DVec2 {
    fn size(&self) -> f64 {
        self.length()
    }
}

impl<T: Copy + Size + AddAssign + Mul<f64, Output = T>> Sum<T> {
    /// A sum of one term.
    pub fn new(term: T) -> Sum<T> {
        Sum {
            value: term,
            size: term.size(),
        }
    }

    /// Adds a term.
    fn add(&mut self, term: T) {
        self.add_sum(Sum::new(term));
    }

    /// Adds a term that is itself a sum.
    fn add_sum(&mut self, term: Sum<T>) {
        self.value += term.value;
        self.size += term.size;
    }

    /// The sum so many times.
    fn times(self, factor: f64) -> Sum<T> {
        Sum {
            value: self.value * factor,
            size: self.size * factor.abs(),
        }
    }
}

/// How many neighbours each particle has: that surely are within its reach, and that may
/// be, since at its rim rounding decides.
pub type Crowd = Vec<[u32; 2]>;

/// The domain, which may repeat without end across and up.
#[derive(Clone, Copy, Debug)]
struct Domain {
    width: f64,
    height: f64,
    across: bool,
    up: bool,
}

/// Part of a kernel's reach within which rounding may decide who is a neighbour.
const RIM: f64 = 1e-4;

/// Another particle within the kernel.
#[derive(Clone, Copy, Debug)]
struct Neighbour {
    j: usize,
    /// Offset from it \[m\].
    offset: DVec2,
}

impl Domain {
    /// What each particle has neighbours_of it within `reach` or just beyond: all others, and
    /// all images beyond a periodic edge, its own too.
    fn neighbours(&self, particles: &[Plain], reach: f64) -> Vec<Vec<Neighbour>> {
        let reach = (1.0 + RIM) * reach;
        let images = |repeats: bool, length: f64| {
            let shifts = if repeats { -1..=1 } else { 0..=0 };
            shifts.map(move |n| f64::from(n) * length)
        };
        let neighbours_of = |i: usize| {
            let mut found = Vec::new();
            for (j, other) in particles.iter().enumerate() {
                let offset = particles[i].position.value - other.position.value;
                for x in images(self.across, self.width) {
                    // Most are too far away, and so are their images above.
                    if (offset.x - x).abs() >= reach {
                        continue;
                    }
                    for y in images(self.up, self.height) {
                        let offset = offset - DVec2::new(x, y);
                        let itself = i == j && x == 0.0 && y == 0.0;
                        if offset.length() < reach && !itself {
                            found.push(Neighbour { j, offset });
                        }
                    }
                }
            }
            found
        };
        (0..particles.len()).map(neighbours_of).collect()
    }

    /// How many there are of these.
    fn crowd(near: &[Vec<Neighbour>], reach: f64) -> Crowd {
        let within = |near: &[Neighbour], reach: f64| {
            let within = near.iter().filter(|other| other.offset.length() < reach);
            within.count() as u32
        };
        let count =
            |near: &Vec<Neighbour>| [1.0 - RIM, 1.0 + RIM].map(|rim| within(near, rim * reach));
        near.iter().map(count).collect()
    }

    /// A place beyond a periodic edge, brought back in.
    fn wrap(&self, at: DVec2) -> DVec2 {
        let mut inside = at;
        if self.across && at.x.abs() > 0.5 * self.width {
            inside.x = (at.x + 0.5 * self.width).rem_euclid(self.width) - 0.5 * self.width;
        }
        if self.up && !(0.0..=self.height).contains(&at.y) {
            inside.y = at.y.rem_euclid(self.height);
        }
        inside
    }

    fn holds(&self, at: DVec2) -> bool {
        at.x.abs() <= 0.5 * self.width && (0.0..=self.height).contains(&at.y)
    }
}

/// The cubic spline, piece by piece.
#[derive(Clone, Copy, Debug)]
struct Kernel {
    h: f64,
    norm: f64,
}

impl Kernel {
    /// With σ = 10/(7πh²).
    fn new(h: f64) -> Kernel {
        let norm = 10.0 / (7.0 * std::f64::consts::PI * h * h);
        Kernel { h, norm }
    }

    /// With the paper's σ = 1/(πh³).
    fn as_printed(h: f64) -> Kernel {
        let norm = 1.0 / (std::f64::consts::PI * h * h * h);
        Kernel { h, norm }
    }

    fn support(&self) -> f64 {
        2.0 * self.h
    }

    /// W(r).
    fn value(&self, r: f64) -> f64 {
        let q = r / self.h;
        self.norm
            * if q < 1.0 {
                1.0 - 1.5 * q * q + 0.75 * q * q * q
            } else if q < 2.0 {
                0.25 * (2.0 - q).powi(3)
            } else {
                0.0
            }
    }

    /// ∇W at that offset.
    fn gradient(&self, offset: DVec2) -> DVec2 {
        let q = offset.length() / self.h;
        let slope = if q < 1.0 {
            -3.0 * q + 2.25 * q * q
        } else if q < 2.0 {
            -0.75 * (2.0 - q) * (2.0 - q)
        } else {
            0.0
        };
        offset.normalize_or_zero() * (self.norm / self.h * slope)
    }

    /// ∇²W in two dimensions.
    fn laplacian(&self, r: f64) -> f64 {
        let q = r / self.h;
        self.norm / (self.h * self.h)
            * if q < 1.0 {
                // W″ + W′/r = (−3 + 4.5 q) + (−3 + 2.25 q)
                -6.0 + 6.75 * q
            } else if q < 2.0 {
                1.5 * (2.0 - q) - 0.75 * (2.0 - q) * (2.0 - q) / q
            } else {
                0.0
            }
    }

    /// (r·∇W)/(r² + 0.01 h²), by which Morris' viscosity and all diffusion go.
    fn brookshaw(&self, offset: DVec2) -> f64 {
        offset.dot(self.gradient(offset)) / (offset.length_squared() + 0.01 * self.h * self.h)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_accounts_for_cancellation() {
        let mut sum = Sum::new(3.0);
        sum.add(-3.0);
        assert_eq!((sum.value, sum.size), (0.0, 6.0));
        let half = sum.times(-0.5);
        assert_eq!((half.value, half.size), (0.0, 3.0));
    }

    #[test]
    fn the_fast_kernel_is_the_same() {
        for h in [0.01, 0.05] {
            let (plain, fast) = (Kernel::new(h), hearth_core::kernel::Kernel::new(h as f32));
            let height = plain.value(0.0);
            for i in 1..250 {
                let r = 0.01 * f64::from(i) * h;
                let slope = plain.gradient(DVec2::new(r, 0.0)).x;
                let (value, gradient) = (fast.value(r as f32), fast.gradient_over_r(r as f32));
                assert!((plain.value(r) - f64::from(value)).abs() < 1e-6 * height);
                assert!((slope - f64::from(gradient) * r).abs() < 1e-5 * height / h);
            }
        }
    }

    #[test]
    fn images_beyond_corners_and_of_the_particle_itself_are_neighbours() {
        let domain = Domain {
            width: 0.3,
            height: 0.2,
            across: true,
            up: true,
        };
        let corners = [Vec2::new(0.149, 0.199), Vec2::new(-0.149, 0.001)];
        let particles = corners.map(|at| Plain::new(&Particle::at(at)));
        let near = domain.neighbours(&particles, 0.1);
        assert_eq!((near[0].len(), near[1].len()), (1, 1));
        assert!(near[0][0].offset.distance(DVec2::new(-0.002, -0.002)) < 1e-7);
        // Two images of the other and, above and below, two of itself.
        assert_eq!(domain.neighbours(&particles, 0.201)[0].len(), 4);
    }
}

//! Turbulence: a random, divergence-free force with zero mean.
//!
//! Particles do not resolve the finest eddies. A random field represents them (Stam & Fiume,
//! SIGGRAPH 1993): the curl of a noise, which is divergence-free (Bridson, Hourihan,
//! Nordenstam, SIGGRAPH 2007):
//!
//! ```text
//! a = A (∂ψ/∂y, −∂ψ/∂x)
//! ```
//!
//! ψ is the sum of two layers of Perlin noise that scroll in different directions, so that
//! eddies appear and disappear while the field rises. It has the period of the domain.

use glam::Vec2;

use super::{BodyForce, LocalGas};
use crate::noise::perlin_gradient;
use crate::params::Physics;

/// Root mean square of the gradient of one layer, per lattice cell. It makes `turbulence` the
/// root mean square of the acceleration.
const RMS_GRADIENT: f32 = 1.22;

/// Seed and velocity [m/s] of each layer.
const LAYERS: [(u32, f64, f64); 2] = [(0xC0_FFEE, 0.13, 0.7), (0xBEEF, -0.19, -0.25)];

/// The field at one moment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turbulence {
    strength: f32,
    /// Lattice cells per metre, in x and y.
    cells: Vec2,
    /// Periods of the noise in cells, in x and y.
    periods: [u32; 2],
    layers: [Layer; 2],
}

#[derive(Clone, Copy, Debug)]
struct Layer {
    seed: u32,
    /// Scrolled distance, in cells.
    scrolled: Vec2,
}

impl Turbulence {
    /// The field at `time`; `None` without turbulence.
    pub fn new(values: &Physics, time: f64) -> Option<Turbulence> {
        (values.turbulence > 0.0).then(|| Turbulence::at(values, time))
    }

    fn at(values: &Physics, time: f64) -> Turbulence {
        let repeat = |length: f32| (length / values.turbulence_scale).round().max(1.0);
        let (width, height) = (values.domain_width, values.domain_height);
        let periods = Vec2::new(repeat(width), repeat(height));
        let cells = periods / Vec2::new(width, height);
        let scrolled = |speed: f64, cells: f32, periods: f32| {
            let turns = time * speed * f64::from(cells / periods);
            (turns - turns.floor()) as f32 * periods
        };
        Turbulence {
            strength: values.turbulence,
            cells,
            periods: [periods.x as u32, periods.y as u32],
            layers: LAYERS.map(|(seed, across, up)| Layer {
                seed: values.seed ^ seed,
                scrolled: Vec2::new(
                    scrolled(across, cells.x, periods.x),
                    scrolled(up, cells.y, periods.y),
                ),
            }),
        }
    }
}

impl BodyForce for Turbulence {
    fn acceleration(&self, gas: &LocalGas) -> Vec2 {
        let mut slope = Vec2::ZERO;
        for layer in &self.layers {
            let at = gas.position * self.cells - layer.scrolled;
            slope += perlin_gradient(layer.seed, at, self.periods);
        }
        // The gradient per metre, not per cell: cells are not quite square, and the curl
        // per cell would have a divergence in metres.
        let per_metre = slope * self.cells / self.cells.max_element();
        let rms = RMS_GRADIENT * std::f32::consts::SQRT_2;
        Vec2::new(per_metre.y, -per_metre.x) * (self.strength / rms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Parameters;
    use crate::params::Input;
    use crate::random::Random;

    fn of(values: &[(&str, f64)]) -> Parameters {
        let mut parameters = Parameters::default();
        for &(id, value) in [("turbulence", 2.0)].iter().chain(values) {
            assert_eq!(parameters.set(id, Input::Number(value)), Ok(()));
        }
        parameters
    }

    impl Turbulence {
        fn at_place(&self, position: Vec2) -> Vec2 {
            self.acceleration(&LocalGas {
                position,
                velocity: Vec2::ZERO,
                temperature: 293.0,
                expansion: 1.0,
            })
        }
    }

    fn places(seed: u32) -> Vec<Vec2> {
        let mut random = Random::new(seed);
        let mut place = || Vec2::new(random.between(-0.6, 0.6), random.between(0.0, 1.5));
        (0..4000).map(|_| place()).collect()
    }

    #[test]
    fn it_is_divergence_free_with_zero_mean() {
        for scale in [0.05, 0.15, 0.6] {
            let field = Turbulence::at(&of(&[("turbulence_scale", scale)]), 12.3);
            let d = 2e-3 * scale as f32;
            let (mut divergence, mut shear, mut sum) = (0.0, 0.0, Vec2::ZERO);
            for at in places(1) {
                let (x, y) = (Vec2::new(d, 0.0), Vec2::new(0.0, d));
                let along_x = (field.at_place(at + x) - field.at_place(at - x)) / (2.0 * d);
                let along_y = (field.at_place(at + y) - field.at_place(at - y)) / (2.0 * d);
                divergence += (along_x.x + along_y.y).abs();
                shear += along_x.x.abs() + along_y.y.abs();
                sum += field.at_place(at);
            }
            assert!(divergence < 0.02 * shear, "{divergence} of {shear}");
            assert!((sum / 4000.0).length() < 0.15, "{sum}");
        }
    }

    #[test]
    fn its_rms_strength_is_the_parameter() {
        for scale in [0.05, 0.15] {
            let field = Turbulence::at(&of(&[("turbulence_scale", scale)]), 3.0);
            let squares = places(2)
                .into_iter()
                .map(|at| field.at_place(at).length_squared());
            let rms = (squares.sum::<f32>() / 4000.0).sqrt();
            assert!((rms / 2.0 - 1.0).abs() < 0.15, "{rms}");
        }
    }

    #[test]
    fn it_repeats_with_the_domain_and_changes() {
        let values = of(&[]);
        let field = Turbulence::at(&values, 5.0);
        let domain = Vec2::new(values.domain_width, values.domain_height);
        for at in places(3) {
            for across in [Vec2::new(domain.x, 0.0), Vec2::new(0.0, domain.y)] {
                assert!(field.at_place(at).distance(field.at_place(at + across)) < 1e-2);
            }
        }
        let later = Turbulence::at(&values, 6.0);
        let moved = places(3)
            .iter()
            .filter(|&&at| field.at_place(at).distance(later.at_place(at)) > 0.2)
            .count();
        assert!(moved > 2000, "{moved} of 4000");
    }

    #[test]
    fn it_changes_little_from_step_to_step_even_after_a_year() {
        let values = of(&[]);
        let year = 365.0 * 86_400.0;
        let (now, next) = (
            Turbulence::at(&values, year),
            Turbulence::at(&values, year + 1e-3),
        );
        for at in places(4) {
            assert!(now.at_place(at).distance(next.at_place(at)) < 0.1);
        }
    }
}

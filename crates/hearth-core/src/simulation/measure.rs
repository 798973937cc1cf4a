//! What a probe measures at a place, along the vertical through it, and of the fire as a whole.

use glam::Vec2;

use super::Simulation;
use crate::extremes::{fast_max, fast_min};
use crate::kernel::Kernel;
use crate::params::{DisplayMode, Edges, Floor, Model};
use crate::particle::Particle;

/// Heights at which the vertical is measured.
const HEIGHTS: usize = 64;

/// Numbers of the fire, and of each place.
const OF_FIRE: usize = 6;
const OF_PLACE: usize = 8;

/// Gas that is hotter glows \[K\], and the light of hotter gas is measured against this \[K\].
const GLOWING: f32 = 900.0;
const BRIGHT: f32 = 1500.0;

/// Soot beyond this amount no longer brightens the gas.
const OPAQUE: f32 = 1.5;

/// Of gas, Σ V W is one; where it is less than this, there is none.
const SPARSE: f32 = 0.2;

impl Simulation {
    /// Numbers for bindings: six of the fire, then eight of `place`, then eight of each of 64 places
    /// on the vertical through it, evenly from the floor to the top of the domain.
    ///
    /// Of the fire: whole seconds of its time and the rest \[s\], the height of the domain \[m\], the
    /// power [kW/m], the distance from the lowest to the highest gas that is hotter than 900 K \[m\],
    /// and the luminosity, Σ V s (T/1500 K)⁴ of that gas \[m²\], with s its soot, at most 1.5, or the
    /// remaining life of a classic particle. Of a place: temperature \[K\], velocity to the right and
    /// upwards [m/s], density [kg/m³], fuel, oxygen, soot, and the distance from the surface of the
    /// nearest solid \[m\], negative inside. What the model does not have is not a number, and so is
    /// all of a place without gas; open air that rests is left out of a simulation, but is gas.
    pub fn measure(&self, place: Vec2) -> Vec<f32> {
        let (solver, values) = (&self.solver, self.scene.world());
        let burns = values.model() == Model::Combustion;
        let kernel = Kernel::new(values.smoothing_length());
        let height = values.domain_height;
        let at = |row: usize| match row {
            0 => place,
            _ => Vec2::new(place.x, height * (row as f32 - 0.5) / HEIGHTS as f32),
        };
        let mut sums = [[0.0_f32; OF_PLACE]; HEIGHTS + 1];
        let (mut low, mut high, mut light) = (f32::MAX, f32::MIN, 0.0);
        for i in 0..solver.count() {
            let Particle {
                position,
                velocity: Vec2 { x, y },
                temperature,
                age,
                lifetime,
                fuel,
                oxygen,
                soot,
            } = solver.particle(i, self.time);
            let mode = DisplayMode::Temperature;
            let volume = solver.measured(i, values, mode).volume;
            if temperature > GLOWING {
                low = fast_min(low, position.y);
                high = fast_max(high, position.y);
                let glow = if burns {
                    fast_min(soot, OPAQUE)
                } else {
                    1.0 - age / lifetime
                };
                let ratio = temperature / BRIGHT;
                light += volume * glow * ratio * ratio * ratio * ratio;
            }
            if (position.x - place.x).abs() > kernel.support() {
                continue;
            }
            let density = solver.density(i);
            let read = [temperature, x, y, density, fuel, oxygen, soot, 1.0];
            for (row, sum) in sums.iter_mut().enumerate() {
                let weight = volume * kernel.value(position.distance(at(row)));
                for (sum, value) in sum.iter_mut().zip(read) {
                    *sum += weight * value;
                }
            }
        }
        let mut numbers = Vec::with_capacity(OF_FIRE + (HEIGHTS + 1) * OF_PLACE);
        let power = self.power().unwrap_or(f32::NAN);
        numbers.extend([
            self.time.floor() as f32,
            self.time.fract() as f32,
            height,
            power,
        ]);
        numbers.extend([fast_max(high - low, 0.0), light]);
        for (row, sum) in sums.into_iter().enumerate() {
            numbers.extend(self.read(at(row), sum, burns));
        }
        numbers
    }

    /// The numbers of a place, from the sums over the gas around it.
    #[inline(always)]
    fn read(&self, place: Vec2, sum: [f32; OF_PLACE], burns: bool) -> [f32; OF_PLACE] {
        let values = self.scene.world();
        let [low, high] = self.extent();
        let gap = self.solver.solids().nearest(place, high.distance(low));
        let weight = sum[OF_PLACE - 1];
        let floored = values.edges == Edges::Open && values.floor == Floor::Solid && place.y < 0.0;
        let mut all = if gap < 0.0 || floored && burns {
            [f32::NAN; OF_PLACE]
        } else if weight > SPARSE {
            sum.map(|sum| sum / weight)
        } else if values.has_open_edges() {
            let Particle {
                fuel, oxygen, soot, ..
            } = Particle::at(place);
            [
                values.ambient_temperature,
                values.wind,
                0.0,
                values.ambient_density,
                fuel,
                oxygen,
                soot,
                0.0,
            ]
        } else {
            [f32::NAN; OF_PLACE]
        };
        if !burns {
            all[4..].fill(f32::NAN);
        }
        all[OF_PLACE - 1] = gap;
        all
    }
}

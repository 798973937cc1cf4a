//! The boundaries of the gas: the burner, and the fresh air beyond the seam and the sides.

use glam::DVec2;

use super::{Combustion, Common, HEAT_CAPACITY};
use crate::plain::{Plain, Sum};

/// How fast gas in the burner takes on its velocity [1/s].
const GRIP: f64 = 400.0;

impl Combustion {
    /// The burner, without noise. Returns the heat that its gas took [kJ/m].
    pub(super) fn feed(&mut self, common: &Common, dt: f64) -> Sum<f64> {
        let (p, source) = (common.p, common.source);
        if source.power == 0.0 {
            return Sum::default();
        }
        let (seam, height) = (f64::from(p.seam), f64::from(p.domain_height));
        let block = 3.0 * common.spacing;
        let highest = ((1.0 - seam) * height - block).max(0.0);
        let lowest = (seam * height).min(highest);
        let bottom = f64::from(source.y).max(lowest).min(highest);
        let narrowest = f64::from(source.width).max(4.0 * common.spacing);
        let width = f64::from(p.domain_width);
        let half = 0.5 * narrowest.min(width);
        let farthest = (0.5 * width - half - seam * width).max(0.0);
        let middle = f64::from(source.x).clamp(-farthest, farthest);
        // A particle on the edge of the block is outside. The edge of a block at the edge of
        // the domain is exact up to rounding, which must not let that particle in.
        let reach = half - 1e-9 * width;
        // Exact at right angles, as a particle may be on an edge of the block.
        let axis = DVec2::from_angle(f64::from(source.angle).to_radians());
        let axis = (axis * 1e12).round() / 1e12;
        let in_block = |particle: &Plain, above: f64| {
            let from = particle.position.value - DVec2::new(middle, bottom);
            let (along, up) = (axis.dot(from), axis.perp_dot(from));
            along.abs() < reach && up > above && up < block + above
        };

        let mut heated = Sum::default();
        let pilot = 1.02 * f64::from(p.ignition_temperature);
        let hot = f64::from(source.temperature).max(pilot);
        let grip = (GRIP * dt).min(1.0);
        let target = axis.perp() * f64::from(source.speed);
        for particle in &mut self.particles {
            if in_block(particle, 0.0) {
                let [t, _, oxygen, _] = &mut particle.mixture;
                if t.value < hot {
                    heated.add(hot);
                    heated.add(-t.value);
                }
                t.value = t.value.max(hot);
                oxygen.value = oxygen.value.min(source.oxygen.into());
                let dragged = target - particle.velocity.value;
                particle.velocity.add(dragged * grip);
            }
        }

        let heat_of_fuel =
            HEAT_CAPACITY * f64::from(p.flame_rise) * (1.0 + f64::from(p.air_demand));
        let mut fuel = f64::from(source.power) / heat_of_fuel * dt;
        let mut above = 0.0;
        while fuel > 0.0 && bottom + block + above <= (1.0 - seam) * height {
            let takes = |particle: &&mut Plain| in_block(particle, above);
            let takers: Vec<&mut Plain> = self.particles.iter_mut().filter(takes).collect();
            let each = fuel / (common.mass * takers.len() as f64);
            if !takers.is_empty() {
                fuel = 0.0;
            }
            for particle in takers {
                let amount = &mut particle.mixture[1];
                amount.add(each);
                fuel += (amount.value - 1.0).max(0.0) * common.mass;
                amount.value = amount.value.min(1.0);
            }
            above += block;
        }
        heated.times(common.mass * HEAT_CAPACITY)
    }

    /// The seam, and with wind the sides: gas becomes fresh air.
    pub(super) fn relax_to_air(&mut self, common: &Common, dt: f64) {
        let p = common.p;
        if p.seam == 0.0 {
            return;
        }
        let (width, height) = (common.domain.width, common.domain.height);
        let thick = |length: f64| (f64::from(p.seam) * length).max(2.0 * common.spacing);
        let (thickness, side) = (thick(height), thick(width));
        let wind = DVec2::new(p.wind.into(), 0.0);
        let blows = (f64::from(p.wind).abs() / 0.5).min(1.0);
        let air = [f64::from(p.ambient_temperature), 0.0, 1.0, 0.0];
        for particle in &mut self.particles {
            let at = particle.position.value;
            let depth: f64 = 1.0 - at.y.min(height - at.y) / thickness;
            if depth > 0.0 {
                let calmed = 1.0 / (1.0 + 3.0 / thickness * dt * depth.min(1.0));
                particle.velocity.add(-wind);
                particle.velocity = particle.velocity.times(calmed);
                particle.velocity.add(wind);
            }
            let from_side = 0.5 * width - at.x.abs();
            let depth = depth.max((1.0 - from_side / side) * blows);
            if depth > 0.0 {
                let kept = 1.0 / (1.0 + 9.6 / thickness * dt * (4.0 * depth).min(1.0));
                for (amount, air) in particle.mixture.iter_mut().zip(air) {
                    amount.add(-air);
                    *amount = amount.times(kept);
                    amount.add(air);
                }
            }
        }
    }
}

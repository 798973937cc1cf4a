//! The gas as the renderer receives it.

use super::Gas;
use crate::instance::{GasParticle, Instance, Measured, numbered};
use crate::params::DisplayMode;

/// Gas that is hotter \[K\] or has more soot is visible.
const VISIBLE_TEMPERATURE: f32 = 400.0;
const VISIBLE_SOOT: f32 = 0.002;

impl Gas {
    /// Density of a particle [kg/m³], as the last step found it.
    pub fn density(&self, i: usize) -> f32 {
        self.mass / self.volume[i]
    }

    /// Copies out the particles that the display of the fire shows.
    pub fn write_visible(&self, out: &mut Vec<Instance>) {
        out.extend((0..self.len()).filter_map(|i| {
            let [temperature, _, _, soot] = self.state[i].to_array();
            let visible = temperature > VISIBLE_TEMPERATURE || soot > VISIBLE_SOOT;
            visible.then(|| {
                Instance::from(GasParticle {
                    position: self.position[i],
                    velocity: self.velocity[i],
                    temperature,
                    volume: self.volume[i],
                    soot,
                    burn_rate: self.burn[i],
                })
            })
        }));
    }

    /// A particle with the quantity of a display mode.
    pub fn measured(&self, i: usize, mode: DisplayMode) -> Measured {
        let [temperature, fuel, _, soot] = self.state[i].to_array();
        let value = match mode {
            DisplayMode::Particles | DisplayMode::Temperature => temperature,
            DisplayMode::Density => self.density(i),
            DisplayMode::Pressure => self.pressure[i],
            DisplayMode::Velocity => self.velocity[i].length(),
            DisplayMode::Fuel => fuel,
            DisplayMode::Soot | DisplayMode::Sprites => soot,
            _ => 0.0,
        };
        Measured {
            position: self.position[i],
            velocity: self.velocity[i],
            temperature,
            volume: self.volume[i],
            number: numbered(self.id[i], mode),
            value,
        }
    }
}

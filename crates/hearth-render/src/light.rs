//! The light of a fire as a whole: how bright it is, and where.

use hearth_core::params::Model;
use hearth_core::{Instance, Parameters};

/// The temperature against which light is measured \[K\], and the soot that brightens gas no more.
const BRIGHT: f32 = 1500.0;
const OPAQUE: f32 = 1.5;

/// The luminosity of particles in the display mode `fire`, Σ V s (T/1500 K)⁴ \[m²\], as
/// [`measure`](hearth_core::Simulation::measure) has it, and its centroid \[m\].
pub fn light(gas: &[Instance], values: &Parameters) -> [f32; 3] {
    let mut sums = [0.0; 3];
    for &[x, y, _, _, temperature, bulk, state, life] in gas {
        let volume = match values.model() {
            Model::Combustion => bulk * state.min(OPAQUE),
            Model::Classic => values.particle_mass / bulk * life,
        };
        let ratio = temperature * (1.0 / BRIGHT);
        let light = volume * ratio * ratio * ratio * ratio;
        for (sum, share) in sums.iter_mut().zip([1.0, x, y]) {
            *sum += share * light;
        }
    }
    let [light, x, y] = sums;
    let per_light = 1.0 / light.max(1e-9);
    [light, x * per_light, y * per_light]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gas of a volume and a soot at a place.
    fn gas(x: f32, y: f32, temperature: f32, volume: f32, soot: f32) -> Instance {
        [x, y, 0.0, 0.0, temperature, volume, soot, 0.0]
    }

    #[test]
    fn light_grows_with_heat_and_soot_and_is_where_they_are() {
        let values = Parameters::new(Model::Combustion);
        assert_eq!(light(&[], &values), [0.0; 3]);
        let hot = gas(0.1, 0.4, 1500.0, 0.01, 1.0);
        let [bright, x, y] = light(&[hot, gas(0.9, 0.9, 300.0, 0.01, 0.0)], &values);
        assert!((bright - 0.01).abs() < 1e-6 && (x - 0.1).abs() < 1e-5 && (y - 0.4).abs() < 1e-5);
        let [brighter, x, _] = light(&[hot, gas(0.3, 0.4, 3000.0, 0.01, 9.0)], &values);
        assert!(
            (brighter - 0.01 - 0.24).abs() < 1e-5 && x > 0.28,
            "{brighter} {x}"
        );
    }
}

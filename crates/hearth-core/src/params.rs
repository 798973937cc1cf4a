//! THE table of parameters.
//!
//! Each parameter is stated here once: id, label, unit, kind, scale, the
//! models it belongs to with a default and a range for each, and its doc. From
//! this table come the struct, the defaults, the one validator
//! ([`Parameters::set`]), the sliders, the attributes, URL and JSON keys, the
//! TypeScript types and `docs/parameters.md`.
//!
//! Lengths are metres, times seconds, temperatures kelvin; the simulation is a
//! slice of one metre's depth, so a mass is in kg/m.

mod choices;
mod decimal;
mod table;
mod value;

use std::ops::Deref;

use table::parameters;

pub use choices::{Choice, DisplayMode, Walls};
pub use table::{Description, Domain, Kind, Model, Param, Scale};
pub use value::{Colour, Input, ParamError, Refusal, Value};

parameters! {
    "World" {
        /// Width of the simulated domain. The source stands in the middle of its floor.
        domain_width: number "Width" ["m"] Log { Every(1.2, 0.1..=6.0) }
        /// Height of the simulated domain; the picture fits it.
        domain_height: number "Height" ["m"] Log { Every(1.5, 0.1..=6.0) }
        /// What happens at the left and the right edge: particles leave, are held
        /// back, or come back in on the other side. The floor holds them back,
        /// unless the edges are open; the top is always open.
        walls: (choice Walls) "Walls" { Classic(Open) }
        /// Acceleration of gravity, as buoyancy feels it.
        gravity: number "Gravity" ["m/s²"] Linear { Every(9.81, 0.0..=20.0) }
        /// Temperature of the air around the fire.
        ambient_temperature: number "Air temperature" ["K"] Linear { Every(293.0, 250.0..=350.0) }
        /// Density of the air around the fire.
        ambient_density: number "Air density" ["kg/m³"] Linear { Every(1.2, 0.5..=2.0) }
    }
    "Gas" {
        /// Smoothing length h: particles feel each other up to twice this distance.
        smoothing_radius: number "Smoothing radius" ["m"] Log { Classic(0.026, 0.005..=0.1) }
        /// Mass of one particle, for each metre of depth.
        particle_mass: number "Particle mass" ["kg/m"] Log { Classic(2.5e-4, 1e-4..=2e-3) }
        /// Density at which the gas has no pressure.
        rest_density: number "Rest density" ["kg/m³"] Linear { Classic(1.0, 0.5..=2.0) }
        /// Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound:
        /// how hard compressed gas pushes apart. More of it widens the fire.
        gas_constant: number "Gas constant" ["m²/s²"] Log { Classic(0.6, 0.05..=6.0) }
        /// Dynamic viscosity: how strongly neighbours share their motion.
        viscosity: number "Viscosity" ["Pa·s"] Linear { Classic(0.005, 0.0..=0.1) }
    }
    "Lift" {
        /// Lift β of gas that is thinner than the air. More of it narrows the fire.
        buoyancy: number "Buoyancy" [""] Linear { Classic(0.12, 0.0..=1.0) }
        /// Lift of gas that is hotter than the air.
        thermal_buoyancy: number "Thermal buoyancy" [""] Linear { Classic(0.2, 0.0..=1.0) }
        /// Weight added to every particle, as if gravity counted a second time.
        extra_weight: number "Extra weight" ["m/s²"] Linear { Classic(0.0, 0.0..=20.0) }
        /// Speed at which lift and the resistance of the air, which this model
        /// leaves out otherwise, balance.
        terminal_speed: number "Terminal speed" ["m/s"] Linear { Classic(2.5, 0.5..=3.5) }
        /// A net, not a law: no particle moves faster.
        speed_limit: number "Speed limit" ["m/s"] Linear { Classic(4.0, 4.0..=8.0) }
    }
    "Source" {
        /// Most particles alive at one time.
        max_particles: integer "Particles" [""] Log { Classic(1000, 100.0..=100_000.0) }
        /// Particles born each second, as long as the source has room and the
        /// number of particles allows it.
        emission_rate: number "Emission rate" ["1/s"] Log { Classic(1500.0, 50.0..=100_000.0) }
        /// Shortest life of a particle.
        lifetime_min: number "Shortest life" ["s"] Linear { Classic(0.3, 0.1..=3.0) }
        /// Longest life of a particle. A life below the shortest one counts as the shortest.
        lifetime_max: number "Longest life" ["s"] Linear { Classic(1.2, 0.1..=3.0) }
        /// How much shorter particles live that are born towards the rim of the
        /// source, within the shortest and the longest life: it gives the fire its tip.
        taper: number "Taper" [""] Linear { Classic(0.8, 0.0..=1.0) }
        /// Upward speed at birth.
        emission_speed: number "Emission speed" ["m/s"] Linear { Classic(1.0, 0.0..=3.0) }
        /// Random part of the velocity at birth.
        emission_spread: number "Spread" [""] Linear { Classic(0.25, 0.0..=1.0) }
        /// How unevenly the source burns: Perlin noise in place and time.
        emission_noise: number "Emission noise" [""] Linear { Classic(0.5, 0.0..=1.0) }
        /// Width of the source.
        source_width: number "Source width" ["m"] Linear { Classic(0.36, 0.05..=0.6) }
        /// Height of the source above the floor.
        source_height: number "Source height" ["m"] Linear { Classic(0.0, 0.0..=1.0) }
        /// Temperature of a particle at birth.
        maximum_temperature: number "Maximum temperature" ["K"] Linear { Classic(1900.0, 1000.0..=2500.0) }
        /// How fast a particle cools towards the air.
        cooling_rate: number "Cooling rate" ["K/s"] Linear { Classic(900.0, 0.0..=5000.0) }
    }
    "Time" {
        /// Seconds of fire for each second of the clock: below 1 is slow motion.
        time_scale: number "Time scale" [""] Log { Every(1.0, 0.1..=2.0) }
        /// Length of one step; it is divided further where stability asks for it.
        time_step: number "Time step" ["s"] Log { Classic(1.0 / 240.0, 0.002..=0.017) }
        /// Start of the random generator: the same seed gives the same fire.
        seed: seed "Seed" { Every(1) }
    }
    "As printed" {
        /// Equation 1 as printed: the kernel with the factor of three dimensions.
        printed_kernel: flag "Kernel (eq. 1)" { Classic(false) }
        /// Equation 3 as printed: half the pressure force, not divided by the particle's own density.
        printed_pressure: flag "Pressure (eq. 3)" { Classic(false) }
        /// Equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign.
        printed_viscosity: flag "Viscosity (eq. 4)" { Classic(false) }
        /// Equations 5 and 7 as printed: densities of force divided by the mass instead of the density, and no lift by temperature.
        printed_divisor: flag "Divisor (eq. 5, 7)" { Classic(false) }
        /// Equation 6 as printed: forward Euler, the position moves with the old velocity.
        printed_euler: flag "Euler (eq. 6)" { Classic(false) }
    }
    "Look" {
        /// What is drawn.
        display_mode: (choice DisplayMode) "Display" { Every(Fire) }
        /// Size at which a particle is drawn.
        particle_size: number "Particle size" ["m"] Log { Classic(0.04, 0.01..=0.1) }
        /// Brightness, in steps that each double it.
        exposure: number "Exposure" ["EV"] Linear { Every(0.0, -4.0..=4.0) }
        /// How much of a black body's enormous range of brightness is kept.
        luminance_exponent: number "Luminance exponent" [""] Linear { Every(0.35, 0.15..=1.0) }
        /// How strongly smoke hides what is behind it.
        smoke_opacity: number "Smoke opacity" [""] Linear { Every(0.3, 0.0..=2.0) }
        /// Glow around bright places.
        bloom: number "Bloom" [""] Linear { Every(0.15, 0.0..=0.6) }
        /// Fine structure that rises with the flow.
        detail: number "Detail" [""] Linear { Every(1.0, 0.0..=2.0) }
        /// What stands behind the fire: `transparent` or a colour.
        background: colour "Background" { Every(Colour::TRANSPARENT) }
    }
}

/// A checked set of values: whatever it holds is in range for its model.
///
/// Its values are read as fields (`parameters.viscosity`) and written through
/// [`set`](Parameters::set) alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    model: Model,
    values: Values,
}

impl Default for Parameters {
    fn default() -> Self {
        Parameters::new(Model::Classic)
    }
}

impl Deref for Parameters {
    type Target = Values;
    fn deref(&self) -> &Values {
        &self.values
    }
}

impl Parameters {
    /// The defaults of `model`.
    pub fn new(model: Model) -> Parameters {
        Parameters {
            model,
            values: Values::of_model(model),
        }
    }

    /// The model that these values are for.
    pub fn model(&self) -> Model {
        self.model
    }

    /// Sets the parameter `id`, or says why not and changes nothing.
    ///
    /// # Errors
    /// An unknown id, a value of the wrong kind or one outside the range.
    pub fn set(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let param = Param::find(id).ok_or_else(|| ParamError {
            id: Input::Text(id).to_string().trim_matches('"').to_owned(),
            value: input.to_string(),
            reason: Refusal::UnknownId {
                nearest: table::nearest_id(id),
            },
        })?;
        let value = param.check(self.model, input)?;
        (param.put)(&mut self.values, value);
        Ok(())
    }

    /// The value of the parameter `id`, or `None` where there is none of that id.
    pub fn get(&self, id: &str) -> Option<Value> {
        Param::find(id).map(|param| param.get(self))
    }

    /// Puts the parameter `id` back to its default.
    ///
    /// # Errors
    /// An unknown id.
    pub fn restore(&mut self, id: &str) -> Result<(), ParamError> {
        let default = Param::find(id).and_then(|param| {
            let domain = param.domain(self.model).or(param.domains.first())?;
            Some((param, domain.default))
        });
        match default {
            Some((param, value)) => {
                (param.put)(&mut self.values, value);
                Ok(())
            }
            None => self.set(id, Input::Text("")),
        }
    }

    /// The parameters whose value is not the default, with that value.
    pub fn changed(&self) -> impl Iterator<Item = (&'static Param, Value)> + '_ {
        let defaults = Parameters::new(self.model);
        PARAMETERS.iter().filter_map(move |param| {
            let value = param.get(self);
            (value != param.get(&defaults)).then_some((param, value))
        })
    }
}

impl Param {
    /// The entry of that id.
    pub fn find(id: &str) -> Option<&'static Param> {
        PARAMETERS.iter().find(|param| param.id == id)
    }

    /// What a person reads about this parameter.
    pub fn description(&self) -> &'static Description {
        let at = PARAMETERS
            .iter()
            .position(|param| std::ptr::eq(param, self))
            .unwrap_or_default();
        &DESCRIPTIONS[at]
    }
}

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
mod quantity;
mod table;
#[cfg(test)]
mod tests;
mod value;

use std::ops::Deref;

use table::{Place, parameters};

pub use choices::{Backdrop, Choice, DisplayMode, Layers, Model, Palette, Walls};
pub use quantity::Quantity;
pub use table::{Description, Domain, Kind, Param, Scale, Selection, selections_in_words};
pub use value::{Colour, Input, ParamError, Refusal, Value};

/// The displays that show light, so that its brightness and its colours count.
const LIGHT: &[&str] = &["fire", "paper", "sprites"];

/// The display that shows all of the fire, with smoke, glow and fine structure.
const FIRE: &[&str] = &["fire"];

/// The layers of which light is one, and those of which smoke is one.
const LIT: &[&str] = &["both", "fire"];
const SMOKY: &[&str] = &["both", "smoke"];

/// The layers without any light.
const DARK: &[&str] = &["smoke"];

/// The backdrop that there is.
const WALL: &[&str] = &["bricks"];

parameters! {
    "World" {
        /// Which equations move the particles. Classic: the paper's, in which hot
        /// particles are born, cool and die. Combustion: fuel enters the air, mixes
        /// with it and burns.
        model: (choice Model) "Model" { Every(DEFAULT) }
        /// Width of the simulated domain; the source stands in it where its place says. In the
        /// combustion model what leaves on one side comes back in on the other.
        domain_width: number "Width" ["m"] Log { Every(1.2, 0.1..=6.0) }
        /// Height of the simulated domain; the picture fits it.
        domain_height: number "Height" ["m"] Log { Classic(1.5, 0.1..=6.0) Combustion(1.8, 0.1..=6.0) }
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
        /// How much of the height, at the top and at the bottom, gas becomes fresh
        /// air again. 0 closes the domain upon itself; then no wind blows, and nothing is
        /// lifted: nothing would ever stop it.
        seam: number "Seam" [""] Linear { Combustion(0.07, 0.0..=0.2) }
    }
    "Gas" {
        /// Classic: most particles alive at one time. Combustion: into about how many
        /// particles air and gas are divided; more of them are finer, and slower.
        max_particles: integer "Particles" [""] Log { Classic(1000, 100.0..=100_000.0) Combustion(3000, 200.0..=100_000.0) }
        /// Smoothing length h: particles feel each other up to twice this distance.
        smoothing_radius: number "Smoothing radius" ["m"] Log { Classic(0.026, 0.005..=0.1) }
        /// Smoothing length h in spacings of the particles: they feel each other up
        /// to twice this distance. More of it is smoother, and slower.
        smoothing_ratio: number "Smoothing ratio" [""] Linear { Combustion(1.5, 1.3..=2.0) }
        /// Mass of one particle, for each metre of depth.
        particle_mass: number "Particle mass" ["kg/m"] Log { Classic(2.5e-4, 1e-4..=2e-3) }
        /// Density at which the gas has no pressure.
        rest_density: number "Rest density" ["kg/m³"] Linear { Classic(1.0, 0.5..=2.0) }
        /// Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound:
        /// how hard compressed gas pushes apart. More of it widens the fire.
        gas_constant: number "Gas constant" ["m²/s²"] Log { Classic(0.6, 0.05..=6.0) }
        /// Speed of sound in the simulated gas, far below the real one: how hard
        /// compressed gas pushes apart. More of it keeps the density more even and
        /// makes the steps shorter. It grows by itself for fires above 220 kW/m.
        stiffness: number "Stiffness" ["m/s"] Log { Combustion(6.0, 4.0..=15.0) }
        /// Dynamic viscosity: how strongly neighbours share their motion.
        viscosity: number "Viscosity" ["Pa·s"] Linear { Classic(0.005, 0.0..=0.1) }
        /// Viscosity divided by density: how fast neighbours share their motion.
        kinematic_viscosity: number "Viscosity" ["m²/s"] Linear { Combustion(1e-4, 0.0..=0.01) }
        /// Viscosity between particles that approach each other and none else: it
        /// damps the noise of the particles.
        artificial_viscosity: number "Artificial viscosity" [""] Linear { Combustion(0.1, 0.02..=0.5) }
        /// How strongly whirls that are too small to be resolved mix motion, heat
        /// and gases: Smagorinsky's constant.
        eddy_viscosity: number "Eddy viscosity" [""] Linear { Combustion(0.2, 0.0..=0.4) }
        /// How fast heat, fuel, oxygen and soot spread by themselves, without any flow.
        diffusion: number "Diffusion" ["m²/s"] Linear { Combustion(1e-4, 0.0..=0.01) }
        /// How far hot gas takes more room: 1 is the ideal gas, 0 the paper's
        /// equation of state, in which only density makes pressure.
        gas_expansion: number "Gas expansion" [""] Linear { Combustion(0.5, 0.0..=1.0) }
        /// How strongly particles are moved from where they crowd to where they are
        /// sparse, so that they stay evenly spread.
        shifting: number "Shifting" [""] Linear { Combustion(1.0, 0.2..=1.0) }
    }
    "Lift" {
        /// Classic: lift β of gas that is thinner than the air; more of it narrows
        /// the fire. Combustion: lift of gas that is hotter than the air; 1 is nature's.
        buoyancy: number "Buoyancy" [""] Linear { Classic(0.12, 0.0..=1.0) Combustion(1.0, 0.0..=2.0) }
        /// Lift of gas that is hotter than the air.
        thermal_buoyancy: number "Thermal buoyancy" [""] Linear { Classic(0.2, 0.0..=1.0) }
        /// Weight added to every particle, as if gravity counted a second time.
        extra_weight: number "Extra weight" ["m/s²"] Linear { Classic(0.0, 0.0..=20.0) }
        /// Speed at which lift and the resistance of the air, which this model
        /// leaves out otherwise, balance.
        terminal_speed: number "Terminal speed" ["m/s"] Linear { Classic(2.5, 0.5..=3.0) }
        /// A net, not a law: no particle moves faster.
        speed_limit: number "Speed limit" ["m/s"] Linear { Classic(4.0, 4.0..=8.0) }
    }
    "Flow" {
        /// Speed of the fresh air from left to right; below 0 it blows from right to left.
        wind: number "Wind" ["m/s"] Linear { Combustion(0.0, -3.0..=3.0) }
        /// Strength of a random field of drifting whirls that stirs the gas and
        /// compresses it nowhere.
        turbulence: number "Turbulence" ["m/s²"] Linear { Every(0.0, 0.0..=10.0) }
        /// Size of the whirls that turbulence stirs.
        turbulence_scale: number "Turbulence scale" ["m"] Log { Every(0.15, 0.03..=0.6) }
        /// How strongly small whirls are kept spinning that would be smeared out otherwise.
        vorticity_confinement: number "Vorticity confinement" [""] Linear { Combustion(0.0, 0.0..=1.0) }
    }
    "Source" {
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
        /// Power of the burner: the heat of the fuel that it feeds, for each metre of
        /// depth, on top of what its gas carries by being hot; 0 turns it off.
        fuel_power: number "Fuel power" ["kW/m"] Linear { Combustion(220.0, 0.0..=600.0) }
        /// Upward speed of what leaves the source: of a particle at birth, or of the
        /// gas in the burner.
        emission_speed: number "Emission speed" ["m/s"] Linear { Classic(1.0, 0.0..=3.0) Combustion(0.25, 0.0..=1.5) }
        /// Random part of the velocity at birth.
        emission_spread: number "Spread" [""] Linear { Classic(0.25, 0.0..=1.0) }
        /// How unevenly the source burns: Perlin noise in place and time.
        emission_noise: number "Emission noise" [""] Linear { Classic(0.5, 0.0..=1.0) Combustion(0.2, 0.0..=1.0) }
        /// Width of the source; combustion: of the burner, which is at least four
        /// particles wide.
        source_width: number "Source width" ["m"] Linear { Classic(0.36, 0.05..=0.6) Combustion(0.4, 0.01..=1.0) }
        /// Moves the fire to the right, below 0 to the left: place of the middle of the
        /// source, all of which stays inside the domain.
        source_x: number "Source place" ["m"] Linear { Every(0.0, -3.0..=3.0) }
        /// Height of the source above the floor; combustion: of the burner, which stays
        /// above the seam.
        source_height: number "Source height" ["m"] Linear { Classic(0.0, 0.0..=1.0) Combustion(0.25, 0.0..=1.0) }
        /// Temperature of a particle at birth.
        maximum_temperature: number "Maximum temperature" ["K"] Linear { Classic(1900.0, 1000.0..=2500.0) }
        /// How fast a particle cools towards the air.
        cooling_rate: number "Cooling rate" ["K/s"] Linear { Classic(900.0, 0.0..=5000.0) }
        /// Temperature of the gas in the burner, which is always hot enough to burn.
        source_temperature: number "Source temperature" ["K"] Linear { Combustion(700.0, 500.0..=1200.0) }
        /// Oxygen that the fuel brings along: with 0 it burns only where it meets
        /// the air, hottest at the rim of the flame; 1 is as much as the air has.
        source_oxygen: number "Source oxygen" [""] Linear { Combustion(0.5, 0.0..=1.0) }
    }
    "Burning" {
        /// Temperature above which fuel burns where there is oxygen.
        ignition_temperature: number "Ignition" ["K"] Linear { Combustion(450.0, 400.0..=900.0) }
        /// How much hotter gas becomes where fuel and air burn up without a remainder.
        flame_rise: number "Flame rise" ["K"] Linear { Combustion(1500.0, 600.0..=2500.0) }
        /// Parts of air that one part of fuel needs to burn.
        air_demand: number "Air demand" [""] Linear { Combustion(1.5, 0.5..=6.0) }
        /// Time in which hot fuel with enough oxygen burns down to about a third.
        burn_time: number "Burn time" ["s"] Log { Combustion(0.08, 0.02..=0.5) }
        /// How fast gas and embers of 1500 K cool by what they radiate; that grows with
        /// the fourth power of the temperature.
        radiative_cooling: number "Radiative cooling" ["K/s"] Linear { Combustion(500.0, 0.0..=2000.0) }
        /// Time in which hot soot, which makes a flame glow, burns away to about a third.
        soot_life: number "Soot life" ["s"] Log { Combustion(0.25, 0.05..=2.0) }
        /// Time in which smoke, soot that has cooled, thins out to about a third.
        smoke_life: number "Smoke life" ["s"] Log { Combustion(1.5, 0.1..=10.0) }
    }
    "Embers" {
        /// Embers thrown each second: sparks that the flow carries off.
        ember_rate: number "Ember rate" ["1/s"] Linear { Combustion(40.0, 0.0..=1000.0) } when { display_mode: FIRE, layers: LIT }
        /// Shortest life of an ember.
        ember_life_min: number "Shortest ember life" ["s"] Linear { Combustion(0.5, 0.1..=5.0) } when { display_mode: FIRE, layers: LIT }
        /// Longest life of an ember. A life below the shortest one counts as the shortest.
        ember_life_max: number "Longest ember life" ["s"] Linear { Combustion(2.0, 0.1..=5.0) } when { display_mode: FIRE, layers: LIT }
        /// Size of an ember.
        ember_size: number "Ember size" ["m"] Log { Combustion(0.004, 0.001..=0.02) } when { display_mode: FIRE, layers: LIT }
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
        /// What is shown: the fire; every particle; a quantity of the gas, with a bar
        /// that says which colour is how much; the number of neighbours; the hard round
        /// sprites of the paper; or sprites with a texture. In the classic model fuel is what
        /// is left of a particle's life, and soot what makes smoke of it.
        display_mode: (choice DisplayMode) "Display" { Every(Fire) }
        /// What is drawn: fire and smoke, the fire alone, or the smoke alone.
        layers: (choice Layers) "Layers" { Every(Both) } when { display_mode: FIRE }
        /// Size at which a particle is drawn.
        particle_size: number "Particle size" ["m"] Log { Classic(0.04, 0.01..=0.1) } when { display_mode: LIGHT }
        /// Brightness, in steps that each double it.
        exposure: number "Exposure" ["EV"] Linear { Every(0.0, -4.0..=4.0) } when { display_mode: LIGHT }
        /// How much of a black body's enormous range of brightness is kept.
        luminance_exponent: number "Luminance exponent" [""] Linear { Every(0.35, 0.15..=1.0) } when { display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// How strongly smoke hides what is behind it.
        smoke_opacity: number "Smoke opacity" [""] Linear { Every(0.3, 0.0..=2.0) } when { display_mode: FIRE, layers: SMOKY }
        /// Glow around bright places.
        bloom: number "Bloom" [""] Linear { Every(0.15, 0.0..=0.6) } when { display_mode: FIRE, layers: LIT }
        /// Fine structure that rises with the flow.
        detail: number "Detail" [""] Linear { Every(1.0, 0.0..=2.0) } when { display_mode: FIRE }
        /// Colours of the fire: those of glowing soot, of gas, of copper or lithium salts,
        /// of a ghost, or from a cool colour to a hot one.
        palette: (choice Palette) "Palette" { Every(Blackbody) } when { display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Colour of the coolest fire, where the palette is the custom one; transparent is black.
        cool_colour: colour "Cool colour" { Every(Colour::rgb(0x8a, 0x12, 0xff)) } when { palette: &["custom"], display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Colour of the hottest fire, where the palette is the custom one; transparent is black.
        hot_colour: colour "Hot colour" { Every(Colour::rgb(0x38, 0xe8, 0xff)) } when { palette: &["custom"], display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// What the fire burns in front of, in place of the background: nothing, or a wall
        /// of bricks that it lights.
        backdrop: (choice Backdrop) "Backdrop" { Every(None) } when { display_mode: FIRE }
        /// How strongly hot gas makes the backdrop shimmer; a page cannot be made to.
        heat_haze: number "Heat haze" [""] Linear { Every(0.3, 0.0..=1.0) } when { backdrop: WALL, display_mode: FIRE }
        /// What stands behind the fire: `transparent` or a colour.
        background: colour "Background" { Every(Colour::TRANSPARENT) } unless { backdrop: WALL, display_mode: FIRE }
    }
}

/// The id of the parameter that says which of them the others are for.
const MODEL: &str = "model";

/// Whether one of these names is chosen.
fn is_chosen(parameters: &Parameters, &(id, names): &Selection) -> bool {
    match parameters.get(id) {
        Some(Value::Choice(name)) => names.contains(&name),
        _ => true,
    }
}

/// A checked set of values: whatever it holds is in range for its model.
///
/// Its values are read as fields (`parameters.viscosity`) and written through
/// [`set`](Parameters::set) alone. Each model keeps its own: a parameter that
/// both use with the same domain has one value, every other one a value for each
/// model. So a change of the model and back loses nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// The present model's values.
    current: Values,
    /// Those of the model that it is not.
    other: Values,
}

impl Default for Parameters {
    fn default() -> Self {
        Parameters::new(Model::default())
    }
}

impl Deref for Parameters {
    type Target = Values;
    fn deref(&self) -> &Values {
        &self.current
    }
}

impl Parameters {
    /// The defaults of both models, of which `model` is the present one.
    pub fn new(model: Model) -> Parameters {
        let other = match model {
            Model::Classic => Model::Combustion,
            Model::Combustion => Model::Classic,
        };
        Parameters {
            current: Values::of_model(model),
            other: Values {
                model,
                ..Values::of_model(other)
            },
        }
    }

    /// The model that these values are for.
    pub fn model(&self) -> Model {
        self.model
    }

    /// Sets the parameter `id`, or says why not and changes nothing. A parameter
    /// that the model does not use is set where it belongs, and waits there.
    ///
    /// # Errors
    /// An unknown id, a value of the wrong kind or one outside the range.
    pub fn set(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let param = Param::find(id).ok_or_else(|| unknown(id, input))?;
        let value = param.check(self.model, input)?;
        self.write(param, value);
        Ok(())
    }

    /// Sets several parameters, all of them or none. The model comes first,
    /// wherever it stands, because it decides what the others may be.
    ///
    /// # Errors
    /// Every value that is refused, in the order in which they were tried.
    pub fn set_all<'a>(
        &mut self,
        values: impl IntoIterator<Item = (&'a str, Input<'a>), IntoIter: Clone>,
    ) -> Result<(), Vec<ParamError>> {
        let values = values.into_iter();
        let mut new = self.clone();
        let mut refused = Vec::new();
        // Sorted, they would need a sort's code, which is more than all of this.
        for models in [true, false] {
            for (id, input) in values.clone() {
                if (id == MODEL) == models
                    && let Err(error) = new.set(id, input)
                {
                    refused.push(error);
                }
            }
        }
        if refused.is_empty() {
            *self = new;
            Ok(())
        } else {
            Err(refused)
        }
    }

    /// The value of the parameter `id`, or `None` where there is none of that
    /// id. One that the model does not use has the value that it would have in
    /// the model it belongs to.
    pub fn get(&self, id: &str) -> Option<Value> {
        Param::find(id).map(|param| param.get(self))
    }

    /// Puts the parameter `id` back to its default.
    ///
    /// # Errors
    /// An unknown id.
    pub fn restore(&mut self, id: &str) -> Result<(), ParamError> {
        let param = Param::find(id).ok_or_else(|| unknown(id, Input::Text("")))?;
        self.write(param, param.any_domain(self.model).default);
        Ok(())
    }

    /// The parameters that the model uses and whose value is not its default,
    /// with that value.
    pub fn changed(&self) -> impl Iterator<Item = (&'static Param, Value)> + '_ {
        PARAMETERS.iter().filter_map(move |param| {
            let default = param.domain(self.model)?.default;
            let value = param.get(self);
            (value != default).then_some((param, value))
        })
    }

    /// Writes a checked value to the present model, to the one it belongs to,
    /// or to both.
    #[inline(never)]
    fn write(&mut self, param: &Param, value: Value) {
        let domain = param.domain(self.model);
        let shared = domain.is_some_and(|domain| domain.model.is_none());
        let before = self.model;
        if domain.is_some() {
            self.current.place(param.field).put(value);
        }
        if shared || domain.is_none() {
            self.other.place(param.field).put(value);
        }
        if self.model != before {
            std::mem::swap(&mut self.current, &mut self.other);
        }
    }

    /// Distance of neighbouring particles where the gas is as dense as the air
    /// \[m\].
    pub fn spacing(&self) -> f32 {
        match self.model {
            Model::Classic => libm::sqrtf(self.particle_mass / self.rest_density),
            Model::Combustion => {
                libm::sqrtf(self.domain_width * self.domain_height / self.max_particles as f32)
            }
        }
    }

    /// Smoothing length h: particles feel each other up to twice this distance
    /// \[m\].
    pub fn smoothing_length(&self) -> f32 {
        match self.model {
            Model::Classic => self.smoothing_radius,
            Model::Combustion => self.smoothing_ratio * self.spacing(),
        }
    }
}

/// What is said when somebody wants a value for an id that there is not.
#[cold]
#[inline(never)]
fn unknown(id: &str, input: Input<'_>) -> ParamError {
    ParamError {
        id: Input::Text(id).to_string().trim_matches('"').to_owned(),
        value: input.to_string(),
        reason: Refusal::UnknownId {
            nearest: table::nearest_id(id),
        },
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

    /// The choices that would have to be other ones for its value to count, with the
    /// names that would do.
    pub fn waits_for(&self, parameters: &Parameters) -> impl Iterator<Item = &'static Selection> {
        let when = self.description().when.iter();
        when.filter(|chosen| !is_chosen(parameters, chosen))
    }

    /// The choices that together leave its value without an effect; empty: it has one,
    /// if it does not wait for others.
    pub fn ruled_out_by(&self, parameters: &Parameters) -> &'static [Selection] {
        let unless = self.description().unless;
        if unless.iter().all(|chosen| is_chosen(parameters, chosen)) {
            unless
        } else {
            &[]
        }
    }
}

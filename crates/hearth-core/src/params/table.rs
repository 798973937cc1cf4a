//! THE table of parameters.
//!
//! An entry states a parameter once: id, label, unit, kind, scale, the models that use it
//! with a default and a range for each, and its doc. [`parameters!`] describes the syntax.
//!
//! Lengths are metres, times seconds, temperatures kelvin; the simulation is a
//! slice of one metre's depth, so a mass is in kg/m.

use std::ops::Deref;

use super::choices::{Backdrop, Choice, DisplayMode, Layers, Model, Palette, Walls};
use super::declare::parameters;
use super::entry::{Description, Domain, Kind, Role, Scale};
use super::slot::Slot;
use super::value::{Colour, Value};

/// One entry of the parameter table.
#[derive(Debug)]
pub struct Param {
    /// Unique, flat, snake_case; the attribute is the same in kebab-case.
    pub id: &'static str,
    /// The heading that it stands under.
    pub group: &'static str,
    /// Unit of its values; empty for a pure number.
    pub unit: &'static str,
    /// Kind of its values.
    pub kind: Kind,
    /// The models it belongs to, each with a default and a range.
    pub domains: &'static [Domain],
    /// What it changes.
    pub role: Role,
    pub(super) field: Field,
}

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
    "Basics" {
        /// Another kind of fire. Classic: the paper's equations, in which hot particles
        /// are born, cool and die. Combustion: fuel enters the air, mixes with it and burns.
        model: (choice Model) "Model" { Every(DEFAULT) }
        /// A taller, brighter flame. Power of the burner: the heat of the fuel that it
        /// feeds, for each metre of depth, on top of what its gas carries by being hot; 0
        /// turns it off.
        fuel_power: number "Strength" ["kW/m"] Linear { Combustion(220.0, 0.0..=600.0) }
        /// A denser, brighter flame. Particles born each second, as long as the source has
        /// room and the number of particles allows it.
        emission_rate: number "Strength" ["1/s"] Log { Classic(1500.0, 50.0..=100_000.0) }
        /// A wider fire. Width of the source; combustion: of the burner, which is at least
        /// four particles wide.
        source_width: number "Size" ["m"] Linear { Classic(0.36, 0.05..=0.6) Combustion(0.4, 0.01..=1.0) }
        /// A taller flame. Longest life of a particle; one below the shortest life counts
        /// as that.
        lifetime_max: number "Longest life" ["s"] Linear { Classic(1.2, 0.1..=3.0) }
        /// A livelier, wilder flame. Acceleration by a random field of drifting eddies,
        /// which stirs the gas and compresses it nowhere.
        turbulence: number "Turbulence" ["m/s²"] Linear { Every(0.0, 0.0..=10.0) }
        /// A flame that leans to the right, or below 0 to the left. Speed of the fresh air
        /// from left to right.
        wind: number "Wind" ["m/s"] Linear { Combustion(0.0, -3.0..=3.0) }
        /// Other colours of the fire: those of glowing soot, of gas, of copper or lithium
        /// salts, of a ghost, or your own from a cool colour to a hot one.
        [Look] palette: (choice Palette) "Palette" { Every(Blackbody) } when { display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// A brighter picture. Exposure in steps that each double the light.
        [Look] exposure: number "Brightness" ["EV"] Linear { Every(0.0, -4.0..=4.0) } when { display_mode: LIGHT }
        /// A wider shine around bright places. Share of the light that a lens would spread.
        [Look] bloom: number "Glow" [""] Linear { Every(0.15, 0.0..=0.6) } when { display_mode: FIRE, layers: LIT }
        /// Thicker smoke. How strongly smoke hides what is behind it.
        [Look] smoke_opacity: number "Smoke" [""] Linear { Every(0.3, 0.0..=2.0) } when { display_mode: FIRE, layers: SMOKY }
        /// More sparks. Embers thrown each second, which the flow carries off.
        ember_rate: number "Sparks" ["1/s"] Linear { Combustion(40.0, 0.0..=1000.0) } when { display_mode: FIRE, layers: LIT }
        /// A wall behind the fire, or none. What the fire burns in front of, in place of
        /// the background: the fire lights it.
        [Look] backdrop: (choice Backdrop) "Backdrop" { Every(None) } when { display_mode: FIRE }
        /// A faster fire; below 1 slow motion. Seconds of fire for each second of the clock.
        [View] time_scale: number "Speed" [""] Log { Every(1.0, 0.1..=2.0) }
        /// Another view of the same gas: the fire; every particle; a quantity of the gas,
        /// with a bar that says which colour is how much; the number of neighbours; the hard
        /// round sprites of the paper; or sprites with a texture. In the classic model fuel is
        /// what is left of a particle's life, and soot what makes smoke of it.
        [View] display_mode: (choice DisplayMode) "Display" { Every(Fire) }
    }
    "Fire" {
        /// A fire farther to the right, or below 0 to the left. Place of the middle of the
        /// source, all of which stays inside the domain.
        source_x: number "Place" ["m"] Linear { Every(0.0, -3.0..=3.0) }
        /// A flame that starts higher above the floor. Height of the source; combustion: of
        /// the burner, which stays above the seam.
        source_height: number "Source height" ["m"] Linear { Classic(0.0, 0.0..=1.0) Combustion(0.25, 0.0..=1.0) }
        /// A flame that shoots up from its source. Upward speed of what leaves the source:
        /// of a particle at birth, or of the gas in the burner.
        emission_speed: number "Emission speed" ["m/s"] Linear { Classic(1.0, 0.0..=3.0) Combustion(0.25, 0.0..=1.5) }
        /// A frayed flame that sprays to the sides. Random part of the velocity at birth.
        emission_spread: number "Spread" [""] Linear { Classic(0.25, 0.0..=1.0) }
        /// An uneven flame that flares up here and there. How unevenly the source burns:
        /// Perlin noise in place and time.
        emission_noise: number "Emission noise" [""] Linear { Classic(0.5, 0.0..=1.0) Combustion(0.2, 0.0..=1.0) }
        /// A flame that ends in a point. How much shorter the lives of particles from the
        /// rim of the source are, within the shortest and the longest life.
        taper: number "Taper" [""] Linear { Classic(0.8, 0.0..=1.0) }
        /// A fuller flame, up to its top. Shortest life of a particle.
        lifetime_min: number "Shortest life" ["s"] Linear { Classic(0.3, 0.1..=3.0) }
        /// A whiter flame. Temperature of a particle at birth.
        maximum_temperature: number "Maximum temperature" ["K"] Linear { Classic(1900.0, 1000.0..=2500.0) }
        /// A shorter flame with a redder top. How fast a particle cools towards the air.
        cooling_rate: number "Cooling rate" ["K/s"] Linear { Classic(900.0, 0.0..=5000.0) }
        /// A hotter, whiter flame. Rise of the temperature where fuel and air burn up
        /// without a remainder.
        flame_rise: number "Flame rise" ["K"] Linear { Combustion(1500.0, 600.0..=2500.0) }
        /// A slower fire, whose flame begins higher. Time in which hot fuel with enough
        /// oxygen burns down to about a third.
        burn_time: number "Burn time" ["s"] Log { Combustion(0.08, 0.02..=0.5) }
        /// A taller flame: its fuel has to rise farther to find air. Parts of air that one
        /// part of fuel needs to burn.
        air_demand: number "Air demand" [""] Linear { Combustion(1.5, 0.5..=6.0) }
        /// A longer glow above the flame. Time in which hot soot, which makes a flame glow,
        /// burns away to about a third.
        soot_life: number "Soot life" ["s"] Log { Combustion(0.25, 0.05..=2.0) }
        /// A shorter flame that fades to red sooner. How fast gas and embers of 1500 K cool
        /// by what they radiate; that grows with the fourth power of the temperature.
        radiative_cooling: number "Radiative cooling" ["K/s"] Linear { Combustion(500.0, 0.0..=2000.0) }
        /// A flame that burns evenly down to its root; with 0 it is brightest at its rim.
        /// Oxygen that the fuel brings along; 1 is as much as the air has.
        source_oxygen: number "Source oxygen" [""] Linear { Combustion(0.5, 0.0..=1.0) }
        /// A brighter root of the flame. Temperature of the gas in the burner, which is
        /// always hot enough to burn.
        source_temperature: number "Source temperature" ["K"] Linear { Combustion(700.0, 500.0..=1200.0) }
        /// A flame that tears off and goes out more easily. Temperature above which fuel
        /// burns where there is oxygen.
        ignition_temperature: number "Ignition" ["K"] Linear { Combustion(450.0, 400.0..=900.0) }
    }
    "Look" {
        /// Fire and smoke, the fire alone, or the smoke alone. What of them is drawn.
        [View] layers: (choice Layers) "Layers" { Every(Both) } when { display_mode: FIRE }
        /// Finer tongues and wisps. Strength of the fine structure that the gas carries
        /// along.
        [Look] detail: number "Detail" [""] Linear { Every(1.0, 0.0..=2.0) } when { display_mode: FIRE }
        /// More contrast between bright and dim parts of the fire. How much of a black
        /// body's enormous range of brightness is kept.
        [Look] luminance_exponent: number "Luminance exponent" [""] Linear { Every(0.35, 0.15..=1.0) } when { display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Larger, softer particles. Size at which a particle is drawn.
        [Look] particle_size: number "Particle size" ["m"] Log { Classic(0.04, 0.01..=0.1) } when { display_mode: LIGHT }
        /// Colour of the coolest fire, where the palette is the custom one; transparent is black.
        [Look] cool_colour: colour "Cool colour" { Every(Colour::rgb(0x8a, 0x12, 0xff)) } when { palette: &["custom"], display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Colour of the hottest fire, where the palette is the custom one; transparent is black.
        [Look] hot_colour: colour "Hot colour" { Every(Colour::rgb(0x38, 0xe8, 0xff)) } when { palette: &["custom"], display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Colour behind the fire: `transparent`, so that the page shows through, or a colour.
        [Look] background: colour "Background" { Every(Colour::TRANSPARENT) } unless { backdrop: WALL, display_mode: FIRE }
        /// A backdrop that shimmers behind the flame. How strongly hot gas bends the view
        /// of the backdrop; a page cannot be bent.
        [Look] heat_haze: number "Heat haze" [""] Linear { Every(0.3, 0.0..=1.0) } when { backdrop: WALL, display_mode: FIRE }
    }
    "Air" {
        /// Larger, slower swings of the flame. Size of the eddies that turbulence stirs.
        turbulence_scale: number "Turbulence scale" ["m"] Log { Every(0.15, 0.03..=0.6) }
        /// More curls at the edges of the flame. How strongly small eddies are kept
        /// spinning that the computation would smear out.
        vorticity_confinement: number "Vorticity confinement" [""] Linear { Combustion(0.0, 0.0..=1.0) }
        /// A flame that rises faster. Classic: lift β of gas that is thinner than the air;
        /// more of it narrows the fire. Combustion: lift of gas that is hotter than the air; 1
        /// is nature's.
        buoyancy: number "Buoyancy" [""] Linear { Classic(0.12, 0.0..=1.0) Combustion(1.0, 0.0..=2.0) }
        /// A flame whose hot parts rise faster. Lift of gas that is hotter than the air.
        thermal_buoyancy: number "Thermal buoyancy" [""] Linear { Classic(0.2, 0.0..=1.0) }
        /// A taller, quicker flame. Speed at which lift and the resistance of the air,
        /// which this model leaves out otherwise, balance.
        terminal_speed: number "Terminal speed" ["m/s"] Linear { Classic(2.5, 0.5..=3.0) }
        /// A lazier flame. Weight added to every particle, as if gravity counted a second
        /// time.
        extra_weight: number "Extra weight" ["m/s²"] Linear { Classic(0.0, 0.0..=20.0) }
        /// A flame that rises faster and flickers more. Acceleration of gravity, as
        /// buoyancy feels it; 0 is a fire in free fall.
        gravity: number "Gravity" ["m/s²"] Linear { Every(9.81, 0.0..=20.0) }
        /// A fire that rises a little more slowly. Temperature of the air around the fire.
        ambient_temperature: number "Air temperature" ["K"] Linear { Every(293.0, 250.0..=350.0) }
        /// Classic: a fire that rises a little faster; combustion: a smaller one, for there
        /// is more to heat. Density of the air around the fire.
        ambient_density: number "Air density" ["kg/m³"] Linear { Every(1.2, 0.5..=2.0) }
    }
    "Sparks and smoke" {
        /// Larger sparks. Size of an ember.
        ember_size: number "Spark size" ["m"] Log { Combustion(0.004, 0.001..=0.02) } when { display_mode: FIRE, layers: LIT }
        /// Sparks that all fly far. Shortest life of an ember.
        ember_life_min: number "Shortest spark life" ["s"] Linear { Combustion(0.5, 0.1..=5.0) } when { display_mode: FIRE, layers: LIT }
        /// Sparks of which some fly far. Longest life of an ember; one below the shortest
        /// life counts as that.
        ember_life_max: number "Longest spark life" ["s"] Linear { Combustion(2.0, 0.1..=5.0) } when { display_mode: FIRE, layers: LIT }
        /// Smoke that reaches higher. Time in which smoke, soot that has cooled, thins out
        /// to about a third.
        smoke_life: number "Smoke life" ["s"] Log { Combustion(1.5, 0.1..=10.0) }
    }
    "World" {
        /// More room beside the fire, seen from farther away. Width of the simulated
        /// domain. In the combustion model what leaves on one side comes back in on the other.
        domain_width: number "Width" ["m"] Log { Every(1.2, 0.1..=6.0) }
        /// More room above the fire, seen from farther away. Height of the simulated
        /// domain; the picture fits it.
        domain_height: number "Height" ["m"] Log { Classic(1.5, 0.1..=6.0) Combustion(1.8, 0.1..=6.0) }
        /// Open sides, walls, or sides that lead into each other. What happens at the left
        /// and the right edge: particles leave, are held back, or come back in on the other
        /// side. The floor holds them back, unless the edges are open; the top is always open.
        walls: (choice Walls) "Walls" { Classic(Open) }
        /// A fire that fades at the top and the bottom of the picture. How much of the
        /// height, at either end, turns gas into fresh air again. 0 closes the domain upon
        /// itself; then no wind blows and no gas is lifted, since nothing would ever stop it.
        seam: number "Seam" [""] Linear { Combustion(0.07, 0.0..=0.2) }
    }
    "Time" {
        /// Another course of the same fire. Start of the random generator: the same seed
        /// gives the same fire.
        seed: seed "Seed" { Every(1) }
        /// The same fire, computed less exactly and at less cost. Length of one step; it is
        /// divided further where stability asks for it.
        time_step: number "Time step" ["s"] Log { Classic(1.0 / 240.0, 0.002..=0.017) }
    }
    "Physics" {
        /// A finer fire that takes more work. Classic: most particles alive at one time.
        /// Combustion: into about how many particles air and gas are divided.
        max_particles: integer "Particles" [""] Log { Classic(1000, 100.0..=100_000.0) Combustion(3000, 200.0..=100_000.0) }
        /// A smoother, wider fire that takes more work. Smoothing length h: particles feel
        /// each other up to twice this distance.
        smoothing_radius: number "Smoothing radius" ["m"] Log { Classic(0.026, 0.005..=0.1) }
        /// A smoother fire that takes more work. Smoothing length h in spacings of the
        /// particles: they feel each other up to twice this distance.
        smoothing_ratio: number "Smoothing ratio" [""] Linear { Combustion(1.5, 1.3..=2.0) }
        /// A wider, coarser fire. Mass of one particle, for each metre of depth.
        particle_mass: number "Particle mass" ["kg/m"] Log { Classic(2.5e-4, 1e-4..=2e-3) }
        /// A narrower fire. Density at which the gas has no pressure.
        rest_density: number "Rest density" ["kg/m³"] Linear { Classic(1.0, 0.5..=2.0) }
        /// A wider fire. Gas constant k of p = k (ρ − ρ₀), the square of the speed of
        /// sound: how hard compressed gas pushes apart.
        gas_constant: number "Gas constant" ["m²/s²"] Log { Classic(0.6, 0.05..=6.0) }
        /// A more even fire that takes more work. Speed of sound in the simulated gas, far
        /// below the real one: more of it keeps the density more even and makes the steps
        /// shorter. It grows by itself for fires above 220 kW/m.
        stiffness: number "Stiffness" ["m/s"] Log { Combustion(6.0, 4.0..=15.0) }
        /// A calmer flame. Dynamic viscosity: how strongly neighbours share their motion.
        viscosity: number "Viscosity" ["Pa·s"] Linear { Classic(0.005, 0.0..=0.1) }
        /// A calmer, smoother flame. Viscosity divided by density: how fast neighbours
        /// share their motion.
        kinematic_viscosity: number "Viscosity" ["m²/s"] Linear { Combustion(1e-4, 0.0..=0.01) }
        /// A calmer flame with fewer small curls. Viscosity between particles that approach
        /// each other and no others: it damps the noise of the particles.
        artificial_viscosity: number "Artificial viscosity" [""] Linear { Combustion(0.1, 0.02..=0.5) }
        /// A softer flame without small curls. How strongly eddies that are too small to be
        /// resolved mix motion, heat and gases: Smagorinsky's constant.
        eddy_viscosity: number "Eddy viscosity" [""] Linear { Combustion(0.2, 0.0..=0.4) }
        /// A softer, blurred flame. How fast heat, fuel, oxygen and soot spread by
        /// themselves, without any flow.
        diffusion: number "Diffusion" ["m²/s"] Linear { Combustion(1e-4, 0.0..=0.01) }
        /// A wider, fuller flame. How far hot gas takes more room: 1 is the ideal gas, 0 the
        /// paper's equation of state, in which only density makes pressure.
        gas_expansion: number "Gas expansion" [""] Linear { Combustion(0.5, 0.0..=1.0) }
        /// A picture without gaps and clots. How strongly particles are moved from where
        /// they cluster to where they are sparse, so that they stay evenly spread.
        shifting: number "Shifting" [""] Linear { Combustion(1.0, 0.2..=1.0) }
        /// Room for faster particles, which only a wild fire needs. Highest speed of a
        /// particle: a safety net, not a law.
        speed_limit: number "Speed limit" ["m/s"] Linear { Classic(4.0, 4.0..=8.0) }
        /// The paper's fire, as its equation 1 stands: the kernel with the factor of three
        /// dimensions.
        printed_kernel: flag "Printed kernel (eq. 1)" { Classic(false) }
        /// The paper's fire, as its equation 3 stands: half the pressure force, not divided
        /// by the particle's own density.
        printed_pressure: flag "Printed pressure (eq. 3)" { Classic(false) }
        /// The paper's fire, as its equation 4 stands: viscosity by the kernel's own
        /// Laplacian, which changes sign.
        printed_viscosity: flag "Printed viscosity (eq. 4)" { Classic(false) }
        /// The paper's fire, as its equations 5 and 7 stand: densities of force divided by
        /// the mass instead of the density, and no lift by temperature.
        printed_divisor: flag "Printed divisor (eq. 5, 7)" { Classic(false) }
        /// The paper's fire, as its equation 6 stands: forward Euler, the position moves
        /// with the old velocity.
        printed_euler: flag "Printed Euler (eq. 6)" { Classic(false) }
    }
}

//! THE table of parameters.
//!
//! An entry states a parameter once: id, label, unit, kind, scale, the models that use it
//! with a default and a range for each, and its doc. [`parameters!`] describes the syntax.
//!
//! Lengths are metres, times seconds, temperatures kelvin; the simulation is a
//! slice of one metre's depth, so a mass is in kg/m.

use std::ops::Deref;

use super::choices::{
    Backdrop, Choice, DisplayMode, Edges, Floor, Ground, Layers, Model, Palette, SourceShape, Walls,
};
use super::declare::parameters;
use super::entry::{Description, Domain, Kind, Role, Scale};
use super::slot::{Slot, Slots};
use super::value::{Colour, Value};

/// One entry of the parameter table.
#[derive(Debug)]
pub struct Param {
    /// Unique, flat, snake_case; the attribute is the same in kebab-case.
    pub id: &'static str,
    /// Its name as a property of an object; empty for a parameter of the world.
    pub property: &'static str,
    /// Unit of its values; empty for a pure number.
    pub unit: &'static str,
    /// Kind of its values.
    pub kind: Kind,
    /// The models that use it, each with a default and a range.
    pub domains: &'static [Domain],
    /// The part of Hearth that reads it.
    pub role: Role,
    /// Its field in [`Values`] or [`Source`]; `None` for a property of an object that is not a source.
    pub(super) field: Option<Field>,
}

/// The displays of light, which depend on its brightness and its colours.
const LIGHT: &[&str] = &["fire", "paper", "sprites"];

/// The display of the whole fire, with smoke, glow and fine structure.
const FIRE: &[&str] = &["fire"];

/// The layers with light, and those with smoke.
const LIT: &[&str] = &["both", "fire"];
const SMOKY: &[&str] = &["both", "smoke"];

/// The layers without light.
const DARK: &[&str] = &["smoke"];

/// The edges of the combustion model's air.
const OPEN: &[&str] = &["open"];
const PERIODIC: &[&str] = &["periodic"];

/// The shapes of a source.
const LINE: &[&str] = &["line"];
const SOLID: &[&str] = &["solid"];

/// The model without particles that are born.
const COMBUSTION: &[&str] = &["combustion"];

/// The backdrop.
const WALL: &[&str] = &["bricks"];

parameters! {
    "Basics" {
        /// Another kind of fire. Combustion: fuel enters the air, mixes with it and burns. Classic: the
        /// paper's equations, in which hot particles are born, cool and die, and no solid burns.
        model: (choice Model) "Model" { Every(DEFAULT) }
        /// A taller, brighter flame. Power of the burner per metre of depth: the heat of
        /// combustion of its fuel, without the heat of its hot gas. 0 turns it off.
        @power: fuel_power: number "Strength" ["kW/m"] Linear { Combustion(220.0, 0.0..=3000.0) }
        /// A denser, brighter flame. Particles born per second, limited by the space at the
        /// source and by the number of particles.
        @rate: emission_rate: number "Strength" ["1/s"] Log { Classic(1500.0, 50.0..=100_000.0) }
        /// A wider fire. Width of the source. In the combustion model it is at least four
        /// particles.
        @width: source_width: number "Size" ["m"] Linear { Classic(0.36, 0.05..=0.6) Combustion(0.4, 0.01..=6.0) } when { source_shape: LINE }
        /// A taller flame. Longest life of a particle, at least the shortest life.
        @life_max: lifetime_max: number "Longest life" ["s"] Linear { Classic(1.2, 0.1..=3.0) }
        /// A livelier, wilder flame. Acceleration by a random field of drifting eddies, which
        /// does not compress the gas.
        turbulence: number "Turbulence" ["m/s²"] Linear { Every(0.0, 0.0..=10.0) }
        /// A flame that leans to the right, or below 0 to the left. Speed of the fresh air
        /// from left to right.
        wind: number "Wind" ["m/s"] Linear { Combustion(0.0, -3.0..=3.0) }
        /// Other colours of the fire: those of glowing soot, of gas, of copper or lithium
        /// salts, of a ghost, or your own from a cool colour to a hot one.
        [Look] palette: (choice Palette) "Palette" { Every(Blackbody) } when { display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// A brighter picture. Exposure in stops, each of which doubles the light.
        [Look] exposure: number "Brightness" ["EV"] Linear { Every(0.0, -4.0..=4.0) } when { display_mode: LIGHT }
        /// A wider shine around bright places. Share of the light that a lens scatters.
        [Look] bloom: number "Glow" [""] Linear { Every(0.15, 0.0..=0.6) } when { display_mode: FIRE, layers: LIT }
        /// Thicker smoke. Opacity of the smoke.
        [Look] smoke_opacity: number "Smoke" [""] Linear { Every(0.3, 0.0..=2.0) } when { display_mode: FIRE, layers: SMOKY }
        /// More sparks. Embers emitted per second. The flow carries them.
        ember_rate: number "Sparks" ["1/s"] Linear { Combustion(40.0, 0.0..=1000.0) } when { display_mode: FIRE, layers: LIT }
        /// A wall behind the fire, with its floor, in place of the background. The fire lights it. None:
        /// the page shows through.
        [Look] backdrop: (choice Backdrop) "Wall" { Every(None) } when { display_mode: FIRE }
        /// A ground under the fire, which lights it. Solids cast shadows on it. Over a
        /// transparent background, only its light and its shadows are drawn. None: no ground or,
        /// before a wall, the stone floor of that.
        [Look] ground: (choice Ground) "Ground" { Every(None) } when { display_mode: FIRE }
        /// A faster fire; below 1 slow motion. Seconds of fire for each second of the clock.
        [View] time_scale: number "Speed" [""] Log { Every(1.0, 0.1..=2.0) }
    }
    "Fire" {
        /// A source that burns. One that is off emits nothing and keeps its values. So does one on a
        /// solid that is off.
        @enabled: source_enabled: flag "Source enabled" { Every(true) }
        /// A fire on a line, or on the surface of a solid. Line: the source is straight. Solid: the
        /// whole outline of a solid burns, wherever the solid is.
        @shape: source_shape: (choice SourceShape) "Source shape" { Every(Line) }
        /// A fire on another solid. Id of the solid whose surface is the source. If no solid has it,
        /// the source is a line.
        @solid: source_solid: integer "Source solid" [""] Linear { Every(0, 0.0..=1_000_000.0) } when { source_shape: SOLID }
        /// A fire farther to the right, or below 0 to the left. Position of the middle of the
        /// source, which stays inside the domain.
        @x: source_x: number "Place" ["m"] Linear { Every(0.0, -3.0..=3.0) } when { source_shape: LINE }
        /// A flame that starts higher above the floor. Height of the source. In the combustion
        /// model it stays above the seam.
        @y: source_height: number "Source height" ["m"] Linear { Classic(0.0, 0.0..=6.0) Combustion(0.25, 0.0..=6.0) } when { source_shape: LINE }
        /// A flame that leaves its source to the side. Angle of the width of the source from the
        /// horizontal, counterclockwise; what it emits leaves it at right angles.
        @angle: source_angle: number "Source angle" ["°"] Linear { Every(0.0, -180.0..=180.0) } when { source_shape: LINE }
        /// A flame that shoots up from its source. Speed of a particle at birth, or of the
        /// gas in the burner; upward unless the source is turned. A particle leaves a solid at right
        /// angles. In the combustion model, a solid has none: it supplies no gas.
        @speed: emission_speed: number "Emission speed" ["m/s"] Linear { Classic(1.0, 0.0..=3.0) Combustion(0.6, 0.0..=1.5) } unless { source_shape: SOLID, model: COMBUSTION }
        /// A frayed flame that sprays to the sides. Random part of the velocity at birth.
        @spread: emission_spread: number "Spread" [""] Linear { Classic(0.25, 0.0..=1.0) }
        /// An uneven flame that flares up here and there. How unevenly the source burns:
        /// Perlin noise in place and time.
        @noise: emission_noise: number "Emission noise" [""] Linear { Classic(0.5, 0.0..=1.0) Combustion(0.2, 0.0..=1.0) }
        /// A flame that ends in a point. How much shorter the lives of particles from the
        /// rim of the source are, within the shortest and the longest life.
        @taper: taper: number "Taper" [""] Linear { Classic(0.8, 0.0..=1.0) } when { source_shape: LINE }
        /// A fuller flame, up to its top. Shortest life of a particle.
        @life_min: lifetime_min: number "Shortest life" ["s"] Linear { Classic(0.3, 0.1..=3.0) }
        /// A whiter flame. Temperature of a particle at birth.
        @birth_temperature: maximum_temperature: number "Maximum temperature" ["K"] Linear { Classic(1900.0, 1000.0..=2500.0) }
        /// A shorter flame with a redder top. How fast a particle cools towards the air.
        cooling_rate: number "Cooling rate" ["K/s"] Linear { Classic(900.0, 0.0..=5000.0) }
        /// A hotter, whiter flame. Rise of the temperature if all fuel and all air burn.
        flame_rise: number "Flame rise" ["K"] Linear { Combustion(1500.0, 600.0..=2500.0) }
        /// A slower fire, whose flame begins higher. Time in which hot fuel with enough
        /// oxygen burns down to about a third.
        burn_time: number "Burn time" ["s"] Log { Combustion(0.08, 0.02..=0.5) }
        /// A taller flame, because its fuel rises farther to find air. Parts of air that burn
        /// one part of fuel.
        air_demand: number "Air demand" [""] Linear { Combustion(1.5, 0.5..=6.0) }
        /// A longer glow above the flame. Time in which hot soot, the source of the glow, burns
        /// away to about a third.
        soot_life: number "Soot life" ["s"] Log { Combustion(0.25, 0.05..=2.0) }
        /// A shorter flame that fades to red sooner. How fast gas and embers of 1500 K cool by
        /// radiation, which grows with the fourth power of the temperature.
        radiative_cooling: number "Radiative cooling" ["K/s"] Linear { Combustion(500.0, 0.0..=2000.0) }
        /// A flame that burns evenly down to its root; with 0 it is brightest at its rim.
        /// Oxygen in the fuel, relative to air.
        @oxygen: source_oxygen: number "Source oxygen" [""] Linear { Combustion(0.5, 0.0..=1.0) }
        /// A brighter root of the flame. Temperature of the gas in the burner, which is always
        /// above the ignition temperature.
        @temperature: source_temperature: number "Source temperature" ["K"] Linear { Combustion(700.0, 500.0..=1200.0) }
        /// A flame that tears off and goes out more easily. Temperature above which fuel
        /// burns where there is oxygen.
        ignition_temperature: number "Ignition" ["K"] Linear { Combustion(450.0, 400.0..=900.0) }
    }
    "Look" {
        /// Another view of the same gas: the fire; every particle; a quantity of the gas, with
        /// a colour bar; the number of neighbours; the hard round sprites of the paper; or
        /// sprites with a texture. In the classic model, fuel is the remaining life of a
        /// particle, and soot is its smoke.
        [View] display_mode: (choice DisplayMode) "Display" { Every(Fire) }
        /// Fire and smoke, the fire alone, or the smoke alone. The visible layers.
        [View] layers: (choice Layers) "Layers" { Every(Both) } when { display_mode: FIRE }
        /// A deeper fire with more tongues. Number of slices: moments of the fire's past that are drawn
        /// behind the present one. Low quality shows three.
        [Look] depth: integer "Depth" [""] Linear { Combustion(5, 1.0..=5.0) } when { display_mode: FIRE }
        /// A bright rim around a darker middle, as of a candle. Share of the light that is seen through a flame
        /// that is round about its axis; 0 is a plane flame.
        [Look] roundness: number "Roundness" [""] Linear { Combustion(0.0, 0.0..=1.0) } when { display_mode: FIRE }
        /// Finer tongues and wisps. Strength of the fine structure that moves with the gas.
        [Look] detail: number "Detail" [""] Linear { Every(1.0, 0.0..=2.0) } when { display_mode: FIRE }
        /// More contrast between bright and dim parts of the fire. Exponent that compresses the
        /// brightness of a black body.
        [Look] luminance_exponent: number "Luminance exponent" [""] Linear { Classic(0.35, 0.15..=1.0) Combustion(0.6, 0.15..=1.0) } when { display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Larger, softer particles. Drawn size of a particle.
        [Look] particle_size: number "Particle size" ["m"] Log { Classic(0.04, 0.0025..=0.1) } when { display_mode: LIGHT }
        /// Colour of the coolest fire in the custom palette; transparent is black.
        [Look] cool_colour: colour "Cool colour" { Every(Colour::rgb(0x8a, 0x12, 0xff)) } when { palette: &["custom"], display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Colour of the hottest fire in the custom palette; transparent is black.
        [Look] hot_colour: colour "Hot colour" { Every(Colour::rgb(0x38, 0xe8, 0xff)) } when { palette: &["custom"], display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Colour behind the fire; with `transparent` the page shows through.
        [Look] background: colour "Background" { Every(Colour::TRANSPARENT) } unless { backdrop: WALL, display_mode: FIRE }
        /// A whiter, less red fire, and light of it. Temperature of the black body that the camera shows as white; at
        /// 6500 the fire has its physical hues. Other palettes keep theirs.
        [Look] white_balance: number "White balance" ["K"] Linear { Every(3200.0, 2000.0..=6500.0) } when { display_mode: LIGHT } unless { layers: DARK, display_mode: FIRE }
        /// Solids in their own colours, as in a lit room or on a white page. White light of the surroundings on solids,
        /// wall and ground.
        [Look] ambient_light: number "Ambient light" [""] Linear { Every(0.0, 0.0..=1.0) } when { display_mode: FIRE }
        /// A backdrop that shimmers behind the flame. How strongly hot gas refracts the view of
        /// the backdrop. The page behind the element is not refracted.
        [Look] heat_haze: number "Heat haze" [""] Linear { Every(0.3, 0.0..=1.0) } when { backdrop: WALL, display_mode: FIRE }
    }
    "Air" {
        /// Larger, slower swings of the flame. Size of the eddies of the turbulence.
        turbulence_scale: number "Turbulence scale" ["m"] Log { Every(0.15, 0.03..=0.6) }
        /// More curls at the edges of the flame. How strongly small eddies keep the rotation
        /// that the computation would dissipate.
        vorticity_confinement: number "Vorticity confinement" [""] Linear { Combustion(0.0, 0.0..=1.0) }
        /// A flame that rises faster. Classic: buoyancy β of gas that is thinner than the air;
        /// more of it narrows the fire. Combustion: buoyancy of hot gas; 1 is the physical
        /// value.
        buoyancy: number "Buoyancy" [""] Linear { Classic(0.12, 0.0..=1.0) Combustion(1.0, 0.0..=2.0) }
        /// A flame whose hot parts rise faster. Buoyancy of gas that is hotter than the air.
        thermal_buoyancy: number "Thermal buoyancy" [""] Linear { Classic(0.2, 0.0..=1.0) }
        /// A taller, quicker flame. Speed at which buoyancy and the drag of the air balance.
        terminal_speed: number "Terminal speed" ["m/s"] Linear { Classic(2.5, 0.5..=3.0) }
        /// A lazier flame. Additional downward acceleration of every particle.
        extra_weight: number "Extra weight" ["m/s²"] Linear { Classic(0.0, 0.0..=20.0) }
        /// A flame that rises faster and flickers more. Gravitational acceleration in the
        /// buoyancy; 0 is a fire in free fall.
        gravity: number "Gravity" ["m/s²"] Linear { Every(9.81, 0.0..=20.0) }
        /// A fire that rises a little more slowly. Temperature of the air around the fire.
        ambient_temperature: number "Air temperature" ["K"] Linear { Every(293.0, 250.0..=350.0) }
        /// Classic: a fire that rises a little faster. Combustion: a smaller fire, because it
        /// heats more air. Density of the air around the fire.
        ambient_density: number "Air density" ["kg/m³"] Linear { Every(1.2, 0.5..=2.0) }
    }
    "Sparks and smoke" {
        /// Larger sparks. Size of an ember.
        ember_size: number "Spark size" ["m"] Log { Combustion(0.004, 0.001..=0.02) } when { display_mode: FIRE, layers: LIT }
        /// Sparks that all fly far. Shortest life of an ember.
        ember_life_min: number "Shortest spark life" ["s"] Linear { Combustion(0.5, 0.1..=5.0) } when { display_mode: FIRE, layers: LIT }
        /// Sparks of which some fly far. Longest life of an ember, at least the shortest life.
        ember_life_max: number "Longest spark life" ["s"] Linear { Combustion(2.0, 0.1..=5.0) } when { display_mode: FIRE, layers: LIT }
        /// Smoke that reaches higher. Time in which smoke, which is cold soot, decays to about
        /// a third.
        smoke_life: number "Smoke life" ["s"] Log { Combustion(1.5, 0.1..=10.0) }
    }
    "World" {
        /// More space beside the fire, in a wider view. Width of the domain, which the picture fits.
        /// Open edges: gas is simulated beyond it, too.
        domain_width: number "Domain width" ["m"] Log { Every(1.2, 0.1..=6.0) }
        /// More space above the fire, in a wider view. Height of the domain, which the picture
        /// fits. Open edges: gas is simulated beyond it, too.
        domain_height: number "Domain height" ["m"] Log { Classic(1.5, 0.1..=6.0) Combustion(1.8, 0.1..=6.0) }
        /// Open sides, walls, or periodic sides. Particles at the left and the right edge
        /// leave, are stopped, or enter on the other side. The floor stops them, unless the
        /// sides are open; the top is always open.
        walls: (choice Walls) "Walls" { Classic(Open) }
        /// A fire in the open, or in a closed box. Open: air surrounds the fire, smoke leaves,
        /// and fresh air enters. Periodic: gas that leaves on one side of the domain enters on
        /// the other.
        edges: (choice Edges) "Edges" { Combustion(Open) }
        /// A fire that stands on a floor, or one that draws air from below. A solid floor is at
        /// the lower edge of the domain.
        floor: (choice Floor) "Floor" { Combustion(None) } when { edges: OPEN }
        /// A fire that fades at the top and the bottom of the picture. Share of the height, at
        /// either end, in which gas becomes fresh air again. With 0 the domain is periodic
        /// without fresh air, and has neither wind nor buoyancy, because nothing would stop the
        /// gas.
        seam: number "Seam" [""] Linear { Combustion(0.07, 0.0..=0.2) } when { edges: PERIODIC }
    }
    "Time" {
        /// Another variation of the same fire. Seed of the random generator: the same seed
        /// gives the same fire.
        seed: seed "Seed" { Every(1) }
        /// The same fire at lower cost and accuracy. Length of one step, which is divided
        /// further for stability.
        time_step: number "Time step" ["s"] Log { Classic(1.0 / 240.0, 0.002..=0.017) }
    }
    "Physics" {
        /// A coarser fire that takes less work. Distance of neighbouring particles in air. Until it
        /// is set, it follows the domain, the number of particles and the quality.
        spacing: number "Spacing" ["m"] Log { Combustion(0.0268, 0.0003..=0.5) } when { edges: OPEN }
        /// A finer fire that takes more work. Number of particles that would fill the domain. Until it
        /// is set, it follows the scene, the `spacing` and the quality.
        particles: integer "Particles" [""] Log { Combustion(3000, 200.0..=100_000.0) }
        /// A fire that may grow larger. Largest number of particles, with open edges or in the classic model.
        /// The highest air sleeps beyond it; until it is set, there is room for twice the domain.
        max_particles: integer "Most particles" [""] Log { Classic(1000, 100.0..=100_000.0) Combustion(6000, 200.0..=100_000.0) }
        /// A smoother, wider fire that takes more work. Smoothing length h: particles interact
        /// up to twice this distance.
        smoothing_radius: number "Smoothing radius" ["m"] Log { Classic(0.026, 0.005..=0.1) }
        /// A smoother fire that takes more work. Smoothing length h in spacings of the
        /// particles, which interact up to twice this distance.
        smoothing_ratio: number "Smoothing ratio" [""] Linear { Combustion(1.5, 1.3..=2.0) }
        /// A wider, coarser fire. Mass of one particle per metre of depth.
        particle_mass: number "Particle mass" ["kg/m"] Log { Classic(2.5e-4, 1e-4..=2e-3) }
        /// A narrower fire. Density at which the gas has no pressure.
        rest_density: number "Rest density" ["kg/m³"] Linear { Classic(1.0, 0.5..=2.0) }
        /// A wider fire. Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound:
        /// how strongly compressed gas expands.
        gas_constant: number "Gas constant" ["m²/s²"] Log { Classic(0.6, 0.05..=6.0) }
        /// A more even fire that takes more work. Speed of sound in the simulated gas, far
        /// below the real one. A higher speed gives a more uniform density and shorter steps.
        /// It increases automatically for fires above 220 kW/m.
        stiffness: number "Stiffness" ["m/s"] Log { Combustion(6.0, 4.0..=15.0) }
        /// A calmer flame. Dynamic viscosity.
        viscosity: number "Viscosity" ["Pa·s"] Linear { Classic(0.005, 0.0..=0.1) }
        /// A calmer, smoother flame. Kinematic viscosity: viscosity divided by density.
        kinematic_viscosity: number "Viscosity" ["m²/s"] Linear { Combustion(1e-4, 0.0..=0.01) }
        /// A calmer flame with fewer small curls. Viscosity between approaching particles only,
        /// which damps the noise of the particles.
        artificial_viscosity: number "Artificial viscosity" [""] Linear { Combustion(0.1, 0.02..=0.5) }
        /// A softer flame without small curls. How strongly unresolved eddies mix momentum,
        /// heat and gases: Smagorinsky's constant.
        eddy_viscosity: number "Eddy viscosity" [""] Linear { Combustion(0.2, 0.0..=0.4) }
        /// A compact flame that no hot rolls leave. Size C of the eddies into which rolls break
        /// up, in the length D* of the fire: how strongly rolls mix momentum, heat and gases.
        roll_mixing: number "Roll mixing" [""] Linear { Combustion(0.085, 0.0..=0.2) }
        /// A softer, blurred flame. Diffusivity of heat, fuel, oxygen and soot.
        diffusion: number "Diffusion" ["m²/s"] Linear { Combustion(1e-4, 0.0..=0.01) }
        /// A wider, fuller flame. Exponent of the thermal expansion: 1 is the ideal gas, 0 the
        /// paper's equation of state, in which pressure depends on density only.
        gas_expansion: number "Gas expansion" [""] Linear { Combustion(0.5, 0.0..=1.0) }
        /// A picture without gaps and clumps. How strongly particles are shifted from dense to
        /// sparse regions, so that they stay evenly distributed.
        shifting: number "Shifting" [""] Linear { Combustion(1.0, 0.2..=1.0) }
        /// Faster particles, which only an extreme fire needs. Largest speed of a particle.
        speed_limit: number "Speed limit" ["m/s"] Linear { Classic(5.0, 4.0..=8.0) }
        /// The paper's fire, with equation 1 as printed: the kernel with the factor of three
        /// dimensions.
        printed_kernel: flag "Printed kernel (eq. 1)" { Classic(false) }
        /// The paper's fire, with equation 3 as printed: half the pressure force, not divided
        /// by the particle's own density.
        printed_pressure: flag "Printed pressure (eq. 3)" { Classic(false) }
        /// The paper's fire, with equation 4 as printed: viscosity by the kernel's own
        /// Laplacian, which changes sign.
        printed_viscosity: flag "Printed viscosity (eq. 4)" { Classic(false) }
        /// The paper's fire, with equations 5 and 7 as printed: force densities divided by the
        /// mass instead of the density, and no thermal buoyancy.
        printed_divisor: flag "Printed divisor (eq. 5, 7)" { Classic(false) }
        /// The paper's fire, with equation 6 as printed: forward Euler, the position moves
        /// with the old velocity.
        printed_euler: flag "Printed Euler (eq. 6)" { Classic(false) }
    }
}

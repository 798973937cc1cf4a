//! The colours of the measured quantities: they follow the gas, and they are smooth.

use hearth_core::params::{DisplayMode, Input, Model};
use hearth_core::{Particle, Simulation, Vec2};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::{console_log, wasm_bindgen_test};

use super::{HEIGHT, WIDTH, closed, off, shown};
use crate::canvas::{Canvas, words};
use crate::scale::colour;

/// A disc of hot gas that turns rigidly \[1/s\], in the middle of air at rest, and how
/// far from its rim neither looks like the other \[m\].
const MIDDLE: Vec2 = Vec2::new(0.0, 0.9);
const RADIUS: f32 = 0.44;
const SPIN: f32 = 6.0;
const RIM: f32 = 0.15;

/// The modes that show a field.
const FIELDS: [DisplayMode; 7] = [
    DisplayMode::Temperature,
    DisplayMode::Density,
    DisplayMode::Pressure,
    DisplayMode::Velocity,
    DisplayMode::Vorticity,
    DisplayMode::Fuel,
    DisplayMode::Soot,
];

/// Gas of the combustion model: the disc, and the air around it.
fn turning_disc() -> Result<Simulation, JsValue> {
    let mut parameters = closed(Model::Combustion)?;
    // Before the first step hot gas has not made the room yet that it takes.
    let slight = Input::Number(0.1);
    parameters.set("gas_expansion", slight).map_err(words)?;
    let mut fire = Simulation::new(parameters);
    let mut gas = fire.particles();
    for particle in &mut gas {
        let off = particle.position - MIDDLE;
        if off.length() < RADIUS {
            particle.velocity = SPIN * off.perp();
            particle.temperature = 1500.0;
            (particle.fuel, particle.soot) = (0.6, 0.3);
        }
    }
    fire.set_particles(&gas).map_err(words)?;
    Ok(fire)
}

/// The value of the quantity that the library computes at a place of the disc.
fn read(fire: &Simulation, mode: DisplayMode, place: Vec2) -> f32 {
    let turns = place.distance(MIDDLE) < RADIUS;
    let of_disc = |value: f32, of_air: f32| if turns { value } else { of_air };
    match mode {
        DisplayMode::Temperature => of_disc(1500.0, 293.0),
        DisplayMode::Velocity => of_disc(SPIN * place.distance(MIDDLE), 0.0),
        DisplayMode::Vorticity => of_disc(2.0 * SPIN, 0.0),
        DisplayMode::Fuel => of_disc(0.6, 0.0),
        DisplayMode::Soot => of_disc(0.3, 0.0),
        DisplayMode::Density => {
            let values = fire.parameters();
            let room = (1500.0 / values.ambient_temperature).powf(values.gas_expansion);
            let densities = fire.densities();
            let thickest = densities.into_iter().fold(0.0, f32::max);
            of_disc(thickest / room, thickest)
        }
        // None before the first step.
        _ => 0.0,
    }
}

#[wasm_bindgen_test]
fn colours_follow_the_quantity_of_the_gas() -> Result<(), JsValue> {
    // How far off a place on the scale may be: for half floats, and for eight bits.
    for (canvas, astray) in [
        (Canvas::new(WIDTH, HEIGHT)?, 0.0),
        (Canvas::without_float_targets(WIDTH, HEIGHT)?, 0.03),
    ] {
        let mut fire = turning_disc()?;
        let mut worst = 0.0_f32;
        for mode in FIELDS {
            let (pixels, scale) = shown(&canvas, &mut fire, mode)?;
            let [least, most] = scale.ok_or("no scale")?;
            let signed = mode.quantity().is_some_and(|quantity| quantity.signed);
            for (x, y, pixel) in pixels.all() {
                let place = Vec2::new(x, y);
                let is_inside = x.abs() < 0.5 && (0.1..1.7).contains(&y);
                // The speed of the turning gas has a tip in its middle.
                let apart = place.distance(MIDDLE);
                if !is_inside || (apart - RADIUS).abs() < RIM || apart < 0.12 {
                    continue;
                }
                let expected = read(&fire, mode, place);
                let share = (expected - least) / (most - least);
                assert!((-0.01..=1.01).contains(&share), "{mode:?}: {expected}");
                let near = (-8..=8).map(|k| share + astray * k as f32 / 8.0);
                let found = near.map(|share| off(pixel, colour(share.clamp(0.0, 1.0), signed)));
                let found = found.fold(f32::INFINITY, f32::min);
                worst = worst.max(found);
                assert!(
                    found <= 6.0 && pixel[3] == 255,
                    "{mode:?} at {place}: {pixel:?} for {expected} of {least} to {most}"
                );
            }
        }
        console_log!("colours are at most {worst} of 255 off, {astray} astray");
    }
    Ok(())
}

#[wasm_bindgen_test]
fn a_field_is_smooth_between_pixels() -> Result<(), JsValue> {
    // The value rises evenly over the domain, so that no colour may jump: no texel, no
    // particle and no edge of a quad is seen.
    for (canvas, allowed) in [
        (Canvas::new(WIDTH, HEIGHT)?, 3.0),
        (Canvas::without_float_targets(WIDTH, HEIGHT)?, 6.0),
    ] {
        let mut fire = Simulation::new(closed(Model::Combustion)?);
        let mut gas: Vec<Particle> = fire.particles();
        for particle in &mut gas {
            particle.fuel = particle.position.y / 1.8;
        }
        fire.set_particles(&gas).map_err(words)?;
        let (pixels, _) = shown(&canvas, &mut fire, DisplayMode::Fuel)?;
        let metre = HEIGHT as f32 / 1.8;
        // As displays encode it; the eye sees little of blue.
        let bright =
            |[r, g, b, _]: [u8; 4]| 0.3 * f32::from(r) + 0.6 * f32::from(g) + 0.1 * f32::from(b);
        let mut worst = 0.0_f32;
        for (x, y, pixel) in pixels.all() {
            if x.abs() > 0.45 || !(0.1..1.7).contains(&y) {
                continue;
            }
            for beside in [pixels.at(x + 1.0 / metre, y), pixels.at(x, y + 1.0 / metre)] {
                let apart = (bright(pixel) - bright(beside)).abs();
                worst = worst.max(apart);
                assert!(apart <= allowed, "{pixel:?}, {beside:?} at {x}, {y}");
            }
        }
        console_log!("neighbouring pixels are at most {worst} of 255 apart");
    }
    Ok(())
}

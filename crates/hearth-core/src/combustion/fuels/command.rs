//! Lighting solids, and putting them out.

use std::fmt;

use glam::Vec2;

use super::cells::Burning;
use super::material::{BOILING, VAPORISATION, WATER_CAPACITY};
use super::state::Fuels;
use crate::combustion::gas::Gas;
use crate::extremes::fast_max;
use crate::params::Physics;
use crate::solids::{Body, Solids};

/// Radius within which a place is lit \[m\].
const DEFAULT_RADIUS: f32 = 0.1;
/// How much hotter than its pyrolysis temperature a lit solid is \[K\].
const IGNITION_EXCESS: f32 = 120.0;
/// Heat flux of the pilot flame [kW/m²], that of usual tests (ISO 5660-1), and for how long it burns
/// \[s\].
const PILOT_FLUX: f32 = 50.0;
const PILOT_DURATION: f32 = 2.0;
/// Temperature of the gas beside it \[K\], and how far it reaches, in spacings.
const PILOT_TEMPERATURE: f32 = 1200.0;
const PILOT_REACH: f32 = 2.0;
/// Distance from a solid within which gas is put out with it \[m\].
const EXTINGUISHED_MARGIN: f32 = 0.15;

/// What is lit or put out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IgnitionTarget {
    /// A solid, by its id.
    Object(u32),
    /// What is near a place, and how near: 0 for a usual distance \[m\].
    Place(Vec2, f32),
}

/// The error of lighting or putting out what has no fuel. The classic model has none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IgniteError;

impl IgniteError {
    /// What it must be instead.
    pub const ALLOWED: &'static str =
        "a solid with fuel, or a place near one or near a source that is on";
}

impl fmt::Display for IgniteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "it must be {}", IgniteError::ALLOWED)
    }
}

impl std::error::Error for IgniteError {}

impl Fuels {
    /// Heats the surface there to above the pyrolysis temperature, and the gas beside it.
    ///
    /// # Errors
    /// No fuel is there.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn ignite(
        &mut self,
        at: IgnitionTarget,
        gas: &mut Gas,
        solids: &Solids,
        values: &Physics,
    ) -> Result<(), IgniteError> {
        self.each(at, solids, &mut |burning, index| {
            burning.light(index, values.ambient_temperature);
        })?;
        let near = PILOT_REACH * values.spacing();
        for (&position, state) in gas.position.iter().zip(&mut gas.state) {
            let is_there = solids.bodies.iter().any(|body| {
                let there = match at {
                    IgnitionTarget::Object(id) => self.is_of(body, id),
                    IgnitionTarget::Place(place, radius) => {
                        position.distance(place) < reach(radius)
                    }
                };
                there
                    && body.burns
                    && body.may_touch(position, near)
                    && body.surface.distance(position).0 < near
            });
            if is_there {
                state.x = fast_max(state.x, PILOT_TEMPERATURE);
            }
        }
        Ok(())
    }

    /// Cools the solids and the gas there to the temperature of the air, and removes the fuel of
    /// that gas.
    ///
    /// # Errors
    /// No solid with fuel has that id.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn extinguish(
        &mut self,
        at: IgnitionTarget,
        gas: &mut Gas,
        solids: &Solids,
        values: &Physics,
    ) -> Result<(), IgniteError> {
        let air = values.ambient_temperature;
        let done = self.each(at, solids, &mut |burning, index| burning.cool(index, air));
        if at_object(at) {
            done?;
        }
        for (&position, state) in gas.position.iter().zip(&mut gas.state) {
            let is_there = match at {
                IgnitionTarget::Place(place, radius) => position.distance(place) < radius,
                IgnitionTarget::Object(id) => solids.bodies.iter().any(|body| {
                    self.is_of(body, id)
                        && body.may_touch(position, EXTINGUISHED_MARGIN)
                        && body.surface.distance(position).0 < EXTINGUISHED_MARGIN
                }),
            };
            if is_there {
                state.x = air;
                state.y = 0.0;
            }
        }
        Ok(())
    }

    /// Whether a body is that object or a part of it.
    fn is_of(&self, body: &Body, object: u32) -> bool {
        let mut all = self.all.iter();
        body.id() == object
            || all.any(|burning| burning.object == object && burning.id == body.id())
    }

    /// Calls `act` for each cell there: of an object, all of them; near a place, those within its
    /// radius.
    fn each(
        &mut self,
        at: IgnitionTarget,
        solids: &Solids,
        act: &mut dyn FnMut(&mut Burning, usize),
    ) -> Result<(), IgniteError> {
        let mut found = false;
        for burning in &mut self.all {
            let Some(body) = solids.first(burning.id) else {
                continue;
            };
            for index in 0..burning.cells.len() {
                let present = burning.cells[index].mass() > 0.0;
                let is_there = match at {
                    IgnitionTarget::Object(id) => burning.object == id,
                    IgnitionTarget::Place(point, radius) => {
                        let place = body.surface.frame.local(point);
                        place.distance(burning.place(index)) < reach(radius)
                    }
                };
                if present && is_there {
                    act(burning, index);
                    found = true;
                }
            }
        }
        if found { Ok(()) } else { Err(IgniteError) }
    }
}

fn at_object(at: IgnitionTarget) -> bool {
    matches!(at, IgnitionTarget::Object(_))
}

/// How near a place is meant \[m\].
pub(in crate::combustion) fn reach(radius: f32) -> f32 {
    if radius > 0.0 { radius } else { DEFAULT_RADIUS }
}

impl Burning {
    /// Heats and dries a cell of the surface.
    fn light(&mut self, index: usize, air: f32) {
        let material = self.material;
        let cell = &mut self.cells[index];
        if cell.length <= 0.0 {
            return;
        }
        let account = &mut self.account;
        let steam = f64::from(cell.water);
        let warm = fast_max(cell.temperature, BOILING);
        let before = f64::from(cell.capacity(material) * (cell.temperature - air));
        cell.water = 0.0;
        cell.pilot = PILOT_DURATION;
        cell.temperature = fast_max(cell.temperature, material.pyrolysis + IGNITION_EXCESS);
        let after = f64::from(cell.capacity(material) * (cell.temperature - air));
        let vapour = steam * f64::from(VAPORISATION + WATER_CAPACITY * (warm - air));
        account.steam += steam;
        account.gained += after - before + vapour;
        account.lost += vapour;
    }

    /// Heats the cells that have a pilot flame.
    pub(super) fn pilot(&mut self, dt: f32) {
        for cell in &mut self.cells {
            if cell.pilot > 0.0 && cell.mass() > 0.0 {
                let heat = PILOT_FLUX * cell.length * dt;
                cell.temperature += heat / cell.capacity(self.material);
                cell.pilot -= dt;
                self.account.gained += f64::from(heat);
            }
        }
    }

    /// Cools a cell to the temperature of the air.
    fn cool(&mut self, index: usize, air: f32) {
        let material = self.material;
        let cell = &mut self.cells[index];
        let heat = cell.capacity(material) * fast_max(cell.temperature - air, 0.0);
        self.account.lost += f64::from(heat);
        (cell.temperature, cell.received, cell.pilot) = (air, 0.0, 0.0);
        (self.account.power, self.account.starved) = (0.0, false);
    }
}

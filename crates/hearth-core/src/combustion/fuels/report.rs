//! What readers see of the solids that burn.

use super::cells::{Account, Burning, Cell, NONE};
use super::state::Fuels;
use crate::combustion::charred::{Charred, CharredSolid};
use crate::series::{BROKEN, CHARRED, DRIED, Totals};
use crate::solids::Solids;

/// Power below which a solid is out [kW/m].
const OUT_POWER: f32 = 0.05;
/// Power from which it is lit [kW/m].
const LIT_POWER: f32 = 0.5;
/// Oxygen beside a solid, relative to air, below which it went out because it lacked oxygen: flames go
/// out from 13 to 15 % of 21 % (Drysdale 2011, 3.5.4).
const STARVED_OXYGEN: f32 = 0.65;
/// Share of the fuel below which nothing is left.
const MIN_FUEL_SHARE: f32 = 0.02;

/// Largest share of char in a record, so that it is not a degree.
const MAX_CHAR: f32 = 0.99;

/// The state of a solid with fuel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BurningState {
    /// All of it has burnt.
    Burnt,
    /// It has not burnt yet.
    Unlit,
    /// It went out because it lacked heat.
    Out,
    /// It went out because it lacked oxygen.
    Starved,
    /// It burns.
    Burning,
}

impl BurningState {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            BurningState::Burnt => "burnt",
            BurningState::Unlit => "unlit",
            BurningState::Out => "out",
            BurningState::Starved => "no-oxygen",
            BurningState::Burning => "burning",
        }
    }
}

/// A solid with fuel; masses in kg and heat in kJ, per metre of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BurningSolid {
    /// Its id.
    pub id: u32,
    /// Whether it burns.
    pub state: BurningState,
    /// Dry mass at first.
    pub first: f64,
    /// Mass of fuel, of water and of char that is left.
    pub fuel: f64,
    /// Mass of water that is left.
    pub water: f64,
    /// Mass of char and ash that is left.
    pub char: f64,
    /// Mass of fuel gas that it has given off, and its heat of combustion.
    pub gas: f64,
    /// Heat of combustion of that gas.
    pub gas_heat: f64,
    /// Mass of steam that it has given off.
    pub steam: f64,
    /// Mass of char that has burnt.
    pub oxidised: f64,
    /// Mass that has fallen off as ash.
    pub fallen: f64,
    /// Heat that it stores, relative to the air.
    pub stored: f64,
    /// Heat that came in: from the gas, by radiation, from its char, and by `ignite`.
    pub gained: f64,
    /// Heat that left: by radiation, with what it gave off, and to dry and pyrolyse it.
    pub lost: f64,
    /// Heat that the gas has lost to it, less that of what it gave off.
    pub exchanged: f64,
    /// Heat of its gas that burnt at its surface: a part of what came in.
    pub flames: f64,
    /// Power of its gas and its char, averaged over a moment \[kW/m\].
    pub power: f32,
    /// Temperature of its hottest part \[K\].
    pub hottest: f32,
}

/// All solids with fuel, together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FuelTotal {
    /// Power of their gas and their char, averaged over a moment [kW/m].
    pub power: f64,
    /// Share of the fuel that is left.
    pub left: f64,
    /// The [state](BurningState) of the solid that comes last in their order; empty without any.
    pub state: &'static str,
    /// Parts that hold together only because there are 64 solids already.
    pub unbroken: u32,
}

impl Burning {
    /// Notes whether it burns.
    pub(super) fn note(&mut self) {
        let account = &mut self.account;
        if account.power > LIT_POWER {
            account.lit = true;
        }
        if account.power > OUT_POWER {
            account.starved = account.oxygen < STARVED_OXYGEN;
        }
    }
}

impl Account {
    /// Adds that of a part that has broken off.
    fn add(&mut self, part: &Account) {
        self.gas += part.gas;
        self.steam += part.steam;
        self.oxidised += part.oxidised;
        self.fallen += part.fallen;
        self.gained += part.gained;
        self.lost += part.lost;
        self.exchanged += part.exchanged;
        self.flames += part.flames;
        self.power += part.power;
        self.lit |= part.lit;
        self.starved |= part.starved;
    }

    fn state(&self, left: f64) -> BurningState {
        if self.lit && self.power > OUT_POWER {
            BurningState::Burning
        } else if left < f64::from(MIN_FUEL_SHARE) {
            BurningState::Burnt
        } else if !self.lit {
            BurningState::Unlit
        } else if self.starved {
            BurningState::Starved
        } else {
            BurningState::Out
        }
    }
}

impl Fuels {
    /// Every solid with fuel, together with what has broken off it.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn solids(&self, air: f32, gas_heat: f32) -> Vec<BurningSolid> {
        let whole = self
            .all
            .iter()
            .filter(|burning| burning.id == burning.object);
        whole
            .map(|burning| self.solid(burning, air, gas_heat))
            .collect()
    }

    fn solid(&self, burning: &Burning, air: f32, gas_heat: f32) -> BurningSolid {
        let mut account = Account::default();
        let (mut first, mut fuel, mut water, mut char) = (0.0, 0.0, 0.0, 0.0);
        let (mut waiting, mut stored, mut hottest) = (0.0, 0.0, 0.0_f32);
        for part in self.all.iter().filter(|other| other.object == burning.id) {
            account.add(&part.account);
            stored += part.stored(air);
            for cell in &part.cells {
                first += f64::from(cell.first);
                fuel += f64::from(cell.fuel);
                water += f64::from(cell.water);
                char += f64::from(cell.char);
                waiting += f64::from(cell.waiting);
                if cell.mass() > 0.0 {
                    hottest = hottest.max(cell.temperature);
                }
            }
        }
        let heat = f64::from(burning.material.gas_heat());
        fuel += waiting * f64::from(gas_heat) / heat;
        BurningSolid {
            id: burning.id,
            state: account.state(fuel / first.max(1e-12)),
            first,
            fuel,
            water,
            char,
            gas: account.gas,
            gas_heat: account.gas * heat,
            steam: account.steam,
            oxidised: account.oxidised,
            fallen: account.fallen,
            stored,
            gained: account.gained,
            lost: account.lost,
            exchanged: account.exchanged,
            flames: account.flames,
            power: account.power,
            hottest,
        }
    }

    /// All of them together.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn total(&self, gas_heat: f32) -> FuelTotal {
        let (mut power, mut left, mut first) = (0.0, 0.0, 0.0);
        let mut state = BurningState::Burnt;
        for solid in self.solids(0.0, gas_heat) {
            power += f64::from(solid.power);
            left += solid.fuel;
            first += solid.first;
            state = state.max(solid.state);
        }
        FuelTotal {
            power,
            left: left / first.max(1e-12),
            state: state.name(),
            unbroken: self.all.iter().map(|burning| burning.unbroken).sum(),
        }
    }

    /// Adds what all of them have given off and where they burn.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn add_totals(&self, solids: &Solids, totals: &mut Totals) {
        let (mut power, mut moment, mut load) = (0.0, 0.0, 0.0);
        for burning in &self.all {
            let account = &burning.account;
            totals.grown[DRIED] += account.steam;
            totals.grown[CHARRED] += account.gas * f64::from(burning.material.char_per_gas());
            totals.grown[BROKEN] += f64::from(u8::from(burning.id != burning.object));
            power += account.power;
            load += account.power * burning.load;
            if let Some(body) = solids.first(burning.id) {
                moment += account.power * body.surface.frame.centre.x;
            }
        }
        totals.place = moment / power.max(1e-6);
        totals.load = load / power.max(1e-6);
    }

    /// Adds all of them to a picture.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn write_charred(&self, solids: &Solids, out: &mut Charred) {
        for burning in &self.all {
            let place = out.records.len();
            let body = solids.first(burning.id);
            let body = body.filter(|_| burning.id != burning.object);
            out.solids.push(CharredSolid {
                id: burning.object,
                place,
                left: burning.left.clone(),
                part: body.map(|body| body.surface.frame),
            });
            let [width, height, radius] = burning.drawn();
            out.records.push([
                burning.id as f32,
                burning.columns as f32,
                burning.rows as f32,
                burning.half.x,
                burning.half.y,
                width,
                height,
                radius,
            ]);
            for some in burning.cells.chunks(8) {
                let mut record = [0.0; 8];
                for (value, cell) in record.iter_mut().zip(some) {
                    *value = burning.seen(cell);
                }
                out.records.push(record);
            }
        }
    }
}

impl Burning {
    /// Temperature and char of a cell; without anything in it, of the cell below it.
    fn seen(&self, cell: &Cell) -> f32 {
        let cell = match cell.vent {
            vent if vent != NONE && cell.mass() <= 0.0 => &self.cells[usize::from(vent)],
            _ => cell,
        };
        cell.temperature.floor() + MAX_CHAR * cell.charred()
    }
}

//! Solids that burn: fuel in cells, which the gas and its radiation heat, which dry, give off gas,
//! char, glow and fall.
//!
//! A solid gets [cells](cells) when it is set, or when the spacing changes. Every step
//! [exchanges](step) heat, fuel and oxygen with the gas beside them. A few times a second the
//! [outline](outline) follows what is left. The code is a part of the wasm that a page loads for a
//! scene with a fuel: nothing outside of it calls a function of it without one, or inlines it.

mod breaking;
mod cells;
mod command;
mod continued;
mod material;
mod outline;
mod radiation;
mod reaction;
mod report;
mod state;
mod step;
mod wet;

use super::gas::walls::Walls;
use super::gas::{Gas, make_room};
use super::open_air::OpenAir;
use super::reaction::embers::Embers;
use crate::params::Physics;
use crate::random::Random;
use crate::scene::Scene;
use crate::solids::Solids;
use crate::solids::free::FreeBodies;
use cells::Burning;
use state::{AdjacentGas, BLOCKS, Block};

pub(super) use command::reach;
pub use command::{IgniteError, IgnitionTarget};
pub(super) use material::{BOILING, VAPORISATION, WATER_CAPACITY};
pub(super) use radiation::MAX_RECEIVED_SHARE;
pub use report::{BurningSolid, BurningState, FuelTotal};
pub(crate) use state::Fuels;

/// Steps from one radiation to the next; and among free bodies, which are many: a hundredth of a
/// second, in which no flame changes much.
const RADIATION_STEPS: u32 = 2;
const STEPS_AMONG_BODIES: u32 = 4;

impl Fuels {
    /// The solids of a scene that burn, in place of those of the scene before.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn set(present: &mut Option<Box<Fuels>>, scene: &Scene, solids: &mut Solids) {
        let values = scene.world();
        let (air, spacing) = (values.ambient_temperature, values.spacing());
        let mut fuels = present.take().unwrap_or_default();
        let mut before = std::mem::take(&mut fuels.all);
        for (id, solid, surface) in scene.surfaces() {
            let known = before.iter().position(|burning| burning.id == id);
            let known = known.map(|at| before.swap_remove(at));
            let burning = match known {
                Some(known) if known.is(solid, surface, spacing) => Some(known),
                known => {
                    let mut new = Burning::new(id, solid, surface, spacing, air);
                    if let (Some(new), Some(known)) = (&mut new, known)
                        && new.is_finer_or_coarser(&known)
                    {
                        new.continue_from(known);
                    }
                    new
                }
            };
            fuels.all.extend(burning);
        }
        let all = &fuels.all;
        before.retain(|part| {
            let mut whole = all.iter().filter(|burning| burning.id == part.object);
            part.id != part.object && whole.any(|burning| burning.is_broken)
        });
        fuels.all.append(&mut before);
        if solids.free.is_some() {
            let all = &fuels.all;
            FreeBodies::remove_parts(solids, &|id| all.iter().any(|burning| burning.id == id));
        }
        for burning in &fuels.all {
            if let Some(field) = &burning.left {
                solids.reshape(burning.id, field);
            }
            burning.weigh(solids);
        }
        fuels.make_room();
        fuels.blocks.resize(BLOCKS * BLOCKS, Block::default());
        if !fuels.all.is_empty() {
            *present = Some(fuels);
        }
    }

    /// Makes room for the gas beside each cell and the light on it.
    fn make_room(&mut self) {
        let mut cells = 0;
        for burning in &mut self.all {
            burning.first_beside = cells;
            cells += burning.cells.len();
        }
        self.beside.resize(cells, AdjacentGas::default());
        self.views.clear();
        self.views.resize(cells, 0.0);
    }

    /// Makes room for so many particles near walls.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn reserve(&mut self, particles: usize) {
        make_room(&mut self.touches, particles);
    }

    /// Burns for `dt`. Returns the power of the flames in the film at the surface [kW/m].
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn burn(
        &mut self,
        (gas, walls): (&mut Gas, &Walls),
        (open, solids): (Option<&mut OpenAir>, &mut Solids),
        embers: &mut Embers,
        values: &Physics,
        random: &mut Random,
        dt: f32,
    ) -> f32 {
        if let Some(open) = open {
            for body in solids.bodies.iter().filter(|body| body.burns) {
                let frame = &body.surface.frame;
                let half = frame.extent() + values.spacing();
                open.activate(frame.centre - half, frame.centre + half);
            }
        }
        let steps = match solids.free.is_some() {
            true => STEPS_AMONG_BODIES,
            false => RADIATION_STEPS,
        };
        if self.steps.is_multiple_of(steps) {
            self.irradiate(gas, solids, values);
        }
        self.steps = self.steps.wrapping_add(1);
        self.exchange(gas, walls.near(), solids, values, dt);
        for burning in &mut self.all {
            burning.note();
        }
        self.shrink(solids, embers, values, random, dt);
        self.film
    }

    /// The solids that burn, and the power of each [kW/m].
    pub fn powers(&self) -> impl Iterator<Item = (u32, f32)> {
        let all = self.all.iter();
        all.map(|burning| (burning.id, burning.account.power))
    }

    /// Power of the gas that is given off and of the char that burns [kW/m].
    pub fn power(&self) -> f32 {
        self.power
    }
}

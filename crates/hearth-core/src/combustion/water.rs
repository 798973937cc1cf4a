//! Water: a spray of droplets that the gas drags, heats and evaporates, and that wet what they strike.
//!
//! A [parcel](Droplets) stands for many droplets of one size, which move and evaporate alike. Every
//! step parcels [exchange](exchange) momentum and heat with the gas around them, fall, and
//! [strike](strike) solids, [beds](bed) of sources and the floor. A part of their vapour becomes
//! [steam](steam), which only pictures show. No fire is put out by decree: gas that is cooled below its
//! ignition temperature does not burn, and fuel that is wet dries first. The code is a part of the wasm
//! that a page loads for the first spray: nothing outside of it calls a function of it without one, or
//! inlines it.

mod advance;
mod around;
mod bed;
mod beds;
mod exchange;
mod report;
mod spray;
mod state;
mod steam;
mod strike;

pub(super) use around::Around;
pub use report::{Droplets, SprayError, SprayTotals};
pub(super) use state::Water;

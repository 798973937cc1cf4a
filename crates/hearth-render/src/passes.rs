//! The table of passes. A pass is a file here and a pair of shaders in `shaders/`. A frame draws
//! the passes that apply to it, in this order.

mod accumulate;
mod advect_noise;
mod backdrop;
mod bloom_downsample;
mod bloom_upsample;
mod colour_map;
mod composite;
mod disc;
mod ember;
mod flame;
mod gas;
mod irradiance;
mod outline;
mod paper;
mod scenery;
mod shade;
mod shadow;
mod solid;
mod splat;
mod spread;
mod sprite;
mod tone_map;
mod velocity;

use crate::pass::Row;

/// Every pass, in the order of a frame.
pub static PASSES: [Row; 23] = [
    // Fire of the classic model: particles, field, light.
    Row::of::<splat::Splat>(),
    Row::of::<spread::Spread>(),
    Row::of::<shade::Shade>(),
    // Fire of the combustion model.
    Row::of::<gas::Gas>(),
    Row::of::<velocity::Velocity>(),
    Row::of::<advect_noise::AdvectNoise>(),
    Row::of::<flame::Flame>(),
    Row::of::<ember::Ember>(),
    // Light to the picture.
    Row::of::<bloom_downsample::BloomDownsample>(),
    Row::of::<bloom_upsample::BloomUpsample>(),
    Row::of::<tone_map::ToneMap>(),
    Row::of::<sprite::Sprite>(),
    Row::of::<composite::Composite>(),
    Row::of::<scenery::Scenery>(),
    Row::of::<irradiance::Irradiance>(),
    Row::of::<backdrop::Backdrop>(),
    // Display modes that draw particles or a quantity.
    Row::of::<paper::Paper>(),
    Row::of::<accumulate::Accumulate>(),
    Row::of::<colour_map::ColourMap>(),
    Row::of::<disc::Disc>(),
    // Solids and their shadows, in front of everything but the fire.
    Row::of::<shadow::Shadow>(),
    Row::of::<solid::Solid>(),
    Row::of::<outline::Outline>(),
];

//! The table of passes. A pass is a file here and a pair of shaders in `shaders/`. A frame draws
//! the passes that apply to it, in this order.

mod accumulate;
mod advect_noise;
mod backdrop;
mod behind;
mod bloom_downsample;
mod bloom_upsample;
mod carry_noise;
mod colour_map;
mod composite;
mod disc;
mod ember;
mod enlarge;
mod flame;
mod gas;
mod irradiance;
mod outline;
mod paper;
mod scenery;
mod shade;
mod shadow;
mod sheet;
mod smoke_light;
mod solid;
mod splat;
mod spread;
mod sprite;
mod tone_map;
mod velocity;

use crate::pass::Row;

/// Every pass, in the order of a frame.
pub static PASSES: [Row; 31] = [
    // Fire of the classic model: particles, field, light.
    Row::of::<splat::Splat>("splat"),
    Row::of::<spread::Spread>("spread"),
    Row::of::<shade::Shade>("shade"),
    // Fire of the combustion model.
    Row::of::<gas::Gas>("gas"),
    Row::of::<velocity::Velocity>("velocity"),
    Row::of::<advect_noise::AdvectNoise>("advect_noise"),
    Row::of::<carry_noise::CarryNoise>("carry_noise"),
    Row::of::<behind::Behind>("behind"),
    Row::of::<flame::Flame>("flame"),
    Row::of::<sheet::Sheet>("sheet"),
    Row::of::<behind::Under>("under"),
    Row::of::<ember::Ember>("ember"),
    // Light to the picture.
    Row::of::<bloom_downsample::BloomDownsample>("bloom_downsample"),
    Row::of::<bloom_upsample::BloomUpsample>("bloom_upsample"),
    Row::of::<smoke_light::SmokeLight>("smoke_light"),
    Row::of::<sheet::SheetLight>("sheet_light"),
    Row::of::<tone_map::ToneMap>("tone_map"),
    Row::of::<sprite::Sprite>("sprite"),
    Row::of::<composite::Composite>("composite"),
    Row::of::<scenery::Scenery>("scenery"),
    Row::of::<irradiance::Irradiance>("irradiance"),
    Row::of::<backdrop::Backdrop>("backdrop"),
    Row::of::<shadow::Shadow>("shadow"),
    Row::of::<solid::Cladding>("cladding"),
    Row::of::<enlarge::Enlarge>("enlarge"),
    // Display modes that draw particles or a quantity.
    Row::of::<paper::Paper>("paper"),
    Row::of::<accumulate::Accumulate>("accumulate"),
    Row::of::<colour_map::ColourMap>("colour_map"),
    Row::of::<disc::Disc>("disc"),
    // Solids, in front of everything but the fire.
    Row::of::<solid::Solid>("solid"),
    Row::of::<outline::Outline>("outline"),
];

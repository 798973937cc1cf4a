//! Readers of an [`Instance`] through its typed views. `hearth_core::instance` and
//! `shaders/particle.glsl` state its layout.

use hearth_core::Instance;
use hearth_core::instance::{ClassicParticle, Measured};

/// Position \[m\], which every view has.
pub fn position(&instance: &Instance) -> [f32; 2] {
    Measured::from(instance).position.to_array()
}

/// Velocity [m/s], which every view has.
pub fn velocity(&instance: &Instance) -> [f32; 2] {
    Measured::from(instance).velocity.to_array()
}

/// Upward speed [m/s], which every view has.
pub fn upward_speed(&instance: &Instance) -> f32 {
    Measured::from(instance).velocity.y
}

/// Temperature \[K\], which every view has.
pub fn temperature(&instance: &Instance) -> f32 {
    Measured::from(instance).temperature
}

/// Remaining share of the life, in the classic model's fire.
pub fn remaining_life(&instance: &Instance) -> f32 {
    ClassicParticle::from(instance).life
}

/// The measured quantity, in display modes that measure one.
pub fn measured(&instance: &Instance) -> f32 {
    Measured::from(instance).value
}

/// All instances as floats for an upload.
pub fn floats(instances: &[Instance]) -> &[f32] {
    instances.as_flattened()
}

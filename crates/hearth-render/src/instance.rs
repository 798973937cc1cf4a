//! Accessors of [`Instance`]. Only this file and `shaders/particle.glsl` depend on its layout.

use hearth_core::Instance;

/// Position \[m\].
pub fn position(&[x, y, ..]: &Instance) -> [f32; 2] {
    [x, y]
}

/// Upward speed [m/s].
pub fn upward_speed(&[_, _, _, speed, ..]: &Instance) -> f32 {
    speed
}

/// Temperature \[K\].
pub fn temperature(&[_, _, _, _, kelvin, ..]: &Instance) -> f32 {
    kelvin
}

/// Remaining share of the life, in the classic model's fire.
pub fn remaining_life(&[.., life]: &Instance) -> f32 {
    life
}

/// The measured quantity, in display modes that measure one.
pub fn measured(&[.., measured]: &Instance) -> f32 {
    measured
}

/// All instances as floats for an upload.
pub fn floats(instances: &[Instance]) -> &[f32] {
    instances.as_flattened()
}

//! What the renderer reads of a particle. The layout of [`Instance`] is known here and in
//! `shaders/particle.glsl`, and nowhere else in the renderer.

use hearth_core::Instance;

/// Place \[m\].
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

/// Share of its life that remains, in the classic model's fire.
pub fn remaining_life(&[.., life]: &Instance) -> f32 {
    life
}

/// What the display mode measures, in modes that measure.
pub fn measured(&[.., measured]: &Instance) -> f32 {
    measured
}

/// All of them as the graphics card gets them.
pub fn floats(instances: &[Instance]) -> &[f32] {
    instances.as_flattened()
}

//! Memory for the particles of a fire, reserved before it grows.
//!
//! Wasm aborts where memory does not suffice, which ends every fire of a page. So a fire that
//! grows first reserves what it will need, and is rejected with a message if the browser gives no more.

use hearth_core::params::{Model, Parameters};

use hearth_settings::untrusted::{Untrusted, ValidationError};

/// Memory of a particle with its neighbours and its copies for the renderer, rounded up \[B\].
const BYTES_PER_PARTICLE: usize = 1024;

/// Reserves the memory of a fire that changes from `old` to `new` values, for at most `limit`
/// particles. The allocator keeps it.
///
/// # Errors
/// The fire grows or changes its model or its edges, and the browser gives no more memory.
pub fn reserve(
    old: Option<&Parameters>,
    new: &Parameters,
    limit: u32,
) -> Result<(), ValidationError> {
    let wanted = new.capacity();
    let kind = |values: &Parameters| (values.model(), values.has_open_edges());
    if old.is_some_and(|old| wanted <= old.capacity() && kind(new) == kind(old))
        || has_room(wanted.min(limit) as usize)
    {
        return Ok(());
    }
    // The cap leaves room for twice the domain unless it is larger.
    let particles = new.particles;
    let is_cap = new.model() == Model::Classic || wanted / 2 > particles;
    let (id, number) = if is_cap {
        ("max_particles", wanted)
    } else {
        ("particles", particles)
    };
    Err(ValidationError::new(
        id,
        &Untrusted::Number(number.into()),
        "fewer, because there is no memory left for so many",
    ))
}

/// Whether the browser gives the memory of that many particles. The allocator keeps it.
pub fn has_room(particles: usize) -> bool {
    let bytes = particles * BYTES_PER_PARTICLE;
    Vec::<u8>::new().try_reserve_exact(bytes).is_ok()
}

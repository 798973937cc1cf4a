//! Memory for the particles of a fire, reserved before it grows.
//!
//! Wasm aborts where memory does not suffice, which ends every fire of a page. So a fire that
//! grows first reserves what it will need, and is refused in words if the browser gives no more.

use crate::{Untrusted, ValidationError};

/// Memory of a particle with its neighbours and its copies for the renderer, rounded up \[B\].
const BYTES_PER_PARTICLE: usize = 1024;

/// Reserves the memory of that many particles of a fire. The allocator keeps it.
///
/// # Errors
/// The browser gives no more memory.
pub fn reserve(particles: u32) -> Result<(), ValidationError> {
    let bytes = particles as usize * BYTES_PER_PARTICLE;
    match Vec::<u8>::new().try_reserve_exact(bytes) {
        Ok(()) => Ok(()),
        Err(_) => Err(ValidationError::new(
            "max_particles",
            &Untrusted::Number(particles.into()),
            "fewer, because the browser has no memory left for so many",
        )),
    }
}

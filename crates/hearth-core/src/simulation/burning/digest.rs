//! A digest of the physics of a fire.

use crate::params::{AnyValue, Param, Role, SOLID, Source};
use crate::scene::{Scene, SceneSource};

/// A hash of all values that affect the gas. Values at their default are not hashed, so that a
/// new parameter changes no digest. Nor are the seed, which has no effect on a burning fire, and
/// the number and the spacing of the particles, to which a fire can be resampled.
pub fn digest(scene: &Scene) -> u64 {
    let world = scene.world();
    let mut hash = fnv(0xcbf2_9ce4_8422_2325, world.model().name().as_bytes());
    // The first source that is on, with the values of the world.
    let none = Source::new(world.model());
    let first = scene.sources().next();
    let first = first.unwrap_or_else(|| SceneSource::new(&none, world, 0));
    hash = with_changed(hash, first.changed());
    if scene.sources().count() != 1 {
        hash = fnv(hash, b"objects");
        for source in scene.sources() {
            hash = with_changed(fnv(hash, b"source"), source.changed());
        }
    }
    for solid in scene.solids() {
        let changed = SOLID.iter().filter_map(|param| {
            let value = solid.get(param)?;
            (value != param.domains[0].default).then_some((param, value))
        });
        hash = with_changed(fnv(hash, b"solid"), changed);
    }
    hash
}

/// Continues a hash with these values.
fn with_changed<'a>(
    mut hash: u64,
    changed: impl Iterator<Item = (&'static Param, AnyValue<'a>)>,
) -> u64 {
    for (param, value) in changed {
        let resampled = ["seed", "particles", "max_particles", "spacing"].contains(&param.id);
        if param.role != Role::Physics || resampled {
            continue;
        }
        hash = fnv(hash, param.id.as_bytes());
        let number = match value {
            AnyValue::Number(x) => x.to_bits(),
            AnyValue::Integer(n) | AnyValue::Seed(n) => n,
            AnyValue::Flag(on) => on.into(),
            AnyValue::Choice(name) | AnyValue::Text(name) => {
                hash = fnv(hash, name.as_bytes());
                continue;
            }
            AnyValue::Colour(_) => continue,
        };
        hash = fnv(hash, &number.to_le_bytes());
    }
    hash
}

/// Continues a hash with these bytes, by Fowler, Noll and Vo (FNV-1a).
fn fnv(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

//! The decoders of links, scene files and checkpoints for `tests/fuzz`, which alone compiles them.

use std::ffi::OsStr;
use std::sync::LazyLock;

use hearth_core::resolution::Level;
use hearth_core::state::State;
use hearth_settings::Settings;
use hearth_settings::untrusted::Untrusted;

use crate::film::checkpoint;
use crate::{Fire, json, scene};

/// The settings of a page's link.
///
/// # Errors
/// What is wrong with it.
pub fn link(link: &str) -> Result<Untrusted, String> {
    scene::link::settings(link)
}

/// The value of a scene file.
///
/// # Errors
/// What is wrong with it.
pub fn scene(bytes: &[u8]) -> Result<Untrusted, String> {
    json::read(bytes)
}

/// Bytes after damage: each four bytes of it are a place, and the byte there; at no place, the bytes end at the rest of it.
pub fn damaged(mut bytes: Vec<u8>, damage: &[u8]) -> Vec<u8> {
    for change in damage.chunks_exact(4) {
        let [a, b, c] = [change[0], change[1], change[2]].map(usize::from);
        let place = a << 16 | b << 8 | c;
        match bytes.get_mut(place) {
            Some(byte) => *byte = change[3],
            None => bytes.truncate(place % (bytes.len() + 1)),
        }
    }
    bytes
}

/// Reads a checkpoint whose state is damaged. It has the right hash: what reads it must not rely on that.
pub fn checkpoint(damage: &[u8]) {
    static WRITTEN: LazyLock<(Vec<u8>, Settings)> = LazyLock::new(|| {
        let settings = Settings::of_preset("match").unwrap_or_default();
        let mut burnt = Fire::new(settings.clone(), Level::Low, 0.0);
        burnt.burn(0.05, &mut |_| {});
        let mut bytes = checkpoint::write(1, 2, &burnt);
        bytes.truncate(bytes.len() - size_of::<u64>());
        (bytes, settings)
    });
    let (written, settings) = &*WRITTEN;
    let mut bytes = damaged(written.clone(), damage);
    checkpoint::hash(&bytes).save(&mut bytes);
    let mut fire = Fire::new(settings.clone(), Level::Low, 0.0);
    let _ = checkpoint::take(&bytes, OsStr::new("a checkpoint"), 1, &mut fire);
}

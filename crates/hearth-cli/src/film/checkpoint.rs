//! The state of a fire at a picture of a film, from which another part of the film resumes.

use std::ffi::OsStr;
use std::fs;

use hearth_core::state::{Bytes, State};

use crate::Fire;
use crate::error::{Error, shown};

/// What a file begins with, and the version of the format: another version of the program has other bits.
const MAGIC: [u8; 8] = *b"HearthCP";
const VERSION: [u8; 16] = {
    let (version, mut padded, mut at) = (env!("CARGO_PKG_VERSION").as_bytes(), [0; 16], 0);
    while at < version.len() && at < padded.len() {
        padded[at] = version[at];
        at += 1;
    }
    padded
};

/// A hash by Fowler, Noll and Vo (FNV-1a).
pub fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// The bytes of a fire before its picture of that number. `film` is the hash of all that the fire follows from.
pub fn write(film: u64, number: u32, fire: &Fire) -> Vec<u8> {
    let mut bytes = [&MAGIC[..], &VERSION].concat();
    film.save(&mut bytes);
    number.save(&mut bytes);
    fire.save(&mut bytes);
    hash(&bytes).save(&mut bytes);
    bytes
}

/// Continues a fire from a file. Returns the number of the picture before which it is.
///
/// # Errors
/// There is no such file, it is damaged, or it is of another version or another film.
pub fn read(name: &OsStr, film: u64, fire: &mut Fire) -> Result<u32, Error> {
    let file = fs::read(name).map_err(|error| Error::at(name, error))?;
    take(&file, name, film, fire)
}

/// Continues a fire from the bytes of a file of that name.
pub fn take(file: &[u8], name: &OsStr, film: u64, fire: &mut Fire) -> Result<u32, Error> {
    let wrong = |words: &str| Error::Use(format!("{}: {words}", shown(name)));
    let damaged = || wrong("the checkpoint is damaged");
    let mut bytes = Bytes(file);
    if bytes.take() != Some(MAGIC) {
        return Err(wrong("is no checkpoint, which --checkpoint writes"));
    }
    if bytes.take() != Some(VERSION) {
        return Err(wrong("another version of hearth wrote the checkpoint"));
    }
    let (content, sum) = file.split_last_chunk().ok_or_else(damaged)?;
    if hash(content) != u64::from_le_bytes(*sum) {
        return Err(damaged());
    }
    if u64::load(&mut bytes) != Some(film) {
        return Err(wrong(
            "the checkpoint is of another film: scene and values, --seed, --quality, --warm, --fit, --size, --from, --fps \
             and --motion-blur must be those with which it was written",
        ));
    }
    let number = u32::load(&mut bytes).ok_or_else(damaged)?;
    fire.load(&mut bytes).ok_or_else(damaged)?;
    match bytes.0.len() == size_of::<u64>() {
        true => Ok(number),
        false => Err(damaged()),
    }
}

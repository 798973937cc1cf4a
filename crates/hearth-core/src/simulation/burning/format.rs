//! The format of a burning fire: a header, then column by column.

use std::fmt;

use glam::Vec2;

use crate::bounds::Bounds;
use crate::scene::MAX_OBJECTS;

/// An error of bytes that are not a fire of this scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BurningError {
    /// The fire has other values or another model. The bytes are valid.
    OtherValues,
    /// The format has this version, which is not [`VERSION`].
    OtherVersion(u16),
    /// The bytes are damaged; the message.
    Damaged(&'static str),
}

impl fmt::Display for BurningError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BurningError::OtherValues => f.write_str("the burning fire has other values"),
            BurningError::OtherVersion(version) => write!(
                f,
                "the burning fire has version {version} of the format; it must be {VERSION}"
            ),
            BurningError::Damaged(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for BurningError {}

/// The version of the format.
pub const VERSION: u16 = 3;

pub(super) const MAGIC: &[u8; 4] = b"Fire";
pub(super) const HEADER: usize = 56;
/// Bytes of a particle, and of an ember.
pub(super) const BYTES_PER_PARTICLE: usize = 10;
/// Most stored embers.
pub(super) const EMBERS: usize = 1000;
/// Bytes of a number of a solid: its temperature, or one of those of a free solid.
const NUMBER: usize = 4;
/// Numbers of a free solid.
pub(super) const BODY: usize = 8;
/// Largest plausible time \[s\].
const MAX_TIME: f64 = 1e6;

/// The message about a value that no fire has.
pub(super) const OUT_OF_RANGE: &str = "the burning fire has values out of range";

/// The message about bytes that do not fit the numbers of the header or of the scene.
pub(super) const WRONG_LENGTH: &str = "the burning fire has the wrong length";
const NO_FIRE: BurningError = BurningError::Damaged("the bytes are not a burning fire");

/// The header.
pub(super) struct Header {
    pub embers: usize,
    pub digest: u64,
    /// [`Discretisation::resolution_key`](crate::combustion::Discretisation::resolution_key).
    pub resolution_key: u32,
    pub particles: usize,
    pub time: f64,
    pub scales: [f32; 6],
}

impl Header {
    /// Reads the header, and checks its values and the number of bytes after it.
    pub fn read(bytes: &mut Bytes<'_>) -> Result<Header, BurningError> {
        let magic = bytes.take().ok_or(NO_FIRE)?;
        let version = u16::from_le_bytes(bytes.take().ok_or(NO_FIRE)?);
        if magic != *MAGIC {
            return Err(NO_FIRE);
        }
        if version != VERSION {
            return Err(BurningError::OtherVersion(version));
        }
        let header = Header::fields(bytes).ok_or(NO_FIRE)?;
        header.check(bytes.0.len()).map_err(BurningError::Damaged)?;
        Ok(header)
    }

    fn fields(bytes: &mut Bytes<'_>) -> Option<Header> {
        Some(Header {
            embers: u16::from_le_bytes(bytes.take()?).into(),
            digest: u64::from_le_bytes(bytes.take()?),
            resolution_key: u32::from_le_bytes(bytes.take()?),
            particles: u32::from_le_bytes(bytes.take()?) as usize,
            time: f64::from_le_bytes(bytes.take()?),
            scales: {
                let mut scales = [0.0; 6];
                for scale in &mut scales {
                    *scale = f32::from_le_bytes(bytes.take()?);
                }
                scales
            },
        })
    }

    fn check(&self, rest: usize) -> Result<(), &'static str> {
        // Enough for any fire, without an overflow below.
        let allowed = 1..=100_000;
        if !allowed.contains(&self.particles) || self.embers > EMBERS {
            return Err("the burning fire has an invalid number of particles");
        }
        let solids = rest.checked_sub(BYTES_PER_PARTICLE * (self.particles + self.embers));
        let most = MAX_OBJECTS * (1 + BODY);
        if !solids.is_some_and(|rest| rest % NUMBER == 0 && rest / NUMBER <= most) {
            return Err(WRONG_LENGTH);
        }
        let [velocity, excess, soot, embers @ ..] = self.scales;
        let valid = (0.0..=500.0).contains(&velocity)
            && (0.0..=20_000.0).contains(&excess)
            && (0.0..=10.0).contains(&soot)
            && embers.iter().all(|scale| (0.0..=500.0).contains(scale))
            && (0.0..=MAX_TIME).contains(&self.time);
        if valid { Ok(()) } else { Err(OUT_OF_RANGE) }
    }
}

/// The unread bytes.
pub(super) struct Bytes<'a>(pub &'a [u8]);

impl<'a> Bytes<'a> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    /// The numbers in all that is left.
    pub fn numbers(self) -> Vec<f32> {
        let (fours, _) = self.0.as_chunks();
        fours.iter().map(|&four| f32::from_le_bytes(four)).collect()
    }

    /// The next `count` bytes, or all if there are fewer.
    fn split(&mut self, count: usize) -> &'a [u8] {
        let (first, rest) = self.0.split_at(count.min(self.0.len()));
        self.0 = rest;
        first
    }
}

/// The columns of particles or of embers.
pub(super) struct Columns<'a> {
    positions: [&'a [u8]; 2],
    shares: [&'a [u8]; 6],
}

impl<'a> Columns<'a> {
    pub fn of(bytes: &mut Bytes<'a>, count: usize) -> Columns<'a> {
        Columns {
            positions: std::array::from_fn(|_| bytes.split(2 * count)),
            shares: std::array::from_fn(|_| bytes.split(count)),
        }
    }

    pub fn share(&self, column: usize, i: usize) -> f32 {
        f32::from(self.shares[column][i]) / 255.0
    }

    pub fn position(&self, i: usize, bounds: &Bounds) -> Vec2 {
        let part = |axis: usize| {
            let (low, high) = (self.positions[axis][2 * i], self.positions[axis][2 * i + 1]);
            (f32::from(u16::from_le_bytes([low, high])) + 0.5) / 65_536.0
        };
        let at = Vec2::new(part(0) - 0.5, part(1)) * Vec2::new(bounds.width, bounds.height);
        at + Vec2::new(0.0, bounds.bottom)
    }

    pub fn velocity(&self, i: usize, largest: f32) -> Vec2 {
        let component = |column: usize| {
            let root = (f32::from(self.shares[column][i]) - 128.0) / 127.0;
            root * root.abs() * largest
        };
        Vec2::new(component(0), component(1))
    }
}

/// A share of the largest in eight bits.
pub(super) fn quantised(value: f32, largest: f32) -> u8 {
    let part = if largest > 0.0 { value / largest } else { 0.0 };
    (part * 255.0 + 0.5).clamp(0.0, 255.0) as u8
}

/// The root of a signed share of the largest in eight bits; 128 is zero.
pub(super) fn quantised_signed(value: f32, largest: f32) -> u8 {
    let part = if largest > 0.0 { value / largest } else { 0.0 };
    let root = part.abs().sqrt().min(1.0) * 127.0;
    (128.5 + root.copysign(part)).clamp(1.0, 255.0) as u8
}

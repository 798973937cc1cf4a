//! The bytes of a burning fire: a head, then column by column.

use glam::Vec2;

/// The version of the form.
pub const VERSION: u16 = 1;

pub(super) const MAGIC: &[u8; 4] = b"Fire";
pub(super) const HEADER: usize = 56;
/// Bytes of a particle, and of an ember.
pub(super) const EACH: usize = 10;
/// Most embers that are stored.
pub(super) const EMBERS: usize = 1000;
/// Longest time that is believed \[s\].
const LONGEST: f64 = 1e6;

/// What stands before the columns.
pub(super) struct Head {
    version: u16,
    pub embers: usize,
    pub digest: u64,
    pub made_with: u32,
    pub particles: usize,
    pub time: f64,
    pub scales: [f32; 6],
}

impl Head {
    pub fn read(bytes: &mut Bytes<'_>) -> Option<Head> {
        if bytes.take::<4>()? != *MAGIC {
            return None;
        }
        let version = u16::from_le_bytes(bytes.take()?);
        let embers = u16::from_le_bytes(bytes.take()?).into();
        let digest = u64::from_le_bytes(bytes.take()?);
        let made_with = u32::from_le_bytes(bytes.take()?);
        let particles = u32::from_le_bytes(bytes.take()?) as usize;
        let time = f64::from_le_bytes(bytes.take()?);
        let mut scales = [0.0; 6];
        for scale in &mut scales {
            *scale = f32::from_le_bytes(bytes.take()?);
        }
        Some(Head {
            version,
            embers,
            digest,
            made_with,
            particles,
            time,
            scales,
        })
    }

    /// What is wrong with it, where so many bytes follow.
    pub fn check(&self, rest: usize) -> Result<(), &'static str> {
        // Enough for any fire, and few enough that no sum below overflows.
        let few = 1..=100_000;
        if self.version != VERSION {
            return Err("the burning fire is of another version");
        }
        if !few.contains(&self.particles) || self.embers > EMBERS {
            return Err("the burning fire has no such number of particles");
        }
        if rest != EACH * (self.particles + self.embers) {
            return Err("the burning fire is cut short, or too long");
        }
        let [velocity, hot, sooty, rest @ ..] = self.scales;
        let good = (0.0..=500.0).contains(&velocity)
            && (0.0..=20_000.0).contains(&hot)
            && (0.0..=10.0).contains(&sooty)
            && rest.iter().all(|scale| (0.0..=500.0).contains(scale))
            && (0.0..=LONGEST).contains(&self.time);
        if good {
            Ok(())
        } else {
            Err("the burning fire is beyond all measure")
        }
    }
}

/// What is left to be read.
pub(super) struct Bytes<'a>(pub &'a [u8]);

impl<'a> Bytes<'a> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    /// The next so many; all that there are, where those are fewer.
    fn split(&mut self, count: usize) -> &'a [u8] {
        let (first, rest) = self.0.split_at(count.min(self.0.len()));
        self.0 = rest;
        first
    }
}

/// The columns of particles or of embers.
pub(super) struct Columns<'a> {
    places: [&'a [u8]; 2],
    shares: [&'a [u8]; 6],
}

impl<'a> Columns<'a> {
    pub fn of(bytes: &mut Bytes<'a>, count: usize) -> Columns<'a> {
        Columns {
            places: std::array::from_fn(|_| bytes.split(2 * count)),
            shares: std::array::from_fn(|_| bytes.split(count)),
        }
    }

    pub fn share(&self, column: usize, i: usize) -> f32 {
        let byte = self.shares[column].get(i).copied().unwrap_or(0);
        f32::from(byte) / 255.0
    }

    pub fn place(&self, i: usize, domain: Vec2) -> Vec2 {
        let part = |axis: usize| {
            let two = self.places[axis].get(2 * i..2 * i + 2);
            let [low, high] = two.and_then(|two| two.try_into().ok()).unwrap_or([0; 2]);
            (f32::from(u16::from_le_bytes([low, high])) + 0.5) / 65_536.0
        };
        Vec2::new(part(0) - 0.5, part(1)) * domain
    }

    pub fn velocity(&self, i: usize, largest: f32) -> Vec2 {
        let one = |column: usize| {
            let byte = self.shares[column].get(i).copied().unwrap_or(128);
            let root = (f32::from(byte) - 128.0) / 127.0;
            root * root.abs() * largest
        };
        Vec2::new(one(0), one(1))
    }
}

/// A share of the largest in eight bits.
pub(super) fn share(value: f32, largest: f32) -> u8 {
    let part = if largest > 0.0 { value / largest } else { 0.0 };
    (part * 255.0 + 0.5).clamp(0.0, 255.0) as u8
}

/// A signed share of the largest as its root, 128 for none.
pub(super) fn signed(value: f32, largest: f32) -> u8 {
    let part = if largest > 0.0 { value / largest } else { 0.0 };
    let root = part.abs().sqrt().min(1.0) * 127.0;
    (128.5 + root.copysign(part)).clamp(1.0, 255.0) as u8
}

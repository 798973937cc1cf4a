//! The sound of a film, as a WAV file.

use hearth_core::Simulation;
use hearth_core::sound::{Mix, Synthesis};

/// Sample rate \[Hz\].
const RATE: u32 = 48_000;
/// Bytes of both channels of a sample.
const BYTES: u32 = 4;

/// What a fire sounds like: that of the element from the beginning of the fire on.
#[derive(Clone)]
pub struct Sound {
    synthesis: Synthesis,
    /// Seconds of fire in a second of the clock.
    speed: f64,
    half_width: f32,
    /// Number of samples until now.
    count: usize,
    /// Number of the first one that is kept.
    first: usize,
    /// The kept samples, left and right in turn.
    kept: Vec<i16>,
}

hearth_core::state! { Sound: synthesis speed half_width count; first kept }

impl Sound {
    /// The sound of a fire, which is recorded from now on.
    pub fn of(fire: &mut Simulation) -> Sound {
        fire.record_series(true);
        let values = fire.parameters();
        Sound {
            synthesis: Synthesis::new(f64::from(RATE), 1, Mix::default()),
            speed: values.time_scale.into(),
            half_width: 0.5 * values.domain_width,
            count: 0,
            first: 0,
            kept: Vec::new(),
        }
    }

    /// The number of the sample at an age \[s\]: it is one of the clock.
    pub fn sample_at(&self, age: f64) -> usize {
        (age / self.speed * f64::from(RATE)).round() as usize
    }

    /// Keeps samples from that number on.
    pub fn keep_from(&mut self, first: usize) {
        self.first = first;
    }

    /// Hears what the fire has done since the last call.
    pub fn listen(&mut self, fire: &mut Simulation) {
        let synthesis = &mut self.synthesis;
        synthesis.push(&fire.read_series(), self.speed, self.half_width);
        let count = (synthesis.ahead() * f64::from(RATE)) as usize;
        let (mut left, mut right) = (vec![0.0; count], vec![0.0; count]);
        synthesis.render(&mut left, &mut right);
        let unheard = self.first.saturating_sub(self.count).min(count);
        let both = left.iter().zip(&right).skip(unheard);
        let both = both.flat_map(|(left, right)| [*left, *right]);
        let whole = |sample: f32| (f32::from(i16::MAX) * sample).round() as i16;
        self.kept.extend(both.map(whole));
        self.count += count;
    }

    /// The kept samples up to that number, once all of them are there.
    pub fn until(&self, end: usize) -> Option<&[i16]> {
        self.kept.get(..2 * end.saturating_sub(self.first))
    }
}

/// A stereo file of 16 bits, whose header is Microsoft's and IBM's of 1991.
pub fn wav(samples: &[i16]) -> Vec<u8> {
    let bytes = 2 * samples.len() as u32;
    let mut file = Vec::with_capacity(44 + bytes as usize);
    file.extend(b"RIFF");
    file.extend((36 + bytes).to_le_bytes());
    file.extend(b"WAVEfmt ");
    file.extend(16_u32.to_le_bytes());
    file.extend([1_u16, 2].map(u16::to_le_bytes).concat());
    file.extend([RATE, BYTES * RATE].map(u32::to_le_bytes).concat());
    file.extend([BYTES as u16, 16].map(u16::to_le_bytes).concat());
    file.extend(b"data");
    file.extend(bytes.to_le_bytes());
    file.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
    file
}

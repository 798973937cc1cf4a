//! The sound of a film, as a WAV file.

use hearth_core::sound::{Mix, Synthesis};

use crate::Fire;

/// Sample rate \[Hz\].
const RATE: u32 = 48_000;
/// Bytes of both channels of a sample.
const BYTES: u32 = 4;
/// Time of fire between two readings of what it has done \[s\]. The simulation keeps 2048 steps.
const READ_SECONDS: f64 = 0.1;

/// Samples of a fire, left and right in turn, from one age to another \[s\]. They are those of the element's sound from
/// the beginning of the fire on.
pub fn samples(fire: &mut Fire, [from, to]: [f64; 2], on_step: &mut dyn FnMut(f64)) -> Vec<i16> {
    let values = fire.simulation().parameters();
    let (speed, half_width) = (f64::from(values.time_scale), 0.5 * values.domain_width);
    let mut synthesis = Synthesis::new(f64::from(RATE), 1, Mix::default());
    fire.simulation.record_series(true);
    // A sample is one of the clock, which the speed of time relates to the age.
    let [first, end] = [from, to].map(|age| (age / speed * f64::from(RATE)).round() as usize);
    let (mut left, mut right, mut samples) = (Vec::new(), Vec::new(), Vec::new());
    while samples.len() < 2 * end {
        fire.advance(fire.simulation().time() + READ_SECONDS, on_step);
        synthesis.push(&fire.simulation.read_series(), speed, half_width);
        let count = (synthesis.ahead() * f64::from(RATE)) as usize;
        left.resize(count, 0.0);
        right.resize(count, 0.0);
        synthesis.render(&mut left, &mut right);
        let both = left
            .iter()
            .zip(&right)
            .flat_map(|(left, right)| [*left, *right]);
        samples.extend(both.map(|sample: f32| (f32::from(i16::MAX) * sample).round() as i16));
    }
    samples.truncate(2 * end);
    samples.split_off(2 * first)
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

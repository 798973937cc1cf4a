//! Writes the low band of a fire's sound to a WAV file: `cargo run --release --example roar -- fire.wav campfire 10`.
//!
//! The low band is the time derivative of the power, through a low pass. `docs/sound.md` says what the sound of the
//! element adds to it: noise above the low band, crackle, steam and jets. The same scene gives the same samples.

use std::error::Error;
use std::f64::consts::{PI, SQRT_2};
use std::fs;

use hearth_fire::preset::Preset;
use hearth_fire::{Simulation, StepRecord};

/// Sample rate [Hz].
const RATE: u32 = 48_000;
/// Highest frequency of the low band [Hz], and its highest share of the rate of steps.
const CUTOFF: f64 = 180.0;
const CUTOFF_SHARE: f64 = 0.35;
/// Seconds of fire between two calls.
const PIECE: f64 = 1.0 / 60.0;
/// Largest sample.
const PEAK: f64 = 0.5;

/// Butterworth's low pass of second order, in transposed direct form II.
#[derive(Default)]
struct LowPass {
    past: [f64; 2],
}

impl LowPass {
    /// Filters a sample, with the cut-off as a share of the sample rate.
    fn run(&mut self, sample: f64, cutoff: f64) -> f64 {
        let k = (PI * cutoff).tan();
        let norm = 1.0 / (1.0 + SQRT_2 * k + k * k);
        let (b, a) = (
            k * k * norm,
            [
                2.0 * (k * k - 1.0) * norm,
                (1.0 - SQRT_2 * k + k * k) * norm,
            ],
        );
        let result = b * sample + self.past[0];
        self.past[0] = 2.0 * b * sample - a[0] * result + self.past[1];
        self.past[1] = b * sample - a[1] * result;
        result
    }
}

/// The power between the middles of steps, which it resamples.
#[derive(Default)]
struct LowBand {
    filter: LowPass,
    last: Option<StepRecord>,
    /// Time of the next sample after the middle of the last step [s].
    due: f64,
    samples: Vec<f64>,
}

impl LowBand {
    /// Adds a step.
    fn add(&mut self, step: StepRecord) {
        let Some(last) = self.last.replace(step) else {
            return;
        };
        let apart = 0.5 * f64::from(last.length + step.length);
        let slope = f64::from(step.power - last.power) / apart;
        let cutoff = CUTOFF.min(CUTOFF_SHARE / f64::from(step.length)) / f64::from(RATE);
        while self.due < apart {
            self.samples.push(self.filter.run(slope, cutoff));
            self.due += 1.0 / f64::from(RATE);
        }
        self.due -= apart;
    }
}

/// A mono file of 16 bits.
fn wav(samples: &[f64]) -> Vec<u8> {
    let bytes = 2 * samples.len() as u32;
    let mut file = Vec::new();
    file.extend(b"RIFF");
    file.extend((36 + bytes).to_le_bytes());
    file.extend(b"WAVEfmt ");
    file.extend(16_u32.to_le_bytes());
    file.extend([1_u16, 1].map(u16::to_le_bytes).concat());
    file.extend([RATE, 2 * RATE].map(u32::to_le_bytes).concat());
    file.extend([2_u16, 16].map(u16::to_le_bytes).concat());
    file.extend(b"data");
    file.extend(bytes.to_le_bytes());
    let loudest = samples.iter().fold(1e-9_f64, |most, x| most.max(x.abs()));
    let scaled = samples
        .iter()
        .map(|x| x / loudest * PEAK * f64::from(i16::MAX));
    file.extend(scaled.flat_map(|x| (x as i16).to_le_bytes()));
    file
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().unwrap_or_else(|| "fire.wav".into());
    let name = arguments.next().unwrap_or_else(|| "campfire".into());
    let seconds: f64 = arguments.next().map_or(Ok(10.0), |text| text.parse())?;

    let preset = Preset::find(&name)?;
    let mut fire = Simulation::new(preset.scene());
    fire.record_series(true);
    let mut band = LowBand::default();
    while fire.time() < seconds {
        fire.advance(PIECE);
        fire.read_series()
            .into_iter()
            .for_each(|step| band.add(step));
    }
    fs::write(file, wav(&band.samples))?;
    Ok(())
}

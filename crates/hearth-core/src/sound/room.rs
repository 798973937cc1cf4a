//! A short reverberation: four delays that feed each other, as before a wall.

use super::filters::decay;

/// Lengths of the delays \[s\].
const DELAYS: [f64; 4] = [0.0113, 0.0167, 0.0209, 0.0277];
/// Time in which the sound falls by 60 dB \[s\].
const REVERBERATION_TIME: f64 = 0.4;
/// Share of a sample that each reflection keeps from the one before it, which dampens high frequencies.
const DAMPING: f64 = 0.35;
/// Level beside the sound itself.
const LEVEL: f64 = 0.08;

/// The reverberation of one fire.
#[derive(Clone, Debug)]
pub(super) struct Room {
    lines: [Line; 4],
}

#[derive(Clone, Debug)]
struct Line {
    samples: Vec<f64>,
    at: usize,
    gain: f64,
    damped: f64,
}

crate::state! { Line: samples at gain damped, Room: lines }

impl Room {
    pub fn new(rate: f64) -> Room {
        let line = |seconds: f64| Line {
            samples: vec![0.0; (seconds * rate) as usize + 1],
            at: 0,
            // Half of it: the matrix that mixes four lines doubles the amplitude.
            gain: 0.5 * decay(REVERBERATION_TIME / (6.9 * seconds)),
            damped: 0.0,
        };
        Room {
            lines: DELAYS.map(line),
        }
    }

    /// What the wall returns of a sample, on both sides.
    pub fn run(&mut self, sample: f64) -> [f64; 2] {
        let mut out = [0.0; 4];
        for (out, line) in out.iter_mut().zip(&mut self.lines) {
            let delayed = line.samples.get(line.at).copied().unwrap_or_default();
            line.damped += (1.0 - DAMPING) * (delayed - line.damped);
            *out = line.damped;
        }
        let [a, b, c, d] = out;
        let mixed = [a + b + c + d, a - b + c - d, a + b - c - d, a - b - c + d];
        for (line, mixed) in self.lines.iter_mut().zip(mixed) {
            if let Some(place) = line.samples.get_mut(line.at) {
                *place = sample + line.gain * mixed;
            }
            line.at += 1;
            if line.at >= line.samples.len() {
                line.at = 0;
            }
        }
        [LEVEL * (a + c), LEVEL * (b + d)]
    }
}

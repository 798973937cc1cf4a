//! Writes the sound of a scene to a WAV file: `cargo run --release --example sound -- fire.wav campfire 10`. The same
//! scene gives the same samples, and they are those of the element and of `hearth-fire/sound`.

use std::error::Error;
use std::fs;

use hearth_fire::Simulation;
use hearth_fire::preset::Preset;
use hearth_fire::sound::{Mix, Synthesis};

/// Sample rate [Hz].
const RATE: u32 = 48_000;

/// A stereo file of 16 bits.
fn wav(samples: &[i16]) -> Vec<u8> {
    let bytes = 2 * samples.len() as u32;
    let mut file = Vec::new();
    file.extend(b"RIFF");
    file.extend((36 + bytes).to_le_bytes());
    file.extend(b"WAVEfmt ");
    file.extend(16_u32.to_le_bytes());
    file.extend([1_u16, 2].map(u16::to_le_bytes).concat());
    file.extend([RATE, 4 * RATE].map(u32::to_le_bytes).concat());
    file.extend([4_u16, 16].map(u16::to_le_bytes).concat());
    file.extend(b"data");
    file.extend(bytes.to_le_bytes());
    file.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
    file
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().unwrap_or_else(|| "fire.wav".into());
    let name = arguments.next().unwrap_or_else(|| "campfire".into());
    let seconds: f64 = arguments.next().map_or(Ok(10.0), |text| text.parse())?;

    let scene = Preset::find(&name)?.scene();
    let speed = f64::from(scene.world().time_scale);
    let half_width = 0.5 * scene.world().domain_width;
    let mut fire = Simulation::new(scene);
    fire.record_series(true);
    let mut sound = Synthesis::new(f64::from(RATE), 1, Mix::default());
    let count = (seconds * f64::from(RATE)) as usize;
    let (mut left, mut right) = (Vec::new(), Vec::new());
    let mut samples = Vec::new();
    while samples.len() < 2 * count {
        for _ in 0..10 {
            fire.step();
        }
        sound.push(&fire.read_series(), speed, half_width);
        let frames = (sound.ahead() * f64::from(RATE)) as usize;
        left.resize(frames, 0.0);
        right.resize(frames, 0.0);
        sound.render(&mut left, &mut right);
        let both = left
            .iter()
            .zip(&right)
            .flat_map(|(&left, &right)| [left, right]);
        samples.extend(both.map(|sample| (f32::from(i16::MAX) * sample).round() as i16));
    }
    samples.truncate(2 * count);
    fs::write(file, wav(&samples))?;
    Ok(())
}

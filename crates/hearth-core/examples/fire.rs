//! Draws a fire from the readers of the library alone, as a PPM picture:
//!
//! ```sh
//! cargo run -p hearth-fire-core --release --example fire > fire.ppm
//! ```

use std::io::{self, Write};

use hearth_core::{Parameters, Simulation, Vec2};

/// Pixels per metre.
const SCALE: f32 = 200.0;

fn main() -> io::Result<()> {
    let mut fire = Simulation::new(Parameters::default());
    while fire.time() < 2.0 {
        fire.step();
    }
    let parameters = fire.parameters();
    let size = SCALE * Vec2::new(parameters.domain_width, parameters.domain_height);
    let (width, height) = (size.x as usize, size.y as usize);
    // A particle covers the pixels within its smoothing length, the hottest above the others.
    let reach = SCALE * parameters.smoothing_length();
    let mut hottest = vec![0.0_f32; width * height];
    for (position, kelvin) in fire.positions().into_iter().zip(fire.temperatures()) {
        let x = 0.5 * size.x + SCALE * position.x;
        let y = size.y - SCALE * position.y;
        let inside = |at: f32, end: usize| (at.max(0.0) as usize).min(end);
        let pixels = |at: f32, end| inside(at - reach, end)..inside(at + reach, end);
        for row in pixels(y, height) {
            for pixel in &mut hottest[row * width..][pixels(x, width)] {
                *pixel = pixel.max(kelvin);
            }
        }
    }
    let mut file = format!("P6 {width} {height} 255\n").into_bytes();
    // From dark red at 600 K over yellow to white at 1800 K.
    let colour =
        |kelvin: f32| [600.0, 1000.0, 1400.0].map(|from| (255.0 * (kelvin - from) / 400.0) as u8);
    file.extend(hottest.into_iter().flat_map(colour));
    io::stdout().write_all(&file)
}

//! A picture of a fire: each particle spreads its light over the pixels within its kernel, as
//! in the simulation.
//!
//! Soot glows at the temperature of the gas, in proportion to its amount, in the colours of
//! Planck's law for red, green and blue. Burning fuel adds a little blue.

use hearth_core::kernel::Kernel;
use hearth_core::params::Model;
use hearth_core::{Simulation, Vec2};

/// Red, green and blue light \[m\].
const WAVELENGTHS: [f32; 3] = [610e-9, 550e-9, 465e-9];
/// Second radiation constant [m K].
const RADIATION: f32 = 0.014_388;
/// Black bodies of this temperature \[K\] look white.
const WHITE: f32 = 6500.0;
/// The red light of one of this temperature \[K\] counts as 1.
const BRIGHT: f32 = 1500.0;
/// Emissivity of the gas per soot, and of the gas of the classic model, which has no soot.
const SOOT: f32 = 4.0;
const CLASSIC: f32 = 0.3;
/// Light of the combustion, for a full share of fuel burnt in a second.
const FLAME: Light = [0.003, 0.008, 0.025];
/// Weight of the light of embers, which are smaller than a pixel.
const EMBER: f32 = 3.0;

/// Linear red, green and blue light.
type Light = [f32; 3];

/// Pixels, row by row from the top.
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Three bytes a pixel, sRGB.
    pub rgb: Vec<u8>,
}

impl Picture {
    /// Draws `fire` so that the height of its domain is that of the picture.
    pub fn of(fire: &Simulation, height: u32) -> Picture {
        let parameters = fire.parameters();
        let scale = height as f32 / parameters.domain_height;
        let width = ((parameters.domain_width * scale).round() as u32).clamp(1, 16 * height);
        let canvas = Canvas {
            width: width as usize,
            height: height as usize,
            scale,
        };
        let mut light: Vec<Light> = canvas.gas(fire).iter().map(Gas::light).collect();
        for ember in fire.embers() {
            let radius = ember.size.max(1.5 / scale);
            let colour = black_body(ember.temperature);
            canvas.reach(ember.position, radius, |pixel, distance| {
                let share = EMBER * (1.0 - distance / radius);
                for (light, colour) in light[pixel].iter_mut().zip(colour) {
                    *light += share * colour;
                }
            });
        }
        let rgb = light.into_iter().flat_map(|light| light.map(tone_map));
        Picture {
            width,
            height,
            rgb: rgb.collect(),
        }
    }
}

/// The gas in a pixel: sums over particles, each by its weight.
#[derive(Clone, Copy, Default)]
struct Gas {
    weight: f32,
    temperature: f32,
    soot: f32,
    burning: f32,
}

impl Gas {
    fn light(&self) -> Light {
        if self.weight <= 0.0 {
            return Light::default();
        }
        let opacity = 1.0 - (-SOOT * self.soot / self.weight).exp();
        let glow = black_body(self.temperature / self.weight).map(|light| opacity * light);
        let burning = self.burning / self.weight;
        [0, 1, 2].map(|channel| glow[channel] + burning * FLAME[channel])
    }
}

/// Planck's law at three wavelengths.
fn black_body(temperature: f32) -> Light {
    let radiance = |wavelength: f32, kelvin: f32| {
        let quanta = RADIATION / (wavelength * kelvin);
        1.0 / (quanta.exp() - 1.0)
    };
    let of_white = |wavelength, kelvin| radiance(wavelength, kelvin) / radiance(wavelength, WHITE);
    let bright = of_white(WAVELENGTHS[0], BRIGHT);
    WAVELENGTHS.map(|wavelength| of_white(wavelength, temperature.max(1.0)) / bright)
}

/// A tone curve that maps bright light to white, in sRGB.
fn tone_map(light: f32) -> u8 {
    let exposed = 1.0 - (-light).exp();
    let encoded = if exposed < 0.003_130_8 {
        12.92 * exposed
    } else {
        1.055 * exposed.powf(1.0 / 2.4) - 0.055
    };
    (255.0 * encoded).round() as u8
}

/// The viewport of the domain.
struct Canvas {
    width: usize,
    height: usize,
    /// Pixels per metre.
    scale: f32,
}

impl Canvas {
    /// The gas at every pixel, interpolated as the simulation does.
    fn gas(&self, fire: &Simulation) -> Vec<Gas> {
        let parameters = fire.parameters();
        // A particle is at least a pixel, however small the picture.
        let kernel = Kernel::new(parameters.smoothing_length().max(1.0 / self.scale));
        let classic = parameters.model() == Model::Classic;
        // Beyond the particles there is air, which counts as one more particle.
        let air = if classic {
            kernel.value(0.0) / parameters.rest_density
        } else {
            0.0
        };
        let empty = Gas {
            weight: air,
            temperature: air * parameters.ambient_temperature,
            ..Gas::default()
        };
        let mut pixels = vec![empty; self.width * self.height];
        let (temperatures, densities) = (fire.temperatures(), fire.densities());
        let (soots, burning) = (
            fire.soots().unwrap_or_default(),
            fire.burn_rates().unwrap_or_default(),
        );
        for (i, position) in fire.positions().into_iter().enumerate() {
            // All have the same mass, so the volume is the inverse of the density, which is 0 at
            // birth.
            let volume = match densities[i] {
                density if density > 0.0 => 1.0 / density,
                _ => continue,
            };
            let soot = if classic { CLASSIC } else { soots[i] };
            self.reach(position, kernel.support(), |pixel, distance| {
                let gas = &mut pixels[pixel];
                let weight = kernel.value(distance) * volume;
                gas.weight += weight;
                gas.temperature += weight * temperatures[i];
                gas.soot += weight * soot;
                gas.burning += weight * burning[i];
            });
        }
        pixels
    }

    /// Calls `add` with each pixel that is nearer to `centre` than `radius` \[m\], and
    /// with its distance.
    fn reach(&self, centre: Vec2, radius: f32, mut add: impl FnMut(usize, f32)) {
        let (x, y) = (
            0.5 * self.width as f32 + centre.x * self.scale,
            self.height as f32 - centre.y * self.scale,
        );
        let range = |at: f32, end: usize| {
            let reach = radius * self.scale;
            (at - reach).max(0.0) as usize..((at + reach).max(0.0) as usize + 1).min(end)
        };
        for row in range(y, self.height) {
            for column in range(x, self.width) {
                let off = Vec2::new(column as f32 + 0.5 - x, row as f32 + 0.5 - y);
                let distance = off.length() / self.scale;
                if distance < radius {
                    add(row * self.width + column, distance);
                }
            }
        }
    }
}

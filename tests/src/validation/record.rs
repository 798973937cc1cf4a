//! A burning fire watched at 60 Hz: what its fields are on average, and how
//! its luminous part swings.

use hearth_core::{Scene, Simulation};

use super::boxes::{mass, run};
use super::measure::field::{Field, Sampler};
use super::measure::signal;
use crate::fires::source;

/// Frames a second.
const RATE: f64 = 60.0;

/// Gas glows that is hotter than this \[K\] …
const GLOWING: f64 = 900.0;
/// … and has at least this much soot.
const SOOTY: f64 = 0.05;

/// What was seen.
pub(super) struct Record {
    pub sampler: Sampler,
    /// Height of the burner's lower edge \[m\].
    pub base: f64,
    /// Whether the fire came to the end, and finite.
    pub came: bool,
    /// Light in arbitrary units, frame by frame, row by row.
    pub light: Vec<Vec<f64>>,
    /// Height of the highest luminous gas above the burner \[m\], frame by frame.
    pub tips: Vec<f64>,
    /// Speed at which air flows in over the burner's two edges, together, frame
    /// by frame, row by row [m/s].
    pub breath: Vec<Vec<f64>>,
    /// Share of frames in which a row has luminous gas.
    pub intermittency: Vec<f64>,
    /// Mean width of the luminous gas of a row \[m\].
    pub widths: Vec<f64>,
    /// Share of frames in which a cell is luminous.
    pub luminous: Field,
    /// Mean temperature \[K\].
    pub temperature: Field,
    /// Mean upward velocity [m/s].
    pub rise: Field,
    /// Mean velocity to the right [m/s].
    pub drift: Field,
    /// Mean flux of heat upward, fluctuations included [kW/m²].
    pub heat_flux: Field,
    /// Mean power that came out of the burner [kW/m]: what burned, and what
    /// unburned fuel there is more of in the end.
    pub delivered: f64,
    /// The fire as it stands now.
    pub fire: Simulation,
}

/// Heat that the fuel in the domain will set free [kJ/m].
fn stock(fire: &Simulation) -> f64 {
    let p = fire.parameters();
    let heat = f64::from(p.flame_rise) * (1.0 + f64::from(p.air_demand));
    let fuel: f64 = fire
        .fuels()
        .unwrap_or_default()
        .into_iter()
        .map(f64::from)
        .sum();
    mass(fire) * fuel * heat
}

/// Power that comes out of the burner over `seconds` [kW/m]: what burns, and
/// what unburned fuel there is more of in the end.
pub(super) fn delivered(fire: &mut Simulation, seconds: f64) -> f64 {
    let (began, before, mut burned) = (fire.time(), stock(fire), 0.0);
    let came = run(fire, began + seconds, |fire| {
        fire.step();
        burned += f64::from(fire.power().unwrap_or_default()) * fire.step_length();
    });
    if came {
        (burned + stock(fire) - before) / (fire.time() - began)
    } else {
        f64::NAN
    }
}

/// Burns for `settle` seconds, then watches for `seconds`.
pub(super) fn watch(scene: Scene, settle: f64, seconds: f64) -> Record {
    let world = scene.world();
    let (width, height) = (
        f64::from(world.domain_width),
        f64::from(world.domain_height),
    );
    let cell = 0.6 * f64::from(world.spacing());
    let h = f64::from(world.smoothing_length());
    let base = f64::from(source(&scene).y);
    let sampler = Sampler::new(width, height, cell, h);
    let cells = sampler.columns * sampler.rows;
    let mut fire = Simulation::new(scene);
    let mut came = run(&mut fire, settle, Simulation::step);
    let mut record = Record {
        base,
        came,
        light: Vec::new(),
        tips: Vec::new(),
        breath: Vec::new(),
        intermittency: vec![0.0; sampler.rows],
        widths: vec![0.0; sampler.rows],
        luminous: vec![0.0; cells],
        temperature: vec![0.0; cells],
        rise: vec![0.0; cells],
        drift: vec![0.0; cells],
        heat_flux: vec![0.0; cells],
        delivered: 0.0,
        sampler,
        fire,
    };
    let frames = (seconds * RATE) as u32;
    let mut delivered_sum = 0.0;
    for frame in 1..=frames {
        let until = settle + f64::from(frame) / RATE;
        let span = until - record.fire.time();
        let power = delivered(&mut record.fire, span);
        came &= power.is_finite();
        if !came {
            break;
        }
        delivered_sum += power;
        record.look();
    }
    record.came = came;
    record.delivered = delivered_sum / f64::from(frames);
    let n = record.light.len() as f64;
    let means = [
        &mut record.intermittency,
        &mut record.widths,
        &mut record.luminous,
        &mut record.temperature,
        &mut record.rise,
        &mut record.drift,
        &mut record.heat_flux,
    ];
    for value in means.into_iter().flatten() {
        *value /= n;
    }
    record
}

/// Seeds of the records that are taken together where one alone would leave much to
/// chance.
pub(super) const SEEDS: [f64; 3] = [1.0, 2.0, 3.0];

/// The mean of spectra over the same frequencies.
pub(super) fn mean_spectrum(spectra: &[Vec<(f64, f64)>]) -> Vec<(f64, f64)> {
    let Some(first) = spectra.first() else {
        return Vec::new();
    };
    let mean = |k: usize| spectra.iter().map(|spectrum| spectrum[k].1).sum::<f64>();
    let each = first.iter().enumerate();
    each.map(|(k, (frequency, _))| (*frequency, mean(k) / spectra.len() as f64))
        .collect()
}

impl Record {
    /// The mean fields of several records; the rest is the first one's.
    pub fn joined([mut first, others @ ..]: [Record; SEEDS.len()]) -> Record {
        let n = SEEDS.len() as f64;
        for other in &others {
            first.came &= other.came;
            let pairs = [
                (&mut first.intermittency, &other.intermittency),
                (&mut first.widths, &other.widths),
                (&mut first.luminous, &other.luminous),
                (&mut first.temperature, &other.temperature),
                (&mut first.rise, &other.rise),
                (&mut first.drift, &other.drift),
                (&mut first.heat_flux, &other.heat_flux),
            ];
            for (sum, more) in pairs {
                for (sum, more) in sum.iter_mut().zip(more) {
                    *sum += more;
                }
            }
        }
        let sums = [
            &mut first.intermittency,
            &mut first.widths,
            &mut first.luminous,
            &mut first.temperature,
            &mut first.rise,
            &mut first.drift,
            &mut first.heat_flux,
        ];
        for value in sums.into_iter().flatten() {
            *value /= n;
        }
        first
    }

    /// Adds the frame that is there now.
    fn look(&mut self) {
        let fire = &self.fire;
        let p = fire.parameters();
        let mass = mass(fire) as f32;
        // Where there is no gas, there is air at rest.
        let air = p.ambient_temperature;
        let half = 0.5 * p.domain_width;
        let places = fire.positions().into_iter().zip(fire.densities());
        let state = fire
            .temperatures()
            .into_iter()
            .zip(fire.soots().unwrap_or_default());
        let inside = places
            .zip(state)
            .zip(fire.velocities())
            .filter(|(((position, _), _), _)| position.x.abs() <= half);
        let particles = inside.map(|(((position, density), (temperature, soot)), velocity)| {
            let excess = temperature - air;
            let heat_flux = density * velocity.y * excess;
            (
                position,
                mass / density,
                [excess, soot, velocity.y, velocity.x, heat_flux],
            )
        });
        let [excess, soot, rise, along, heat_flux] = self.sampler.sample(particles);
        let temperature: Field = excess
            .iter()
            .map(|excess| excess + f64::from(air))
            .collect();
        let columns = self.sampler.columns;
        let mut light = vec![0.0; self.sampler.rows];
        let mut tip = 0.0;
        let mut breath = Vec::with_capacity(self.sampler.rows);
        let edge = 0.5 * f64::from(source(fire.scene()).width);
        let (left, right) = (self.sampler.column(-edge), self.sampler.column(edge));
        for row in 0..self.sampler.rows {
            let mut lit = 0.0;
            for at in row * columns..(row + 1) * columns {
                if temperature[at] > GLOWING && soot[at] > SOOTY {
                    lit += 1.0;
                    self.luminous[at] += 1.0;
                    light[row] += (temperature[at] / 1500.0).powi(4) * soot[at].min(1.5);
                }
            }
            if lit > 0.0 {
                self.intermittency[row] += 1.0;
                tip = self.sampler.y(row) - self.base;
            }
            self.widths[row] += lit * self.sampler.cell;
            breath.push(along[row * columns + left] - along[row * columns + right]);
        }
        for (sum, now) in [
            (&mut self.temperature, temperature),
            (&mut self.rise, rise),
            (&mut self.drift, along),
            (&mut self.heat_flux, heat_flux),
        ] {
            for (sum, now) in sum.iter_mut().zip(now) {
                *sum += now;
            }
        }
        self.light.push(light);
        self.tips.push(tip);
        self.breath.push(breath);
    }

    /// Height above the burner up to which luminous gas is seen in `share` of
    /// the frames \[m\]: going up from where it is seen most.
    pub fn height(&self, share: f64) -> f64 {
        let most = self.steadiest();
        let above = self.intermittency.iter().enumerate().skip(most);
        let mut below: Option<(f64, f64)> = None;
        for (row, &seen) in above {
            let y = self.sampler.y(row) - self.base;
            if seen < share {
                return match below {
                    Some((y0, seen0)) => y0 + (y - y0) * (seen0 - share) / (seen0 - seen),
                    None => f64::NAN,
                };
            }
            below = Some((y, seen));
        }
        f64::NAN
    }

    /// The row in which luminous gas is seen most; the highest of several.
    pub fn steadiest(&self) -> usize {
        self.intermittency
            .iter()
            .enumerate()
            .max_by(|a, b| a.1.total_cmp(b.1))
            .map_or(0, |(row, _)| row)
    }

    /// Power over frequency of the light of the fire up to so high above the
    /// burner \[m\].
    pub fn light_spectrum(&self, top: f64) -> Vec<(f64, f64)> {
        let row = self.sampler.row(self.base + top);
        let swing: Vec<f64> = self
            .light
            .iter()
            .map(|light| light[..=row].iter().sum())
            .collect();
        signal::spectrum(&swing, RATE, 8.0, 8.0)
    }

    /// Power over frequency of the air that flows in from both sides, so high
    /// above the burner \[m\]: the flame's breath, which is its puffing, without
    /// its swaying, in which one side's gain is the other's loss.
    pub fn breath_spectrum(&self, height: f64) -> Vec<(f64, f64)> {
        let row = self.sampler.row(self.base + height);
        let swing: Vec<f64> = self.breath.iter().map(|breath| breath[row]).collect();
        signal::spectrum(&swing, RATE, 8.0, 8.0)
    }

    /// The integral of a field over a row \[m\].
    pub fn over(&self, field: &Field, row: usize) -> f64 {
        let columns = self.sampler.columns;
        let values = &field[row * columns..(row + 1) * columns];
        values.iter().sum::<f64>() * self.sampler.cell
    }

    /// A row of a field with its places \[m\].
    pub fn across(&self, field: &Field, row: usize) -> Vec<(f64, f64)> {
        let columns = self.sampler.columns;
        (0..columns)
            .map(|column| (self.sampler.x(column), field[row * columns + column]))
            .collect()
    }
}

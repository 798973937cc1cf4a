//! Light of torn flames: what shines apart from the flame that is on its source.

use hearth_core::preset::Preset;
use hearth_core::{Simulation, Vec2};

use super::boxes::{mass, run};
use super::measure::field::{Field, Sampler};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[Case {
    name: "detached-light",
    pace: Pace::Long(150),
    run: || Outcome::rows(SCENES.map(detached_light)),
}];

/// Scenes of large flames, and the height up to which each is watched \[m\].
const SCENES: [(&str, f32); 7] = [
    ("default", 3.0),
    ("campfire", 3.2),
    ("fireside", 3.2),
    ("fireplace", 3.0),
    ("torch", 2.8),
    ("forge", 2.2),
    ("wall-of-fire", 4.0),
];

/// Spacing of the particles at the quality *high*, in spacings of the scene.
const HIGH: f64 = 0.66;
/// Time of lighting, and of looking \[s\]; looks a second.
const SETTLE: f64 = 3.0;
const SECONDS: f64 = 8.0;
const RATE: f64 = 15.0;
/// Light that is seen, as a share of the brightest.
const SEEN: f64 = 0.05;
/// Light is far from its fire above so many L50.
const FAR: f64 = 1.3;

/// The light that was seen, row by row.
struct Light {
    sampler: Sampler,
    /// Height of the lowest source, and of what is on it \[m\].
    base: f64,
    foot: f64,
    looks: f64,
    /// Looks in which a row is lit.
    lit: Vec<f64>,
    all: Vec<f64>,
    /// The part that is not connected with the foot.
    detached: Vec<f64>,
}

fn detached_light((name, top): (&str, f32)) -> Row {
    let mut scene = Preset::find(name).map(Preset::scene).unwrap_or_default();
    let spacing = HIGH * f64::from(scene.world().spacing());
    for (id, value) in [("spacing", spacing), ("max_particles", 30_000.0)] {
        if let Err(refusal) = scene.set(id, value) {
            panic!("{refusal}");
        }
    }
    let world = scene.world();
    let (width, h) = (world.domain_width, world.smoothing_length());
    let sources = || scene.sources();
    let base = f64::from(sources().map(|s| s.y).fold(f32::MAX, f32::min));
    let widest = f64::from(sources().map(|s| s.width).fold(0.0, f32::max));
    let sampler = Sampler::new(width.into(), top.into(), 0.4 * f64::from(h), h.into());
    let rows = sampler.rows;
    let mut light = Light {
        sampler,
        base,
        foot: base + 0.35 * widest.min(0.5) + 0.1,
        looks: 0.0,
        lit: vec![0.0; rows],
        all: vec![0.0; rows],
        detached: vec![0.0; rows],
    };
    let mut fire = Simulation::new(scene);
    let half = 0.5 * width;
    fire.set_visible_area(Some([Vec2::new(-half, 0.0), Vec2::new(half, top)]));
    let mut came = run(&mut fire, SETTLE, Simulation::step);
    for look in 1..=(SECONDS * RATE) as u32 {
        let until = SETTLE + f64::from(look) / RATE;
        came &= run(&mut fire, until, Simulation::step);
        light.look(&fire);
    }
    let half = light.height(0.5);
    let above = |from: f64| light.share_above(from * half);
    Row::new(
        format!("detached-{name}"),
        format!("{name}: light apart from the flame on its source / all light"),
        Expected::AtMost(0.05),
        if came { above(f64::NEG_INFINITY) } else { f64::NAN },
    )
    .noting(format!(
        "{:.1} % of all light is above {FAR} L50; L50 {half:.2}, L05 {:.2} m above the source; light {:.0} cm²",
        100.0 * above(FAR),
        light.height(0.05),
        1e4 * light.all.iter().sum::<f64>() * light.sampler.cell.powi(2) / light.looks
    ))
}

impl Light {
    fn look(&mut self, fire: &Simulation) {
        let field = self.field(fire);
        let columns = self.sampler.columns;
        let attached = self.attached(&field);
        for row in 0..self.sampler.rows {
            let cells = row * columns..(row + 1) * columns;
            let seen = cells.filter(|&at| field[at] > SEEN);
            let (mut all, mut detached) = (0.0, 0.0);
            for at in seen {
                all += field[at];
                detached += if attached[at] { 0.0 } else { field[at] };
            }
            self.lit[row] += if all > 0.0 { 1.0 } else { 0.0 };
            self.all[row] += all;
            self.detached[row] += detached;
        }
        self.looks += 1.0;
    }

    /// The light of the gas as a picture shows it: soot that glows, in a layer that becomes opaque.
    fn field(&self, fire: &Simulation) -> Field {
        let (half, mass) = (0.5 * fire.parameters().domain_width, mass(fire) as f32);
        let densities = fire.particles().into_iter().zip(fire.densities());
        let inside = densities.filter(|(particle, _)| particle.position.x.abs() <= half);
        let [kelvin, soot] = self.sampler.sample(inside.map(|(particle, density)| {
            let values = [particle.temperature, particle.soot];
            (particle.position, mass / density, values)
        }));
        let glow = |(kelvin, soot): (&f64, &f64)| {
            let covered = 1.0 - (-3.0 * (soot - 0.03).max(0.0)).exp();
            let glowing = ((kelvin - 800.0) / 250.0).clamp(0.0, 1.0);
            let radiance = (12_400.0 * (1.0 / 1500.0 - 1.0 / kelvin.max(500.0))).exp();
            let smooth = glowing * glowing * (3.0 - 2.0 * glowing);
            1.0 - (-4.0 * covered * smooth * radiance).exp()
        };
        kelvin.iter().zip(&soot).map(glow).collect()
    }

    /// Whether each cell is connected with the foot of the flame by cells that are seen.
    fn attached(&self, field: &Field) -> Vec<bool> {
        let (columns, rows) = (self.sampler.columns, self.sampler.rows);
        let mut attached = vec![false; field.len()];
        let foot = (self.sampler.row(self.foot) + 1) * columns;
        let mut waiting: Vec<usize> = (0..foot).filter(|&at| field[at] > SEEN).collect();
        while let Some(at) = waiting.pop() {
            if attached[at] || field[at] <= SEEN {
                continue;
            }
            attached[at] = true;
            let (column, row) = (at % columns, at / columns);
            let beside = [
                (column > 0).then(|| at - 1),
                (column + 1 < columns).then(|| at + 1),
                (row > 0).then(|| at - columns),
                (row + 1 < rows).then(|| at + columns),
            ];
            waiting.extend(beside.into_iter().flatten());
        }
        attached
    }

    /// Height above the source up to which light is seen in `share` of the looks \[m\].
    fn height(&self, share: f64) -> f64 {
        let row = self.lit.iter().rposition(|lit| *lit >= share * self.looks);
        self.sampler.y(row.unwrap_or(0)) - self.base
    }

    /// Detached light higher above the source than `from` \[m\], as a share of all light.
    fn share_above(&self, from: f64) -> f64 {
        let rows = self.detached.iter().enumerate();
        let above = rows.filter(|(row, _)| self.sampler.y(*row) - self.base > from);
        above.map(|(_, light)| light).sum::<f64>() / self.all.iter().sum::<f64>()
    }
}

//! Soot at the edges of what is seen: it leaves, and does not come back.
//!
//! A particle is as wide as its kernel, so it has left once its whole kernel is outside, and is back
//! once its middle is inside. What shifts to and fro over the edge by less is still seen.

use hearth_core::{Simulation, Vec2};

use super::boxes::{mass, open, run};
use super::measure::fit;
use super::record::SEEDS;
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "soot-frame",
        pace: Pace::Long(200),
        run: || soot("the default frame", "frame", (1.2, 1.8)),
    },
    Case {
        name: "soot-wide",
        pace: Pace::Long(200),
        run: || soot("a wide view", "wide", (4.3, 1.8)),
    },
    Case {
        name: "soot-tall",
        pace: Pace::Long(200),
        run: || soot("a tall view", "tall", (1.2, 2.6)),
    },
];

/// Looks a second.
const RATE: f64 = 60.0;
/// Time of lighting, and of looking \[s\].
const SETTLE: f64 = 3.0;
const SECONDS: f64 = 60.0;
/// Rows of the upper half of the view.
const ROWS: usize = 10;
/// Share of the soot that leaves, below which a row's flux counts as none.
const NOTHING: f64 = 1e-3;

/// The soot inside of a rectangle that is seen.
struct Edges {
    /// How far outside a particle has left \[m\].
    reach: f32,
    /// The particles of the last look: id, whether each was inside, and whether it was above.
    last: Vec<(u64, bool, bool)>,
    /// Soot that came in, the part of it from above, and soot that went out, in particles of pure
    /// soot.
    entered: f64,
    from_above: f64,
    left: f64,
    /// Soot times rise in the outer tenths of each row, summed over the looks [m/s].
    rise: [f64; ROWS],
}

impl Edges {
    fn new(reach: f32) -> Edges {
        Edges {
            reach,
            last: Vec::new(),
            entered: 0.0,
            from_above: 0.0,
            left: 0.0,
            rise: [0.0; ROWS],
        }
    }

    fn look(&mut self, fire: &Simulation, (width, height): (f32, f32)) {
        let mut now = Vec::with_capacity(fire.count());
        let mut soots = Vec::with_capacity(fire.count());
        let each = fire.ids().into_iter().zip(fire.particles());
        for (id, particle) in each {
            let Vec2 { x, y } = particle.position;
            let outside = (x.abs() - 0.5 * width).max(y - height).max(-y);
            let known = self.last.binary_search_by_key(&id, |known| known.0);
            let was_inside = known.is_ok_and(|at| self.last[at].1);
            let inside = outside < if was_inside { self.reach } else { 0.0 };
            now.push((id, inside, y >= height));
            soots.push(f64::from(particle.soot));
            let up = (y / height - 0.5) * 2.0 * ROWS as f32;
            if outside < 0.0 && up >= 0.0 && x.abs() > 0.4 * width {
                let row = (up as usize).min(ROWS - 1);
                self.rise[row] += f64::from(particle.soot * particle.velocity.y);
            }
        }
        for (&(id, inside, _), soot) in now.iter().zip(soots) {
            let Ok(at) = self.last.binary_search_by_key(&id, |known| known.0) else {
                continue;
            };
            match (self.last[at], inside) {
                ((_, false, above), true) => {
                    self.entered += soot;
                    self.from_above += if above { soot } else { 0.0 };
                }
                ((_, true, _), false) => self.left += soot,
                _ => {}
            }
        }
        self.last = now;
    }
}

/// Watches the soot of the default fire in a frame as high as the default's, in a view of this
/// size \[m\].
fn soot(view: &str, id: &str, size: (f32, f32)) -> Outcome {
    let (mut came, mut kilograms, mut crossing) = (true, 0.0, 0.0);
    let records = SEEDS.map(|seed| {
        let mut fire = Simulation::new(open((1.2, 1.8), 0.0268, [("seed", seed)]));
        let (width, height) = size;
        fire.set_visible_area(Some([
            Vec2::new(-0.5 * width, 0.0),
            Vec2::new(0.5 * width, height),
        ]));
        came &= run(&mut fire, SETTLE, Simulation::step);
        let support = 2.0 * fire.parameters().smoothing_length();
        let (mut edges, mut of_middles) = (Edges::new(support), Edges::new(0.0));
        for look in 1..=(SECONDS * RATE) as u32 {
            let until = SETTLE + f64::from(look) / RATE;
            came &= run(&mut fire, until, Simulation::step);
            edges.look(&fire, size);
            of_middles.look(&fire, size);
        }
        kilograms += edges.left * mass(&fire) / SEEDS.len() as f64;
        crossing += of_middles.entered / of_middles.left / SEEDS.len() as f64;
        edges
    });
    let unless_ended = |measured: f64| if came { measured } else { f64::NAN };
    let share = |part: fn(&Edges) -> f64| records.each_ref().map(|edges| part(edges) / edges.left);
    let entered = share(|edges| edges.entered);
    let [from, to] = [f64::min, f64::max].map(|of| entered.into_iter().reduce(of).unwrap_or(0.0));
    // What rises at v crosses a row, which is this high, in so many looks.
    let row = f64::from(size.1) / (2.0 * ROWS as f64);
    let falls = |at: usize| {
        fit::mean(
            records
                .iter()
                .map(|edges| -edges.rise[at] / RATE / row / edges.left),
        )
    };
    let falls: Vec<_> = (0..ROWS).map(falls).collect();
    let falling = falls.iter().filter(|&&share| share > NOTHING).count();
    let most = falls.into_iter().fold(0.0, f64::max);
    Outcome::rows([
        Row::new(
            format!("soot-enters-{id}"),
            format!("soot that enters {view} over its edges / soot that leaves, 60 s"),
            Expected::AtMost(0.02),
            unless_ended(fit::mean(entered)),
        )
        .noting(format!(
            "{:.2} to {:.2} % of three seeds; {:.2} % come back from above, the rest from the \
             sides; the middles of {:.2} % cross an edge inwards; {kilograms:.2} kg/m in units of \
             `soot` leave",
            100.0 * from,
            100.0 * to,
            100.0 * fit::mean(share(|edges| edges.from_above)),
            100.0 * crossing
        )),
        Row::new(
            format!("soot-falls-{id}"),
            format!("rows of the upper half of {view} whose outer tenths carry soot down"),
            Expected::AtMost(0.0),
            unless_ended(falling as f64),
        )
        .noting(format!(
            "at most {:.2} % of the soot that leaves",
            100.0 * most
        )),
    ])
}

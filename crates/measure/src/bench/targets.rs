//! The targets of speed, and what was measured of them.

use Unit::{Bytes, Milliseconds, StepsASecond, Times};

use super::figures::{BROWSER, Figures, Row, Time};

/// A target, with what was measured of it.
#[derive(Debug)]
pub(super) struct Target {
    /// Its subject, with the number of particles where that matters.
    pub what: String,
    pub bound: Bound,
    /// By medians and by best rounds; `None` where it could not be measured.
    pub measured: Option<Time>,
}

/// A limit with its unit.
#[derive(Clone, Copy, Debug)]
pub(super) enum Bound {
    AtLeast(f64, Unit),
    AtMost(f64, Unit),
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Unit {
    Times,
    Milliseconds,
    StepsASecond,
    Bytes,
}

impl Bound {
    /// The limit with its sign and unit.
    pub fn limit(self) -> String {
        let (sign, Bound::AtLeast(limit, unit) | Bound::AtMost(limit, unit)) = (self.sign(), self);
        match unit {
            Times => format!("{sign} {limit} ×"),
            Milliseconds => format!("{sign} {limit} ms"),
            StepsASecond => format!("{sign} {limit} steps a second"),
            Bytes => format!("{sign} {limit} B a particle"),
        }
    }

    /// A figure in its unit.
    pub fn show(self, figure: f64) -> String {
        let (Bound::AtLeast(_, unit) | Bound::AtMost(_, unit)) = self;
        match unit {
            Times if figure >= 100.0 => format!("{figure:.0} ×"),
            Times if figure >= 10.0 => format!("{figure:.1} ×"),
            Times => format!("{figure:.2} ×"),
            Milliseconds => format!("{figure:.1} ms"),
            StepsASecond => format!("{figure:.0}"),
            Bytes => format!("{figure:.0} B"),
        }
    }

    /// Whether a figure is within it.
    pub fn holds(self, figure: f64) -> bool {
        match self {
            Bound::AtLeast(limit, _) => figure >= limit,
            Bound::AtMost(limit, _) => figure <= limit,
        }
    }

    fn sign(self) -> char {
        match self {
            Bound::AtLeast(..) => '≥',
            Bound::AtMost(..) => '≤',
        }
    }
}

/// The numbers of particles at which programs are compared.
const SIZES: [u64; 2] = [20_000, 100_000];

/// What is compared of a row.
type Cost = fn(&Row) -> Time;

/// Other programs: the label, how many times as fast Hearth is to be, place, program, scene and
/// what is compared. SPlisHSPlasH is made for fewer neighbours.
const RIVALS: [(&str, f64, &str, &str, &str, Cost); 4] = [
    (
        "SPlisHSPlasH WCSPH, native, a neighbour of a particle",
        10.0,
        "native",
        "SPlisHSPlasH",
        "block",
        a_neighbour,
    ),
    (
        "JavaScript, typed arrays, 3 × 3 cells",
        7.0,
        BROWSER,
        "Hearth",
        "scan",
        Row::nanoseconds,
    ),
    (
        "JavaScript, typed arrays, list of pairs",
        3.0,
        BROWSER,
        "Hearth",
        "typed",
        Row::nanoseconds,
    ),
    (
        "salva2d DFSPH, native, 1 + 1 iterations",
        30.0,
        "native",
        "salva2d",
        "block",
        Row::nanoseconds,
    ),
];

/// Nanoseconds a neighbour of a particle and substep.
fn a_neighbour(row: &Row) -> Time {
    let pairs = row.neighbours * row.substeps as f64;
    row.nanoseconds().map(|ns| ns / pairs)
}

/// The targets beside other programs.
pub(super) fn compared(figures: &Figures) -> Vec<Target> {
    let own = |scene: &str, count| figures.own(scene, BROWSER, count);
    let faster = |what: &str, limit, measured| target(what, Bound::AtLeast(limit, Times), measured);
    let mut targets = Vec::new();
    for (what, limit, place, name, scene, cost) in RIVALS {
        for count in SIZES {
            let other = figures.row(name, scene, place, count);
            let what = format!("faster than {what}, N = {count}");
            let times = ratio(other, own("block", count), cost);
            targets.push(faster(&what, limit, times));
        }
    }
    let paper = ratio(own("paper", 5000), own("block", 5000), Row::nanoseconds);
    let what = "faster than JavaScript, the paper's loop, N = 5000";
    targets.push(faster(what, 500.0, paper));
    // A named program is compared in the place where it ran.
    let rows = figures.rows.iter();
    let yardsticks = rows.filter(|row| row.yardstick && SIZES.contains(&row.count));
    let before = targets.len();
    let most = Bound::AtMost(1.2, Times);
    targets.extend(yardsticks.map(|row| {
        let own = figures.own("block", &row.place, row.count);
        let what = format!("time of {}, {}, N = {}", row.name, row.place, row.count);
        target(&what, most, ratio(own, Some(row), Row::nanoseconds))
    }));
    if targets.len() == before {
        let what = "time of a program that `--yardstick` names";
        targets.push(target(what, most, None));
    }
    targets
}

/// The targets without another program.
pub(super) fn absolute(figures: &Figures) -> [Target; 9] {
    let own = |scene: &str, count| figures.own(scene, BROWSER, count);
    let frame = |name: &str, count, limit| {
        let row = own("combustion", count);
        // Fewer burn than the case allows.
        let burning = row.map_or(String::new(), |row| {
            format!(", {} particles", row.particles)
        });
        let what = format!("{name}{burning}, steps of a 60 Hz frame");
        target(
            &what,
            Bound::AtMost(limit, Milliseconds),
            row.and_then(Row::frame),
        )
    };
    let throttled = figures.throttled();
    [
        target(
            "100,000 particles in the browser",
            Bound::AtLeast(60.0, StepsASecond),
            own("block", 100_000).map(|row| row.step.map(|ms| 1e3 / ms)),
        ),
        target(
            "a pair of the combustion model / one of the classic model, at 28 neighbours",
            Bound::AtMost(2.2, Times),
            ratio(own("combustion", 3000), own("block", 3000), a_neighbour),
        ),
        frame("default", 3000, 10.0),
        frame("high", 6700, 45.0),
        target(
            "the lowest level on a processor slowed down 4 ×, steps of a 60 Hz frame",
            Bound::AtMost(14.0, Milliseconds),
            throttled.map(|(step, steps)| step.map(|ms| ms * steps)),
        ),
        target(
            "a particle among 400,000 / one among 5000, which the processor’s cache decides",
            Bound::AtMost(1.3, Times),
            ratio(own("block", 400_000), own("block", 5000), Row::nanoseconds),
        ),
        target(
            "the first picture of a fire after its page was opened",
            Bound::AtMost(1000.0, Milliseconds),
            figures.first_picture(),
        ),
        target(
            "longest task of the page’s thread beside 10,000 burning particles",
            Bound::AtMost(50.0, Milliseconds),
            figures.longest_task(),
        ),
        target(
            "memory, the worst of all sizes, natively",
            Bound::AtMost(400.0, Bytes),
            figures.memory(),
        ),
    ]
}

fn target(what: &str, bound: Bound, measured: Option<Time>) -> Target {
    Target {
        what: what.to_owned(),
        bound,
        measured,
    }
}

fn ratio(upper: Option<&Row>, lower: Option<&Row>, of: impl Fn(&Row) -> Time) -> Option<Time> {
    Some(of(upper?).over(of(lower?)))
}

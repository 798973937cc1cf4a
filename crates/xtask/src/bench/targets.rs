//! What is to be reached, and whether it is.

use super::figures::{BROWSER, Figures, Row, Time};

/// A target, with what was measured of it.
#[derive(Debug)]
pub(super) struct Target {
    /// What it is about, with the number of particles where that matters.
    pub what: String,
    pub wanted: Bound,
    /// By medians and by best rounds; none where it could not be measured.
    pub found: Option<Time>,
}

/// What a figure is to be, with its unit and the digits it is shown with.
#[derive(Clone, Copy, Debug)]
pub(super) enum Bound {
    AtLeast(f64, Unit),
    AtMost(f64, Unit),
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Unit {
    Times,
    Share,
    Milliseconds,
    StepsASecond,
    Bytes,
}

impl Bound {
    fn unit(self) -> Unit {
        let (Bound::AtLeast(_, unit) | Bound::AtMost(_, unit)) = self;
        unit
    }

    /// Itself in words.
    pub fn words(self) -> String {
        match self {
            Bound::AtLeast(limit, unit) => format!("≥ {}", unit.limit(limit)),
            Bound::AtMost(limit, unit) => format!("≤ {}", unit.limit(limit)),
        }
    }

    /// A figure in its unit.
    pub fn show(self, figure: f64) -> String {
        self.unit().figure(figure)
    }

    /// Whether a figure is within it.
    pub fn holds(self, figure: f64) -> bool {
        match self {
            Bound::AtLeast(limit, _) => figure >= limit,
            Bound::AtMost(limit, _) => figure <= limit,
        }
    }
}

impl Unit {
    fn limit(self, limit: f64) -> String {
        match self {
            Unit::Times => format!("{limit} ×"),
            Unit::Share => format!("{:.0} %", 100.0 * limit),
            Unit::Milliseconds => format!("{limit} ms"),
            Unit::StepsASecond => format!("{limit} steps a second"),
            Unit::Bytes => format!("{limit} B a particle"),
        }
    }

    fn figure(self, figure: f64) -> String {
        match self {
            Unit::Times if figure >= 100.0 => format!("{figure:.0} ×"),
            Unit::Times if figure >= 10.0 => format!("{figure:.1} ×"),
            Unit::Times => format!("{figure:.2} ×"),
            Unit::Share => format!("{:.1} %", 100.0 * figure),
            Unit::Milliseconds => format!("{figure:.1} ms"),
            Unit::StepsASecond => format!("{figure:.0}"),
            Unit::Bytes => format!("{figure:.0} B"),
        }
    }
}

/// Numbers of particles at which speed is held against others.
const SIZES: [u64; 2] = [20_000, 100_000];

/// Every target.
pub(super) fn all(figures: &Figures) -> Vec<Target> {
    let mut targets = Vec::new();
    for (what, limit, place, name, scene) in [
        (
            "SPlisHSPlasH WCSPH, native, at its 12 neighbours",
            12.0,
            "native",
            "SPlisHSPlasH",
            "block",
        ),
        (
            "JavaScript, typed arrays, 3 × 3 cells",
            15.0,
            BROWSER,
            "Hearth",
            "scan",
        ),
        (
            "JavaScript, typed arrays, list of pairs",
            15.0,
            BROWSER,
            "Hearth",
            "typed",
        ),
        (
            "salva2d DFSPH, native, 1 + 1 iterations",
            30.0,
            "native",
            "salva2d",
            "block",
        ),
    ] {
        for count in SIZES {
            targets.push(faster_than(
                figures,
                what,
                limit,
                figures.row(name, scene, place, count),
                count,
            ));
        }
    }
    let paper = figures.own("paper", BROWSER, 5000);
    let what = "JavaScript, the paper's loop";
    targets.push(faster_than(figures, what, 600.0, paper, 5000));
    targets.extend(SIZES.map(|count| {
        let own = figures.own("block", BROWSER, count);
        Target {
            what: at("share of the measured peak of 128-bit SIMD", count),
            wanted: Bound::AtLeast(0.30, Unit::Share),
            found: own.and_then(|row| figures.share_of_peak(row)),
        }
    }));
    targets.extend(yardsticks(figures));
    targets.extend(absolute(figures));
    targets
}

/// Hearth in the browser against `other`, a particle against a particle.
fn faster_than(
    figures: &Figures,
    what: &str,
    limit: f64,
    other: Option<&Row>,
    count: u64,
) -> Target {
    let own = figures.own("block", BROWSER, count);
    Target {
        what: at(&format!("faster than {what}"), count),
        wanted: Bound::AtLeast(limit, Unit::Times),
        found: both(other, own).map(|(other, own)| other.nanoseconds().over(own.nanoseconds())),
    }
}

/// Against a program that a person named: in the place where that ran.
fn yardsticks(figures: &Figures) -> Vec<Target> {
    let mut targets: Vec<Target> = figures
        .rows
        .iter()
        .filter(|row| row.is_yardstick && SIZES.contains(&row.count))
        .map(|row| {
            let own = figures.own("block", &row.place, row.count);
            Target {
                what: at(
                    &format!("faster than {}, {}", row.name, row.place),
                    row.count,
                ),
                wanted: Bound::AtLeast(1.0, Unit::Times),
                found: own.map(|own| row.nanoseconds().over(own.nanoseconds())),
            }
        })
        .collect();
    if targets.is_empty() {
        targets.push(Target {
            what: "faster than a program that `--yardstick` names".to_owned(),
            wanted: Bound::AtLeast(1.0, Unit::Times),
            found: None,
        });
    }
    targets
}

/// Those that compare Hearth with nobody else.
fn absolute(figures: &Figures) -> Vec<Target> {
    let own = |scene: &str, count| figures.own(scene, BROWSER, count);
    let a_pair = |row: &Row| row.nanoseconds().map(|ns| ns / row.neighbours);
    let frame = |count| own("combustion", count).and_then(Row::frame);
    let ratio = |upper: Option<&Row>, lower: Option<&Row>, of: &dyn Fn(&Row) -> Time| {
        both(upper, lower).map(|(upper, lower)| of(upper).over(of(lower)))
    };
    let target = |what: &str, wanted, found| Target {
        what: what.to_owned(),
        wanted,
        found,
    };
    vec![
        target(
            "100,000 particles in the browser",
            Bound::AtLeast(60.0, Unit::StepsASecond),
            own("block", 100_000).map(|row| row.step.map(|ms| 1e3 / ms)),
        ),
        target(
            "a pair of the combustion model / one of the classic model, at 28 neighbours",
            Bound::AtMost(2.2, Unit::Times),
            ratio(own("combustion", 3000), own("block", 3000), &a_pair),
        ),
        target(
            "default, steps of a 60 Hz frame",
            Bound::AtMost(10.0, Unit::Milliseconds),
            frame(3000),
        ),
        target(
            "high, steps of a 60 Hz frame",
            Bound::AtMost(45.0, Unit::Milliseconds),
            frame(6700),
        ),
        target(
            "the automatic 1200 on a processor slowed down 4 ×, steps of a 60 Hz frame",
            Bound::AtMost(14.0, Unit::Milliseconds),
            figures
                .throttled()
                .map(|(step, steps)| step.map(|ms| ms * steps)),
        ),
        target(
            "a particle among 400,000 / one among 5000",
            Bound::AtMost(1.3, Unit::Times),
            ratio(own("block", 400_000), own("block", 5000), &Row::nanoseconds),
        ),
        target(
            "the first picture of a fire after its page was opened",
            Bound::AtMost(1000.0, Unit::Milliseconds),
            figures.first_picture(),
        ),
        target(
            "longest task of the page’s thread beside 10,000 burning particles",
            Bound::AtMost(50.0, Unit::Milliseconds),
            figures.longest_task(),
        ),
        target(
            "memory, the worst of all sizes, natively",
            Bound::AtMost(400.0, Unit::Bytes),
            figures.memory().map(|bytes| Time {
                median: bytes,
                best: bytes,
            }),
        ),
    ]
}

fn both<'a>(a: Option<&'a Row>, b: Option<&'a Row>) -> Option<(&'a Row, &'a Row)> {
    Some((a?, b?))
}

fn at(what: &str, count: u64) -> String {
    format!("{what}, N = {count}")
}

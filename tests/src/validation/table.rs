//! The table as people read it.

use std::fmt::Write as _;
use std::time::Duration;

use super::{Case, Expected, Outcome, Row, Verdict};

/// A case that has run.
#[derive(Clone, Debug)]
pub struct Finished {
    /// Which.
    pub case: &'static Case,
    /// What it measured.
    pub outcome: Outcome,
    /// How long it took.
    pub took: Duration,
}

/// `value` with three digits that count.
pub fn figure(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let magnitude = value.abs().log10().floor();
    if (-3.0..4.0).contains(&magnitude) {
        format!("{value:.*}", (2.0 - magnitude).max(0.0) as usize)
    } else {
        format!("{value:.1e}")
    }
}

/// The expected value and the tolerance of a row, as texts.
fn expected(row: &Row) -> [String; 2] {
    let unit = |text: String| match row.unit {
        "" => text,
        unit => format!("{text} {unit}"),
    };
    match row.expected {
        Expected::Share { value, tolerance } => [
            unit(figure(value)),
            format!("{} %", figure(100.0 * tolerance)),
        ],
        Expected::Value { value, tolerance } => [unit(figure(value)), unit(figure(tolerance))],
        Expected::AtMost(limit) => [unit(format!("≤ {}", figure(limit))), String::new()],
        Expected::AtLeast(limit) => [unit(format!("≥ {}", figure(limit))), String::new()],
        Expected::Between(low, high) => [
            unit(format!("{} to {}", figure(low), figure(high))),
            String::new(),
        ],
    }
}

/// A row's line on the console.
pub fn line(row: &Row) -> String {
    let [value, tolerance] = expected(row);
    let allowed = match tolerance.as_str() {
        "" => value,
        tolerance => format!("{value} ± {tolerance}"),
    };
    let verdict = match row.verdict() {
        Verdict::Holds => "holds",
        Verdict::NotReached(_) => "not reached",
        Verdict::Fails => "FAILS",
    };
    let mut line = format!(
        "  {verdict:<11} {:<10} expected {allowed}: {}",
        figure(row.measured),
        row.what
    );
    if !row.note.is_empty() {
        let _ = write!(line, " ({})", row.note);
    }
    line
}

/// The listed rows, and all rows that do not hold, as a table in Markdown, and below it why rows are
/// not reached.
pub fn markdown(cases: &[Finished]) -> String {
    let mut text = String::from(
        "| case | expected | tolerance | measured | verdict | time |\n|---|--:|--:|--:|---|--:|\n",
    );
    let mut reasons = String::new();
    for finished in cases {
        let shown = |row: &&Row| row.is_listed || row.verdict() != Verdict::Holds;
        for (i, row) in finished.outcome.rows.iter().filter(shown).enumerate() {
            let [value, tolerance] = expected(row);
            let verdict = match row.verdict() {
                Verdict::Holds => "holds",
                Verdict::NotReached(known) => {
                    let _ = writeln!(
                        reasons,
                        "- *{}*: measured {}. {}",
                        cell(&row.what),
                        figure(row.measured),
                        known.reason
                    );
                    "not reached"
                }
                Verdict::Fails => "**fails**",
            };
            let time = match i {
                0 => format!("{:.1} s", finished.took.as_secs_f64()),
                _ => String::new(),
            };
            let note = match row.note.as_str() {
                "" => String::new(),
                note => format!(" ({})", cell(note)),
            };
            let _ = writeln!(
                text,
                "| {}{note} | {value} | {tolerance} | {} | {verdict} | {time} |",
                cell(&row.what),
                figure(row.measured),
            );
        }
    }
    if !reasons.is_empty() {
        let _ = write!(text, "\nNot reached:\n\n{reasons}");
    }
    text
}

fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

/// Whether every row holds or is known not to.
pub fn passed(cases: &[Finished]) -> bool {
    cases
        .iter()
        .flat_map(|finished| &finished.outcome.rows)
        .all(|row| row.verdict() != Verdict::Fails)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_three_digits() {
        for (value, text) in [
            (0.035, "0.0350"),
            (1.0, "1.00"),
            (220.0, "220"),
            (1e-6, "1.0e-6"),
            (0.0, "0"),
            (-0.667, "-0.667"),
        ] {
            assert_eq!(figure(value), text);
        }
    }

    const CASE: Case = Case {
        name: "case",
        pace: super::super::Pace::Quick,
        run: Outcome::default,
    };

    #[test]
    fn a_row_that_fails_fails_the_table() {
        let row = |measured| Row::new("row", "m|v|", Expected::AtMost(1.0), measured);
        let finished = |measured| {
            [Finished {
                case: &CASE,
                outcome: Outcome::rows([row(measured)]),
                took: Duration::from_millis(1500),
            }]
        };
        assert!(passed(&finished(0.5)) && !passed(&finished(1.5)));
        let text = markdown(&finished(1.5));
        assert!(text.contains("| m\\|v\\| | ≤ 1.00 |  | 1.50 | **fails** | 1.5 s |"));
    }

    #[test]
    fn an_unlisted_row_is_shown_where_it_fails() {
        let text = |measured| {
            let row = Row::new("row", "unlisted", Expected::AtMost(1.0), measured).unlisted();
            markdown(&[Finished {
                case: &CASE,
                outcome: Outcome::rows([row]),
                took: Duration::ZERO,
            }])
        };
        assert!(!text(0.5).contains("unlisted") && text(1.5).contains("unlisted"));
    }
}

//! Why a fire changes its level, as text for `stats`.

use super::detail::Detail;
use super::load::Load;

/// The reason of a change to `detail`: what takes how long \[ms\], and what changes.
pub fn of_change(what: &str, ms: f64, load: &Load, detail: Detail) -> String {
    let reason = of_times([(what, ms), (" for a frame of ", load.budget)]);
    let number = |detail: Detail| {
        load.particles
            .map(|numbers| numbers[detail.level() as usize])
    };
    let change = if let (Some(new), Some(old)) = (number(detail), number(load.detail))
        && new != old
    {
        let (new, old) = (with_separator(new), with_separator(old));
        format!("{new} particles instead of {old}")
    } else {
        let than = if detail < load.detail {
            "coarser"
        } else {
            "finer"
        };
        format!("a {than} picture")
    };
    reason + ": " + &change
}

/// The reason of `now` particles instead of the `requested` number: a step takes that time
/// of at most `max` \[ms\].
pub fn of_capacity(step: f64, max: f64, now: u32, requested: u32) -> String {
    let reason = of_times([("a step takes ", step), (" of at most ", max)]);
    let [now, requested] = [now, requested].map(with_separator);
    reason + ": " + &now + " of " + &requested + " particles"
}

/// Two times with the label before each \[ms\].
fn of_times(times: [(&str, f64); 2]) -> String {
    let mut text = String::new();
    for (label, ms) in times {
        let tenths = (ms * 10.0).round() as u32;
        text.push_str(&format!("{label}{}.{} ms", tenths / 10, tenths % 10));
    }
    text
}

/// A number of particles with a separator of thousands.
fn with_separator(number: u32) -> String {
    match number / 1000 {
        0 => format!("{number}"),
        thousands => format!("{thousands},{:03}", number % 1000),
    }
}

//! The figures as tables of Markdown.

use std::fmt::Write as _;

use serde_json::Value;

use super::figures::{BROWSER, Figures, Row, Time};
use super::targets::{self, Target};

/// Hearth beside other programs.
pub(super) fn compared(figures: &Figures) -> String {
    let mut text = introduction(figures);
    targets_table(&mut text, targets::compared(figures));
    left_out(&mut text, &figures.all["leftOut"]);
    text
}

/// What steps, memory and the page cost.
pub(super) fn cost(figures: &Figures) -> String {
    let mut text = introduction(figures);
    targets_table(&mut text, targets::absolute(figures));
    text.push_str("| allocations a step | 0 | | | held by `tests/tests/allocation.rs` |\n");
    fires_table(&mut text, figures);
    guard_table(&mut text, figures);
    blocks_table(&mut text, figures);
    memory_table(&mut text, figures);
    page_table(&mut text, &figures.all["page"]);
    text
}

fn introduction(figures: &Figures) -> String {
    let all = &figures.all;
    let machine = &all["machine"];
    let mut text = format!(
        "Measured on {} ({} cores, {}), with Node {} and {}, in {} rounds. ",
        word(&machine["processor"]),
        word(&machine["cores"]),
        word(&machine["system"]),
        word(&all["node"]).trim_start_matches('v'),
        word(&all["browser"]),
        word(&all["rounds"]),
    );
    let peaks = all["peaks"].as_object();
    let peaks: Vec<String> = peaks
        .into_iter()
        .flatten()
        .map(|(place, peak)| format!("{place} {}", number(peak, 1)))
        .collect();
    let _ = writeln!(
        text,
        "Peak of 128-bit SIMD, multiplications and additions, in GFLOP/s: {}.",
        peaks.join(", ")
    );
    text
}

fn targets_table(text: &mut String, targets: impl IntoIterator<Item = Target>) {
    text.push_str(
        "\nOne wasm thread in Chromium unless stated otherwise.\n\n\
         | target | | median | best round | |\n|---|--:|--:|--:|---|\n",
    );
    for target in targets {
        let (what, bound) = (&target.what, &target.bound);
        let Some(Time { median, best }) = target.measured else {
            let _ = writeln!(text, "| {what} | {} |  |  | not measured |", bound.limit());
            continue;
        };
        // By both: another program's slow round makes a ratio too high.
        let reached = if bound.holds(median) && bound.holds(best) {
            "reached"
        } else {
            "not reached"
        };
        let [limit, median, best] = [bound.limit(), bound.show(median), bound.show(best)];
        let _ = writeln!(text, "| {what} | {limit} | {median} | {best} | {reached} |");
    }
}

fn blocks_table(text: &mut String, figures: &Figures) {
    text.push_str(
        "\n### Blocks\n\n\
         | N | program | where | neighbours | step, ms | best | ns a particle | share of peak | \
         / Hearth in Chromium |\n|--:|---|---|--:|--:|--:|--:|--:|--:|\n",
    );
    let in_blocks = |row: &&Row| !["plume", "combustion"].contains(&row.scene.as_str());
    let mut rows: Vec<&Row> = figures.rows.iter().filter(in_blocks).collect();
    rows.sort_by_key(|row| row.count);
    for row in rows {
        let own = figures.own("block", BROWSER, row.count);
        let ratio = own.map(|own| row.nanoseconds().over(own.nanoseconds()).median);
        let ratio = cell(ratio.map(|ratio| format!("{ratio:.2}")));
        let share = figures.share_of_peak(row);
        let share = cell(share.map(|share| format!("{:.1} %", 100.0 * share.median)));
        let (Time { median, best }, each) = (row.step, row.nanoseconds().median);
        let (count, place, neighbours) = (row.count, &row.place, row.neighbours);
        let label = row.label().replace('|', "\\|");
        let _ = writeln!(
            text,
            "| {count} | {label} | {place} | {neighbours:.1} | {median:.3} | {best:.3} | \
             {each:.1} | {share} | {ratio} |"
        );
    }
}

fn fires_table(text: &mut String, figures: &Figures) {
    text.push_str(
        "\n### Fires\n\n\
         | fire | where | particles | neighbours | substeps | step, ms | best | ns a particle | \
         steps a 60 Hz frame | those, ms |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for row in &figures.rows {
        let name = match (row.scene.as_str(), row.count) {
            ("combustion", 3000) => "default".to_owned(),
            ("combustion", 6700) => "high".to_owned(),
            ("plume", count) => format!("classic plume of up to {count}"),
            _ => continue,
        };
        let (Time { median, best }, each) = (row.step, row.nanoseconds().median);
        let (place, particles, neighbours) = (&row.place, row.particles, row.neighbours);
        let (substeps, steps) = (row.substeps, row.steps_per_frame.unwrap_or_default());
        let frame = cell(row.frame().map(|frame| format!("{:.2}", frame.median)));
        let _ = writeln!(
            text,
            "| {name} | {place} | {particles} | {neighbours:.1} | {substeps} | {median:.3} | \
             {best:.3} | {each:.0} | {steps:.1} | {frame} |"
        );
    }
    let throttled = &figures.all["throttled"];
    if let Some((step, steps)) = figures.throttled() {
        let free = throttled["freeStepMs"].as_f64().unwrap_or_default();
        let _ = writeln!(
            text,
            "\nThe lowest level ({} particles, {steps:.1} steps a \
             frame) on a page that Chromium slows down {} ×: {:.3} ms a step, {:.2} ms a frame's \
             steps; {:.2} ms without that.",
            word(&throttled["particles"]),
            word(&throttled["rate"]),
            step.median,
            step.median * steps,
            free * steps,
        );
    }
}

/// Instructions a particle and step, as `cargo xtask cost` records them.
const INSTRUCTIONS: &str = include_str!("../../../../benches/instructions.json");

/// Times that depend on the machine little: relative to JavaScript in the same run.
fn guard_table(text: &mut String, figures: &Figures) {
    let recorded: Value = serde_json::from_str(INSTRUCTIONS).unwrap_or_default();
    text.push_str(
        "\n### A particle and substep, in wasm\n\nRelative to a particle of the block of 5000 in JavaScript with a \
         list of pairs, in the same place and run.\n\n\
         | case | Node | Chromium | recorded instructions a step |\n|---|--:|--:|--:|\n",
    );
    for (name, scene, count, counted) in [
        ("default", "combustion", 3000, "combustion"),
        ("high", "combustion", 6700, "combustion"),
        ("classic block", "block", 5000, "classic block"),
    ] {
        let of = |place: &str| {
            let (row, yardstick) = (
                figures.own(scene, place, count),
                figures.own("typed", place, 5000),
            );
            let times = row?.nanoseconds().over(yardstick?.nanoseconds());
            Some(format!("{:.3}", times.median / row?.substeps as f64))
        };
        let (node, browser) = (cell(of("node")), cell(of(BROWSER)));
        let instructions = word(&recorded["instructions"][counted]);
        let _ = writeln!(text, "| {name} | {node} | {browser} | {instructions} |");
    }
}

fn memory_table(text: &mut String, figures: &Figures) {
    let Some(listed) = figures.all["memory"].as_array() else {
        return;
    };
    text.push_str("\n### Memory\n\n| block | bytes | a particle |\n|--:|--:|--:|\n");
    for block in listed {
        if let (Some(n), Some(bytes)) = (block["particles"].as_f64(), block["bytes"].as_f64()) {
            let _ = writeln!(text, "| {n} | {bytes} | {:.0} |", bytes / n);
        }
    }
}

fn page_table(text: &mut String, page: &Value) {
    let Some(stats) = page.as_object().filter(|stats| !stats.is_empty()) else {
        return;
    };
    text.push_str("\n### The page, after ten seconds\n\n| | |\n|---|--:|\n");
    for (name, value) in stats {
        let shown = match value {
            Value::Number(_) => number(value, 2),
            other => word(other),
        };
        let _ = writeln!(text, "| {name} | {shown} |");
    }
}

fn left_out(text: &mut String, reasons: &Value) {
    let Some(reasons) = reasons.as_array().filter(|reasons| !reasons.is_empty()) else {
        return;
    };
    text.push_str("\nLeft out:\n\n");
    for reason in reasons {
        let _ = writeln!(text, "- {}", word(reason));
    }
}

fn cell(shown: Option<String>) -> String {
    shown.unwrap_or_default()
}

/// A value as the text of a cell.
fn word(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.replace('|', "\\|"),
        other => other.to_string(),
    }
}

/// A number with so many digits after the point; whole ones without.
fn number(value: &Value, digits: usize) -> String {
    match value.as_f64() {
        Some(x) if value.is_f64() => format!("{x:.digits$}"),
        _ => word(value),
    }
}

#[cfg(test)]
mod tests;

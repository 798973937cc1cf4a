//! The figures as tables.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde_json::Value;

/// The figures that `benches/browser/run.mjs` gives and criterion's times of a
/// step, as Markdown.
pub(super) fn tables(figures: &Value, native: &BTreeMap<String, f64>) -> String {
    let machine = &figures["machine"];
    let mut text = format!(
        "Measured on {} ({} cores, {}), with Node {} and {}. Times are milliseconds: the \
         median of nine rounds, and the best one.\n\n",
        word(&machine["processor"]),
        word(&machine["cores"]),
        word(&machine["system"]),
        word(&figures["node"]).trim_start_matches('v'),
        word(&figures["browser"]),
    );
    text.push_str(
        "| where | scene | particles | neighbours | substeps | step | best | a 60 Hz frame |\n\
         |---|---|--:|--:|--:|--:|--:|--:|\n",
    );
    for row in figures["results"].as_array().into_iter().flatten() {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            word(&row["where"]),
            word(&row["scene"]),
            word(&row["particles"]),
            number(&row["neighbours"], 1),
            word(&row["substeps"]),
            number(&row["stepMs"], 3),
            number(&row["bestStepMs"], 3),
            number(&row["frameMs"], 2),
        );
    }
    if !native.is_empty() {
        text.push_str("\n| natively | step |\n|---|--:|\n");
        for (scene, milliseconds) in native {
            let _ = writeln!(text, "| {scene} | {milliseconds:.3} |");
        }
    }
    let stats = figures["page"].as_object();
    if let Some(stats) = stats.filter(|stats| !stats.is_empty()) {
        text.push_str("\n| on the page, after ten seconds | |\n|---|--:|\n");
        for (name, value) in stats {
            let shown = match value {
                Value::Number(_) => number(value, 2),
                other => word(other),
            };
            let _ = writeln!(text, "| {name} | {shown} |");
        }
    }
    text
}

/// A value as a word of a cell; nothing where there is none.
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
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn every_figure_has_its_cell() {
        let figures = json!({
            "machine": { "processor": "Some | CPU", "cores": 2, "system": "Linux x64" },
            "node": "v20.1.0",
            "browser": "Chrome/1",
            "results": [
                { "where": "node", "scene": "default", "particles": 700, "neighbours": 21.26,
                  "substeps": 1, "stepMs": 0.12345, "bestStepMs": 0.1, "frameMs": 0.5 },
                { "where": "node", "scene": "paper", "particles": 1000, "neighbours": 20.0,
                  "substeps": 1, "stepMs": 9.5, "bestStepMs": 9.0 },
            ],
            "page": { "fps": 60.01, "paused": false },
        });
        let native = BTreeMap::from([("fire/default".to_owned(), 0.0625)]);
        let text = tables(&figures, &native);
        assert!(text.contains("Some \\| CPU (2 cores, Linux x64), with Node 20.1.0"));
        assert!(text.contains("| node | default | 700 | 21.3 | 1 | 0.123 | 0.100 | 0.50 |"));
        assert!(text.contains("| node | paper | 1000 | 20.0 | 1 | 9.500 | 9.000 |  |"));
        assert!(text.contains("| fire/default | 0.062 |"));
        assert!(text.contains("| fps | 60.01 |\n| paused | false |"));
    }
}

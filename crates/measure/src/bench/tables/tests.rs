use super::*;
use anyhow::Result;
use serde_json::json;

fn row(name: &str, scene: &str, place: &str, count: u64, step_ms: f64) -> Value {
    json!({
        "name": name, "scene": scene, "where": place, "count": count, "particles": count,
        "neighbours": 20.0, "substeps": 1, "stepMs": step_ms, "bestStepMs": 0.5 * step_ms,
        "stepsPerFrame": 8.0,
    })
}

fn figures(results: Vec<Value>) -> Result<Figures> {
    let all = json!({
        "machine": { "processor": "Some | CPU", "cores": 2, "system": "Linux x64" },
        "node": "v20.1.0",
        "browser": "Chrome/1",
        "rounds": 7,
        "peaks": { "native": 30.0, "chromium": 27.5 },
        "results": results,
        "throttled": { "rate": 4, "particles": 1190, "stepsPerFrame": 10.0,
                       "stepMs": 1.25, "bestStepMs": 1.0, "freeStepMs": 0.25 },
        "memory": [
            { "particles": 1000, "bytes": 350_000 }, { "particles": 5000, "bytes": 2_100_000 },
        ],
        "page": { "fps": 60.01, "paused": false },
        "leftOut": ["a solver: not to be had"],
    });
    Figures::read(&all.to_string())
}

fn text(results: Vec<Value>) -> Result<String> {
    let figures = figures(results)?;
    Ok(compared(&figures) + &cost(&figures))
}

#[test]
fn every_figure_has_its_cell() -> Result<()> {
    let text = text(vec![
        row("Hearth", "block", "chromium", 20_000, 1.0),
        row("Other", "block", "native", 20_000, 4.0),
        row("Hearth", "combustion", "node", 3000, 0.5),
    ])?;
    for line in [
        "Some \\| CPU (2 cores, Linux x64), with Node 20.1.0 and Chrome/1, in 7 rounds.",
        "native 30.0, chromium 27.5.",
        "| 20000 | Hearth | chromium | 20.0 | 1.000 | 0.500 | 50.0 | 40.0 % | 1.00 |",
        "| 20000 | Other | native | 20.0 | 4.000 | 2.000 | 200.0 |  | 4.00 |",
        "| default | node | 3000 | 20.0 | 1 | 0.500 | 0.250 | 167 | 8.0 | 4.00 |",
        "(1190 particles, 10.0 steps a frame) on a page that Chromium slows down 4 ×: \
         1.250 ms a step, 12.50 ms a frame's steps; 2.50 ms without that.",
        "| 5000 | 2100000 | 420 |",
        "| fps | 60.01 |\n| paused | false |",
        "- a solver: not to be had",
    ] {
        assert!(text.contains(line), "no \"{line}\" in\n{text}");
    }
    Ok(())
}

#[test]
fn a_substep_in_wasm_is_relative_to_javascript_of_the_same_place() -> Result<()> {
    let mut fire = row("Hearth", "combustion", "node", 3000, 1.2);
    fire["substeps"] = json!(2);
    let text = text(vec![
        fire,
        row("Hearth", "typed", "node", 5000, 2.0),
        row("Hearth", "block", "chromium", 5000, 0.5),
        row("Hearth", "typed", "chromium", 5000, 2.0),
    ])?;
    // 0.2 µs a particle and substep of the fire, 0.4 µs of JavaScript.
    for line in [
        "| default | 0.500 |  | ",
        "| high |  |  | ",
        "| classic block |  | 0.250 | ",
    ] {
        assert!(text.contains(line), "no \"{line}\" in\n{text}");
    }
    Ok(())
}

#[test]
fn targets_are_reached_or_not_by_the_median() -> Result<()> {
    let mut faster = row("Y", "block", "node", 20_000, 1.9);
    faster["yardstick"] = json!(true);
    let text = text(vec![
        row("Hearth", "block", "chromium", 20_000, 1.0),
        row("Hearth", "scan", "chromium", 20_000, 15.5),
        row("Hearth", "typed", "chromium", 20_000, 4.0),
        row("salva2d DFSPH 1+1", "block", "native", 20_000, 20.0),
        row("SPlisHSPlasH WCSPH", "block", "native", 20_000, 12.0),
        row("Hearth", "block", "node", 20_000, 2.0),
        faster,
        row("Hearth", "block", "chromium", 5000, 0.25),
        row("Hearth", "block", "chromium", 400_000, 30.0),
        row("Hearth", "block", "chromium", 100_000, 15.0),
        row("Hearth", "block", "chromium", 3000, 1.0),
        row("Hearth", "combustion", "chromium", 3000, 2.0),
    ])?;
    for line in [
        "3 × 3 cells, N = 20000 | ≥ 7 × | 15.5 × | 15.5 × | reached |",
        "list of pairs, N = 20000 | ≥ 3 × | 4.00 × | 4.00 × | reached |",
        "1 + 1 iterations, N = 20000 | ≥ 30 × | 20.0 × | 20.0 × | not reached |",
        "1 + 1 iterations, N = 100000 | ≥ 30 × |  |  | not measured |",
        "a neighbour of a particle, N = 20000 | ≥ 10 × | 12.0 × | 12.0 × | reached |",
        "| time of Y, node, N = 20000 | ≤ 1.2 × | 1.05 × | 1.05 × | reached |",
        "| 100,000 particles in the browser | ≥ 60 steps a second | 67 | 133 | reached |",
        "at 28 neighbours | ≤ 2.2 × | 2.00 × | 2.00 × | reached |",
        "| default, 3000 particles, steps of a 60 Hz frame | ≤ 10 ms | 16.0 ms | 8.0 ms | not reached |",
        "slowed down 4 ×, steps of a 60 Hz frame | ≤ 14 ms | 12.5 ms | 10.0 ms | reached |",
        "| a particle among 400,000 / one among 5000, which the processor’s cache decides | ≤ 1.3 × | 1.50 × | 1.50 × | not reached |",
        "natively | ≤ 400 B a particle | 420 B | 420 B | not reached |",
    ] {
        assert!(text.contains(line), "no \"{line}\" in\n{text}");
    }
    Ok(())
}

#[test]
fn without_a_yardstick_its_row_is_not_measured() -> Result<()> {
    let text = text(Vec::new())?;
    assert!(text.contains("`--yardstick` names | ≤ 1.2 × |  |  | not measured |"));
    Ok(())
}

//! Open air without a fire: at rest, and in the wind.

use hearth_core::{Scene, Simulation, Vec2};

use super::boxes::{on_floor, open, run};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "still-air",
        pace: Pace::Long(20),
        run: still_air,
    },
    Case {
        name: "wind",
        pace: Pace::Long(30),
        run: wind,
    },
];

/// The air around an unlit source of this width \[m\].
fn unlit(width: f64, wind: f64) -> Scene {
    let values = [
        ("fuel_power", 0.0),
        ("ember_rate", 0.0),
        ("source_width", width),
        ("wind", wind),
    ];
    open((1.6, 1.2), 0.03, values)
}

/// Mean velocity along x and root mean square of the deviation from `wind` [m/s], from 2 s to
/// `until` \[s\].
fn motion(scene: Scene, wind: f64, until: f64) -> (f64, f64) {
    let mut fire = Simulation::new(scene);
    let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
    let came = run(&mut fire, until, |fire| {
        fire.step();
        if fire.time() > 2.0 {
            for velocity in fire.velocities() {
                sum += f64::from(velocity.x);
                let off = velocity - Vec2::new(wind as f32, 0.0);
                squares += f64::from(off.length_squared());
                count += 1.0;
            }
        }
    });
    if came {
        (sum / count, (squares / count).sqrt())
    } else {
        (f64::NAN, f64::NAN)
    }
}

/// Nothing moves air at rest, whatever the shape of its rim.
fn still_air() -> Outcome {
    let shapes = [
        ("a narrow source", unlit(0.1, 0.0)),
        ("a wide source", unlit(1.0, 0.0)),
        ("a wide source on a floor", on_floor(unlit(1.0, 0.0))),
    ];
    Outcome::rows(
        shapes
            .into_iter()
            .enumerate()
            .map(|(i, (shape, parameters))| {
                Row::new(
                    format!("still-air-{i}"),
                    format!("air at rest around {shape}: root mean square of the speed"),
                    Expected::AtMost(0.01),
                    motion(parameters, 0.0, 10.0).1,
                )
                .in_unit("m/s")
            }),
    )
}

/// Wind blows through the band of air as fast as it is set.
fn wind() -> Outcome {
    Outcome::rows([-0.5, 0.5, 1.0, 2.0, 3.0].map(|wind| {
        let (mean, deviation) = motion(unlit(1.0, wind), wind, 6.0);
        Row::new(
            format!("wind-{wind}"),
            format!("wind of {wind} m/s: mean over the air around a source"),
            Expected::Share {
                value: wind,
                tolerance: 0.1,
            },
            mean,
        )
        .in_unit("m/s")
        .noting(format!("deviation {deviation:.3} m/s"))
    }))
}

//! Texts about costly values, speed and the number of particles.

use hearth_core::params::Model;

use crate::format::{count_text, significant};
use crate::state::{Fire, Subject};

/// The start of the costly values, which is far above every default.
const COST_LIMITS: &[(&str, f64)] = &[
    ("particles", 10_000.0),
    ("max_particles", 20_000.0),
    ("emission_rate", 15_000.0),
    ("smoothing_ratio", 1.7),
    ("smoothing_radius", 0.04),
    ("stiffness", 9.0),
];

/// Number of particles in the domain from which a `spacing` is costly.
const COSTLY_IN_DOMAIN: u32 = 10_000;

/// Smallest share of sleeping air that counts.
const MIN_ASLEEP_SHARE: f64 = 0.005;

/// From this fraction of the requested number on, the number of particles counts as it.
const NEARLY_ALL: f64 = 0.95;

/// The start of a parameter's costly values, if it has any.
pub fn costly_from(subject: Subject) -> Option<f64> {
    COST_LIMITS
        .iter()
        .find(|(id, _)| *id == subject.id)
        .map(|&(_, from)| from)
}

/// The number of particles, and the requested one if that is another. In open air, the number
/// follows from the fire, and the text has the share that sleeps.
pub fn particles(fire: &Fire) -> String {
    let now = fire.stats.particles;
    if fire.parameters().has_open_edges() {
        let text = format!("{} particles", count_text(now));
        return match fire.stats.asleep {
            share if share < MIN_ASLEEP_SHARE => text,
            share => format!("{text} ({} % asleep)", significant(100.0 * share, 2)),
        };
    }
    let requested = f64::from(fire.parameters().capacity());
    let quality = &*fire.stats.quality;
    if now >= NEARLY_ALL * requested || now == 0.0 {
        return format!("{} particles", count_text(now));
    }
    let of = format!("{} of {}", count_text(now), count_text(requested));
    match (fire.parameters().model(), quality) {
        (Model::Combustion, "low" | "medium" | "high") => format!("{of} (quality {quality})"),
        _ => format!("{of} particles"),
    }
}

/// The real-time factor, if the machine is too slow for the fire.
pub fn speed(fire: &Fire) -> Option<String> {
    let stats = &fire.stats;
    let requested = f64::from(fire.parameters().time_scale);
    if !stats.slowed || stats.time_scale <= 0.0 || requested <= 0.0 {
        return stats.slowed.then(|| "slower than real time".to_owned());
    }
    Some(format!(
        "{} × real time",
        significant(stats.time_scale, 1 + i32::from(stats.time_scale >= 1.0))
    ))
}

/// A note on a value, if there is one.
pub fn note(fire: &Fire, subject: Subject, value: f64) -> Option<String> {
    if subject.id == "max_particles"
        && fire.parameters().model() == Model::Classic
        && fire.stats.particles > 0.0
        && fire.stats.particles < NEARLY_ALL * value
    {
        return Some(format!(
            "{} are alive: strength, life and the space at the source allow no more",
            count_text(fire.stats.particles)
        ));
    }
    let costly = match subject.id {
        "spacing" => fire.parameters().domain_particles() >= COSTLY_IN_DOMAIN,
        _ => costly_from(subject).is_some_and(|from| value >= from),
    };
    match (costly, speed(fire)) {
        (true, Some(speed)) => Some(format!("Expensive value: the fire runs at {speed}")),
        _ => None,
    }
}

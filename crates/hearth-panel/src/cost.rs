//! Which values take much work, and what keeps a number of particles down, in words.

use hearth_core::params::{Model, Param};

use crate::fire::Fire;
use crate::format::{count_text, significant};

/// Values that take much work from some value on, which is far above every default.
const DEAR: &[(&str, f64)] = &[
    ("max_particles", 10_000.0),
    ("emission_rate", 15_000.0),
    ("smoothing_ratio", 1.7),
    ("smoothing_radius", 0.04),
    ("stiffness", 9.0),
];

/// A number of particles that misses the one asked for by less is that one.
const NEARLY: f64 = 0.95;

/// From where on the values of a parameter take much work, where they do.
pub fn dear_from(param: &Param) -> Option<f64> {
    DEAR.iter()
        .find(|(id, _)| *id == param.id)
        .map(|&(_, from)| from)
}

/// What the number of particles is, and what it was to be where it is another one.
pub fn particles(fire: &Fire) -> String {
    let now = fire.stats.particles;
    let wanted = f64::from(fire.parameters.max_particles);
    let quality = &*fire.stats.quality;
    if now >= NEARLY * wanted || now == 0.0 {
        return format!("{} particles", count_text(now));
    }
    let of = format!("{} of {}", count_text(now), count_text(wanted));
    match (fire.parameters.model(), quality) {
        (Model::Combustion, "low" | "medium" | "high") => format!("{of} (quality {quality})"),
        _ => format!("{of} particles"),
    }
}

/// How fast the fire goes, where the machine is too slow for it.
pub fn speed(fire: &Fire) -> Option<String> {
    let stats = &fire.stats;
    let wanted = f64::from(fire.parameters.time_scale);
    if !stats.slowed || stats.time_scale <= 0.0 || wanted <= 0.0 {
        return stats.slowed.then(|| "slower than real time".to_owned());
    }
    Some(format!(
        "{} × real time",
        significant(stats.time_scale, 1 + i32::from(stats.time_scale >= 1.0))
    ))
}

/// What there is to know about the value of a parameter at present.
pub fn note(fire: &Fire, param: &Param, value: f64) -> Option<String> {
    if param.id == "max_particles"
        && fire.parameters.model() == Model::Classic
        && fire.stats.particles > 0.0
        && fire.stats.particles < NEARLY * value
    {
        return Some(format!(
            "{} are alive: strength × life and the room at the source allow no more",
            count_text(fire.stats.particles)
        ));
    }
    let dear = dear_from(param).is_some_and(|from| value >= from);
    match (dear, speed(fire)) {
        (true, Some(speed)) => Some(format!("Takes much work: the fire goes at {speed}")),
        _ => None,
    }
}

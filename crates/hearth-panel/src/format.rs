//! Formats and parses the numbers of the panel.
//!
//! A slider moves in round steps (0.031, not 0.0312499), a value has at most four significant
//! digits, and typed text may contain the unit or a decimal comma. The parameter table of
//! hearth-core validates the range.

use hearth_core::params::{AnyValue, Param, Scale};

/// Most letters of a text in its row.
const LONGEST_SHORT: usize = 28;

/// `x` with at most `digits` significant digits, without trailing zeros.
pub fn significant(x: f64, digits: i32) -> String {
    if x == 0.0 || !x.is_finite() {
        return "0".to_owned();
    }
    let magnitude = x.abs().log10().floor() as i32;
    let decimals = (digits - 1 - magnitude).clamp(0, 12) as usize;
    let text = format!("{x:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A value as its row shows it, without the unit.
pub fn value_text(value: &AnyValue<'_>) -> String {
    match value {
        AnyValue::Number(_) => significant(value.as_number().unwrap_or_default(), 4),
        AnyValue::Choice(name) => choice_text(name),
        AnyValue::Integer(_)
        | AnyValue::Seed(_)
        | AnyValue::Flag(_)
        | AnyValue::Colour(_)
        | AnyValue::Text(_) => value.to_string(),
    }
}

/// A choice by words, as a line of its own: "Black body", "None".
pub fn choice_text(name: &str) -> String {
    let words = match name {
        "blackbody" => "black body".to_owned(),
        name => name.replace(['-', '_'], " "),
    };
    let (initial, rest) = words.split_at(words.chars().next().map_or(0, char::len_utf8));
    initial.to_uppercase() + rest
}

/// A bound of a range, with its unit.
pub fn bound_text(bound: f64, unit: &str) -> String {
    with_unit(&significant(bound, 10), unit)
}

/// `text` followed by its unit, if there is one.
pub fn with_unit(text: &str, unit: &str) -> String {
    if unit.is_empty() {
        text.to_owned()
    } else {
        format!("{text} {unit}")
    }
}

/// A text as its row shows it, without the unit: points and masks as what they measure.
pub fn text_in_short(id: &str, text: &str) -> String {
    match id {
        "points" => {
            let numbers = text.split([',', ' ']).map(str::parse::<f64>);
            let numbers: Vec<f64> = numbers.filter_map(Result::ok).collect();
            let extent = |part: usize| {
                let all = numbers.iter().skip(part).step_by(2);
                let (min, max) = all.fold((f64::MAX, f64::MIN), |(min, max), &x| {
                    (min.min(x), max.max(x))
                });
                significant(max - min, 3)
            };
            let (count, width, height) = (numbers.len() / 2, extent(0), extent(1));
            format!("{count} points, {width} × {height}")
        }
        "mask" => {
            let size = text.split(':').next().unwrap_or_default();
            format!("{} cells", size.replace('x', " × "))
        }
        _ if text.is_empty() => "none".to_owned(),
        _ if text.chars().count() > LONGEST_SHORT => {
            let start: String = text.chars().take(LONGEST_SHORT).collect();
            start + "…"
        }
        _ => text.to_owned(),
    }
}

/// A count in groups of three digits: 12 345.
pub fn count_text(count: f64) -> String {
    let digits = format!("{:.0}", count.max(0.0));
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push('\u{a0}');
        }
        text.push(digit);
    }
    text
}

/// Typed text in the form of the parameter table: without the unit, with a decimal point.
pub fn typed_text(text: &str, param: &Param) -> String {
    let text = text.trim();
    let text = match param.unit {
        "" => text,
        unit => text.strip_suffix(unit).unwrap_or(text).trim_end(),
    };
    let commas = text.matches(',').count();
    if commas == 1 && !text.contains('.') {
        text.replace(',', ".")
    } else {
        text.to_owned()
    }
}

/// The step of a linear slider: a power of ten that divides the range into some hundred steps.
pub fn step(range: (f64, f64)) -> f64 {
    let span = range.1 - range.0;
    if span <= 0.0 {
        return 1.0;
    }
    10_f64.powf((span / 500.0).log10().round())
}

/// The position of `x` on the slider: 0 at the left end, 1 at the right end.
pub fn fraction(x: f64, range: (f64, f64), scale: Scale) -> f64 {
    let (min, max) = range;
    let fraction = match scale {
        Scale::Log if min > 0.0 => (x / min).ln() / (max / min).ln(),
        Scale::Log | Scale::Linear => (x - min) / (max - min),
    };
    if fraction.is_finite() {
        fraction.clamp(0.0, 1.0)
    } else {
        0.0
    }
}

/// The value at a position of the slider, rounded to a step. The ends of the range are exact.
pub fn value_at(fraction: f64, range: (f64, f64), scale: Scale, whole: bool) -> f64 {
    let (min, max) = range;
    if fraction <= 0.0 {
        return min;
    }
    if fraction >= 1.0 {
        return max;
    }
    let rounded = match scale {
        Scale::Log if min > 0.0 => {
            let x = min * (max / min).powf(fraction);
            significant(x, 3).parse().unwrap_or(x)
        }
        Scale::Log | Scale::Linear => {
            let step = step(range);
            let x = ((min + (max - min) * fraction) / step).round() * step;
            // Removes the rounding error of the product (0.30000000000000004).
            significant(x, 12).parse().unwrap_or(x)
        }
    };
    let rounded = if whole { rounded.round() } else { rounded };
    rounded.clamp(min, max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::{Kind, PARAMETERS};

    #[test]
    fn shown_numbers_are_short_and_exact() {
        assert_eq!(significant(0.004_166_667, 4), "0.004167");
        assert_eq!(significant(0.05, 4), "0.05");
        assert_eq!(significant(1900.0, 4), "1900");
        assert_eq!(significant(123_456.7, 4), "123457");
        assert_eq!(significant(-2.5, 4), "-2.5");
        assert_eq!(significant(0.0, 4), "0");
        assert_eq!(count_text(1_234_567.0), "1\u{a0}234\u{a0}567");
        assert_eq!(count_text(999.0), "999");
    }

    #[test]
    fn typed_text_may_have_the_unit_and_a_decimal_comma() {
        let gravity = Param::find("gravity").expect("the table has gravity");
        assert_eq!(typed_text(" 9,5 m/s² ", gravity), "9.5");
        assert_eq!(typed_text("1,000.5", gravity), "1,000.5");
        assert_eq!(typed_text("nonsense", gravity), "nonsense");
    }

    #[test]
    fn every_slider_reaches_its_ends_and_stays_in_its_range() {
        for param in PARAMETERS {
            let (Kind::Number(scale) | Kind::Integer(scale)) = param.kind else {
                continue;
            };
            let whole = matches!(param.kind, Kind::Integer(_));
            for domain in param.domains {
                let (min, max) = domain.range;
                let value = |at| value_at(at, domain.range, scale, whole);
                // A position between two whole numbers shows the nearer one.
                let apart = if whole { 0.51 / (max - min) } else { 0.0 };
                assert_eq!((value(0.0), value(1.0)), (min, max), "{}", param.id);
                let mut last = min;
                for percent in 0..=100 {
                    let at = f64::from(percent) / 100.0;
                    let x = value(at);
                    assert!(x >= last && x <= max, "{} at {percent} %", param.id);
                    assert!(
                        (fraction(x, domain.range, scale) - at).abs() < apart.max(0.02),
                        "{} at {percent} % shows {x}",
                        param.id
                    );
                    last = x;
                }
            }
        }
    }
}

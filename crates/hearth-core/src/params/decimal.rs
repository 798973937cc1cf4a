//! Small code to read and write decimals.
//!
//! The standard library reads and writes every float exactly, with tables and big integers.
//! Parameters are `f32`s with few digits: integers
//! and powers of ten up to 10²² are exact in an `f64`, and a division of two of them is rounded
//! once, like the result of the standard library.

use std::fmt;

/// Largest power of ten that is exact as an `f64`.
const EXACT_POWER: i32 = 22;
/// Whole numbers below are exact as an `f64`.
const EXACT_WHOLE: f64 = 9_007_199_254_740_992.0;

/// Parses numbers such as `-12.5`, `.5` and `3e-4`.
pub(super) fn parse(text: &str) -> Option<f64> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse().ok()?),
        None => (text, 0_i32),
    };
    let (is_negative, digits) = match mantissa.as_bytes() {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] | digits => (false, digits),
    };
    let (mut number, mut count) = (0.0, 0);
    // The number of digits before the point.
    let mut whole = None;
    for &digit in digits {
        match digit {
            b'0'..=b'9' => {
                number = number * 10.0 + f64::from(digit - b'0');
                count += 1;
            }
            b'.' if whole.is_none() => whole = Some(count),
            _ => return None,
        }
    }
    if count == 0 {
        return None;
    }
    let places = count - whole.unwrap_or(count);
    let size = scaled(number, exponent.saturating_sub(places));
    Some(if is_negative { -size } else { size })
}

/// `x · 10^exponent`.
fn scaled(x: f64, exponent: i32) -> f64 {
    let (mut x, mut left) = (x, exponent.clamp(-400, 400));
    while left != 0 {
        let part = left.clamp(-EXACT_POWER, EXACT_POWER);
        let power = power_of_ten(part.unsigned_abs());
        x = if part < 0 { x / power } else { x * power };
        left -= part;
    }
    x
}

fn power_of_ten(exponent: u32) -> f64 {
    (0..exponent).fold(1.0, |power, _| power * 10.0)
}

/// The shortest decimal that is `x` as an `f32`: 0.05 for 0.05.
pub(super) fn shortest(x: f32) -> f64 {
    let exact = f64::from(x);
    (0..=22)
        .map(power_of_ten)
        .map(|power| (exact * power).round() / power)
        .find(|&near| near as f32 == x)
        .unwrap_or(exact)
}

/// A number for a message: with at most 17 decimal places, or nine if it is not a short
/// decimal; with four digits if it is very large or small.
pub(super) struct Decimal(pub f64);

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if self.0 < 0.0 {
            f.write_str("-")?;
        }
        if size.is_nan() {
            return f.write_str("NaN");
        }
        if size.is_infinite() {
            return f.write_str("inf");
        }
        if size != 0.0 && !(1e-6..1e15).contains(&size) {
            return write_far(f, size);
        }
        let exact = (0..=17)
            .map(|places| (places, size * power_of_ten(places)))
            .take_while(|&(_, whole)| whole < EXACT_WHOLE)
            .map(|(places, whole)| (places, whole.round()))
            .find(|&(places, whole)| whole / power_of_ten(places) == size);
        let (places, whole) = exact.unwrap_or_else(|| match size < 1e6 {
            true => (9, (size * 1e9).round()),
            false => (0, size.round()),
        });
        write_places(f, whole as u64, places)
    }
}

fn write_places(f: &mut fmt::Formatter<'_>, whole: u64, places: u32) -> fmt::Result {
    let unit = 10_u64.pow(places);
    write!(f, "{}", whole / unit)?;
    match places {
        0 => Ok(()),
        _ => write!(f, ".{:0width$}", whole % unit, width = places as usize),
    }
}

/// Four digits and a power of ten.
fn write_far(f: &mut fmt::Formatter<'_>, size: f64) -> fmt::Result {
    let (mut mantissa, mut sign, mut exponent) = (size, "", 0_u64);
    while mantissa >= 10.0 {
        mantissa /= 10.0;
        exponent += 1;
    }
    while mantissa < 1.0 {
        mantissa *= 10.0;
        (sign, exponent) = ("-", exponent + 1);
    }
    write_places(f, (mantissa * 1e3).round() as u64, 3)?;
    write!(f, "e{sign}{exponent}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_parse_as_in_the_standard_library() {
        for text in [
            "0",
            "-0",
            "1",
            "+7",
            "0.05",
            "1.5",
            ".5",
            "5.",
            "3e-4",
            "6E-4",
            "1e5",
            "-2.25",
            "4294967295",
            "0.00041666666666666666",
            "293",
            "9.81",
            "1e22",
            "123456.789",
        ] {
            assert_eq!(parse(text), text.parse().ok(), "{text}");
        }
        for text in [
            "", ".", "-", "e5", "1e", "1e5.0", "0x1", "1 2", "--1", "1,5", "NaN", "inf", "٣",
        ] {
            assert_eq!(parse(text), None, "{text}");
        }
        assert_eq!(parse("1e999"), Some(f64::INFINITY));
        assert_eq!(parse("1e-999"), Some(0.0));
        assert_eq!(parse("1e99999999999"), None);
    }

    #[test]
    fn the_shortest_decimal_is_that_of_the_standard_library() {
        let mut x = 1e-6_f32;
        while x < 1e6 {
            assert_eq!(Some(shortest(x)), x.to_string().parse().ok(), "{x}");
            assert_eq!(Some(shortest(-x)), (-x).to_string().parse().ok(), "-{x}");
            x *= 1.000_37;
        }
        for x in [0.0, 0.05, 6e-4, 1.0 / 240.0, 100_000.0, 4.0, f32::MAX] {
            assert_eq!(shortest(x) as f32, x);
        }
    }

    #[test]
    fn decimals_are_formatted_briefly() {
        for (x, text) in [
            (0.0, "0"),
            (0.05, "0.05"),
            (-4.0, "-4"),
            (100_000.0, "100000"),
            (1.0 / 480.0, "0.002083333"),
            (4294967295.0, "4294967295"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
            (1.5e300, "1.500e300"),
            (-2.5e-9, "-2.500e-9"),
        ] {
            assert_eq!(Decimal(x).to_string(), text);
        }
    }
}

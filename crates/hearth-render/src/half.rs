//! Half floats, in which the history keeps its samples.

/// The nearest half float, as its bits. A number beyond the range becomes the largest one, so that no
/// sample holds an infinity.
// Eight inlined copies for each particle would be larger and not faster.
#[inline(never)]
pub fn bits(number: f32) -> u16 {
    let sign = (number.to_bits() >> 16) as u16 & 0x8000;
    let size = number.abs();
    let magnitude = if size >= LARGEST {
        0x7bff
    } else if size >= SMALLEST_NORMAL {
        // The exponent's bias falls from 127 to 15, and half a unit of the last place rounds.
        ((size.to_bits() + 0x1000 - (112 << 23)) >> 13) as u16
    } else {
        // The distance of two subnormal numbers is 2⁻²⁴. NaN becomes zero.
        (size * 16_777_216.0 + 0.5) as u16
    };
    sign | magnitude
}

const LARGEST: f32 = 65_504.0;
const SMALLEST_NORMAL: f32 = 6.103_515_6e-5;

/// The number of a half float's bits.
#[cfg(test)]
pub fn number(bits: u16) -> f32 {
    let (exponent, fraction) = ((bits >> 10) & 31, f32::from(bits & 1023));
    let size = match exponent {
        0 => fraction / 16_777_216.0,
        _ => (1.0 + fraction / 1024.0) * (f32::from(exponent) - 15.0).exp2(),
    };
    if bits >> 15 == 1 { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_half_float_keeps_its_bits() {
        for sign in [0, 0x8000] {
            for magnitude in 0..0x7c00 {
                assert_eq!(bits(number(sign | magnitude)), sign | magnitude);
            }
        }
    }

    #[test]
    fn a_number_rounds_to_the_nearest_and_stays_finite() {
        for size in [
            1e-7_f32, 3e-5, 0.001, 0.7, 1.9996, 2.4, 311.7, 1873.0, 60_000.0,
        ] {
            let error = (number(bits(-size)) + size).abs();
            assert!(error <= (size / 2047.0).max(3e-8), "{size}");
        }
        for beyond in [1e9, f32::INFINITY] {
            assert_eq!(number(bits(beyond)), LARGEST);
        }
        assert!(number(bits(f32::NAN)).is_finite());
    }
}

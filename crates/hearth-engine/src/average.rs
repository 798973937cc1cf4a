//! Figures that change from frame to frame, as a person reads them.

/// Weight of the newest frame.
const SMOOTHING: f64 = 0.1;

/// Lets `average` follow what is measured; the first measurement counts fully.
pub fn smooth(average: &mut f64, newest: f64) {
    *average += if *average == 0.0 {
        newest
    } else {
        SMOOTHING * (newest - *average)
    };
}

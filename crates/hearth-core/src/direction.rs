//! Directions of angles.
//!
//! `libm`'s functions take radians, in which no right angle is exact.

use glam::Vec2;

/// The unit vector at an angle \[°\] from the x axis, counterclockwise: exact at right angles.
pub(crate) fn direction(degrees: f32) -> Vec2 {
    let quarters = (degrees / 90.0 + 0.5).floor();
    let x = (degrees - 90.0 * quarters).to_radians();
    let square = x * x;
    // Taylor's series up to π/4: errors below 3e-8.
    let sine = x
        * (1.0
            - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))));
    let cosine =
        1.0 - square / 2.0 * (1.0 - square / 12.0 * (1.0 - square / 30.0 * (1.0 - square / 56.0)));
    let mut axis = Vec2::new(cosine, sine);
    for _ in 0..(quarters as i32).rem_euclid(4) {
        axis = axis.perp();
    }
    axis
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_unit_vector_at_the_angle() {
        for step in -1440..=1440 {
            let degrees = 0.5 * step as f32;
            let radians = f64::from(degrees).to_radians();
            let axis = direction(degrees);
            assert!(
                (f64::from(axis.x) - radians.cos()).abs() < 3e-7,
                "{degrees}°"
            );
            assert!(
                (f64::from(axis.y) - radians.sin()).abs() < 3e-7,
                "{degrees}°"
            );
        }
        assert_eq!(direction(-90.0), -Vec2::Y);
        assert_eq!(direction(180.0), -Vec2::X);
        assert_eq!(direction(0.0), Vec2::X);
    }
}

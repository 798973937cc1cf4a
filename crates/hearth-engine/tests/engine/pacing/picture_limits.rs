//! PictureLimits of frame rate and picture size, and the force of a pointer.

use hearth_core::resolution::Level;
use hearth_engine::commands::Command;
use hearth_engine::pacing::picture_limits::PictureLimits;
use hearth_engine::pointer::PointerForce;
use hearth_settings::untrusted::{Untrusted, Within};

const PIXELS: (f64, f64) = (1024.0, 16_777_216.0);

fn fps(fps: f64) -> PictureLimits {
    let (fps, pixels) = (Some(fps), None);
    PictureLimits { fps, pixels }
}

fn pixels(pixels: f64) -> PictureLimits {
    let (fps, pixels) = (None, Some(pixels));
    PictureLimits { fps, pixels }
}

/// Number of pictures in ten seconds on a display with that rate \[Hz\].
fn drawn(limits: PictureLimits, display: f64) -> u32 {
    let mut next = 0.0;
    let frames = (10.0 * display) as u32;
    let due = |&frame: &u32| limits.is_due(1000.0 * f64::from(frame) / display, &mut next);
    (0..frames).filter(due).count() as u32
}

#[test]
fn a_limited_fire_draws_nearly_at_its_limit() {
    for display in [50.0, 60.0, 120.0, 144.0] {
        assert_eq!(
            drawn(PictureLimits::default(), display),
            (10.0 * display) as u32
        );
        for fps in [10.0, 24.0, 30.0] {
            let limits = self::fps(fps);
            let max = 10.0 * fps + 1.0;
            let got = f64::from(drawn(limits, display));
            assert!(
                got <= max && got > 0.8 * max,
                "{got} of {max} at {display} Hz"
            );
        }
    }
}

#[test]
fn a_pause_is_not_made_up_for() {
    let limits = fps(10.0);
    let mut next = 0.0;
    assert!(limits.is_due(0.0, &mut next));
    assert!(limits.is_due(60_000.0, &mut next));
    assert!(!limits.is_due(60_016.0, &mut next));
    assert!(limits.is_due(60_100.0, &mut next));
}

#[test]
fn a_limited_picture_keeps_its_shape() {
    for size in [(1920, 1080), (300, 4000), (1, 8192), (64, 64), (8192, 8192)] {
        for max in [PIXELS.0, 90_000.0, PIXELS.1] {
            let (width, height) = pixels(max).fit(size, Level::High.pixels());
            let drawn = f64::from(width) * f64::from(height);
            assert!(width > 0 && height > 0);
            assert!(
                drawn <= max.max(f64::from(size.0.max(size.1))),
                "{size:?}: {drawn}"
            );
            if f64::from(size.0) * f64::from(size.1) <= max {
                assert_eq!((width, height), size);
            } else if width > 20 && height > 20 {
                let ratio = |(width, height)| f64::from(width) / f64::from(height);
                assert!((ratio((width, height)) / ratio(size) - 1.0).abs() < 0.05);
            }
        }
    }
}

#[test]
fn the_quality_limits_pixels_by_default() {
    let screen = (3840, 2160);
    let pixels = Level::ALL.map(|level| {
        let (width, height) = PictureLimits::default().fit(screen, level.pixels());
        width * height
    });
    assert!(pixels.is_sorted_by(|a, b| a < b), "{pixels:?}");
    let own = self::pixels(PIXELS.1);
    assert_eq!(own.fit(screen, Level::Low.pixels()), screen);
}

#[test]
fn a_limit_is_a_number_in_range_or_missing() {
    let limit = |id: &str, value: Untrusted| {
        let arguments = [value];
        let limit = Command::parse(&Untrusted::Text(id.to_owned()), &arguments);
        limit.map(|limit| match limit {
            Command::LimitFps { fps_limit } => fps_limit.map(|Within(fps)| fps),
            Command::LimitPixels { max_pixels } => max_pixels.map(|Within(pixels)| pixels),
            other => panic!("{other:?}"),
        })
    };
    assert_eq!(limit("fps_limit", Untrusted::Number(30.0)), Ok(Some(30.0)));
    assert_eq!(limit("max_pixels", Untrusted::Missing), Ok(None));
    for (id, (min, max)) in [("fps_limit", (10.0, 240.0)), ("max_pixels", PIXELS)] {
        for end in [min, max] {
            assert_eq!(limit(id, Untrusted::Number(end)), Ok(Some(end)));
        }
        for wrong in [
            Untrusted::Number(min - 1.0),
            Untrusted::Number(max + 1.0),
            Untrusted::Number(f64::NAN),
            Untrusted::Number(f64::INFINITY),
            Untrusted::Text("fast".to_owned()),
            Untrusted::Null,
        ] {
            let error = limit(id, wrong).expect_err("refused");
            let allowed = format!("must be a number from {min} to {max}");
            assert!(error.message.ends_with(&allowed), "{error:?}");
            assert_eq!((error.id.as_str(), error.range), (id, Some((min, max))));
        }
    }
    assert!(Command::parse(&Untrusted::Text("seed".to_owned()), &[]).is_err());
}

#[test]
fn a_pointer_accelerates_only_gas_near_it() {
    let mut force = PointerForce::new([0.1, 0.5], [2.0, 0.0]);
    assert!(force.acceleration([0.1, 0.5], [0.0; 2])[0] > 0.0);
    assert_eq!(
        force.acceleration([0.1, 0.5], [2.0, 0.0]),
        [0.0; 2],
        "as fast as the pointer"
    );
    assert_eq!(
        force.acceleration([0.5, 0.5], [0.0; 2]),
        [0.0; 2],
        "far away"
    );
    assert!(force.lasts(0.001));
    assert!(!force.lasts(1.0), "the force ends");
}

//! How much a fire may draw, and what stirs it.

use hearth_engine::limits::{Limit, Limits, PIXELS, RATES, Stir};
use hearth_engine::quality::Level;
use hearth_engine::raw::Raw;

fn object(fields: &[(&str, Raw)]) -> Raw {
    let named = fields
        .iter()
        .map(|(id, value)| ((*id).to_owned(), value.clone()));
    Raw::Object(named.collect())
}

fn limit(id: &str, value: Raw) -> Result<Limit, String> {
    let id = ("id", Raw::Text(id.to_owned()));
    Limit::parse(&object(&[id, ("value", value)])).map_err(|refused| refused.message)
}

/// Frames of a display of that rate that are drawn in ten seconds.
fn drawn(limits: Limits, display: f64) -> u32 {
    let mut next = 0.0;
    let frames = (10.0 * display) as u32;
    let due = |&frame: &u32| limits.is_due(1000.0 * f64::from(frame) / display, &mut next);
    (0..frames).filter(due).count() as u32
}

#[test]
fn a_limited_fire_draws_about_as_often_as_it_may() {
    for display in [50.0, 60.0, 120.0, 144.0] {
        assert_eq!(drawn(Limits::default(), display), (10.0 * display) as u32);
        for fps in [10.0, 24.0, 30.0] {
            let limits = Limits::default().with(Limit::Fps(Some(fps)));
            let most = 10.0 * fps + 1.0;
            let got = f64::from(drawn(limits, display));
            assert!(
                got <= most && got > 0.8 * most,
                "{got} of {most} at {display} Hz"
            );
        }
    }
}

#[test]
fn after_a_pause_nothing_is_made_up_for() {
    let limits = Limits::default().with(Limit::Fps(Some(10.0)));
    let mut next = 0.0;
    assert!(limits.is_due(0.0, &mut next));
    assert!(limits.is_due(60_000.0, &mut next));
    assert!(!limits.is_due(60_016.0, &mut next));
    assert!(limits.is_due(60_100.0, &mut next));
}

#[test]
fn a_picture_keeps_its_shape_and_has_no_more_pixels_than_it_may() {
    for size in [(1920, 1080), (300, 4000), (1, 8192), (64, 64), (8192, 8192)] {
        for most in [PIXELS.0, 90_000.0, PIXELS.1] {
            let (width, height) = Limits::default()
                .with(Limit::Pixels(Some(most)))
                .fit(size, Level::High.pixels());
            let pixels = f64::from(width) * f64::from(height);
            assert!(width > 0 && height > 0);
            assert!(
                pixels <= most.max(f64::from(size.0.max(size.1))),
                "{size:?}: {pixels}"
            );
            if f64::from(size.0) * f64::from(size.1) <= most {
                assert_eq!((width, height), size);
            } else if width > 20 && height > 20 {
                let ratio = |(width, height)| f64::from(width) / f64::from(height);
                assert!((ratio((width, height)) / ratio(size) - 1.0).abs() < 0.05);
            }
        }
    }
}

#[test]
fn where_nobody_limits_them_the_quality_does() {
    let screen = (3840, 2160);
    let pixels = Level::ALL.map(|level| {
        let (width, height) = Limits::default().fit(screen, level.pixels());
        width * height
    });
    assert!(pixels.is_sorted_by(|a, b| a < b), "{pixels:?}");
    let own = Limits::default().with(Limit::Pixels(Some(PIXELS.1)));
    assert_eq!(own.fit(screen, Level::Low.pixels()), screen);
}

#[test]
fn a_limit_is_a_number_in_its_range_or_none() {
    assert_eq!(
        limit("fps_limit", Raw::Number(30.0)),
        Ok(Limit::Fps(Some(30.0)))
    );
    assert_eq!(limit("max_pixels", Raw::Missing), Ok(Limit::Pixels(None)));
    for (id, (min, max)) in [("fps_limit", RATES), ("max_pixels", PIXELS)] {
        for wrong in [
            Raw::Number(min - 1.0),
            Raw::Number(max + 1.0),
            Raw::Number(f64::NAN),
            Raw::Number(f64::INFINITY),
            Raw::Text("fast".to_owned()),
            Raw::Other("null"),
        ] {
            let said = limit(id, wrong).err().unwrap_or_default();
            assert!(
                said.contains(id) && said.contains(&format!("from {min} to {max}")),
                "{said}"
            );
        }
    }
    assert!(limit("seed", Raw::Number(1.0)).is_err());
}

#[test]
fn stirred_gas_is_carried_along_near_the_place_and_nowhere_else() {
    let number = |x| Raw::Number(x);
    let fields = [
        ("x", number(0.1)),
        ("y", number(0.5)),
        ("u", number(2.0)),
        ("v", number(0.0)),
    ];
    let stir = Stir::parse(&object(&fields));
    let Ok(mut stir) = stir else {
        panic!("{stir:?}");
    };
    assert!(stir.push([0.1, 0.5], [0.0; 2])[0] > 0.0);
    assert_eq!(
        stir.push([0.1, 0.5], [2.0, 0.0]),
        [0.0; 2],
        "as fast as the pointer"
    );
    assert_eq!(stir.push([0.5, 0.5], [0.0; 2]), [0.0; 2], "far away");
    assert!(stir.lasts(0.001));
    assert!(!stir.lasts(1.0), "it ends");
    for (at, wrong) in [f64::NAN, f64::INFINITY, 1e30].into_iter().enumerate() {
        let mut fields = fields.clone();
        fields[at].1 = number(wrong);
        assert!(Stir::parse(&object(&fields)).is_err());
    }
}

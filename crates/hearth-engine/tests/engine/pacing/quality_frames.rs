//! Adaptive quality with irregular frames: other displays, busy pages, coarse clocks.

use hearth_core::resolution::Level;
use hearth_engine::pacing::quality::{FrameCost, Quality};
use hearth_engine::pacing::thread_budget::SHARE_OF_WORKER;

/// Interval of a display of 60 Hz \[ms\].
const DISPLAY: f64 = 1000.0 / 60.0;

#[test]
fn slow_steps_of_a_fixed_number_of_particles_leave_the_picture() {
    // Each frame makes one step, which is longer than the frame.
    let mut quality = Quality::new(None, Level::Medium);
    for frame in 1..1800 {
        quality.frame(&FrameCost {
            now: 33.4 * f64::from(frame),
            steps_ms: 30.0,
            simulated: 0.002,
            slowed: true,
            particles: None,
            ..idle()
        });
    }
    assert_eq!(quality.level(), Level::Medium, "{}", quality.reason());
}

/// A frame of a cheap fire.
fn idle() -> FrameCost {
    FrameCost {
        now: 0.0,
        min_interval: 0.0,
        steps_ms: 2.0,
        simulated: DISPLAY * 1e-3,
        draw_ms: 0.5,
        pixels: Some(1280.0 * 800.0),
        time_scale: 1.0,
        slowed: false,
        particles: Some(Level::ALL.map(Level::particles)),
        fires: 1,
        share: SHARE_OF_WORKER,
    }
}

/// Adds frames of a cheap fire with these intervals.
fn frames(quality: &mut Quality, now: &mut f64, gaps: impl IntoIterator<Item = f64>) {
    for gap in gaps {
        *now += gap;
        let (made, steps_ms) = (gap * 1e-3, 0.2 * gap);
        quality.frame(&FrameCost {
            now: *now,
            simulated: made,
            steps_ms,
            ..idle()
        });
    }
}

#[test]
fn a_slower_display_does_not_lower_the_level() {
    let mut quality = Quality::new(None, Level::High);
    let mut now = 0.0;
    // A window moves from a display of 120 Hz to one of 60 Hz and back.
    for _ in 0..5 {
        frames(&mut quality, &mut now, [1000.0 / 120.0; 1200]);
        assert_eq!(quality.level(), Level::High, "{}", quality.reason());
        frames(&mut quality, &mut now, [1000.0 / 60.0; 600]);
        assert_eq!(quality.level(), Level::High, "{}", quality.reason());
    }
}

#[test]
fn a_few_short_intervals_are_no_faster_display() {
    let mut quality = Quality::new(None, Level::High);
    let mut now = 0.0;
    for _ in 0..60 {
        frames(&mut quality, &mut now, [8.0; 3]);
        frames(&mut quality, &mut now, [1000.0 / 60.0; 57]);
        // Intervals that jitter.
        frames(&mut quality, &mut now, [15.7, 17.7].repeat(30));
    }
    assert_eq!(quality.level(), Level::High, "{}", quality.reason());
}

#[test]
fn the_reason_distinguishes_rare_frames_from_long_steps() {
    let mut quality = Quality::new(None, Level::Medium);
    let mut now = 0.0;
    frames(&mut quality, &mut now, [1000.0 / 60.0; 30]);
    for _ in 0..60 {
        now += 150.0;
        // The clock makes up for at most a tenth of a second.
        quality.frame(&FrameCost {
            now,
            simulated: 0.1,
            slowed: true,
            ..idle()
        });
    }
    assert_eq!(quality.level(), Level::Low);
    let reason = quality.reason();
    assert!(
        reason.starts_with("pictures come every 150.0 ms"),
        "{reason}"
    );
}

#[test]
fn a_page_that_was_busy_for_a_second_keeps_the_level() {
    let mut quality = Quality::new(None, Level::High);
    let mut now = 0.0;
    frames(&mut quality, &mut now, [1000.0 / 60.0; 120]);
    let mut burn = |gap: f64, times: u32| {
        for _ in 0..times {
            now += gap;
            quality.frame(&FrameCost {
                now,
                simulated: gap * 1e-3,
                slowed: true,
                ..idle()
            });
        }
    };
    burn(200.0, 5);
    // The fire still counts as slowed for a while.
    burn(1000.0 / 60.0, 180);
    assert_eq!(quality.level(), Level::High, "{}", quality.reason());
}

#[test]
fn coarse_clocks_are_sufficient() {
    // The same steps, measured by clocks of different resolution.
    let tried = |tick: f64, rate: f64| {
        let mut quality = Quality::new(None, Level::Medium);
        let (mut now, mut busy) = (0.0_f64, 0.3_f64);
        for _ in 0..45 {
            now += DISPLAY;
            let made = DISPLAY * 1e-3;
            let started = busy;
            busy += DISPLAY;
            let read = |time: f64| (time / tick).floor() * tick;
            let steps_ms = read(started + rate * made) - read(started);
            quality.frame(&FrameCost {
                now,
                steps_ms,
                simulated: made,
                ..idle()
            });
        }
        (quality.level(), quality.reason().to_owned())
    };
    for tick in [0.005, 1.0, 2.0, 4.0] {
        for (rate, level) in [
            (60.0, Level::High),
            (500.0, Level::Medium),
            (2000.0, Level::Low),
        ] {
            let (seen, reason) = tried(tick, rate);
            assert_eq!(seen, level, "a clock of {tick} ms, {reason}");
            assert!(!reason.contains("take 0.0 ms"), "{reason}");
        }
    }
}

#[test]
fn several_fires_share_the_frame() {
    let mut quality = Quality::new(None, Level::Medium);
    let mut now = 0.0;
    for _ in 0..600 {
        now += DISPLAY;
        quality.frame(&FrameCost {
            now,
            steps_ms: 6.0,
            draw_ms: 1.0,
            fires: 4,
            ..idle()
        });
    }
    assert_eq!(quality.level(), Level::Low);
}

#[test]
fn a_fire_with_a_limited_frame_rate_is_not_late() {
    let mut quality = Quality::new(None, Level::Medium);
    for frame in 0..300 {
        quality.frame(&FrameCost {
            now: 100.0 * f64::from(frame),
            min_interval: 100.0,
            simulated: 0.1,
            ..idle()
        });
    }
    assert!(quality.level() >= Level::Medium, "{}", quality.reason());
}

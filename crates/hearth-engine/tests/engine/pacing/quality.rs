//! Adaptive quality on machines of every speed.

use hearth_core::params::{IN_DOMAIN, Parameters};
use hearth_core::resolution::Level;
use hearth_engine::pacing::quality::{FrameCost, Quality};
use hearth_engine::pacing::thread_budget::SHARE_OF_WORKER;

/// A machine and its display.
#[derive(Clone, Copy)]
struct Machine {
    /// Time of a second of fire with 3,000 particles \[ms\].
    steps: f64,
    /// Time of drawing a picture of medium quality \[ms\].
    draw: f64,
    /// The same on a graphics card without a timer \[ms\].
    hidden: f64,
    /// Time between two frames of the display \[ms\].
    display: f64,
}

const FAST: Machine = Machine {
    steps: 120.0,
    draw: 0.5,
    hidden: 1.0,
    display: 1000.0 / 60.0,
};

/// A fire with a simulated clock.
struct Burning {
    quality: Quality,
    now: f64,
    /// Pixels of its element; none if its picture has a limit.
    pixels: Option<f64>,
    changes: Vec<(Level, String)>,
}

impl Burning {
    fn from(guess: Level) -> Burning {
        Burning {
            quality: Quality::new(None, guess),
            now: 0.0,
            pixels: Some(1280.0 * 800.0),
            changes: Vec::new(),
        }
    }

    /// Simulates frames for a duration \[s\].
    fn on(&mut self, machine: Machine, seconds: f64, particles: bool) -> &mut Burning {
        let end = self.now + 1000.0 * seconds;
        let mut gap = machine.display;
        while self.now < end {
            let level = self.quality.level();
            let more = f64::from(level.particles()) / 3000.0;
            let share = self.quality.pixels() / level.pixels();
            let picture = share * [0.6, 1.0, 1.8][level as usize];
            let rate = machine.steps * if particles { more.powf(1.5) } else { 1.0 };
            // The engine drops steps beyond its budget.
            let due_ms = rate * gap.min(100.0) * 1e-3;
            let steps_ms = due_ms.min(12.0);
            let draw_ms = machine.draw * picture;
            let busy = (steps_ms + draw_ms).max(machine.hidden * picture);
            gap = (busy / machine.display).ceil().max(1.0) * machine.display;
            self.now += gap;
            let changed = self.quality.frame(&FrameCost {
                now: self.now,
                min_interval: 0.0,
                steps_ms,
                simulated: steps_ms / rate,
                draw_ms,
                pixels: self.pixels,
                time_scale: 1.0,
                slowed: due_ms > 1.06 * steps_ms,
                particles: particles.then(|| Level::ALL.map(Level::particles)),
                fires: 1,
                share: SHARE_OF_WORKER,
            });
            if changed {
                let level = self.quality.level();
                self.changes.push((level, self.quality.reason().to_owned()));
            }
        }
        self
    }

    fn level(&self) -> Level {
        self.quality.level()
    }
}

/// The level on which a machine settles after a guess.
fn settled(machine: Machine, guess: Level) -> Level {
    Burning::from(guess).on(machine, 120.0, true).level()
}

#[test]
fn the_medium_level_has_the_default_number_of_particles() {
    assert_eq!(IN_DOMAIN, Level::Medium.particles());
    // The default spacing has three digits.
    let default = f64::from(Parameters::default().domain_particles());
    assert!((default / f64::from(IN_DOMAIN) - 1.0).abs() < 3e-3);
}

#[test]
fn a_fast_machine_rises_and_a_slow_one_falls_within_a_second() {
    for guess in Level::ALL {
        let mut fast = Burning::from(guess);
        assert_eq!(fast.on(FAST, 1.0, true).level(), Level::High);
        let slow = Machine {
            steps: 2000.0,
            ..FAST
        };
        assert_eq!(Burning::from(guess).on(slow, 1.0, true).level(), Level::Low);
    }
}

#[test]
fn the_level_stays_if_steps_fill_the_frame_well() {
    // Steps take 10 of 16.7 ms.
    let machine = Machine {
        steps: 600.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    burning.on(machine, 120.0, true);
    assert_eq!(burning.changes, []);
}

#[test]
fn a_faster_display_leaves_less_time_for_drawing() {
    let at = |display| settled(Machine { display, ..FAST }, Level::Medium);
    assert_eq!(at(1000.0 / 60.0), Level::High);
    // Steps per frame decrease with the interval; drawing does not.
    let drawing = |display| {
        settled(
            Machine {
                draw: 4.0,
                display,
                ..FAST
            },
            Level::High,
        )
    };
    assert_eq!(drawing(1000.0 / 60.0), Level::High);
    assert!(drawing(1000.0 / 144.0) < Level::High);
}

#[test]
fn a_fire_that_exceeds_its_frames_falls_with_a_reason() {
    let mut burning = Burning::from(Level::Medium);
    burning.on(FAST, 10.0, true);
    let busy = Machine {
        steps: 900.0,
        draw: 4.0,
        ..FAST
    };
    burning.on(busy, 4.0, true);
    assert_eq!(burning.level(), Level::Low);
    let (_, reason) = burning.changes.last().expect("a change");
    assert!(reason.starts_with("steps and drawing took "), "{reason}");
    assert!(reason.contains(" ms for a frame of 16.7 ms: "), "{reason}");
    assert!(
        reason.ends_with("1,500 particles instead of 6,700"),
        "{reason}"
    );
}

#[test]
fn late_pictures_reveal_a_slow_graphics_card() {
    let machine = Machine {
        hidden: 30.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    burning.on(machine, 15.0, true);
    assert_eq!(burning.level(), Level::Low);
    let (_, reason) = burning.changes.last().expect("a change");
    assert!(
        reason.starts_with("pictures come every 33.3 ms for a frame of 16.7 ms: "),
        "{reason}"
    );
}

#[test]
fn pictures_that_take_long_at_the_lowest_level_have_fewer_pixels() {
    let share = |fire: &Burning| fire.quality.pixels() / Level::Low.pixels();
    // The drawing of a quarter, a half and all of the pixels that the lowest level has.
    for (all_pixels, kept) in [(6.0, 1.0), (18.0, 0.5), (90.0, 0.25)] {
        let machine = Machine {
            draw: all_pixels / 0.6,
            ..FAST
        };
        let mut fire = Burning::from(Level::Low);
        fire.on(machine, 60.0, true);
        assert_eq!((fire.level(), share(&fire)), (Level::Low, kept));
        if kept < 1.0 {
            let reason = fire.quality.reason();
            assert!(reason.ends_with("a coarser picture"), "{reason}");
        }
        fire.on(FAST, 120.0, true);
        assert!(fire.level() > Level::Low, "{:?}", fire.quality);
    }
    // Long steps leave the picture.
    let mut fire = Burning::from(Level::Low);
    fire.on(
        Machine {
            steps: 2000.0,
            ..FAST
        },
        60.0,
        true,
    );
    assert_eq!((fire.level(), share(&fire)), (Level::Low, 1.0));
    // So do drawing that no fewer pixels shorten, and a requested level.
    for pixels in [None, Some(480.0 * 270.0)] {
        let mut fire = Burning::from(Level::Low);
        fire.pixels = pixels;
        fire.on(Machine { draw: 90.0, ..FAST }, 60.0, true);
        assert_eq!(share(&fire), 1.0);
    }
    let mut fire = Burning::from(Level::Low);
    fire.quality.request(Some(Level::Low));
    fire.on(Machine { draw: 90.0, ..FAST }, 60.0, true);
    assert_eq!(share(&fire), 1.0);
}

#[test]
fn a_slow_display_does_not_keep_the_lowest_level() {
    let machine = Machine {
        display: 1000.0 / 30.0,
        ..FAST
    };
    assert!(settled(machine, Level::Medium) > Level::Low);
}

#[test]
fn a_long_pause_changes_no_level() {
    let machine = Machine {
        steps: 600.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    burning.on(machine, 10.0, true);
    burning.now += 5000.0;
    burning.on(machine, 10.0, true);
    assert_eq!(burning.changes, []);
}

#[test]
fn the_level_changes_at_most_eleven_times_in_an_hour() {
    let slow = Machine {
        steps: 1500.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    // Another program slows the machine every minute.
    for _ in 0..60 {
        burning.on(FAST, 50.0, true).on(slow, 10.0, true);
    }
    let changes = burning.changes.len();
    assert!(changes <= 11, "{changes} changes in an hour");
}

#[test]
fn with_a_fixed_number_of_particles_only_drawing_counts() {
    let heavy = Machine {
        steps: 5000.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    burning.on(heavy, 60.0, false);
    assert!(
        burning.level() >= Level::Medium,
        "a coarser picture would not help"
    );
    let mut drawing = Burning::from(Level::High);
    drawing.on(Machine { draw: 12.0, ..FAST }, 10.0, false);
    assert_eq!(drawing.level(), Level::Low);
    let (_, reason) = drawing.changes.last().expect("a change");
    assert!(reason.ends_with("a coarser picture"), "{reason}");
}

#[test]
fn fast_displays_have_adaptive_quality() {
    for display in [240.0, 280.0, 360.0, 480.0].map(|rate| 1000.0 / rate) {
        let mut burning = Burning::from(Level::Low);
        burning.on(Machine { display, ..FAST }, 60.0, true);
        assert_eq!(burning.level(), Level::High, "{display} ms");
        let slow = Machine {
            steps: 2000.0,
            display,
            ..FAST
        };
        assert_eq!(settled(slow, Level::Medium), Level::Low, "{display} ms");
    }
}

#[test]
fn a_requested_level_stays() {
    for level in Level::ALL {
        let mut burning = Burning::from(Level::Medium);
        burning.quality.request(Some(level));
        burning.on(
            Machine {
                steps: 5000.0,
                ..FAST
            },
            20.0,
            true,
        );
        burning.on(FAST, 20.0, true);
        assert_eq!((burning.level(), burning.changes.len()), (level, 0));
        assert_eq!(burning.quality.reason(), "as requested");
        // Adaptive again, the level rises.
        burning.quality.request(None);
        burning.on(FAST, 60.0, true);
        assert_eq!(burning.level(), Level::High);
    }
}

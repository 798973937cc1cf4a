//! A fire that finds its quality itself, on machines of every speed.

use hearth_core::params::{Model, Param, Value};
use hearth_engine::quality::{Frame, Level, Quality};

/// A machine and the display before it.
#[derive(Clone, Copy)]
struct Machine {
    /// Time of a second of fire with 3,000 particles \[ms\].
    steps: f64,
    /// Time of drawing a picture of medium quality \[ms\].
    draw: f64,
    /// The same on the graphics card, which nobody measures \[ms\].
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

/// A fire on a machine, and its clock.
struct Burning {
    quality: Quality,
    now: f64,
    changes: Vec<(Level, String)>,
}

impl Burning {
    fn from(guess: Level) -> Burning {
        Burning {
            quality: Quality::new(None, guess),
            now: 0.0,
            changes: Vec::new(),
        }
    }

    /// Burns on for so many seconds.
    fn on(&mut self, machine: Machine, seconds: f64, particles: bool) -> &mut Burning {
        let end = self.now + 1000.0 * seconds;
        let mut gap = machine.display;
        while self.now < end {
            let level = self.quality.level();
            let more = f64::from(level.particles()) / 3000.0;
            let picture = [0.6, 1.0, 1.8][level as usize];
            let rate = machine.steps * if particles { more.powf(1.5) } else { 1.0 };
            // The engine's budget; the rest is dropped.
            let wanted = rate * gap.min(100.0) * 1e-3;
            let steps_ms = wanted.min(12.0);
            let draw_ms = machine.draw * picture;
            let busy = (steps_ms + draw_ms).max(machine.hidden * picture);
            gap = (busy / machine.display).ceil().max(1.0) * machine.display;
            self.now += gap;
            let changed = self.quality.frame(&Frame {
                now: self.now,
                apart: 0.0,
                steps_ms,
                made: steps_ms / rate,
                draw_ms,
                time_scale: 1.0,
                slowed: wanted > 1.06 * steps_ms,
                particles: particles.then(|| Level::ALL.map(Level::particles)),
                fires: 1,
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

/// Where a machine ends that starts from a guess.
fn settled(machine: Machine, guess: Level) -> Level {
    Burning::from(guess).on(machine, 120.0, true).level()
}

#[test]
fn medium_is_what_the_table_says_of_particles() {
    let param = Param::find("max_particles").expect("it is in the table");
    let default = param.any_domain(Model::Combustion).default;
    assert_eq!(default, Value::Integer(Level::Medium.particles()));
}

#[test]
fn a_fast_machine_takes_more_and_a_slow_one_less_within_a_second() {
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
fn where_the_frame_is_well_filled_it_stays() {
    // Ten of 16.7 ms.
    let machine = Machine {
        steps: 600.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    burning.on(machine, 120.0, true);
    assert_eq!(burning.changes, []);
}

#[test]
fn a_faster_display_leaves_less_room() {
    let at = |display| settled(Machine { display, ..FAST }, Level::Medium);
    assert_eq!(at(1000.0 / 60.0), Level::High);
    // There are fewer steps a frame as well; drawing is what counts.
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
fn what_does_not_fit_makes_way_and_says_why() {
    let mut burning = Burning::from(Level::Medium);
    burning.on(FAST, 10.0, true);
    let busy = Machine {
        steps: 900.0,
        draw: 4.0,
        ..FAST
    };
    burning.on(busy, 4.0, true);
    assert_eq!(burning.level(), Level::Low);
    let (_, reason) = burning.changes.last().expect("it has changed");
    assert!(reason.starts_with("steps and drawing took "), "{reason}");
    assert!(reason.contains(" ms for a frame of 16.7 ms: "), "{reason}");
    assert!(
        reason.ends_with("1,200 particles instead of 6,700"),
        "{reason}"
    );
}

#[test]
fn a_slow_graphics_card_is_noticed_by_late_pictures() {
    let machine = Machine {
        hidden: 30.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    burning.on(machine, 15.0, true);
    assert_eq!(burning.level(), Level::Low);
    let (_, reason) = burning.changes.last().expect("it has changed");
    assert!(
        reason.starts_with("pictures come every 33.3 ms for a frame of 16.7 ms: "),
        "{reason}"
    );
}

#[test]
fn a_slow_display_is_not_the_fires_fault_for_ever() {
    let machine = Machine {
        display: 1000.0 / 30.0,
        ..FAST
    };
    assert!(settled(machine, Level::Medium) > Level::Low);
}

#[test]
fn one_long_pause_changes_nothing() {
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
fn it_never_flaps() {
    let slow = Machine {
        steps: 1500.0,
        ..FAST
    };
    let mut burning = Burning::from(Level::Medium);
    // A machine that is busy with something else every minute.
    for _ in 0..60 {
        burning.on(FAST, 50.0, true).on(slow, 10.0, true);
    }
    let changes = burning.changes.len();
    assert!(changes <= 11, "{changes} changes in an hour");
}

#[test]
fn where_the_number_of_particles_is_somebody_elses_only_drawing_counts() {
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
    let (_, reason) = drawing.changes.last().expect("it has changed");
    assert!(reason.ends_with("a coarser picture"), "{reason}");
}

#[test]
fn steps_that_somebody_asked_for_make_no_coarser_picture() {
    // One step is longer than a frame, and at least one is made in each.
    let mut quality = Quality::new(None, Level::Medium);
    for frame in 1..1800 {
        quality.frame(&Frame {
            now: 33.4 * f64::from(frame),
            steps_ms: 30.0,
            made: 0.002,
            slowed: true,
            particles: None,
            ..idle()
        });
    }
    assert_eq!(quality.level(), Level::Medium, "{}", quality.reason());
}

/// A frame of a fire that takes next to nothing.
fn idle() -> Frame {
    Frame {
        now: 0.0,
        apart: 0.0,
        steps_ms: 2.0,
        made: FAST.display * 1e-3,
        draw_ms: 0.5,
        time_scale: 1.0,
        slowed: false,
        particles: Some(Level::ALL.map(Level::particles)),
        fires: 1,
    }
}

/// Frames of a fire that has room, so long after one another.
fn frames(quality: &mut Quality, now: &mut f64, gaps: impl IntoIterator<Item = f64>) {
    for gap in gaps {
        *now += gap;
        let (made, steps_ms) = (gap * 1e-3, 0.2 * gap);
        quality.frame(&Frame {
            now: *now,
            made,
            steps_ms,
            ..idle()
        });
    }
}

#[test]
fn a_display_may_become_slower() {
    let mut quality = Quality::new(None, Level::High);
    let mut now = 0.0;
    // A window goes from a display of 120 Hz to one of 60, and back, and again.
    for _ in 0..5 {
        frames(&mut quality, &mut now, [1000.0 / 120.0; 1200]);
        assert_eq!(quality.level(), Level::High, "{}", quality.reason());
        frames(&mut quality, &mut now, [1000.0 / 60.0; 600]);
        assert_eq!(quality.level(), Level::High, "{}", quality.reason());
    }
}

#[test]
fn a_few_short_gaps_are_no_faster_display() {
    let mut quality = Quality::new(None, Level::High);
    let mut now = 0.0;
    for _ in 0..60 {
        frames(&mut quality, &mut now, [8.0; 3]);
        frames(&mut quality, &mut now, [1000.0 / 60.0; 57]);
        // Times of frames that are not quite even.
        frames(&mut quality, &mut now, [15.7, 17.7].repeat(30));
    }
    assert_eq!(quality.level(), Level::High, "{}", quality.reason());
}

#[test]
fn the_fastest_displays_count_too() {
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
fn rare_frames_of_a_page_are_not_called_long_steps() {
    let mut quality = Quality::new(None, Level::Medium);
    let mut now = 0.0;
    frames(&mut quality, &mut now, [1000.0 / 60.0; 30]);
    for _ in 0..60 {
        now += 150.0;
        // What comes later than a tenth of a second is not made up for.
        quality.frame(&Frame {
            now,
            made: 0.1,
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
fn a_page_that_was_busy_for_a_second_costs_no_particles() {
    let mut quality = Quality::new(None, Level::High);
    let mut now = 0.0;
    frames(&mut quality, &mut now, [1000.0 / 60.0; 120]);
    let mut burn = |gap: f64, times: u32| {
        for _ in 0..times {
            now += gap;
            quality.frame(&Frame {
                now,
                made: gap * 1e-3,
                slowed: true,
                ..idle()
            });
        }
    };
    burn(200.0, 5);
    // For a while it still counts as slow.
    burn(1000.0 / 60.0, 180);
    assert_eq!(quality.level(), Level::High, "{}", quality.reason());
}

#[test]
fn a_clock_that_ticks_rarely_is_enough() {
    // The same steps by clocks that tick every 0.005, 1, 2 and 4 ms.
    let tried = |tick: f64, rate: f64| {
        let mut quality = Quality::new(None, Level::Medium);
        let (mut now, mut busy) = (0.0_f64, 0.3_f64);
        for _ in 0..45 {
            now += FAST.display;
            let made = FAST.display * 1e-3;
            let started = busy;
            busy += FAST.display;
            let read = |time: f64| (time / tick).floor() * tick;
            let steps_ms = read(started + rate * made) - read(started);
            quality.frame(&Frame {
                now,
                steps_ms,
                made,
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
fn what_somebody_asks_for_stays() {
    for level in Level::ALL {
        let mut burning = Burning::from(Level::Medium);
        burning.quality.ask(Some(level));
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
        assert_eq!(burning.quality.reason(), "as asked for");
        // And left to itself again, it finds its own.
        burning.quality.ask(None);
        burning.on(FAST, 60.0, true);
        assert_eq!(burning.level(), Level::High);
    }
}

#[test]
fn several_fires_share_the_frame() {
    let mut quality = Quality::new(None, Level::Medium);
    let mut now = 0.0;
    for _ in 0..600 {
        now += FAST.display;
        quality.frame(&Frame {
            now,
            apart: 0.0,
            steps_ms: 6.0,
            made: FAST.display * 1e-3,
            draw_ms: 1.0,
            time_scale: 1.0,
            slowed: false,
            particles: Some(Level::ALL.map(Level::particles)),
            fires: 4,
        });
    }
    assert_eq!(quality.level(), Level::Low);
}

#[test]
fn a_fire_that_is_to_draw_seldom_is_not_late() {
    let mut quality = Quality::new(None, Level::Medium);
    for frame in 0..300 {
        quality.frame(&Frame {
            now: 100.0 * f64::from(frame),
            apart: 100.0,
            made: 0.1,
            ..idle()
        });
    }
    assert!(quality.level() >= Level::Medium, "{}", quality.reason());
}

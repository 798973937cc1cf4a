//! The number of particles of a fire, and its reason.

use hearth_core::resolution::CountLimit::{Machine, Settings, Size};
use hearth_core::resolution::Level::{self, High, Low, Medium};
use hearth_core::resolution::Resolution::{Classic, Page, Scene};
use hearth_core::resolution::SizeLimit;
use hearth_core::resolution::{CountInputs, CountLimit, ParticleCount, Resolution};

/// A fire of medium quality in a large element on a fast machine.
fn usual(settings: Resolution) -> CountInputs {
    CountInputs {
        settings,
        level: Medium,
        is_level_requested: false,
        size: SizeLimit::default(),
        machine: u32::MAX,
        is_coarse: false,
    }
}

fn count(inputs: &CountInputs) -> (u32, CountLimit) {
    let ParticleCount { number, limit } = ParticleCount::of(inputs);
    (number, limit)
}

#[test]
fn the_number_follows_from_settings_level_size_and_machine() {
    let by_level = CountLimit::Level;
    // Settings, level, whether a page requested it, side, particles in time; number, limit.
    let table = [
        (
            Resolution::Level,
            Low,
            false,
            600.0,
            u32::MAX,
            1500,
            by_level(Low),
        ),
        (
            Resolution::Level,
            Medium,
            false,
            600.0,
            u32::MAX,
            3000,
            by_level(Medium),
        ),
        (
            Resolution::Level,
            High,
            false,
            600.0,
            u32::MAX,
            6700,
            by_level(High),
        ),
        (Resolution::Level, High, false, 64.0, u32::MAX, 300, Size),
        (
            Resolution::Level,
            High,
            true,
            64.0,
            u32::MAX,
            6700,
            by_level(High),
        ),
        // Levels have limits of their own.
        (
            Resolution::Level,
            High,
            false,
            600.0,
            500,
            6700,
            by_level(High),
        ),
        (Scene(4000), Low, false, 600.0, u32::MAX, 4000, Settings),
        (Scene(4000), High, false, 64.0, u32::MAX, 300, Size),
        (Scene(4000), High, true, 64.0, u32::MAX, 4000, Settings),
        (Scene(4000), High, true, 64.0, 1000, 1000, Machine),
        (Scene(4000), High, false, 64.0, 1000, 300, Size),
        (Page(20_000), Low, false, 64.0, u32::MAX, 20_000, Settings),
        (Page(20_000), Low, false, 64.0, 10_000, 10_000, Machine),
        (Classic(1500), Low, false, 64.0, u32::MAX, 1500, Settings),
        (Classic(1500), Low, false, 64.0, 1000, 1000, Machine),
    ];
    for (settings, level, is_level_requested, side, machine, number, limit) in table {
        let inputs = CountInputs {
            level,
            is_level_requested,
            size: SizeLimit::of(side),
            machine,
            ..usual(settings)
        };
        assert_eq!(count(&inputs), (number, limit), "{inputs:?}");
    }
}

#[test]
fn the_first_part_of_a_warm_up_has_a_quarter_of_the_particles() {
    for (settings, coarse) in [
        (Resolution::Level, 750),
        (Scene(4000), 1000),
        (Page(20_000), 5000),
        // At least 600, if there are as many.
        (Page(1000), 600),
        (Page(500), 500),
        (Classic(4000), 4000),
    ] {
        let inputs = CountInputs {
            is_coarse: true,
            ..usual(settings)
        };
        let (number, limit) = count(&inputs);
        assert_eq!(number, coarse, "{settings:?}");
        assert_eq!(
            limit,
            count(&usual(settings)).1,
            "the limit is that of the fire"
        );
    }
}

#[test]
fn statistics_name_every_limit() {
    let levels = Level::ALL.map(|level| CountLimit::Level(level).name());
    assert_eq!(levels, ["quality low", "quality medium", "quality high"]);
    let others = [Settings, Size, Machine].map(CountLimit::name);
    assert_eq!(others, ["", "size", "speed"]);
}

//! Settings, links and attributes without a spacing, with open edges: the resolution is that of their
//! number of particles in their domain.

use crate::harness::{after, at_level, imported, set, text};
use hearth_core::Simulation;
use hearth_core::params::{IN_DOMAIN, Parameters};
use hearth_core::preset::Preset;
use hearth_core::resolution::Level;
use hearth_core::resolution::Resolution;
use hearth_core::resolution::SizeLimit;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, export};

/// Width and height of the domain \[m\], and the number of particles at medium quality.
type Box = (f32, f32, u32);

/// Scenes with the combustion model: their domains, and their numbers of particles.
const SCENES: [(&str, Box); 11] = [
    ("default", (1.2, 1.8, 3000)),
    ("bonfire-in-wind", (2.8, 2.0, 4000)),
    ("campfire", (1.8, 1.8, 3000)),
    ("candle", (0.42, 0.5, 3000)),
    ("fireside", (1.6, 1.6, 2000)),
    ("forge", (2.8, 1.15, 3000)),
    ("gas-burner", (0.31, 0.35, 3014)),
    ("ghost-fire", (1.1, 1.6, 3000)),
    ("match", (0.42, 0.5, 3000)),
    ("smoke-stack", (1.6, 2.2, 3000)),
    ("torch", (1.0, 1.3, 3000)),
];

/// Links, and the boxes that they open.
const LINKS: [(&str, Box); 26] = [
    ("", (1.2, 1.8, 3000)),
    ("scene=default&wind=1.5&turbulence=2", (1.2, 1.8, 3000)),
    ("seam=0.03", (1.2, 1.8, 3000)),
    ("particles=5000", (1.2, 1.8, 5000)),
    ("particles=3000", (1.2, 1.8, 3000)),
    ("particles=200", (1.2, 1.8, 200)),
    ("particles=100000&seed=7", (1.2, 1.8, 100_000)),
    ("domain-width=4&domain-height=2.4", (4.0, 2.4, 3000)),
    (
        "domain-width=4&domain-height=2.4&particles=15000&wind=1",
        (4.0, 2.4, 15_000),
    ),
    (
        "domain-width=6&domain-height=6&particles=200",
        (6.0, 6.0, 200),
    ),
    (
        "domain-width=0.1&domain-height=0.1&particles=100000",
        (0.1, 0.1, 100_000),
    ),
    ("domain_height=3", (1.2, 3.0, 3000)),
    (
        "fuel-power=600&source-width=1&domain-width=3",
        (3.0, 1.8, 3000),
    ),
    ("scene=candle", (0.42, 0.5, 3000)),
    (
        "scene=candle&seam=0.1&source-height=0.05",
        (0.42, 0.5, 3000),
    ),
    ("preset=candle&particles=1200", (0.42, 0.5, 1200)),
    ("scene=fireside", (1.6, 1.6, 2000)),
    ("scene=fireside&domain-width=2.4", (2.4, 1.6, 2000)),
    ("scene=fireside&particles=6700", (1.6, 1.6, 6700)),
    (
        "scene=fireside&domain-height=2&particles=2000&seam=0.07",
        (1.6, 2.0, 2000),
    ),
    ("scene=bonfire-in-wind&wind=-2", (2.8, 2.0, 4000)),
    (
        "scene=bonfire-in-wind&domain-height=3&domain-width=3",
        (3.0, 3.0, 4000),
    ),
    (
        "scene=forge&domain-width=1.4&ember-rate=1000",
        (1.4, 1.15, 3000),
    ),
    ("scene=wall-of-fire&time-scale=1", (2.8, 1.4, 3000)),
    (
        "scene=smoke-stack&domain-width=3&particles=9000",
        (3.0, 2.2, 9000),
    ),
    (
        "scene=torch&palette=copper&domain-height=2.6",
        (1.0, 2.6, 3000),
    ),
];

/// The preset and the values of a link, with open edges.
fn read(link: &str) -> (String, Vec<(String, Untrusted)>) {
    let mut preset = "default".to_owned();
    let edges = Untrusted::field_of("edges", text("open"));
    let is_classic = link.contains("model=classic");
    let mut values: Vec<_> = (!is_classic).then_some(edges).into_iter().collect();
    for (name, value) in link.split('&').filter_map(|pair| pair.split_once('=')) {
        match name {
            "scene" | "preset" => preset = value.to_owned(),
            _ => values.push(Untrusted::field_of(&name.replace('-', "_"), text(value))),
        }
    }
    (preset, values)
}

/// The settings that a link requests: as a file, and as attributes in both orders.
fn opened(link: &str) -> [Settings; 3] {
    let (preset, values) = read(link);
    let file = Untrusted::Object(vec![
        Untrusted::field_of("hearth", Untrusted::Number(3.0)),
        Untrusted::field_of("preset", text(&preset)),
        Untrusted::field_of("values", Untrusted::Object(values.clone())),
    ]);
    let attributes = |values: &mut dyn Iterator<Item = &(String, Untrusted)>| {
        let first = after(&Settings::default(), Change::Preset(&preset));
        values.fold(first, |settings, value| {
            after(&settings, Change::Set(std::slice::from_ref(value)))
        })
    };
    [
        imported(&file),
        attributes(&mut values.iter()),
        attributes(&mut values.iter().rev()),
    ]
}

fn assert_opens_as(settings: &Settings, (width, height, number): Box, name: &str) {
    let values = settings.completed();
    assert!(values.has_open_edges());
    assert_eq!(
        (values.domain_width, values.domain_height),
        (width, height),
        "{name}"
    );
    let expected = (width * height / number as f32).sqrt();
    let off = values.spacing() / expected - 1.0;
    assert!(
        off.abs() < 2e-3,
        "{name}: {} m for {expected} m",
        values.spacing()
    );
    let cap = (2 * number).min(100_000);
    assert!(
        values.max_particles >= cap,
        "{name}: {} particles",
        values.max_particles
    );
    // A page reads the spacing that the fire has.
    assert_eq!(settings.parameters().spacing, values.spacing, "{name}");
}

#[test]
fn scenes_and_links_without_a_spacing_have_the_resolution_of_their_number_of_particles() {
    for (name, closed) in SCENES {
        for settings in opened(&format!("scene={name}")) {
            assert_opens_as(&settings, closed, name);
        }
    }
    for (link, closed) in LINKS {
        let [file, forward, backward] = opened(link);
        assert_opens_as(&file, closed, link);
        for attributes in [forward, backward] {
            assert_eq!(attributes.completed(), file.completed(), "{link}");
            assert_eq!(attributes.parameters(), file.parameters(), "{link}");
        }
        // And once more, after an export.
        let again = imported(&export(&file));
        assert_eq!(again.completed(), file.completed(), "{link}");
        assert_eq!(again, file, "{link}");
    }
}

#[test]
fn periodic_edges_and_the_classic_model_keep_their_box() {
    for (link, (width, height, number)) in LINKS {
        let [file, ..] = opened(&format!("{link}&edges=periodic"));
        let values = file.completed();
        assert_eq!((values.domain_width, values.domain_height), (width, height));
        assert_eq!(values.capacity(), number, "{link}");
    }
    for link in ["", "max-particles=500&domain-width=3", "scene=seed"] {
        let [file, ..] = opened(&format!("{link}&model=classic"));
        assert_eq!(file.completed(), *file.parameters(), "{link}");
    }
}

#[test]
fn the_levels_set_the_spacing_of_open_air() {
    let [settings, ..] = opened("domain-width=2.4");
    assert_eq!(settings.resolution(), Resolution::Level);
    for level in Level::ALL {
        let scene = at_level(&settings, level);
        let values = scene.world();
        let number = f64::from(values.domain_particles());
        assert!((number / f64::from(level.particles()) - 1.0).abs() < 0.003);
        assert!(values.max_particles >= 2 * level.particles());
    }
    // A page that names the resolution fixes it.
    for link in ["spacing=0.02", "particles=5000", "particles=3000"] {
        for settings in opened(link) {
            assert!(matches!(settings.resolution(), Resolution::Page(_)));
            let [low, high] = [Level::Low, Level::High].map(|level| at_level(&settings, level));
            assert_eq!(low, high, "{link}");
        }
    }
}

#[test]
fn a_number_of_particles_beside_a_spacing_is_a_cap() {
    for link in [
        "spacing=0.02&max-particles=1500",
        "max-particles=1500&spacing=0.02&domain-width=3",
        "scene=candle&max-particles=1500&spacing=0.02",
    ] {
        for settings in opened(link) {
            let values = settings.completed();
            assert_eq!(
                (values.spacing, values.max_particles),
                (0.02, 1500),
                "{link}"
            );
            assert_eq!(imported(&export(&settings)), settings, "{link}");
        }
    }
    // Without a number, the cap leaves room.
    let [settings, ..] = opened("spacing=0.01");
    assert!(settings.completed().max_particles >= 2 * 21_600);
}

#[test]
fn without_a_spacing_the_resolution_follows_the_frame_again() {
    let [settings, ..] = opened("spacing=0.02");
    let wide = set(&settings, "domain_width", Untrusted::Number(2.4));
    assert_eq!(wide.completed().spacing, 0.02);
    let free = set(&wide, "spacing", Untrusted::Null);
    assert_eq!(free.resolution(), Resolution::Level);
    assert_opens_as(&free, (2.4, 1.8, IN_DOMAIN), "restored");
    let back = set(&free, "domain_width", Untrusted::Null);
    assert_eq!(back.parameters().spacing, Parameters::default().spacing);
}

#[test]
fn the_resolution_of_a_scene_is_that_of_medium_quality_or_its_own() {
    for preset in Preset::all() {
        let values = preset.world();
        if !values.has_open_edges() {
            continue;
        }
        let number = f64::from(values.domain_particles());
        if preset.names("particles") {
            assert!(
                preset.names("spacing"),
                "{}: a cap needs a spacing",
                preset.name
            );
        } else {
            let off = number / f64::from(IN_DOMAIN) - 1.0;
            assert!(off.abs() < 0.01, "{}: {number} particles", preset.name);
        }
        assert!(
            f64::from(values.max_particles) > 1.9 * number,
            "{}",
            preset.name
        );
    }
}

#[test]
fn an_icon_burns_with_a_few_hundred_particles() {
    for link in [
        "",
        "floor=solid&source-height=0",
        "scene=candle",
        "scene=torch",
    ] {
        let [settings, ..] = opened(link);
        let number = SizeLimit::of(64.0).of_level(Level::Medium);
        let mut fire = Simulation::new(settings.at(number));
        let mut most = 0;
        while fire.time() < 2.0 {
            fire.step();
            most = most.max(fire.count());
        }
        assert!((100..=600).contains(&most), "{link}: {most} particles");
        assert!(fire.report().asleep.unwrap_or_default() < 0.3, "{link}");
        let hottest = fire.temperatures().into_iter().fold(0.0, f32::max);
        assert!(hottest > 900.0, "{link}: {hottest} K");
    }
}

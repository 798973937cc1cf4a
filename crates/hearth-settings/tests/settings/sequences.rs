//! Laws of random sequences of changes.

use hearth_core::params::{Kind, PARAMETERS, Param};
use hearth_core::preset::Preset;
use hearth_core::random::Random;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, export, whole};

use crate::harness::{number, object, text};

const SEQUENCES: u32 = 10_000;
const LONGEST: usize = 8;

fn below(random: &mut Random, count: usize) -> usize {
    random.bits() as usize % count
}

/// A parameter; often one whose value decides what others mean.
fn parameter(random: &mut Random) -> &'static Param {
    const DECISIVE: [&str; 7] = [
        "model",
        "edges",
        "spacing",
        "particles",
        "max_particles",
        "domain_width",
        "domain_height",
    ];
    let decisive = DECISIVE.get(below(random, 3 * DECISIVE.len()));
    let found = decisive.and_then(|id| Param::find(id));
    found.unwrap_or(&PARAMETERS[below(random, PARAMETERS.len())])
}

/// A value of a parameter, in the range of either model.
fn value(random: &mut Random, param: &Param) -> Untrusted {
    let domain = &param.domains[below(random, param.domains.len())];
    let (min, max) = domain.range;
    match param.kind {
        Kind::Number(_) => number(min + (max - min) * f64::from(random.unit())),
        Kind::Integer(_) | Kind::Seed => {
            number((min + (max - min) * f64::from(random.unit())).round())
        }
        Kind::Choice(names) => text(names[below(random, names.len())]),
        Kind::Flag => Untrusted::Flag(random.bits() & 1 == 0),
        Kind::Colour => text("#12345678"),
        Kind::Text(_) => text(""),
    }
}

/// The fields of an object: those of a source or of a solid.
fn object_fields(random: &mut Random) -> Vec<(String, Untrusted)> {
    let x = number(f64::from(random.between(-1.0, 1.0)));
    let fields = match below(random, 3) {
        0 => object([("kind", text("source")), ("x", x)]),
        1 => object([("kind", text("source")), ("power", number(50.0))]),
        _ => object([("kind", text("solid")), ("x", x)]),
    };
    fields.fields().to_vec()
}

/// The settings after a random change; the same if the change is refused.
fn changed(random: &mut Random, settings: &Settings) -> Settings {
    let ids: Vec<u32> = settings.scene().objects().map(|object| object.id).collect();
    let id = ids.get(below(random, 4)).copied().unwrap_or(9);
    let fields = object_fields(random);
    let values: Vec<_> = (0..=below(random, 3))
        .map(|_| {
            let param = parameter(random);
            (param.id.to_owned(), value(random, param))
        })
        .collect();
    let null = [(parameter(random).id.to_owned(), Untrusted::Null)];
    let presets = Preset::all();
    let list = [(
        "objects".to_owned(),
        Untrusted::List(vec![Untrusted::Object(fields.clone())]),
    )];
    let change = match below(random, 12) {
        0 => Change::Preset(presets[below(random, presets.len())].name),
        1 => Change::AddObject(&fields),
        2 => Change::ChangeObject(id, &fields[1..]),
        3 => Change::RemoveObject(id),
        4 => Change::Set(&list),
        5 | 6 => Change::Set(&null),
        _ => Change::Set(&values),
    };
    settings.after(&change).unwrap_or_else(|_| settings.clone())
}

#[test]
fn a_file_restores_the_settings_after_any_sequence_of_changes() {
    for seed in 0..SEQUENCES {
        let random = &mut Random::new(seed);
        let mut settings = Settings::default();
        for _ in 0..=below(random, LONGEST) {
            settings = changed(random, &settings);
        }
        for write in [export, whole] {
            let file = write(&settings);
            let read =
                Settings::of_file(&file).unwrap_or_else(|errors| panic!("{seed}: {errors:?}"));
            assert_eq!(write(&read), file, "{seed}");
            assert!(read == settings, "{seed}: {file:?} is {read:?}");
        }
    }
}

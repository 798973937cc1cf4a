//! Laws of random sequences of changes: calls of the page, steps of tools and panel, undo and children.

use hearth_core::params::{Kind, PARAMETERS, Param};
use hearth_core::preset::Preset;
use hearth_core::random::Random;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, delta, export, objects, whole};

use crate::harness::{number, object, text};

const SEQUENCES: u32 = 10_000;
/// Sequences of the slower laws.
const FEWER: u32 = SEQUENCES / 5;
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

/// A random list of up to three children, each of which states up to two properties anew; of any order and without
/// values, or sources first.
fn children(random: &mut Random, of_any_order: bool) -> Vec<Untrusted> {
    let mut numbers: Vec<u32> = (1001..1004).filter(|_| random.bits() & 1 == 0).collect();
    if of_any_order && random.bits() & 1 == 0 {
        numbers.reverse();
    }
    let list = numbers.into_iter().map(|child| {
        let kind = if child == 1003 { "solid" } else { "source" };
        let x = number(f64::from(random.between(-1.0, 1.0)));
        let stated = [
            vec![],
            vec![("x", x.clone())],
            vec![("x", x), ("y", number(0.6))],
        ];
        let stated = stated[below(random, 3)].clone();
        let changed = ["x", "y"]
            .into_iter()
            .filter(|_| random.bits() & 1 == 0)
            .map(text)
            .collect();
        let values = stated
            .into_iter()
            .map(|(name, value)| Untrusted::field_of(name, value));
        let values = match below(random, 5) {
            0 if of_any_order => Untrusted::Null,
            _ => Untrusted::Object(values.collect()),
        };
        object([
            ("id", number(child.into())),
            ("kind", text(kind)),
            ("values", values),
            ("changed", Untrusted::List(changed)),
        ])
    });
    list.collect()
}

/// The settings after a random call or another list of children.
fn changed(random: &mut Random, settings: &Settings) -> Settings {
    match below(random, 5) {
        0 => settings.with_children(&children(random, true), &mut Vec::new()),
        _ => called(random, settings),
    }
}

/// The settings after a random call; the same if it is refused.
fn called(random: &mut Random, settings: &Settings) -> Settings {
    let ids: Vec<u32> = settings.scene().ids().collect();
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
    let mut all = objects(settings.scene()).list().to_vec();
    all.reverse();
    let reversed = [("objects".to_owned(), Untrusted::List(all))];
    let change = match below(random, 14) {
        0 => Change::Preset(presets[below(random, presets.len())].name),
        1 => Change::AddObject(&fields),
        2 => Change::ChangeObject(id, &fields[1..]),
        3 => Change::RemoveObject(id),
        4 => Change::Set(&list),
        5 => Change::State(&list),
        6 | 7 => Change::Set(&null),
        8 => Change::Set(&reversed),
        _ => Change::Set(&values),
    };
    settings.after(&change).unwrap_or_else(|_| settings.clone())
}

/// The numbers of a seed, and the settings after up to so many random changes.
fn random_settings(seed: u32) -> (Random, Settings) {
    let mut random = Random::new(seed);
    let mut settings = Settings::default();
    for _ in 0..=below(&mut random, LONGEST) {
        settings = changed(&mut random, &settings);
    }
    (random, settings)
}

#[test]
fn a_file_restores_the_settings_after_any_sequence_of_changes() {
    for seed in 0..SEQUENCES {
        let (_, settings) = random_settings(seed);
        let file = whole(&settings);
        let read = Settings::of_whole(&file);
        let read = read.unwrap_or_else(|errors| panic!("{seed}: {errors:?}"));
        assert!(read == settings, "{seed}: {file:?}");
        let file = export(&settings);
        let read = Settings::of_file(&file).unwrap_or_else(|errors| panic!("{seed}: {errors:?}"));
        assert_eq!(export(&read), file, "{seed}");
        assert_eq!(read.scene(), settings.scene(), "{seed}");
    }
}

/// The list that the element sends if nothing of its children has changed.
fn same_children(settings: &Settings) -> Vec<Untrusted> {
    let known = whole(settings);
    let list = known.field("children").list().iter().map(|child| {
        let values = match child.field("state").text() {
            "hidden" => Untrusted::Null,
            _ => child.field("values").clone(),
        };
        object([
            ("id", child.field("id").clone()),
            ("kind", child.field("kind").clone()),
            ("values", values),
            ("changed", Untrusted::List(Vec::new())),
        ])
    });
    list.collect()
}

#[test]
fn what_burns_follows_from_the_page_and_the_children_alone() {
    for seed in 0..FEWER {
        let (_, settings) = random_settings(seed);
        let again = settings.with_children(&same_children(&settings), &mut Vec::new());
        assert!(again == settings, "{seed}: {:?}", whole(&settings));
    }
}

#[test]
fn whole_settings_undo_what_calls_have_set_since() {
    for seed in 0..FEWER {
        let (mut random, before) = random_settings(seed);
        let random = &mut random;
        let mut after = before.clone();
        for _ in 0..=below(random, LONGEST) {
            after = called(random, &after);
        }
        let undone = after.after_file(&whole(&before));
        let undone = undone.unwrap_or_else(|errors| panic!("{seed}: {errors:?}"));
        assert!(undone == before, "{seed}: {:?}", whole(&undone));
    }
}

#[test]
fn children_that_come_and_leave_change_nothing_else() {
    let none = |settings: &Settings| settings.with_children(&[], &mut Vec::new());
    for seed in 0..FEWER {
        let (mut random, settings) = random_settings(seed);
        let random = &mut random;
        let bare = none(&settings);
        // An object with the number of a child is that of the child.
        if bare.scene().ids().any(|id| id > 1000) {
            continue;
        }
        let list = children(random, false);
        let mut errors = Vec::new();
        let laid = bare.with_children(&list, &mut errors);
        let again = laid.with_children(&list, &mut errors);
        assert_eq!(errors, [], "{seed}");
        assert!(again == laid, "{seed}: {list:?} laid twice");
        assert_eq!(whole(&none(&laid)), whole(&bare), "{seed}");
    }
}

#[test]
fn undo_of_all_steps_restores_the_page_and_keeps_what_children_state() {
    let page = |settings: &Settings| {
        let whole = whole(settings);
        ["preset", "values", "objects"].map(|part| whole.field(part).clone())
    };
    let stated = |settings: &Settings| {
        let whole = whole(settings);
        let list = whole.field("children").list().iter();
        let stated = list.map(|child| (child.field("id").clone(), child.field("values").clone()));
        stated.collect::<Vec<_>>()
    };
    for seed in 0..FEWER {
        let (mut random, mut settings) = random_settings(seed);
        let random = &mut random;
        let first = page(&settings);
        let mut steps = Vec::new();
        for _ in 0..=below(random, LONGEST) {
            let after = called(random, &settings);
            steps.push((delta(&after, &settings), delta(&settings, &after)));
            settings = after;
            // The page states other children between two steps.
            if below(random, 3) == 0 {
                let list = children(random, true);
                settings = settings.with_children(&list, &mut Vec::new());
            }
        }
        let last = (page(&settings), stated(&settings));
        let moved = |settings: &Settings, delta: &Untrusted| {
            let moved = settings.after_deltas(std::slice::from_ref(delta));
            moved.unwrap_or_else(|errors| panic!("{seed}: {errors:?}"))
        };
        let undone = steps
            .iter()
            .rev()
            .fold(settings, |now, (undo, _)| moved(&now, undo));
        assert_eq!(page(&undone), first, "{seed}");
        assert_eq!(stated(&undone), last.1, "{seed}");
        let redone = steps
            .iter()
            .fold(undone, |now, (_, redo)| moved(&now, redo));
        assert_eq!((page(&redone), stated(&redone)), last, "{seed}");
    }
}

#[test]
fn settings_without_a_difference_have_an_empty_delta() {
    for seed in 0..FEWER {
        let (_, settings) = random_settings(seed);
        assert_eq!(delta(&settings, &settings.clone()).fields(), [], "{seed}");
    }
}

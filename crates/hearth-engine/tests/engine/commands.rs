//! Parsing of calls: their form, and the errors of invalid ones.

use crate::harness::{number, object, sent, text};
use hearth_core::resolution::Level;
use hearth_engine::commands::{
    COMMANDS, Command, MAX_SECONDS, MAX_SIDE, MAX_STEPS, NamedFit, RequestedLevel, Start,
};
use hearth_render::Fit;
use hearth_settings::untrusted::Argument;
use hearth_settings::untrusted::{Check, Form, Untrusted, ValidationError, Whole, Within};

#[track_caller]
fn refused(name: &str, arguments: &[Untrusted]) -> ValidationError {
    match Command::parse(&text(name), arguments) {
        Ok(command) => panic!("{command:?} is accepted"),
        Err(error) => error,
    }
}

#[test]
fn a_command_is_parsed_by_its_arguments() {
    let viscosity = sent([("viscosity", number(0.01))]);
    let values = Untrusted::Object(viscosity.clone());
    let source = "test";
    for (name, arguments, command) in [
        (
            "set",
            vec![values.clone(), text(source)],
            Command::Set {
                values: &viscosity,
                source,
                attributes: &Untrusted::Missing,
            },
        ),
        (
            "import",
            vec![values.clone(), text(source), Untrusted::Flag(true)],
            Command::Import {
                config: &values,
                source,
                keeps_seed: Some(true),
            },
        ),
        (
            "resize",
            vec![number(3.0), number(0.0), number(3.5)],
            Command::Resize {
                width: Whole(3),
                height: Whole(0),
                side: 3.5,
            },
        ),
        ("step", vec![number(5.0)], Command::Step { steps: Whole(5) }),
        (
            "advance",
            vec![number(0.5)],
            Command::Advance {
                seconds: Within(0.5),
            },
        ),
        (
            "warm",
            vec![number(2.5)],
            Command::Warm {
                seconds: Some(Within(2.5)),
            },
        ),
        ("warm", vec![], Command::Warm { seconds: None }),
    ] {
        assert_eq!(Command::parse(&text(name), &arguments), Ok(command));
    }
}

#[test]
fn errors_name_the_argument_that_fails_its_check() {
    let strange = [
        Untrusted::Missing,
        number(f64::NAN),
        number(f64::INFINITY),
        number(1e30),
        text("nothing of this name"),
        Untrusted::Flag(true),
        Untrusted::List(vec![number(1.0)]),
        Untrusted::Object(vec![]),
        Untrusted::Null,
    ];
    let good = |check: &Check| match check.form {
        Form::Any => Untrusted::Missing,
        Form::Finite | Form::Positive(_) => number(1.0),
        Form::Within { min, .. } => number(min.into()),
        Form::Flag => Untrusted::Flag(true),
        Form::Text => text("words"),
        Form::OneOf(names) => text(names[0]),
        Form::Values => Untrusted::Object(vec![]),
    };
    for command in COMMANDS {
        let arguments: Vec<_> = command.arguments.iter().map(|a| good(&a.check)).collect();
        let parsed = Command::parse(&text(command.name), &arguments);
        assert!(parsed.is_ok(), "{}: {parsed:?}", command.name);
        for (at, argument) in command.arguments.iter().enumerate() {
            for value in &strange {
                let mut arguments = arguments.clone();
                arguments[at] = value.clone();
                let Err(error) = Command::parse(&text(command.name), &arguments) else {
                    continue;
                };
                assert!(error.message.contains(argument.id), "{error:?}");
                let words = if argument.id == "ids" && matches!(value, Untrusted::List(_)) {
                    number(1.0)
                } else {
                    value.summary()
                };
                assert_eq!(format!("{:?}", error.value), format!("{words:?}"));
            }
        }
    }
}

#[test]
fn unknown_names_and_wrong_types_are_refused() {
    for name in ["", "plays", "__proto__", "constructor"] {
        let error = refused(name, &[]);
        assert_eq!(error.id, "method");
        assert!(error.message.contains("the name of a command"), "{error:?}");
    }
    for name in [
        Untrusted::Missing,
        Untrusted::Flag(true),
        Untrusted::List(vec![]),
    ] {
        assert!(Command::parse(&name, &[]).is_err());
    }
    let source = || text("test");
    for (name, arguments) in [
        ("add", vec![]),
        ("set", vec![number(1.0), source()]),
        ("set", vec![Untrusted::List(vec![]), source()]),
        ("check", vec![]),
        ("preset", vec![Untrusted::Missing, source()]),
        ("visible", vec![text("yes")]),
        ("advance", vec![]),
    ] {
        refused(name, &arguments);
    }
}

#[test]
fn a_level_of_quality_has_a_name_or_is_adaptive() {
    let names = Level::ALL.map(|level| (level.name(), Some(level)));
    for (name, level) in names.into_iter().chain([("auto", None)]) {
        let quality = RequestedLevel(level);
        let arguments = [text(name)];
        let parsed = Command::parse(&text("quality"), &arguments);
        assert_eq!(parsed, Ok(Command::Quality { quality }));
    }
    for bad in [
        text("best"),
        text(""),
        text("Low"),
        number(1.0),
        Untrusted::Flag(true),
    ] {
        let error = refused("quality", std::slice::from_ref(&bad));
        assert_eq!((error.id.as_str(), &error.value), ("quality", &bad));
        let allowed = "one of auto, low, medium, high";
        assert!(error.message.ends_with(allowed), "{error:?}");
    }
}

#[test]
fn a_start_is_read_field_by_field_and_may_be_empty() {
    let state = Untrusted::Bytes(vec![7, 8]);
    let sent = object([
        ("side", number(3.5)),
        ("warm", number(3.0)),
        ("state", state),
        ("guess", text("low")),
        ("quality", text("auto")),
        ("paused", Untrusted::Flag(true)),
        ("lights", Untrusted::Flag(true)),
        ("sheets", Untrusted::Flag(true)),
    ]);
    let start = Start::read(&sent);
    assert_eq!(
        (start.side, start.warm, start.state),
        (3.5, 3.0, &[7, 8][..])
    );
    assert_eq!((start.guess, start.quality), (Some(Level::Low), None));
    assert!(start.paused && start.lights && start.sheets);
    let empty = Untrusted::Object(vec![]);
    let start = Start::read(&empty);
    assert!(start.values.is_empty() && start.state.is_empty());
    assert!(start.preset.is_none() && start.config.is_missing() && !start.paused);
    assert!(!start.lights && !start.sheets);
    for wrong in [-1.0, 30.5, f64::NAN] {
        let error = refused("warm", &[number(wrong)]);
        assert!(
            error.message.ends_with("a number from 0 to 30"),
            "{error:?}"
        );
        assert_eq!(error.range, Some((0.0, 30.0)));
    }
}

#[test]
fn numbers_out_of_range_are_refused_with_their_range() {
    let max = f64::from(MAX_STEPS);
    for bad in [-1.0, 0.0, 0.5, max + 1.0, f64::NAN, f64::INFINITY] {
        let error = refused("step", &[number(bad)]);
        assert_eq!(error.range, Some((1.0, max)), "{bad}");
        let allowed = "must be a whole number from 1 to 100000";
        assert!(error.message.ends_with(allowed), "{error:?}");
    }
    let max = f64::from(MAX_SECONDS);
    for bad in [-1.0, max + 1.0, f64::NAN, f64::INFINITY] {
        let error = refused("advance", &[number(bad)]);
        let allowed = "must be a number from 0 to 1000";
        assert!(error.message.ends_with(allowed), "{error:?}");
        assert_eq!(error.range, Some((0.0, max)));
    }
    let good = number(10.0);
    let error = refused("resize", &[number(-1.0), good.clone(), good.clone()]);
    assert_eq!(error.id, "width");
    let long = number(f64::from(MAX_SIDE) + 1.0);
    let error = refused("resize", &[good.clone(), long, good]);
    assert_eq!(error.id, "height");
}

#[test]
fn arguments_of_view_sparks_and_stir_are_checked() {
    for (name, fit) in Fit::ALL {
        let (fit, x, y) = (NamedFit(fit), Within(0.25), Within(1.0));
        let arguments = [text(name), number(0.25), number(1.0)];
        let parsed = Command::parse(&text("view"), &arguments);
        assert_eq!(parsed, Ok(Command::View { fit, x, y }));
    }
    for count in [1, 24, 200] {
        let (x, y) = (Within(0.5), Within(0.5));
        let arguments = [number(0.5), number(0.5), number(count.into())];
        let count = Whole(count);
        let parsed = Command::parse(&text("sparks"), &arguments);
        assert_eq!(parsed, Ok(Command::Sparks { x, y, count }));
    }
    let zero = || number(0.0);
    let fits = "one of height, contain, cover, width";
    let part = "a number from 0 to 1";
    let zoom = "a number from 1 to 10";
    let place = "a number from -1000 to 1000";
    let count = "a whole number from 1 to 200";
    let speed = "a number from -20 to 20";
    let nan = || number(f64::NAN);
    for (name, arguments, id, allowed) in [
        ("view", vec![text("fill"), zero(), zero()], "fit", fits),
        ("view", vec![text("cover"), number(1.1), zero()], "x", part),
        ("view", vec![text("cover"), zero()], "y", part),
        ("zoom", vec![zero(), zero(), zero()], "zoom", zoom),
        ("zoom", vec![number(2.0), zero(), nan()], "y", part),
        ("sparks", vec![zero(), zero(), number(1.5)], "count", count),
        ("sparks", vec![nan(), zero(), number(24.0)], "x", place),
        (
            "spray",
            vec![zero(), zero(), zero(), zero(), zero()],
            "grams",
            "a number above 0, up to 1000",
        ),
        ("stir", vec![zero(), zero(), zero(), text("1")], "v", speed),
    ] {
        let error = refused(name, &arguments);
        assert_eq!(error.id, id);
        assert!(error.message.ends_with(allowed), "{error:?}");
    }
}

//! What the engine makes of calls, good and bad, without a browser.

use hearth_bindings::{
    Argument, Check, Form, Positive, Untrusted, ValidationError, Whole, Within, settings,
};
use hearth_core::Parameters;
use hearth_core::params::{Input, Model};
use hearth_engine::commands::{
    COMMANDS, Command, Fitting, MAX_SECONDS, MAX_SIDE, MAX_STEPS, Start, Wish,
};
use hearth_engine::quality::Level;
use hearth_engine::requested::Requested;
use hearth_render::Fit;

type Sent = Vec<(String, Untrusted)>;

fn number(number: f64) -> Untrusted {
    Untrusted::Number(number)
}

fn text(words: &str) -> Untrusted {
    Untrusted::Text(words.to_owned())
}

fn object<const N: usize>(fields: [(&str, Untrusted); N]) -> Untrusted {
    Untrusted::Object(sent(fields))
}

fn sent<const N: usize>(values: [(&str, Untrusted); N]) -> Sent {
    values.map(|(id, value)| (id.to_owned(), value)).into()
}

/// The values of a model, by id.
fn of_model<const N: usize>(model: &str, values: [(&str, Untrusted); N]) -> Sent {
    let mut all = sent([("model", text(model))]);
    all.extend(sent(values));
    all
}

#[track_caller]
fn refused(name: &str, arguments: &[Untrusted]) -> ValidationError {
    match Command::parse(&text(name), arguments) {
        Ok(command) => panic!("{command:?} is taken"),
        Err(error) => error,
    }
}

/// What a fire starts with, and what was refused.
fn starting_values(start: &Untrusted) -> (Parameters, Vec<ValidationError>) {
    let (requested, errors) = Requested::at_first(&Start::read(start));
    (requested.parameters().clone(), errors)
}

/// A start with these values and nothing else.
fn start(values: Sent) -> Untrusted {
    object([("values", Untrusted::Object(values))])
}

fn ids(errors: &[ValidationError]) -> Vec<&str> {
    errors.iter().map(|error| error.id.as_str()).collect()
}

#[test]
fn every_command_has_its_form() {
    let one = sent([("viscosity", number(0.01))]);
    let values = Untrusted::Object(one.clone());
    let seed = [text("seed")];
    let list = Untrusted::List(seed.to_vec());
    let source = "test";
    let config = object([("preset", text("seed"))]);
    for (name, arguments, command) in [
        (
            "set",
            vec![values.clone(), text(source)],
            Command::Set {
                values: &one,
                source,
            },
        ),
        ("check", vec![values], Command::CheckValues { values: &one }),
        (
            "restore",
            vec![list, text(source)],
            Command::Restore { ids: &seed, source },
        ),
        (
            "preset",
            vec![text("seed"), text(source)],
            Command::Preset {
                name: "seed",
                source,
            },
        ),
        (
            "import",
            vec![config.clone(), text(source)],
            Command::Import {
                config: &config,
                source,
            },
        ),
        ("export", vec![], Command::Export {}),
        (
            "resize",
            vec![number(3.0), number(0.0), number(3.5)],
            Command::Resize {
                width: Whole(3),
                height: Whole(0),
                side: 3.5,
            },
        ),
        (
            "visible",
            vec![Untrusted::Flag(false)],
            Command::Visible { visible: false },
        ),
        (
            "stir",
            vec![number(0.5), number(0.25), number(-20.0), number(20.0)],
            Command::Stir {
                x: Within(0.5),
                y: Within(0.25),
                u: Within(-20.0),
                v: Within(20.0),
            },
        ),
        ("play", vec![], Command::Play {}),
        ("pause", vec![], Command::Pause {}),
        ("reset", vec![], Command::Reset {}),
        ("remove", vec![], Command::Remove {}),
        ("step", vec![number(5.0)], Command::Step { steps: Whole(5) }),
        (
            "burn",
            vec![number(0.5)],
            Command::Burn {
                seconds: Positive(0.5),
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
fn every_argument_that_fails_its_check_is_refused_by_its_name() {
    let strange = [
        Untrusted::Missing,
        number(f64::NAN),
        number(f64::INFINITY),
        number(1e30),
        text("nothing of this name"),
        Untrusted::Flag(true),
        Untrusted::List(vec![number(1.0)]),
        Untrusted::Object(vec![]),
        Untrusted::Other("null"),
    ];
    let good = |check: &Check| match check.form {
        Form::Any => Untrusted::Missing,
        Form::Finite | Form::Positive(_) => number(1.0),
        Form::Within { min, .. } => number(min.into()),
        Form::Flag => Untrusted::Flag(true),
        Form::Text => text("words"),
        Form::OneOf(names) => text(names[0]),
        Form::Ids => Untrusted::List(vec![]),
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
fn what_is_no_command_is_refused() {
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
        ("restore", vec![text("seed"), source()]),
        (
            "restore",
            vec![Untrusted::List(vec![number(1.0)]), source()],
        ),
        ("preset", vec![Untrusted::Missing, source()]),
        ("visible", vec![text("yes")]),
        ("burn", vec![]),
    ] {
        refused(name, &arguments);
    }
}

#[test]
fn a_quality_has_a_name_or_is_left_to_the_fire() {
    let names = Level::ALL.map(|level| (level.name(), Some(level)));
    for (name, level) in names.into_iter().chain([("auto", None)]) {
        let quality = Wish(level);
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
fn a_new_fire_may_start_warm_with_a_saved_one() {
    let state = Untrusted::Bytes(vec![7, 8]);
    let sent = object([
        ("side", number(3.5)),
        ("warm", number(3.0)),
        ("state", state),
        ("guess", text("low")),
        ("quality", text("auto")),
        ("paused", Untrusted::Flag(true)),
    ]);
    let start = Start::read(&sent);
    assert_eq!(
        (start.side, start.warm, start.state),
        (3.5, 3.0, &[7, 8][..])
    );
    assert_eq!((start.guess, start.quality), (Some(Level::Low), None));
    assert!(start.paused && !start.count_overridden);
    let empty = Untrusted::Object(vec![]);
    let start = Start::read(&empty);
    assert!(start.values.is_empty() && start.kept.is_empty() && start.state.is_empty());
    assert!(start.preset.is_none() && start.config.is_missing() && !start.paused);
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
fn numbers_that_are_no_counts_are_refused_with_their_range() {
    let max = f64::from(MAX_STEPS);
    for bad in [-1.0, 0.0, 0.5, max + 1.0, f64::NAN, f64::INFINITY] {
        let error = refused("step", &[number(bad)]);
        assert_eq!(error.range, Some((1.0, max)), "{bad}");
        let allowed = "must be a whole number from 1 to 100000";
        assert!(error.message.ends_with(allowed), "{error:?}");
    }
    let max = f64::from(MAX_SECONDS);
    for bad in [-1.0, 0.0, max + 1.0, f64::NAN, f64::INFINITY] {
        let error = refused("burn", &[number(bad)]);
        let allowed = "must be a number above 0, up to 1000";
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

fn with_values(
    old: &Parameters,
    values: &[(String, Untrusted)],
) -> Result<Parameters, Vec<ValidationError>> {
    let new = settings::with_values(&old.clone().into(), values);
    new.map(|scene| scene.settings().clone())
}

fn with_defaults(
    old: &Parameters,
    values: &[(String, Untrusted)],
) -> Result<Parameters, Vec<ValidationError>> {
    let new = settings::with_defaults(&old.clone().into(), values);
    new.map(|scene| scene.settings().clone())
}

#[test]
fn values_are_set_all_or_none() {
    let old = Parameters::new(Model::Classic);
    let good = sent([("viscosity", number(0.02))]);
    let set = with_values(&old, &good);
    assert_eq!(set.map(|new| new.viscosity), Ok(0.02));

    let mixed = sent([
        ("viscosity", number(0.02)),
        ("bloom", number(99.0)),
        ("viscositty", number(0.02)),
    ]);
    let Err(errors) = with_values(&old, &mixed) else {
        panic!("a bad value was accepted");
    };
    assert_eq!(ids(&errors), ["bloom", "viscositty"]);
    assert!(errors[0].message.contains("99") && errors[0].range.is_some());
    assert_eq!(errors[0].value, number(99.0));
    assert!(errors[1].message.contains("viscosity"));
}

/// The ids of values, as defaults are asked for.
fn named<const N: usize>(ids: [&str; N]) -> Sent {
    sent(ids.map(|id| (id, Untrusted::Missing)))
}

#[test]
fn restoring_gives_the_default_and_nothing_else() {
    let values = sent([("viscosity", number(0.02)), ("bloom", number(0.5))]);
    let default = Parameters::new(Model::Classic);
    let restored =
        with_values(&default, &values).and_then(|new| with_defaults(&new, &named(["viscosity"])));
    assert_eq!(
        restored.map(|new| (new.viscosity, new.bloom)),
        Ok((default.viscosity, 0.5))
    );
    assert!(with_defaults(&default, &named(["heat"])).is_err());
}

#[test]
fn a_new_fire_keeps_the_good_values_beside_a_bad_one() {
    let values = of_model(
        "classic",
        [("viscosity", number(0.02)), ("bloom", text("much"))],
    );
    let (parameters, errors) = starting_values(&object([
        ("preset", text("no such preset")),
        ("values", Untrusted::Object(values)),
    ]));
    assert_eq!(parameters.viscosity, 0.02);
    assert_eq!(parameters.bloom, Parameters::default().bloom);
    assert_eq!(ids(&errors), ["preset", "bloom"]);
}

#[test]
fn an_unknown_preset_is_refused_with_the_known_names() {
    let errors = Requested::of_preset("sead").expect_err("it is refused");
    assert!(errors[0].message.contains("one of default, "));
    assert!(errors[0].message.contains("seed") && errors[0].message.contains("\"sead\""));
    for name in ["", "__proto__", &"x".repeat(1000)] {
        let errors = Requested::of_preset(name).expect_err("it is refused");
        assert!(errors[0].message.len() < 600, "{errors:?}");
    }
}

#[test]
fn a_model_comes_before_the_values_that_it_decides_about() {
    // One that both models have, each with a range of its own, and one of each.
    let sent = of_model(
        "classic",
        [
            ("emission_speed", number(2.5)),
            ("gas_constant", number(1.0)),
            ("fuel_power", number(100.0)),
        ],
    );
    for model in [Model::Classic, Model::Combustion] {
        let old = Parameters::new(model);
        let new = with_values(&old, &sent);
        let seen = new.map(|new| (new.model(), new.emission_speed, new.gas_constant));
        assert_eq!(seen, Ok((Model::Classic, 2.5, 1.0)));

        let mut reversed = sent.clone();
        reversed.reverse();
        assert_eq!(with_values(&old, &reversed), with_values(&old, &sent));

        // In the other model that speed is out of range, and nothing is taken.
        let mut other = sent.clone();
        other[0].1 = text("combustion");
        let errors = with_values(&old, &other).expect_err("it is refused");
        assert_eq!(ids(&errors), ["emission_speed"]);
    }
}

#[test]
fn a_fire_starts_the_same_in_whatever_order_its_values_come() {
    let mut sent = of_model(
        "classic",
        [
            ("emission_speed", number(2.5)),
            ("domain_height", number(1.0)),
        ],
    );
    let (parameters, errors) = starting_values(&start(sent.clone()));
    assert_eq!(errors, []);
    assert_eq!(parameters.model(), Model::Classic);
    assert_eq!(
        (parameters.emission_speed, parameters.domain_height),
        (2.5, 1.0)
    );
    sent.reverse();
    assert_eq!(starting_values(&start(sent)), (parameters, Vec::new()));
}

#[test]
fn a_model_goes_before_that_of_the_preset() {
    let (parameters, errors) = starting_values(&object([
        ("preset", text("classic")),
        ("values", Untrusted::Object(of_model("combustion", []))),
    ]));
    assert_eq!(errors, []);
    assert_eq!(parameters, Parameters::new(Model::Combustion));
}

#[test]
fn a_fire_that_comes_back_has_the_values_of_both_models() {
    let values =
        |model, height| Untrusted::Object(of_model(model, [("domain_height", number(height))]));
    let (mut parameters, errors) = starting_values(&object([
        ("kept", values("combustion", 3.0)),
        ("values", values("classic", 2.0)),
    ]));
    assert_eq!(errors, []);
    assert_eq!(
        (parameters.model(), parameters.domain_height),
        (Model::Classic, 2.0)
    );
    assert_eq!(parameters.set("model", Input::Text("combustion")), Ok(()));
    assert_eq!(parameters.domain_height, 3.0);
}

#[test]
fn the_model_is_restored_before_the_values_that_it_decides_about() {
    for model in [Model::Classic, Model::Combustion] {
        let old = Parameters::new(model);
        let high = with_values(&old, &sent([("domain_height", number(4.0))]));
        let ids = named(["domain_height", "model"]);
        let restored = high.and_then(|high| with_defaults(&high, &ids));
        let default = Parameters::default();
        let seen = restored.map(|new| (new.model(), new.domain_height));
        assert_eq!(seen, Ok((default.model(), default.domain_height)));
    }
}

#[test]
fn a_view_sparks_and_a_pointer_are_checked_before_anything_is_done() {
    for (name, fit) in Fit::ALL {
        let (fit, x, y) = (Fitting(fit), Within(0.25), Within(1.0));
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
    let place = "a number from -1000 to 1000";
    let count = "a whole number from 1 to 200";
    let speed = "a number from -20 to 20";
    let nan = || number(f64::NAN);
    for (name, arguments, id, allowed) in [
        ("view", vec![text("fill"), zero(), zero()], "fit", fits),
        ("view", vec![text("cover"), number(1.1), zero()], "x", part),
        ("view", vec![text("cover"), zero(), nan()], "y", part),
        ("view", vec![text("cover"), zero()], "y", part),
        ("sparks", vec![zero(), zero(), zero()], "count", count),
        (
            "sparks",
            vec![zero(), zero(), number(201.0)],
            "count",
            count,
        ),
        ("sparks", vec![zero(), zero(), number(1.5)], "count", count),
        ("sparks", vec![nan(), zero(), number(24.0)], "x", place),
        (
            "sparks",
            vec![zero(), number(f64::INFINITY), number(24.0)],
            "y",
            place,
        ),
        ("stir", vec![nan(), zero(), zero(), zero()], "x", place),
        (
            "stir",
            vec![zero(), number(1e30), zero(), zero()],
            "y",
            place,
        ),
        (
            "stir",
            vec![zero(), zero(), number(20.5), zero()],
            "u",
            speed,
        ),
        ("stir", vec![zero(), zero(), zero(), text("1")], "v", speed),
    ] {
        let error = refused(name, &arguments);
        assert_eq!(error.id, id);
        assert!(error.message.ends_with(allowed), "{error:?}");
    }
}

//! What the engine makes of messages, good and bad, without a browser.

use hearth_core::Parameters;
use hearth_core::params::Model;
use hearth_engine::limits::Sparks;
use hearth_engine::message::{
    LONGEST_SIDE, MOST_SECONDS, MOST_STEPS, Message, Order, Refused, RefusedMessage, SentValues,
    Start,
};
use hearth_engine::quality::Level;
use hearth_engine::raw::Raw;
use hearth_engine::scene;
use hearth_engine::wanted::Wanted;
use hearth_render::{Camera, Fit};

fn text(words: &str) -> Raw {
    Raw::Text(words.to_owned())
}

fn object<const N: usize>(fields: [(&str, Raw); N]) -> Raw {
    Raw::Object(fields.map(|(name, value)| (name.to_owned(), value)).into())
}

/// A message of `kind` for fire 7, request 3, from a test, with one more field.
fn message(kind: &str, field: &str, value: Raw) -> Raw {
    object([
        ("type", text(kind)),
        ("fire", Raw::Number(7.0)),
        ("request", Raw::Number(3.0)),
        ("source", text("test")),
        (field, value),
    ])
}

/// A start with these values and nothing else.
fn start(values: SentValues) -> Start {
    Start {
        size: (1, 1),
        side: 0.0,
        warm: 0.0,
        state: Vec::new(),
        preset: None,
        config: Raw::Missing,
        kept: Vec::new(),
        values,
        own_number: false,
        quality: None,
        guess: None,
        paused: false,
        visible: true,
        camera: Camera::default(),
    }
}

/// What a fire starts with, and what was refused.
fn starting_values(start: &Start) -> (Parameters, Vec<hearth_engine::message::Refused>) {
    let (wanted, errors) = Wanted::at_first(start);
    (wanted.parameters().clone(), errors)
}

/// The values of a model, by id.
fn values<const N: usize>(model: &str, values: [(&str, Raw); N]) -> SentValues {
    let values = values.map(|(id, value)| (id.to_owned(), value));
    std::iter::once(("model".to_owned(), text(model)))
        .chain(values)
        .collect()
}

fn order(raw: &Raw) -> Option<Order> {
    Message::parse(raw).ok().map(|message| message.order)
}

fn refused(raw: &Raw) -> Option<RefusedMessage> {
    Message::parse(raw).err()
}

#[test]
fn a_message_says_who_wants_what_of_whom() {
    let values = vec![("viscosity".to_owned(), Raw::Number(0.01))];
    let raw = message("set", "values", Raw::Object(values.clone()));
    let wanted = Message {
        fire: 7,
        request: Some(3.0),
        source: "test".to_owned(),
        order: Order::Set(values.clone()),
    };
    assert_eq!(Message::parse(&raw), Ok(wanted));
    let asked = message("check", "values", Raw::Object(values.clone()));
    assert_eq!(order(&asked), Some(Order::Check(values)));
    assert!(order(&message("check", "value", Raw::Missing)).is_none());
}

#[test]
fn a_new_fire_may_be_warmed_and_start_with_a_kept_one() {
    let start = |field, value| {
        let size = ["width", "height"].map(|side| (side.to_owned(), Raw::Number(8.0)));
        let Raw::Object(mut fields) = message("add", field, value) else {
            return None;
        };
        fields.extend(size);
        match order(&Raw::Object(fields)) {
            Some(Order::Add(start)) => Some((start.side, start.warm, start.state)),
            _ => None,
        }
    };
    assert_eq!(start("side", Raw::Number(3.5)), Some((3.5, 0.0, vec![])));
    assert_eq!(start("warm", Raw::Number(3.0)), Some((0.0, 3.0, vec![])));
    let kept = Raw::Bytes(vec![7, 8]);
    assert_eq!(start("state", kept), Some((0.0, 0.0, vec![7, 8])));
    assert_eq!(start("state", text("bytes")), None);
    for wrong in [-1.0, 30.5, f64::NAN] {
        assert_eq!(start("warm", Raw::Number(wrong)), None);
        let refused = refused(&message("warm", "seconds", Raw::Number(wrong)));
        let error = refused.and_then(|refused| refused.errors.into_iter().next());
        assert!(error.is_some_and(|error| error.message.ends_with("a number from 0 to 30")));
    }
}

#[test]
fn every_order_has_its_form() {
    let none = || ("nothing", Raw::Missing);
    let plain = |kind| order(&message(kind, none().0, none().1));
    assert_eq!(plain("play"), Some(Order::Play));
    assert_eq!(plain("pause"), Some(Order::Pause));
    assert_eq!(plain("reset"), Some(Order::Reset));
    assert_eq!(plain("remove"), Some(Order::Remove));
    assert_eq!(
        order(&message("step", "steps", Raw::Number(5.0))),
        Some(Order::Step(5))
    );
    assert_eq!(
        order(&message("burn", "seconds", Raw::Number(0.5))),
        Some(Order::Burn(0.5))
    );
    assert_eq!(
        order(&message("warm", "seconds", Raw::Number(2.5))),
        Some(Order::Warm(Some(2.5)))
    );
    assert_eq!(plain("warm"), Some(Order::Warm(None)));
    assert_eq!(
        order(&message("visible", "visible", Raw::Flag(false))),
        Some(Order::Visible(false))
    );
    assert_eq!(
        order(&message("preset", "name", text("seed"))),
        Some(Order::Preset("seed".to_owned()))
    );
    assert_eq!(
        order(&message("restore", "ids", Raw::List(vec![text("seed")]))),
        Some(Order::Restore(vec!["seed".to_owned()]))
    );
}

#[test]
fn a_quality_has_a_name_or_is_left_to_the_fire() {
    for level in Level::ALL {
        let raw = message("quality", "quality", text(level.name()));
        assert_eq!(order(&raw), Some(Order::Quality(Some(level))));
    }
    let auto = message("quality", "quality", text("auto"));
    assert_eq!(order(&auto), Some(Order::Quality(None)));
    for bad in [
        text("best"),
        text(""),
        text("Low"),
        Raw::Number(1.0),
        Raw::Flag(true),
    ] {
        let refused = refused(&message("quality", "quality", bad.clone())).expect("it is bad");
        assert_eq!(
            (refused.errors[0].id.as_str(), &refused.errors[0].value),
            ("quality", &bad)
        );
    }
}

#[test]
fn a_fire_may_start_without_a_size() {
    let raw = object([
        ("type", text("add")),
        ("fire", Raw::Number(1.0)),
        ("width", Raw::Number(0.0)),
        ("height", Raw::Number(0.0)),
    ]);
    let Some(Order::Add(start)) = order(&raw) else {
        panic!("{:?}", Message::parse(&raw));
    };
    assert_eq!(start.size, (0, 0));
    assert!(start.values.is_empty() && start.kept.is_empty());
    assert!(start.visible && !start.paused);
}

#[test]
fn numbers_that_are_no_counts_are_refused_with_their_range() {
    let most = f64::from(MOST_STEPS);
    for bad in [-1.0, 0.0, 0.5, most + 1.0, f64::NAN, f64::INFINITY] {
        let error = refused(&message("step", "steps", Raw::Number(bad)));
        let Some(RefusedMessage { errors, .. }) = error else {
            panic!("{bad} steps were accepted");
        };
        assert_eq!(errors[0].range, Some((1.0, most)), "{bad}");
    }
    for bad in [-1.0, 0.0, MOST_SECONDS + 1.0, f64::NAN, f64::INFINITY] {
        let error = refused(&message("burn", "seconds", Raw::Number(bad)));
        let Some(RefusedMessage { errors, .. }) = error else {
            panic!("{bad} seconds were accepted");
        };
        assert!(errors[0].message.contains(&MOST_SECONDS.to_string()));
    }
    let sides = [("width", -1.0), ("height", f64::from(LONGEST_SIDE) + 1.0)];
    for (side, bad) in sides {
        let mut fields = vec![
            ("type".to_owned(), text("resize")),
            ("fire".to_owned(), Raw::Number(1.0)),
            (side.to_owned(), Raw::Number(bad)),
        ];
        for other in ["width", "height"] {
            fields.push((other.to_owned(), Raw::Number(10.0)));
        }
        let error = refused(&Raw::Object(fields));
        assert_eq!(error.map(|e| e.errors[0].id.clone()), Some(side.to_owned()));
    }
}

#[test]
fn a_refusal_goes_back_to_who_asked() {
    let error = refused(&message("set", "values", Raw::Number(1.0)));
    let Some(error) = error else {
        panic!("a number was accepted as values");
    };
    assert_eq!(error.fire, Some(7));
    assert_eq!(error.request, Some(3.0));
    assert_eq!(error.source, "test");
    assert_eq!(error.errors[0].id, "values");
}

#[test]
fn what_is_no_message_is_refused() {
    let strange = [
        Raw::Missing,
        Raw::Number(1.0),
        text("play"),
        Raw::List(vec![]),
        Raw::Object(vec![]),
        Raw::Other("null"),
        object([("type", text("play"))]),
        object([("type", text("play")), ("fire", text("7"))]),
        object([("type", text("play")), ("fire", Raw::Number(-1.0))]),
        object([("type", text("burn")), ("fire", Raw::Number(7.0))]),
        object([("type", Raw::Flag(true)), ("fire", Raw::Number(7.0))]),
        message("set", "values", Raw::List(vec![])),
        message("restore", "ids", text("seed")),
        message("restore", "ids", Raw::List(vec![Raw::Number(1.0)])),
        message("preset", "name", Raw::Missing),
        message("visible", "visible", text("yes")),
        message("add", "width", Raw::Number(5.0)),
    ];
    for raw in &strange {
        assert!(refused(raw).is_some(), "{raw:?} was accepted");
    }
}

fn with_values(old: &Parameters, values: &[(String, Raw)]) -> Result<Parameters, Vec<Refused>> {
    let mut new = old.clone().into();
    scene::set(&mut new, values).map(|()| new.settings().clone())
}

fn with_defaults(old: &Parameters, ids: &[String]) -> Result<Parameters, Vec<Refused>> {
    let mut new = old.clone().into();
    scene::restore(&mut new, ids).map(|()| new.settings().clone())
}

#[test]
fn values_are_set_all_or_none() {
    let old = Parameters::new(Model::Classic);
    let good = ("viscosity".to_owned(), Raw::Number(0.02));
    let bad = ("bloom".to_owned(), Raw::Number(99.0));
    let unknown = ("viscositty".to_owned(), Raw::Number(0.02));

    let set = with_values(&old, std::slice::from_ref(&good));
    assert_eq!(set.map(|new| new.viscosity), Ok(0.02));

    let Err(errors) = with_values(&old, &[good, bad, unknown]) else {
        panic!("a bad value was accepted");
    };
    let ids: Vec<&str> = errors.iter().map(|error| error.id.as_str()).collect();
    assert_eq!(ids, ["bloom", "viscositty"]);
    assert!(errors[0].message.contains("99") && errors[0].range.is_some());
    assert!(errors[1].message.contains("viscosity"));
}

#[test]
fn restoring_gives_the_default_and_nothing_else() {
    let values = [
        ("viscosity".to_owned(), Raw::Number(0.02)),
        ("bloom".to_owned(), Raw::Number(0.5)),
    ];
    let default = Parameters::new(Model::Classic);
    let restored = with_values(&default, &values)
        .and_then(|new| with_defaults(&new, &["viscosity".to_owned()]));
    assert_eq!(
        restored.map(|new| (new.viscosity, new.bloom)),
        Ok((default.viscosity, 0.5))
    );
    assert!(with_defaults(&default, &["heat".to_owned()]).is_err());
}

#[test]
fn a_new_fire_keeps_the_good_values_beside_a_bad_one() {
    let values = values(
        "classic",
        [("viscosity", Raw::Number(0.02)), ("bloom", text("much"))],
    );
    let (parameters, errors) = starting_values(&Start {
        preset: Some("no such preset".to_owned()),
        ..start(values)
    });
    assert_eq!(parameters.viscosity, 0.02);
    assert_eq!(parameters.bloom, Parameters::default().bloom);
    let ids: Vec<&str> = errors.iter().map(|error| error.id.as_str()).collect();
    assert_eq!(ids, ["preset", "bloom"]);
}

#[test]
fn an_unknown_preset_is_refused_with_the_known_names() {
    let refused = Wanted::of_preset("sead")
        .err()
        .map(|errors| errors[0].message.clone());
    assert!(refused.is_some_and(|words| words.contains("seed") && words.contains("sead")));
}

#[test]
fn a_model_comes_before_the_values_that_it_decides_about() {
    // One that both models have, each with a range of its own, and one of each.
    let wanted = values(
        "classic",
        [
            ("emission_speed", Raw::Number(2.5)),
            ("gas_constant", Raw::Number(1.0)),
            ("fuel_power", Raw::Number(100.0)),
        ],
    );
    for model in [Model::Classic, Model::Combustion] {
        let old = Parameters::new(model);
        let new = with_values(&old, &wanted);
        let seen = new.map(|new| (new.model(), new.emission_speed, new.gas_constant));
        assert_eq!(seen, Ok((Model::Classic, 2.5, 1.0)));

        let mut reversed = wanted.clone();
        reversed.reverse();
        assert_eq!(with_values(&old, &reversed), with_values(&old, &wanted));

        // In the other model that speed is out of range, and nothing is taken.
        let mut other = wanted.clone();
        other[0].1 = text("combustion");
        let refused = with_values(&old, &other).err();
        let ids = refused.map(|all| all.iter().map(|one| one.id.clone()).collect::<Vec<_>>());
        assert_eq!(ids, Some(vec!["emission_speed".to_owned()]));
    }
}

#[test]
fn a_fire_starts_the_same_in_whatever_order_its_values_come() {
    let mut wanted = values(
        "classic",
        [
            ("emission_speed", Raw::Number(2.5)),
            ("domain_height", Raw::Number(1.0)),
        ],
    );
    let (parameters, errors) = starting_values(&start(wanted.clone()));
    assert_eq!(errors, []);
    assert_eq!(parameters.model(), Model::Classic);
    assert_eq!(
        (parameters.emission_speed, parameters.domain_height),
        (2.5, 1.0)
    );
    wanted.reverse();
    assert_eq!(starting_values(&start(wanted)), (parameters, Vec::new()));
}

#[test]
fn a_model_goes_before_that_of_the_preset() {
    let (parameters, errors) = starting_values(&Start {
        preset: Some("classic".to_owned()),
        ..start(values("combustion", []))
    });
    assert_eq!(errors, []);
    assert_eq!(parameters, Parameters::new(Model::Combustion));
}

#[test]
fn a_fire_that_comes_back_has_the_values_of_both_models() {
    let (mut parameters, errors) = starting_values(&Start {
        kept: values("combustion", [("domain_height", Raw::Number(3.0))]),
        ..start(values("classic", [("domain_height", Raw::Number(2.0))]))
    });
    assert_eq!(errors, []);
    assert_eq!(
        (parameters.model(), parameters.domain_height),
        (Model::Classic, 2.0)
    );
    assert_eq!(parameters.set("model", text("combustion").input()), Ok(()));
    assert_eq!(parameters.domain_height, 3.0);
}

#[test]
fn the_model_is_restored_before_the_values_that_it_decides_about() {
    for model in [Model::Classic, Model::Combustion] {
        let old = Parameters::new(model);
        let high = with_values(&old, &[("domain_height".to_owned(), Raw::Number(4.0))]);
        let ids = ["domain_height", "model"].map(str::to_owned);
        let restored = high.and_then(|high| with_defaults(&high, &ids));
        let default = Parameters::default();
        let seen = restored.map(|new| (new.model(), new.domain_height));
        assert_eq!(seen, Ok((default.model(), default.domain_height)));
    }
}

#[test]
fn a_view_and_sparks_are_checked_before_anything_is_done() {
    let number = Raw::Number;
    let view = |fit: &str, x, y| {
        let fields = [("fit", text(fit)), ("x", x), ("y", y)];
        object(fields)
    };
    let of = |kind: &str, fields: Raw| {
        let Raw::Object(mut fields) = fields else {
            return Raw::Missing;
        };
        fields.push(("type".to_owned(), text(kind)));
        fields.push(("fire".to_owned(), number(7.0)));
        Raw::Object(fields)
    };
    for (name, fit) in Fit::ALL {
        let raw = of("view", view(name, number(0.25), number(1.0)));
        let align = [0.25, 1.0];
        assert_eq!(order(&raw), Some(Order::View(Camera { fit, align })));
    }
    for (wrong, id, allowed) in [
        (
            view("fill", number(0.0), number(0.0)),
            "fit",
            "one of height, contain, cover, width",
        ),
        (
            view("cover", number(1.1), number(0.0)),
            "x",
            "a number from 0 to 1",
        ),
        (
            view("cover", number(0.0), number(f64::NAN)),
            "y",
            "a number from 0 to 1",
        ),
        (
            view("cover", number(0.0), Raw::Missing),
            "y",
            "a number from 0 to 1",
        ),
    ] {
        let refused = refused(&of("view", wrong.clone())).expect("it is refused");
        assert_eq!(refused.errors[0].id, id);
        assert!(refused.errors[0].message.contains(allowed), "{refused:?}");
        // A new fire is seen as a message says, or there is none.
        let mut start = message("add", "view", wrong);
        if let Raw::Object(fields) = &mut start {
            for side in ["width", "height"] {
                fields.push((side.to_owned(), number(10.0)));
            }
        }
        assert!(Message::parse(&start).is_err());
    }

    let sparks = |x: f64, count: f64| {
        let fields = [
            ("x", number(x)),
            ("y", number(0.5)),
            ("count", number(count)),
        ];
        of("sparks", object(fields))
    };
    for count in [1, 24, 200] {
        let place = [0.5, 0.5];
        let thrown = Order::Sparks(Sparks { place, count });
        assert_eq!(order(&sparks(0.5, count.into())), Some(thrown));
    }
    for (x, count, allowed) in [
        (0.5, 0.0, "a whole number from 1 to 200"),
        (0.5, 201.0, "a whole number from 1 to 200"),
        (0.5, 1.5, "a whole number from 1 to 200"),
        (f64::NAN, 24.0, "a number from -1000 to 1000"),
        (f64::INFINITY, 24.0, "a number from -1000 to 1000"),
    ] {
        let refused = refused(&sparks(x, count)).expect("it is refused");
        assert!(refused.errors[0].message.contains(allowed), "{refused:?}");
    }
}

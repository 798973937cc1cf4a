//! The machinery behind the parameter table: what an entry is, and the macro
//! that turns the table of [`crate::params`] into a struct, its defaults and
//! its one validator.

use super::choices::{Choice, Model};
use super::value::{Colour, Input, ParamError, ParamErrorKind, Value};
use super::{Field, Parameters};

/// How a slider spreads a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal distances are equal differences.
    Linear,
    /// Equal distances are equal ratios.
    Log,
}

/// What kind of value a parameter holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A real number.
    Number(Scale),
    /// A whole number.
    Integer(Scale),
    /// One of these names.
    Choice(&'static [&'static str]),
    /// On or off.
    Flag,
    /// A colour.
    Colour,
    /// Any whole number from 0 to 2³² − 1.
    Seed,
}

/// Default and range of a parameter in one model, or in every one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// The model that this holds for; `None`: every model.
    pub model: Option<Model>,
    /// The value at the start and after a reset.
    pub default: Value,
    /// Smallest and largest value of a number, integer or seed; zeros for the
    /// other kinds.
    pub range: (f64, f64),
}

/// One entry of the parameter table.
#[derive(Debug)]
pub struct Param {
    /// Unique, flat, snake_case; the attribute is the same in kebab-case.
    pub id: &'static str,
    /// The heading that it stands under.
    pub group: &'static str,
    /// Unit of its values; empty for a pure number.
    pub unit: &'static str,
    /// Kind of its values.
    pub kind: Kind,
    /// The models it belongs to, each with a default and a range.
    pub domains: &'static [Domain],
    /// What it changes.
    pub role: Role,
    pub(super) field: Field,
}

/// What a parameter changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The gas: the solver receives these parameters and no others.
    Physics,
    /// The light, colours and surroundings that the renderer gives the gas.
    Look,
    /// What of the simulation a viewer sees, and how fast it plays.
    View,
}

/// What a person reads about a parameter. It stands in an array of its own, so
/// that a build that shows no text carries none.
#[derive(Debug)]
pub struct Description {
    /// A short name for a slider.
    pub label: &'static str,
    /// One or two sentences for a tooltip and the reference.
    pub doc: &'static str,
    /// The choices that each must have one of these names, or its value shows nowhere;
    /// empty: none has to. It can be set all the same.
    pub when: &'static [Condition],
    /// The choices with whose names, all of them chosen together, it shows nowhere
    /// either; empty: there are none.
    pub unless: &'static [Condition],
}

/// A choice, by its id, and some of its names.
pub type Condition = (&'static str, &'static [&'static str]);

/// Choices as words, "layers both or fire and display fire", each id and each name as
/// these say it.
pub fn conditions_in_words<'a>(
    all: impl IntoIterator<Item = &'a Condition>,
    id_in_words: impl Fn(&str) -> String,
    name_in_words: impl Fn(&str) -> String,
) -> String {
    let each = all.into_iter().map(|(id, names)| {
        let names: Vec<_> = names.iter().map(|name| name_in_words(name)).collect();
        let names = match names.split_last() {
            Some((last, others)) if !others.is_empty() => {
                format!("{} or {last}", others.join(", "))
            }
            _ => names.concat(),
        };
        format!("{} {names}", id_in_words(id))
    });
    each.collect::<Vec<_>>().join(" and ")
}

impl Param {
    /// Default and range in `model`, or `None` where the model does not use it.
    pub fn domain(&self, model: Model) -> Option<&'static Domain> {
        self.domains
            .iter()
            .find(|d| d.model.is_none_or(|m| m == model))
    }

    /// Default and range in `model` or, where that does not use it, in the
    /// model that it belongs to: its value is kept there, so it has to be right
    /// even while it is hidden.
    pub fn any_domain(&self, model: Model) -> &'static Domain {
        self.domain(model).unwrap_or(&self.domains[0])
    }

    /// The value in `parameters`: the present model's or, where that does not
    /// use it, the value that it has in the model it belongs to.
    pub fn get(&self, parameters: &Parameters) -> Value {
        match self.domain(parameters.model) {
            Some(_) => parameters.current.get(self.field),
            None => parameters.other.get(self.field),
        }
    }

    /// Checks `input` against the kind and the range: **the** validator.
    pub(super) fn check(&self, model: Model, input: Input<'_>) -> Result<Value, ParamError> {
        let (min, max) = self.any_domain(model).range;
        let refuse = |kind| ParamError {
            id: self.id.to_owned(),
            value: input.to_string(),
            kind,
        };
        let in_range = |whole: bool| {
            input
                .number()
                .filter(|x| !whole || x.fract() == 0.0)
                // The bounds are decimals; a slider sends the nearest f32.
                .filter(|&x| {
                    (min..=max).contains(&x)
                        || !whole && [min, max].iter().any(|&end| x as f32 == end as f32)
                })
                .ok_or_else(|| {
                    refuse(ParamErrorKind::OutOfRange {
                        min,
                        max,
                        unit: self.unit,
                        whole,
                    })
                })
        };
        match self.kind {
            // −0 + 0 is 0: a fire must not depend on which zero was sent.
            Kind::Number(_) => in_range(false).map(|x| Value::Number(x as f32 + 0.0)),
            Kind::Integer(_) => in_range(true).map(|x| Value::Integer(x as u32)),
            Kind::Seed => in_range(true).map(|x| Value::Seed(x as u32)),
            Kind::Choice(choices) => match input {
                Input::Text(text) => choices.iter().find(|&&name| name == text.trim()),
                Input::Number(_) | Input::Flag(_) => None,
            }
            .map(|name| Value::Choice(name))
            .ok_or_else(|| refuse(ParamErrorKind::NotAChoice { choices })),
            Kind::Flag => input
                .flag()
                .map(Value::Flag)
                .ok_or_else(|| refuse(ParamErrorKind::NotAFlag)),
            Kind::Colour => match input {
                Input::Text(text) => Colour::parse(text),
                Input::Number(_) | Input::Flag(_) => None,
            }
            .map(Value::Colour)
            .ok_or_else(|| refuse(ParamErrorKind::NotAColour)),
        }
    }
}

/// Where a parameter's value stands in [`Values`](super::Values).
pub(super) enum Place<'a> {
    Number(&'a mut f32),
    Whole(&'a mut u32),
    Seed(&'a mut u32),
    Flag(&'a mut bool),
    Colour(&'a mut Colour),
    Choice(&'a mut dyn Chosen),
}

impl Place<'_> {
    pub fn value(self) -> Value {
        match self {
            Place::Number(x) => Value::Number(*x),
            Place::Whole(n) => Value::Integer(*n),
            Place::Seed(n) => Value::Seed(*n),
            Place::Flag(on) => Value::Flag(*on),
            Place::Colour(colour) => Value::Colour(*colour),
            Place::Choice(chosen) => Value::Choice(chosen.chosen()),
        }
    }

    /// Writes a value of the place's own kind; another changes nothing.
    pub fn put(self, value: Value) {
        match (self, value) {
            (Place::Number(x), Value::Number(new)) => *x = new,
            (Place::Whole(n), Value::Integer(new)) => *n = new,
            (Place::Seed(n), Value::Seed(new)) => *n = new,
            (Place::Flag(on), Value::Flag(new)) => *on = new,
            (Place::Colour(colour), Value::Colour(new)) => *colour = new,
            (Place::Choice(chosen), Value::Choice(name)) => chosen.choose(name),
            _ => {}
        }
    }
}

/// A choice of whatever type.
pub(super) trait Chosen {
    fn chosen(&self) -> &'static str;
    fn choose(&mut self, name: &str);
}

impl<T: Choice> Chosen for T {
    fn chosen(&self) -> &'static str {
        self.name()
    }

    fn choose(&mut self, name: &str) {
        if let Some(new) = T::from_name(name) {
            *self = new;
        }
    }
}

/// The known id that is nearest to `id`, where one is near enough to be meant.
pub(super) fn nearest_id(id: &str) -> Option<&'static str> {
    super::PARAMETERS
        .iter()
        .map(|p| (edit_distance(p.id, id), p.id))
        .min_by_key(|&(distance, _)| distance)
        .filter(|&(distance, known)| distance <= known.len() / 2)
        .map(|(_, known)| known)
}

/// Levenshtein's distance; ids are short, so a hostile one is cut.
fn edit_distance(known: &str, asked: &str) -> usize {
    let asked: Vec<char> = asked.chars().take(64).collect();
    let mut row: Vec<usize> = (0..=asked.len()).collect();
    for (i, a) in known.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &b) in asked.iter().enumerate() {
            let substituted = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[asked.len()]
}

/// Turns the table into [`Values`], its defaults, [`PARAMETERS`] and
/// [`DESCRIPTIONS`].
///
/// An entry is
/// `id: kind "Label" ["unit"] Scale { Model(default, min..=max) … }`,
/// after its doc; a choice names its type as `(choice Type)`; unit, scale and
/// range stand only where the kind has them; `Every` stands for every model.
/// `[Look]` or `[View]` before the id is its [`Role`]; an entry without one is physics
/// and stands in [`Physics`](super::Physics).
/// `when { id: names, … }` behind it says when it is of use, `unless { id: names, … }`
/// when not: see [`Description::when`] and [`Description::unless`].
///
/// [`PARAMETERS`]: super::PARAMETERS
/// [`DESCRIPTIONS`]: super::DESCRIPTIONS
macro_rules! parameters {
    ($( $group:literal { $(
        $(#[doc = $doc:literal])+
        $([$role:ident] $shown:ident)? $($id:ident)? : $kind:tt $label:literal $([$unit:literal])? $($scale:ident)?
            { $( $model:ident $domain:tt )+ } $(when { $( $choice:ident : $names:expr ),+ })?
            $(unless { $( $other:ident : $excluded:expr ),+ })?
    )+ } )+) => {
        // A macro cannot stand where a field does, so each struct states all fields and
        // `cfg(any())`, which is never true, takes out those of the other.

        /// The values that move the gas: all that the solver receives.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Physics { $($(
            $(#[doc = $doc])+
            $( #[cfg(any())] #[doc = stringify!($shown)] )?
            pub $($shown)? $($id)?: parameters!(@type $kind),
        )+)+ }

        /// The value of every parameter: those of the look and the view, and through
        /// `Deref` those of the [`Physics`]. Only the validator writes them.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Values {
            physics: Physics,
            $($(
                $(#[doc = $doc])+
                $( #[cfg(any())] #[doc = stringify!($id)] )?
                pub $($shown)? $($id)?: parameters!(@type $kind),
            )+)+
        }

        impl Deref for Values {
            type Target = Physics;
            fn deref(&self) -> &Physics {
                &self.physics
            }
        }

        /// Names each field of [`Values`]: with two functions that know them all
        /// an engine is smaller than with two functions for each.
        #[expect(non_camel_case_types, reason = "named as the fields are")]
        #[derive(Clone, Copy, Debug)]
        enum Field { $($( $($shown)? $($id)?, )+)+ }

        impl Values {
            #[inline(never)]
            fn place(&mut self, field: Field) -> Place<'_> {
                match field { $($(
                    Field::$($shown)? $($id)? =>
                        parameters!(@place $kind, self.$($shown)? $(physics.$id)?),
                )+)+ }
            }

            // Of a copy: one table of places is half the code of one to read and one
            // to write.
            #[inline(never)]
            fn get(&self, field: Field) -> Value {
                self.clone().place(field).value()
            }

            /// These values, for a set whose present model is this one.
            fn belonging_to(mut self, model: Model) -> Values {
                self.physics.model = model;
                self
            }

            fn of_model(model: Model) -> Values {
                let mut values = Values {
                    physics: Physics { $($(
                        $( #[cfg(any())] #[doc = stringify!($shown)] )?
                        $($shown)? $($id)?: parameters!(@first $kind, $($domain)+),
                    )+)+ },
                    $($(
                        $( #[cfg(any())] #[doc = stringify!($id)] )?
                        $($shown)? $($id)?: parameters!(@first $kind, $($domain)+),
                    )+)+
                };
                for param in PARAMETERS {
                    if let Some(domain) = param.domain(model) {
                        values.place(param.field).put(domain.default);
                    }
                }
                values.belonging_to(model)
            }
        }

        /// Every parameter, in the order in which a panel shows them.
        pub static PARAMETERS: &[Param] = &[ $($(
            Param {
                id: stringify!($($shown)? $($id)?),
                group: $group,
                unit: concat!($($unit)?),
                kind: parameters!(@kind $kind $($scale)?),
                domains: &[ $(
                    Domain {
                        model: parameters!(@model $model),
                        default: parameters!(@value $kind, parameters!(@default $kind, $domain)),
                        range: parameters!(@range $kind, $domain),
                    },
                )+ ],
                role: parameters!(@role $($role)?),
                field: Field::$($shown)? $($id)?,
            },
        )+)+ ];

        /// What a person reads about each parameter, in the order of
        /// [`PARAMETERS`].
        pub static DESCRIPTIONS: &[Description] = &[ $($(
            Description {
                label: $label,
                doc: concat!($($doc),+).trim_ascii(),
                when: &[ $($( (stringify!($choice), $names) ),+)? ],
                unless: &[ $($( (stringify!($other), $excluded) ),+)? ],
            },
        )+)+ ];
    };

    (@type number) => { f32 };
    (@type integer) => { u32 };
    (@type seed) => { u32 };
    (@type flag) => { bool };
    (@type colour) => { Colour };
    (@type (choice $type:ident)) => { $type };

    (@kind number $scale:ident) => { Kind::Number(Scale::$scale) };
    (@kind integer $scale:ident) => { Kind::Integer(Scale::$scale) };
    (@kind seed) => { Kind::Seed };
    (@kind flag) => { Kind::Flag };
    (@kind colour) => { Kind::Colour };
    (@kind (choice $type:ident)) => { Kind::Choice(<$type as Choice>::NAMES) };

    (@role) => { Role::Physics };
    (@role $role:ident) => { Role::$role };

    (@model Every) => { None };
    (@model $model:ident) => { Some(Model::$model) };

    (@default (choice $type:ident), ($default:ident)) => { $type::$default };
    (@default $kind:tt, ($default:expr $(, $range:expr)?)) => { $default };
    (@first $kind:tt, $domain:tt $($rest:tt)*) => {
        parameters!(@default $kind, $domain)
    };

    (@range seed, $domain:tt) => { (0.0, u32::MAX as f64) };
    (@range $kind:tt, ($default:expr, $range:expr)) => { (*$range.start(), *$range.end()) };
    (@range $kind:tt, $domain:tt) => { (0.0, 0.0) };

    (@value number, $x:expr) => { Value::Number($x) };
    (@value integer, $x:expr) => { Value::Integer($x) };
    (@value seed, $x:expr) => { Value::Seed($x) };
    (@value flag, $x:expr) => { Value::Flag($x) };
    (@value colour, $x:expr) => { Value::Colour($x) };
    (@value (choice $type:ident), $x:expr) => { Value::Choice($x.name()) };

    (@place number, $x:expr) => { Place::Number(&mut $x) };
    (@place integer, $x:expr) => { Place::Whole(&mut $x) };
    (@place seed, $x:expr) => { Place::Seed(&mut $x) };
    (@place flag, $x:expr) => { Place::Flag(&mut $x) };
    (@place colour, $x:expr) => { Place::Colour(&mut $x) };
    (@place (choice $type:ident), $x:expr) => { Place::Choice(&mut $x) };
}

pub(super) use parameters;

//! The macro behind the parameter table.

/// Expands the table to [`Values`], its defaults, [`PARAMETERS`] and [`DESCRIPTIONS`].
///
/// An entry is
/// `id: kind "Label" ["unit"] Scale { Model(default, min..=max) … }`,
/// after its doc. A choice names its type as `(choice Type)`; unit, scale and range depend on the
/// kind; `Every` is every model. `[Look]` or `[View]` before the id is its [`Role`]; an entry
/// without one is in [`Physics`](super::Physics). `@ name: id` is the property `name` of a source, which is a field
/// of [`Source`](super::Source); its id is that of the first one in a scene. `when { id: names, … }` and
/// `unless { id: names, … }` are [`Description::when`] and [`Description::unless`].
///
/// [`PARAMETERS`]: super::PARAMETERS
/// [`DESCRIPTIONS`]: super::DESCRIPTIONS
macro_rules! parameters {
    ($( $group:literal { $(
        $(#[doc = $doc:literal])+
        $(@ $property:ident: $of_source:ident)? $([$role:ident] $shown:ident)? $($id:ident)? : $kind:tt $label:literal $([$unit:literal])? $($scale:ident)?
            { $( $model:ident $domain:tt )+ } $(when { $( $choice:ident : $names:expr ),+ })?
            $(unless { $( $other:ident : $excluded:expr ),+ })?
    )+ } )+) => {
        // A macro cannot expand to a field, so each struct lists all fields and `cfg(any())`,
        // which is never true, removes those of the other.

        /// The values that the solver reads.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Physics { $($(
            $(#[doc = $doc])+
            $( #[cfg(any())] #[doc = stringify!($shown)] )?
            $( #[cfg(any())] #[doc = stringify!($of_source)] )?
            pub $($shown)? $($of_source)? $($id)?: parameters!(@type $kind),
        )+)+ }

        /// The values of a source. Every value is in range.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Source { $($(
            $(#[doc = $doc])+
            $( #[cfg(any())] #[doc = stringify!($shown)] )?
            $( #[cfg(any())] #[doc = stringify!($id)] )?
            pub $($shown)? $($property)? $($id)?: parameters!(@type $kind),
        )+)+ }

        /// The value of every parameter: those of the look and the view and, through `Deref`,
        /// those of the [`Physics`].
        #[derive(Clone, Debug, PartialEq)]
        pub struct Values {
            physics: Physics,
            $($(
                $(#[doc = $doc])+
                $( #[cfg(any())] #[doc = stringify!($id)] )?
                $( #[cfg(any())] #[doc = stringify!($of_source)] )?
                pub $($shown)? $($of_source)? $($id)?: parameters!(@type $kind),
            )+)+
        }

        impl Deref for Values {
            type Target = Physics;
            fn deref(&self) -> &Physics {
                &self.physics
            }
        }

        /// The fields of [`Values`] and [`Source`]. Two functions over all fields are smaller than two functions
        /// per field.
        #[expect(non_camel_case_types, reason = "named as the entries are")]
        #[derive(Clone, Copy, Debug)]
        pub(super) enum Field { $($( $($shown)? $($of_source)? $($id)?, )+)+ }

        impl Slots for Values {
            fn slot(&mut self, field: Field) -> Option<Slot<'_>> {
                match field { $($(
                    $( Field::$shown => Some(parameters!(@slot $kind, self.$shown)), )?
                    $( Field::$id => Some(parameters!(@slot $kind, self.physics.$id)), )?
                )+)+
                    _ => None,
                }
            }

            fn of_model(model: Model) -> Values {
                let mut values = Values {
                    physics: Physics { $($(
                        $( #[cfg(any())] #[doc = stringify!($shown)] )?
                        $( #[cfg(any())] #[doc = stringify!($of_source)] )?
                        $($shown)? $($of_source)? $($id)?: parameters!(@first $kind, $($domain)+),
                    )+)+ },
                    $($(
                        $( #[cfg(any())] #[doc = stringify!($id)] )?
                        $( #[cfg(any())] #[doc = stringify!($of_source)] )?
                        $($shown)? $($of_source)? $($id)?: parameters!(@first $kind, $($domain)+),
                    )+)+
                };
                values.put_defaults(model);
                values.physics.model = model;
                values
            }
        }

        impl Slots for Source {
            fn slot(&mut self, field: Field) -> Option<Slot<'_>> {
                match field { $($(
                    $( Field::$of_source => Some(parameters!(@slot $kind, self.$property)), )?
                )+)+
                    _ => None,
                }
            }

            fn of_model(model: Model) -> Source {
                let mut values = Source { $($(
                    $( #[cfg(any())] #[doc = stringify!($shown)] )?
                    $( #[cfg(any())] #[doc = stringify!($id)] )?
                    $($shown)? $($property)? $($id)?: parameters!(@first $kind, $($domain)+),
                )+)+ };
                values.put_defaults(model);
                values
            }
        }

        /// Every parameter, in the order of a panel.
        pub static PARAMETERS: &[Param] = &[ $($(
            Param {
                id: stringify!($($shown)? $($of_source)? $($id)?),
                property: concat!($(stringify!($property))?),
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
                field: Some(Field::$($shown)? $($of_source)? $($id)?),
            },
        )+)+ ];

        /// The label and documentation of each parameter, in the order of [`PARAMETERS`].
        pub static DESCRIPTIONS: &[Description] = &[ $($(
            Description {
                group: $group,
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
    (@type (text $type:ident)) => { $type };

    (@kind number $scale:ident) => { Kind::Number(Scale::$scale) };
    (@kind integer $scale:ident) => { Kind::Integer(Scale::$scale) };
    (@kind seed) => { Kind::Seed };
    (@kind flag) => { Kind::Flag };
    (@kind colour) => { Kind::Colour };
    (@kind (text $type:ident)) => { Kind::Text($type::FORM) };
    (@kind (choice $type:ident)) => { Kind::Choice(<$type as Choice>::NAMES) };

    (@role) => { Role::Physics };
    (@role $role:ident) => { Role::$role };

    (@model Every) => { None };
    (@model $model:ident) => { Some(Model::$model) };

    (@default (choice $type:ident), ($default:ident)) => { $type::$default };
    (@default (text $type:ident), $domain:tt) => { $type::default() };
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

    (@slot number, $x:expr) => { Slot::Number(&mut $x) };
    (@slot integer, $x:expr) => { Slot::Whole(&mut $x) };
    (@slot seed, $x:expr) => { Slot::Seed(&mut $x) };
    (@slot flag, $x:expr) => { Slot::Flag(&mut $x) };
    (@slot colour, $x:expr) => { Slot::Colour(&mut $x) };
    (@slot (text $type:ident), $x:expr) => { Slot::Text(&mut $x) };
    (@slot (choice $type:ident), $x:expr) => { Slot::Choice(&mut $x) };
}

/// Expands the table of an object's properties to the struct of its values, its entries, their
/// descriptions and their names as text. An entry is one of [`parameters!`].
macro_rules! properties {
    (@value (text $type:ident), $domain:tt) => { Value::Text($type::DEFAULT) };
    (@value $kind:tt, $domain:tt) => {
        parameters!(@value $kind, parameters!(@default $kind, $domain))
    };
    ($(#[$about:meta])* $object:ident: $entries:ident, $descriptions:ident, $named:ident;
        $( #[doc = $first_doc:literal] $(#[doc = $doc:literal])* $([$role:ident])?
        $id:ident : $kind:tt $label:literal $([$unit:literal])? $($scale:ident)?
            { $domain:tt } $(when { $( $choice:ident : $names:expr ),+ })?
    )+) => {
        $(#[$about])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $object { $(
            #[doc = $first_doc]
            $(#[doc = $doc])*
            pub $id: parameters!(@type $kind),
        )+ }

        impl Default for $object {
            fn default() -> Self {
                $object { $( $id: parameters!(@default $kind, $domain), )+ }
            }
        }

        impl $object {
            /// The fields in the order of the table.
            fn slots(&mut self) -> impl Iterator<Item = Slot<'_>> {
                [ $( parameters!(@slot $kind, self.$id), )+ ].into_iter()
            }
        }

        /// Every property, in the order of a panel.
        pub static $entries: &[Param] = &[ $( Param {
            id: stringify!($id),
            property: stringify!($id),
            unit: concat!($($unit)?),
            kind: parameters!(@kind $kind $($scale)?),
            domains: &[Domain {
                model: None,
                default: properties!(@value $kind, $domain),
                range: parameters!(@range $kind, $domain),
            }],
            role: parameters!(@role $($role)?),
            field: None,
        }, )+ ];

        /// The label and documentation of each property, in the same order.
        pub(super) static $descriptions: &[Description] = &[ $( Description {
            group: "",
            label: $label,
            doc: concat!($first_doc, $($doc),*).trim_ascii(),
            when: &[ $($( (stringify!($choice), $names) ),+)? ],
            unless: &[],
        }, )+ ];

        /// The names of the properties, with that which objects of every kind have.
        pub(crate) const $named: &[&str] = &["name", $( stringify!($id), )+];
    };
}

pub(super) use {parameters, properties};

//! The messages that an engine understands.
//!
//! | type | other fields | what it does |
//! |---|---|---|
//! | `add` | `width`, `height`, `side`?, `warm`?, `state`?, `preset`?, `config`?, `kept`?, `values`?, `ownNumber`?, `quality`?, `guess`?, `paused`?, `visible`?, `view`? | a new fire |
//! | `resize` | `width`, `height`, `side`? | its size in device pixels; 0 is fine; `side`: its height, or that of a square of its area, in CSS pixels |
//! | `set` | `request`, `source`, `values` | sets parameters, all or none |
//! | `check` | `request`, `source`, `values` | asks whether `set` would take them |
//! | `restore` | `request`, `source`, `ids` | puts parameters back to their defaults |
//! | `addObject` | `request`, `source`, `object` | adds an object; `done` has its id as `value` |
//! | `changeObject` | `request`, `source`, `id`, `values` | sets properties of an object, all or none |
//! | `removeObject` | `request`, `source`, `id` | removes an object |
//! | `preset` | `request`, `name` | sets every parameter to the preset's |
//! | `import` | `request`, `source`, `config` | sets every parameter as the settings say: see [`config`](crate::config) |
//! | `export` | `request` | asks for its settings |
//! | `limit` | `request`, `id`: `fps_limit` or `max_pixels`, `value`? | most pictures a second, most pixels of one; without a value, no limit of its own |
//! | `stir` | `x`, `y`, `u`, `v` | moves the gas there [m] as fast as that [m/s] |
//! | `sparks` | `request`, `x`, `y`, `count` | throws so many sparks from there [m] |
//! | `view` | `request`, `fit`, `x`, `y` | how the domain fits the picture: height, contain, cover or width; and where it stands in it, 0 to 1 from left and from below |
//! | `quality` | `request`, `quality` | how much work it makes itself: low, medium, high or auto |
//! | `play`, `pause`, `reset` | `request` | what they say |
//! | `step` | `request`, `steps` | makes that many steps, playing or not |
//! | `burn` | `request`, `seconds` | the same, as many as so much fire needs |
//! | `warm` | `request`, `seconds`? | how long a new fire burns before it is shown; answered when it is, or nobody looks |
//! | `visible` | `visible` | a fire that nobody sees does no work |
//! | `remove` | | frees the fire |
//!
//! Every message names its `fire`, a number that the sender chooses. Whoever
//! sends a `request` number gets it back with `done` or `refused`.

use hearth_render::Camera;

use crate::config::Config;
use crate::fields::Fields;
use crate::limits::{Limit, Sparks, Stir};
use crate::quality::Level;
use crate::raw::Raw;
use crate::view;
use crate::warm::LONGEST as LONGEST_WARM;

/// Longest side of a canvas in device pixels; browsers allow no more.
pub const LONGEST_SIDE: u32 = 16_384;

/// Largest id of an object.
const MOST_OBJECT_ID: u32 = 1_000_000;

/// Most steps that one message may ask for.
pub const MOST_STEPS: u32 = 100_000;

/// Most seconds of fire that one message may ask for.
pub const MOST_SECONDS: f64 = 1000.0;

/// How long a fire may burn before it is shown, in words.
const WARM: &str = "a number from 0 to 30";

/// Values as they were sent, by id.
pub type SentValues = Vec<(String, Raw)>;

/// A message whose form is right. Its parameter values are not checked yet:
/// that is the table's business.
#[derive(Debug, PartialEq)]
pub struct Message {
    /// The fire that it is about.
    pub fire: u32,
    /// The number under which the sender wants an answer.
    pub request: Option<f64>,
    /// Who wanted it: an attribute, a property, the panel …
    pub source: String,
    /// What is wanted.
    pub order: Order,
}

/// What a message wants.
#[derive(Debug, PartialEq)]
pub enum Order {
    /// A new fire.
    Add(Start),
    /// Another size of its canvas, and the side that tells how many particles it needs.
    Resize(u32, u32, f64),
    /// Other values.
    Set(SentValues),
    /// Whether these values would be taken.
    Check(SentValues),
    /// The default values of these ids.
    Restore(Vec<String>),
    /// Another object, with these fields.
    AddObject(SentValues),
    /// Other properties of the object of that id.
    ChangeObject(u32, SentValues),
    /// No object of that id.
    RemoveObject(u32),
    /// All values of that preset.
    Preset(String),
    /// All values of those settings.
    Import(Config),
    /// Its settings.
    Export,
    /// How much it may draw.
    Limit(Limit),
    /// Gas to be moved.
    Stir(Stir),
    /// Sparks to be thrown.
    Sparks(Sparks),
    /// Another part of the world to be seen.
    View(Camera),
    /// That quality, or whichever fits.
    Quality(Option<Level>),
    /// Go on.
    Play,
    /// Stand still.
    Pause,
    /// Start again from nothing.
    Reset,
    /// Make so many steps.
    Step(u32),
    /// Make steps for so many seconds of fire.
    Burn(f64),
    /// Burn so long before the first picture; as long as before, where nothing is said.
    Warm(Option<f64>),
    /// Whether anybody sees it.
    Visible(bool),
    /// Free it.
    Remove,
}

/// How a new fire starts.
#[derive(Debug, PartialEq)]
pub struct Start {
    /// Width and height of its canvas in device pixels.
    pub size: (u32, u32),
    /// Its height, or that of a square of its area, in CSS pixels; 0: not known.
    pub side: f64,
    /// Seconds of fire before it is shown.
    pub warm: f64,
    /// A kept fire to start with, where its values are those that are wanted.
    pub state: Vec<u8>,
    /// The preset to start from.
    pub preset: Option<String>,
    /// The settings to start from, in its place, not checked yet.
    pub config: Raw,
    /// Values on top of it, of a model that it had before.
    pub kept: SentValues,
    /// Values on top of all that.
    pub values: SentValues,
    /// Whether the number of particles among them is one that somebody set.
    pub own_number: bool,
    /// The quality that is asked for; nothing: whichever fits.
    pub quality: Option<Level>,
    /// The one that may fit this device.
    pub guess: Option<Level>,
    /// Whether it stands still at first.
    pub paused: bool,
    /// Whether anybody sees it.
    pub visible: bool,
    /// How its world is seen.
    pub camera: Camera,
}

/// One thing that was refused, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// The parameter, or the field of the message.
    pub id: String,
    /// What was sent for it.
    pub value: Raw,
    /// Why not, in words that name the id, the value and what is allowed.
    pub message: String,
    /// Smallest and largest allowed value, where there are such.
    pub range: Option<(f64, f64)>,
}

impl Refused {
    // Many callers, here and below: what is inlined into each is a kilobyte in all.
    #[inline(never)]
    pub(crate) fn field(id: &str, value: &Raw, allowed: &str) -> Refused {
        Refused {
            id: id.to_owned(),
            value: value.clone(),
            message: format!("{id} = {} is refused: it must be {allowed}", value.input()),
            range: None,
        }
    }

    /// A fire that is not there, or is there already.
    pub fn fire(fire: u32) -> Refused {
        let value = Raw::Number(fire.into());
        Refused::field("fire", &value, "the number of a fire, or a new one to add")
    }

    pub(crate) fn whole(id: &str, value: &Raw, min: u32, max: u32) -> Refused {
        Refused {
            range: Some((min.into(), max.into())),
            ..Refused::field(id, value, &format!("a whole number from {min} to {max}"))
        }
    }
}

/// A refused message: to whom the answer goes, and what was wrong.
#[derive(Debug, PartialEq)]
pub struct RefusedMessage {
    /// The fire, where the message named one.
    pub fire: Option<u32>,
    /// The request, where it named one.
    pub request: Option<f64>,
    /// The source, where it named one.
    pub source: String,
    /// What was wrong.
    pub errors: Vec<Refused>,
}

impl Message {
    /// Checks the form of a message.
    ///
    /// # Errors
    /// The first field that is not as the table above has it.
    pub fn parse(raw: &Raw) -> Result<Message, RefusedMessage> {
        let mut fields = Fields::of(raw);
        let fire = fields.whole("fire", 0, u32::MAX);
        let named = fields.are_good();
        let request = fields.optional_number("request");
        let source = match raw.field("source") {
            Raw::Text(source) => source.clone(),
            _ => String::new(),
        };
        let order = Order::read(&mut fields);
        match (order, fields.refused()) {
            (Some(order), None) => Ok(Message {
                fire,
                request,
                source,
                order,
            }),
            (_, refused) => Err(RefusedMessage {
                fire: named.then_some(fire),
                request,
                source,
                errors: refused.into_iter().collect(),
            }),
        }
    }
}

impl Order {
    /// Reads it; nothing, or anything, where a field is refused.
    fn read(fields: &mut Fields<'_>) -> Option<Order> {
        let raw = fields.raw;
        let name = match raw.field("type") {
            Raw::Text(name) => name.as_str(),
            _ => "",
        };
        Some(match name {
            "add" => Order::Add(Start {
                size: Order::size(fields),
                side: Order::side(fields),
                warm: fields
                    .optional_seconds("warm", LONGEST_WARM, WARM)
                    .unwrap_or(0.0),
                state: fields.optional_bytes("state"),
                preset: fields.optional_text("preset"),
                config: raw.field("config").clone(),
                kept: fields.optional_values("kept"),
                values: fields.optional_values("values"),
                own_number: fields.flag("ownNumber", Some(false)),
                quality: fields.quality("quality"),
                guess: fields.quality("guess"),
                paused: fields.flag("paused", Some(false)),
                visible: fields.flag("visible", Some(true)),
                camera: match raw.field("view") {
                    Raw::Missing => Camera::default(),
                    camera => fields.keep(view::parse(camera)).unwrap_or_default(),
                },
            }),
            "resize" => {
                let (width, height) = Order::size(fields);
                Order::Resize(width, height, Order::side(fields))
            }
            "set" => Order::Set(fields.values("values")),
            "check" => Order::Check(fields.values("values")),
            "restore" => Order::Restore(fields.texts("ids", "an array of ids")),
            "addObject" => Order::AddObject(fields.values("object")),
            "changeObject" => Order::ChangeObject(
                fields.whole("id", 1, MOST_OBJECT_ID),
                fields.values("values"),
            ),
            "removeObject" => Order::RemoveObject(fields.whole("id", 1, MOST_OBJECT_ID)),
            "preset" => Order::Preset(fields.text("name")),
            "import" => Order::Import(fields.keep(Config::parse(raw.field("config")))?),
            "export" => Order::Export,
            "limit" => Order::Limit(fields.keep(Limit::parse(raw))?),
            "stir" => Order::Stir(fields.keep(Stir::parse(raw))?),
            "sparks" => Order::Sparks(fields.keep(Sparks::parse(raw))?),
            "view" => Order::View(fields.keep(view::parse(raw))?),
            "quality" => Order::Quality(fields.quality("quality")),
            "play" => Order::Play,
            "pause" => Order::Pause,
            "reset" => Order::Reset,
            "step" => Order::Step(fields.whole("steps", 1, MOST_STEPS)),
            "burn" => Order::Burn(fields.positive(
                "seconds",
                MOST_SECONDS,
                "a number above 0, up to 1000",
            )),
            "warm" => Order::Warm(fields.optional_seconds("seconds", LONGEST_WARM, WARM)),
            "visible" => Order::Visible(fields.flag("visible", None)),
            "remove" => Order::Remove,
            _ => {
                fields.refuse("type", "the name of a message");
                return None;
            }
        })
    }

    fn size(fields: &mut Fields<'_>) -> (u32, u32) {
        let mut side = |id| fields.whole(id, 0, LONGEST_SIDE);
        (side("width"), side("height"))
    }

    fn side(fields: &mut Fields<'_>) -> f64 {
        fields.optional_number("side").unwrap_or(0.0)
    }
}

/// The same items, before all others that of the model: it decides which values
/// the others may have, and which default.
pub(crate) fn model_first<T>(items: &[T], id: fn(&T) -> &String) -> impl Iterator<Item = &T> {
    let of_model = move |item: &&T| id(item) == "model";
    let others = items.iter().filter(move |item| !of_model(item));
    items.iter().filter(of_model).chain(others)
}

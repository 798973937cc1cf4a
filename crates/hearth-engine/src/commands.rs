//! The table of commands of an engine.
//!
//! A call is `[fire, request, name, …arguments]`. The sender chooses the number `fire`. The
//! answer carries the number `request`; 0 means no answer. Each entry has a name, arguments
//! with types and checks, and a doc. A new command is an entry here, an arm of `Engine::run`
//! and a method of the element, whose JSDoc gives the types, the reference and the iframe's list.

use hearth_render::Fit;
use hearth_settings::untrusted::{
    Argument, Check, Form, Positive, Untrusted, ValidationError, Values, Whole, Within,
};

use crate::pacing::picture_limits::{Fps, Pixels};
use hearth_core::resolution::Level;

/// Maximum side of a canvas [device pixels], which browsers set.
pub const MAX_SIDE: i32 = 16_384;

/// Maximum number of steps of one call.
pub const MAX_STEPS: i32 = 100_000;

/// Maximum duration of the steps of one call [s of fire].
pub const MAX_SECONDS: i32 = 1000;

/// Maximum duration of a warm-up [s of fire].
pub const MAX_WARM: i32 = 30;

/// Maximum mass of water of one call [g/m].
pub const MAX_GRAMS: i32 = 1000;

/// A side of a canvas [device pixels].
pub type Side = Whole<0, MAX_SIDE>;

/// Duration of a warm-up [s of fire].
pub type WarmSeconds = Within<0, MAX_WARM>;

/// The id of an object.
pub type ObjectId = Whole<1, 1_000_000>;

/// A coordinate of a position in the fire's world \[m\].
pub type Metres = Within<-1000, 1000>;

/// A component of a velocity [m/s].
pub type Speed = Within<-20, 20>;

/// Alignment of the domain in the picture, or of the part that is seen, as a share of the free
/// space.
pub type Align = Within<0, 1>;

/// A sample rate \[Hz\].
pub type SampleRate = Within<8000, 768_000>;

/// How loud a part of the sound is, relative to the balance of recorded fires.
pub type Loudness = Within<0, 2>;

/// Magnification of the picture.
pub type Zoom = Within<1, 10>;

/// An argument of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArgumentEntry {
    /// Name in errors.
    pub id: &'static str,
    /// Check of its value.
    pub check: Check,
}

/// A command of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommandEntry {
    /// Name in calls.
    pub name: &'static str,
    command: Name,
    /// Arguments in their order.
    pub arguments: &'static [ArgumentEntry],
}

/// Expands the table to [`Command`] and [`COMMANDS`].
macro_rules! commands {
    ($life:lifetime $(
        $(#[doc = $doc:literal])+
        $name:literal $command:ident { $( $argument:ident : $type:ty ),* }
    )+) => {
        /// A command with checked arguments. Values of parameters and settings among them are
        /// not checked yet.
        #[derive(Debug, PartialEq)]
        #[expect(missing_docs, reason = "the table documents each command as a whole")]
        pub enum Command<$life> { $(
            $(#[doc = $doc])+
            $command { $( $argument: $type ),* },
        )+ }

        /// All commands.
        pub static COMMANDS: &[CommandEntry] = Command::ENTRIES;

        /// The names of the commands.
        #[derive(Clone, Copy, Debug, PartialEq)]
        enum Name { $( $command ),+ }

        impl<$life> Command<$life> {
            const ENTRIES: &'static [CommandEntry] = &[ $(
                CommandEntry {
                    name: $name,
                    command: Name::$command,
                    arguments: &[ $( ArgumentEntry {
                        id: stringify!($argument),
                        check: <$type as Argument<$life>>::CHECK,
                    } ),* ],
                },
            )+ ];

            /// Reads checked arguments.
            fn read(command: Name, arguments: Arguments<$life>) -> Command<$life> {
                match command { $(
                    Name::$command => {
                        commands!(@names arguments $( $argument )*);
                        Command::$command { $( $argument: Argument::read($argument) ),* }
                    }
                )+ }
            }
        }
    };
    (@names $arguments:ident) => {};
    (@names $arguments:ident $a:ident) => {
        let [$a, ..] = $arguments;
    };
    (@names $arguments:ident $a:ident $b:ident) => {
        let [$a, $b, ..] = $arguments;
    };
    (@names $arguments:ident $a:ident $b:ident $c:ident) => {
        let [$a, $b, $c, ..] = $arguments;
    };
    (@names $arguments:ident $a:ident $b:ident $c:ident $d:ident) => {
        let [$a, $b, $c, $d, ..] = $arguments;
    };
    (@names $arguments:ident $a:ident $b:ident $c:ident $d:ident $e:ident) => {
        let [$a, $b, $c, $d, $e] = $arguments;
    };
}

/// The checked arguments of a call, as many as any command has.
type Arguments<'a> = [&'a Untrusted; 5];

commands! { 'a
    /// Adds a fire.
    "add" Add { start: Start<'a> }
    /// Sets parameters, all or none; null restores a default. With another model, the attributes of the page apply again.
    "set" Set { values: Values<'a>, source: &'a str, attributes: &'a Untrusted }
    /// Checks values as `set` would.
    "check" CheckValues { values: Values<'a> }
    /// Adds an object. Answers with its id.
    "addObject" AddObject { object: Values<'a>, source: &'a str }
    /// Sets properties of an object, all or none.
    "changeObject" ChangeObject { id: ObjectId, values: Values<'a>, source: &'a str }
    /// Removes an object.
    "removeObject" RemoveObject { id: ObjectId, source: &'a str }
    /// Lays the [list of children](hearth_settings::Settings::with_children) over the objects. What is refused is left out.
    "children" Children { children: &'a Untrusted }
    /// Replaces all settings by those of a preset.
    "preset" Preset { name: &'a str, source: &'a str }
    /// Undoes or redoes steps by their [deltas](hearth_settings::delta); unless they lead to another preset, it burns on.
    "restore" Restore { deltas: &'a Untrusted, source: &'a str }
    /// Replaces all settings by a [settings file](hearth_settings::file); on request, the seed only by one that it names.
    "import" Import { config: &'a Untrusted, source: &'a str, keeps_seed: Option<bool> }
    /// Answers with a settings file.
    "export" Export {}
    /// Resizes the picture [device pixels]. `side` is the height of the element or, if that is
    /// less, the side of a square of the same area [CSS pixels].
    "resize" Resize { width: Side, height: Side, side: f64 }
    /// Sets whether the element is visible. An invisible fire does no work.
    "visible" Visible { visible: bool }
    /// Limits pictures per second; without a number, removes the limit.
    "fps_limit" LimitFps { fps_limit: Option<Fps> }
    /// Limits the pixels of a picture; without a number, the quality limits them.
    "max_pixels" LimitPixels { max_pixels: Option<Pixels> }
    /// Pulls the gas around a position \[m\] along with a velocity [m/s].
    "stir" Stir { x: Metres, y: Metres, u: Speed, v: Speed }
    /// Throws sparks from a position \[m\].
    "sparks" Sparks { x: Metres, y: Metres, count: Whole<1, 200> }
    /// Lights what is within a radius of a position \[m\] or, unless `lit`, puts it out; 0 is the
    /// usual radius. With a radius below 0, `place` is the id of a solid with fuel.
    "light" Light { lit: bool, radius: f64, place: f64, y: f64 }
    /// Sprays a mass of water [g/m] from a position \[m\] with a velocity [m/s].
    "spray" Spray { x: Metres, y: Metres, u: Speed, v: Speed, grams: Positive<MAX_GRAMS> }
    /// Answers with the [numbers](hearth_core::Simulation::free_solid_numbers) of the solids that
    /// forces move.
    "freeSolids" FreeSolids {}
    /// Answers with the [numbers](hearth_core::Simulation::measure) of the fire, of a position \[m\]
    /// and of the vertical through it.
    "measure" Measure { x: Metres, y: Metres }
    /// Sets how the domain fits the picture, and its alignment from the left and from below.
    "view" View { fit: NamedFit, x: Align, y: Align }
    /// Enlarges a part of the picture at that position from the left and from below.
    "zoom" Zoom { zoom: Zoom, x: Align, y: Align }
    /// Fixes the level of quality, or makes it adaptive.
    "quality" Quality { quality: RequestedLevel }
    /// Plays.
    "play" Play {}
    /// Pauses.
    "pause" Pause {}
    /// Sets how loud roar, crackle and hiss are. Each frame in which the fire plays posts its `samples`, of this rate
    /// \[Hz\], until a call has none.
    "sound" Sound { rate: Option<SampleRate>, roar: Loudness, crackle: Loudness, hiss: Loudness }
    /// Restarts the simulation with the same settings.
    "reset" Reset {}
    /// Makes a number of steps, even if paused. The answer follows when they are drawn.
    "step" Step { steps: Whole<1, MAX_STEPS> }
    /// Makes steps for a duration [s of fire], even if paused. The answer follows when they are drawn.
    "advance" Advance { seconds: Within<0, MAX_SECONDS> }
    /// Sets the duration of the warm-up of new fires. The answer follows when the fire is shown
    /// or cannot be drawn.
    "warm" Warm { seconds: Option<WarmSeconds> }
    /// Frees the fire.
    "remove" Remove {}
}

impl<'a> Command<'a> {
    /// Parses a call.
    ///
    /// # Errors
    /// No command has that name, or an argument fails its check.
    pub fn parse(
        name: &Untrusted,
        arguments: &'a [Untrusted],
    ) -> Result<Command<'a>, ValidationError> {
        let Some(entry) = COMMANDS.iter().find(|entry| entry.name == name.text()) else {
            return Err(ValidationError::new(
                "method",
                name,
                "the name of a command",
            ));
        };
        let mut checked: Arguments<'a> = [&Untrusted::Missing; 5];
        let sent = arguments
            .iter()
            .chain(std::iter::repeat(&Untrusted::Missing));
        for ((slot, argument), value) in checked.iter_mut().zip(entry.arguments).zip(sent) {
            argument.check.test(argument.id, value)?;
            *slot = value;
        }
        Ok(Command::read(entry.command, checked))
    }
}

/// The start of a new fire. The element writes it; its values and settings come from the page
/// and are checked one by one.
#[derive(Clone, Debug, PartialEq)]
pub struct Start<'a> {
    /// Height of the element, or the side of a square of the same area [CSS pixels]; NaN:
    /// unknown.
    pub side: f64,
    /// Duration of the warm-up [s of fire].
    pub warm: f64,
    /// A saved fire to resume if its settings match.
    pub state: &'a [u8],
    /// The preset.
    pub preset: Option<&'a str>,
    /// A settings file, which replaces the preset.
    pub config: &'a Untrusted,
    /// Values on top of all. A copy of a copy records the sparks of a loop or, with two values, shows those of the loop: the
    /// number of its first picture, and of its pictures.
    pub values: Values<'a>,
    /// The requested level of quality; `None`: adaptive.
    pub quality: Option<Level>,
    /// A guess of the level for this device.
    pub guess: Option<Level>,
    /// Whether the fire starts paused.
    pub paused: bool,
    /// Whether the element has children, whose list is the next call.
    pub children: bool,
    /// Whether each picture is followed by the fire's lights.
    pub lights: bool,
    /// Whether a picture is an [atlas](hearth_render::View::sheets).
    pub sheets: bool,
    /// The number of the fire that it copies for a film, instead of all settings; 0: none. That fire waits until the copy
    /// is removed.
    pub films: u32,
}

impl<'a> Argument<'a> for Start<'a> {
    const CHECK: Check = Check::required(Form::Values);

    fn read(value: &'a Untrusted) -> Start<'a> {
        let level = |id: &str| Level::of(value.field(id).text());
        Start {
            side: value.field("side").number(),
            warm: value.field("warm").number(),
            state: value.field("state").bytes(),
            preset: Argument::read(value.field("preset")),
            config: value.field("config"),
            values: value.field("values").fields(),
            quality: level("quality"),
            guess: level("guess"),
            paused: Argument::read(value.field("paused")),
            children: Argument::read(value.field("children")),
            lights: Argument::read(value.field("lights")),
            sheets: Argument::read(value.field("sheets")),
            films: value.field("films").number() as u32,
        }
    }
}

/// A requested level of quality; `None`: adaptive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RequestedLevel(pub Option<Level>);

impl Argument<'_> for RequestedLevel {
    const CHECK: Check = Check::required(Form::OneOf(&["auto", "low", "medium", "high"]));

    fn read(value: &Untrusted) -> RequestedLevel {
        RequestedLevel(Level::of(value.text()))
    }
}

/// A fit of the domain, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedFit(pub Fit);

impl Argument<'_> for NamedFit {
    const CHECK: Check = Check::required(Form::OneOf(&["height", "contain", "cover", "width"]));

    fn read(value: &Untrusted) -> NamedFit {
        let known = Fit::ALL.iter().find(|(name, _)| *name == value.text());
        NamedFit(known.map_or(Fit::default(), |(_, fit)| *fit))
    }
}

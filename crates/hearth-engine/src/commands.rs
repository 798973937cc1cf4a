//! The table of commands: what a script can ask of an engine.
//!
//! A call is `[fire, request, name, …arguments]`. `fire` is a number that the sender
//! chooses. `request` is the number that the answer carries, or 0 where nobody waits for
//! one. The table states each command once: its name, its arguments with their types and
//! checks, and its doc. A new command is an entry here, an arm of `Engine::run` and a
//! method of the element.

use hearth_bindings::{
    Argument, Check, Form, Ids, Positive, Untrusted, ValidationError, Values, Whole, Within,
};
use hearth_render::Fit;

use crate::limits::{Fps, Pixels};
use crate::quality::Level;

/// Longest side of a canvas in device pixels; browsers allow no more.
pub const MAX_SIDE: i32 = 16_384;

/// Most steps that one call may ask for.
pub const MAX_STEPS: i32 = 100_000;

/// Most seconds of fire that one call may ask for.
pub const MAX_SECONDS: i32 = 1000;

/// Longest time that a fire may burn before it is shown \[s\].
pub const MAX_WARM: i32 = 30;

/// A side of a canvas in device pixels.
pub type Side = Whole<0, MAX_SIDE>;

/// Seconds of fire that a new fire burns before it is shown.
pub type WarmSeconds = Within<0, MAX_WARM>;

/// The id of an object.
pub type ObjectId = Whole<1, 1_000_000>;

/// A coordinate of a place in the fire's world \[m\].
pub type Metres = Within<-1000, 1000>;

/// A velocity component of moved gas [m/s].
pub type Speed = Within<-20, 20>;

/// Where the domain stands in the picture, as a part of the free space.
pub type Align = Within<0, 1>;

/// What is known about an argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArgumentEntry {
    /// Its name, which errors use.
    pub id: &'static str,
    /// What it must be.
    pub check: Check,
}

/// What is known about a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommandEntry {
    /// Its name in calls.
    pub name: &'static str,
    command: Name,
    /// Its arguments in their order.
    pub arguments: &'static [ArgumentEntry],
}

/// Turns the table into [`Command`] and [`COMMANDS`].
macro_rules! commands {
    ($life:lifetime $(
        $(#[doc = $doc:literal])+
        $name:literal $command:ident { $( $argument:ident : $type:ty ),* }
    )+) => {
        /// What a call asks for. Its arguments have passed their checks; values of
        /// parameters and settings have not.
        #[derive(Debug, PartialEq)]
        #[expect(missing_docs, reason = "the table documents each command as a whole")]
        pub enum Command<$life> { $(
            $(#[doc = $doc])+
            $command { $( $argument: $type ),* },
        )+ }

        /// Every command.
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
        let [$a, $b, $c, $d] = $arguments;
    };
}

/// The checked arguments of a call, as many as any command has.
type Arguments<'a> = [&'a Untrusted; 4];

commands! { 'a
    /// Adds a fire that starts as described.
    "add" Add { start: Start<'a> }
    /// Sets parameters, all or none.
    "set" Set { values: Values<'a>, source: &'a str }
    /// Answers whether `set` would take these values.
    "check" CheckValues { values: Values<'a> }
    /// Puts parameters back to their defaults, all or none.
    "restore" Restore { ids: Ids<'a>, source: &'a str }
    /// Adds an object and answers with its id.
    "addObject" AddObject { object: Values<'a>, source: &'a str }
    /// Sets properties of an object, all or none.
    "changeObject" ChangeObject { id: ObjectId, values: Values<'a>, source: &'a str }
    /// Removes an object.
    "removeObject" RemoveObject { id: ObjectId, source: &'a str }
    /// Replaces every parameter by the preset's.
    "preset" Preset { name: &'a str, source: &'a str }
    /// Replaces every parameter by those of settings: see [`config`](crate::config).
    "import" Import { config: &'a Untrusted, source: &'a str }
    /// Answers with the settings.
    "export" Export {}
    /// Resizes the picture [device pixels]. `side` is the height or, where that is less,
    /// the side of a square of the same area [CSS pixels].
    "resize" Resize { width: Side, height: Side, side: f64 }
    /// Tells whether anybody sees the fire. Without viewers it does no work.
    "visible" Visible { visible: bool }
    /// Limits pictures a second; without a number, the fire has no limit of its own.
    "fps_limit" LimitFps { fps_limit: Option<Fps> }
    /// Limits pixels of a picture; without a number, the quality does.
    "max_pixels" LimitPixels { max_pixels: Option<Pixels> }
    /// Moves the gas around a place \[m\] with a velocity [m/s].
    "stir" Stir { x: Metres, y: Metres, u: Speed, v: Speed }
    /// Throws sparks from a place \[m\].
    "sparks" Sparks { x: Metres, y: Metres, count: Whole<1, 200> }
    /// Fits the domain into the picture, aligned from left and from below.
    "view" View { fit: Fitting, x: Align, y: Align }
    /// Fixes the quality, or lets the fire find its own.
    "quality" Quality { quality: Wish }
    /// Burns on.
    "play" Play {}
    /// Stands still.
    "pause" Pause {}
    /// Starts again from nothing, with the same values.
    "reset" Reset {}
    /// Makes so many steps, playing or not. The answer follows when they are drawn.
    "step" Step { steps: Whole<1, MAX_STEPS> }
    /// Makes steps for so many seconds of fire. The answer follows when they are drawn.
    "burn" Burn { seconds: Positive<MAX_SECONDS> }
    /// Sets how long a new fire burns before it is shown. The answer follows when it is
    /// shown, or when nobody looks.
    "warm" Warm { seconds: Option<WarmSeconds> }
    /// Frees the fire.
    "remove" Remove {}
}

impl<'a> Command<'a> {
    /// Reads a call of the command of that name.
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
        let mut checked: Arguments<'a> = [&Untrusted::Missing; 4];
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

/// How a new fire starts. Only the element writes it; the values and settings in it are a
/// page's, and are checked one by one.
#[derive(Clone, Debug, PartialEq)]
pub struct Start<'a> {
    /// Its height, or the side of a square of the same area [CSS pixels]; NaN: unknown.
    pub side: f64,
    /// Seconds of fire before it is shown.
    pub warm: f64,
    /// A saved fire to start with, where it burnt with the same values.
    pub state: &'a [u8],
    /// The preset to start from.
    pub preset: Option<&'a str>,
    /// The settings to start from, in its place.
    pub config: &'a Untrusted,
    /// Values on top of it, of the model that it had before.
    pub kept: Values<'a>,
    /// Values on top of all that.
    pub values: Values<'a>,
    /// Whether the number of particles among them was set, and does not follow quality.
    pub count_overridden: bool,
    /// The requested quality; nothing: the fire finds its own.
    pub quality: Option<Level>,
    /// The level that may fit this device.
    pub guess: Option<Level>,
    /// Whether it stands still at first.
    pub paused: bool,
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
            kept: value.field("kept").fields(),
            values: value.field("values").fields(),
            count_overridden: Argument::read(value.field("ownNumber")),
            quality: level("quality"),
            guess: level("guess"),
            paused: Argument::read(value.field("paused")),
        }
    }
}

/// A requested quality: a level, or nothing where the fire finds its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wish(pub Option<Level>);

impl Argument<'_> for Wish {
    const CHECK: Check = Check::required(Form::OneOf(&["auto", "low", "medium", "high"]));

    fn read(value: &Untrusted) -> Wish {
        Wish(Level::of(value.text()))
    }
}

/// How the domain fits the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fitting(pub Fit);

impl Argument<'_> for Fitting {
    const CHECK: Check = Check::required(Form::OneOf(&["height", "contain", "cover", "width"]));

    fn read(value: &Untrusted) -> Fitting {
        let known = Fit::ALL.iter().find(|(name, _)| *name == value.text());
        Fitting(known.map_or(Fit::default(), |(_, fit)| *fit))
    }
}

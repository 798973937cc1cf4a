//! What a parameter can hold, and what is said when it cannot.
//!
//! A value reaches Hearth as a number, a text or a flag, whoever sends it: a
//! slider, an attribute, a URL, a JSON file, a message. [`Input`] is that raw
//! form, [`Value`] the checked one, [`ParamError`] the refusal.

use std::fmt;

use super::decimal::{self, Decimal};

/// A colour with opacity, 8 bits a channel, sRGB, not premultiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour {
    /// Red, green, blue and opacity, each 0–255.
    pub rgba: [u8; 4],
}

impl Colour {
    /// Nothing at all: the page shows through.
    pub const TRANSPARENT: Colour = Colour { rgba: [0; 4] };

    /// An opaque colour.
    pub const fn rgb(r: u8, g: u8, b: u8) -> Colour {
        Colour {
            rgba: [r, g, b, 255],
        }
    }

    /// Reads `transparent`, `#rgb`, `#rrggbb` or `#rrggbbaa`.
    pub fn parse(text: &str) -> Option<Colour> {
        let text = text.trim();
        if text.eq_ignore_ascii_case("transparent") {
            return Some(Colour::TRANSPARENT);
        }
        let digits = text.strip_prefix('#')?;
        if !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return None;
        }
        // `get`, here and below: what an index of a text says when it panics would be
        // 3.5 KB of a page's download.
        let byte =
            |at: usize, length: usize| u8::from_str_radix(digits.get(at..at + length)?, 16).ok();
        let mut rgba = [255; 4];
        match digits.len() {
            3 => {
                for (channel, at) in rgba.iter_mut().zip(0..3) {
                    *channel = byte(at, 1)? * 17;
                }
            }
            6 | 8 => {
                for (channel, at) in rgba.iter_mut().zip((0..digits.len()).step_by(2)) {
                    *channel = byte(at, 2)?;
                }
            }
            _ => return None,
        }
        // What cannot be seen has no colour, so it reads back as it was written.
        Some(match rgba {
            [.., 0] => Colour::TRANSPARENT,
            _ => Colour { rgba },
        })
    }
}

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [r, g, b, a] = self.rgba;
        match a {
            0 => f.write_str("transparent"),
            255 => write!(f, "#{r:02x}{g:02x}{b:02x}"),
            _ => write!(f, "#{r:02x}{g:02x}{b:02x}{a:02x}"),
        }
    }
}

/// A checked value of one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A real number, in the parameter's unit.
    Number(f32),
    /// A whole number.
    Integer(u32),
    /// One of a parameter's named choices.
    Choice(&'static str),
    /// On or off.
    Flag(bool),
    /// A colour.
    Colour(Colour),
    /// The seed of the random generator.
    Seed(u32),
}

impl Value {
    /// The value as JavaScript and JSON see it where it is numeric: the
    /// shortest decimal that reads back as the same `f32`, so that 0.05 stays
    /// 0.05. `None` for a choice, a flag or a colour.
    pub fn as_number(&self) -> Option<f64> {
        match *self {
            Value::Number(x) => Some(decimal::shortest(x)),
            Value::Integer(n) | Value::Seed(n) => Some(f64::from(n)),
            Value::Choice(_) | Value::Flag(_) | Value::Colour(_) => None,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Number(x) => write!(f, "{}", Decimal(decimal::shortest(*x))),
            Value::Integer(n) | Value::Seed(n) => write!(f, "{n}"),
            Value::Choice(name) => f.write_str(name),
            Value::Flag(on) => write!(f, "{on}"),
            Value::Colour(colour) => write!(f, "{colour}"),
        }
    }
}

/// A value as somebody sent it, not yet checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Input<'a> {
    /// A number, from a slider, JSON or a call.
    Number(f64),
    /// A text, from an attribute or a URL; it may spell any kind of value.
    Text(&'a str),
    /// On or off.
    Flag(bool),
}

impl Input<'_> {
    pub(super) fn number(&self) -> Option<f64> {
        match *self {
            Input::Number(x) => Some(x),
            Input::Text(text) => decimal::parse(text.trim()),
            Input::Flag(_) => None,
        }
        .filter(|x: &f64| x.is_finite())
    }

    pub(super) fn flag(&self) -> Option<bool> {
        match *self {
            Input::Flag(on) => Some(on),
            // An attribute that is there without a value means "on", as HTML's
            // own flags do.
            Input::Text("" | "true" | "1" | "on") => Some(true),
            Input::Text("false" | "0" | "off") => Some(false),
            Input::Text(_) | Input::Number(_) => None,
        }
    }
}

impl fmt::Display for Input<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Input::Number(x) => write!(f, "{}", Decimal(*x)),
            Input::Flag(on) => write!(f, "{on}"),
            // A hostile text must not flood a console.
            Input::Text(text) => match text.char_indices().nth(40) {
                Some((end, _)) => write!(f, "\"{}…\"", text.get(..end).unwrap_or_default()),
                None => write!(f, "\"{text}\""),
            },
        }
    }
}

/// Why a value was refused. Its text names the parameter, the value and what
/// would have been allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamError {
    /// The id that was asked for.
    pub id: String,
    /// The value as it was sent.
    pub value: String,
    /// What was wrong with it.
    pub kind: ParamErrorKind,
}

/// What is wrong with a refused value.
#[derive(Clone, Debug, PartialEq)]
pub enum ParamErrorKind {
    /// No parameter has this id; the nearest known one, where there is one.
    UnknownId {
        /// The known id that differs least.
        nearest: Option<&'static str>,
    },
    /// Outside the range, or not a finite number at all.
    OutOfRange {
        /// Smallest allowed value.
        min: f64,
        /// Largest allowed value.
        max: f64,
        /// Unit of both.
        unit: &'static str,
        /// Whether only whole numbers are allowed.
        whole: bool,
    },
    /// Not one of the named choices.
    NotAChoice {
        /// The names that are.
        choices: &'static [&'static str],
    },
    /// Neither on nor off.
    NotAFlag,
    /// Not a colour that can be read.
    NotAColour,
    /// Something else about an object; what it must be, in words.
    Other(&'static str),
}

impl fmt::Display for ParamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ParamError { id, value, kind } = self;
        match kind {
            ParamErrorKind::UnknownId { nearest } => {
                write!(f, "there is no parameter \"{id}\"")?;
                match nearest {
                    Some(nearest) => write!(f, "; did you mean \"{nearest}\"?"),
                    None => Ok(()),
                }
            }
            ParamErrorKind::OutOfRange {
                min,
                max,
                unit,
                whole,
            } => {
                let kind = if *whole { "a whole number" } else { "a number" };
                let space = if unit.is_empty() { "" } else { " " };
                let (min, max) = (Decimal(*min), Decimal(*max));
                write!(
                    f,
                    "{id} = {value} is refused: it must be {kind} from {min} to {max}{space}{unit}"
                )
            }
            ParamErrorKind::NotAChoice { choices } => {
                write!(
                    f,
                    "{id} = {value} is refused: it must be one of {}",
                    choices.join(", ")
                )
            }
            ParamErrorKind::NotAFlag => {
                write!(f, "{id} = {value} is refused: it must be true or false")
            }
            ParamErrorKind::NotAColour => write!(
                f,
                "{id} = {value} is refused: it must be transparent, #rgb, #rrggbb or #rrggbbaa"
            ),
            ParamErrorKind::Other(allowed) => {
                write!(f, "{id} = {value} is refused: it must be {allowed}")
            }
        }
    }
}

impl std::error::Error for ParamError {}

impl ParamError {
    /// Smallest and largest allowed value, where the parameter has them.
    pub fn range(&self) -> Option<(f64, f64)> {
        match self.kind {
            ParamErrorKind::OutOfRange { min, max, .. } => Some((min, max)),
            _ => None,
        }
    }
}

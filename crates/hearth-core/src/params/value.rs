//! Values of parameters, and errors of invalid values.
//!
//! Sliders, attributes, URLs, JSON files and messages send values as numbers, texts or flags:
//! [`Input`]. A checked value is a [`Value`], an error a [`ParamError`].

use std::fmt;

use super::choices::Model;
use super::decimal::{self, Decimal};

/// A colour with opacity, 8 bits a channel, sRGB, not premultiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour {
    /// Red, green, blue and opacity, each 0–255.
    pub rgba: [u8; 4],
}

impl Colour {
    /// Fully transparent.
    pub const TRANSPARENT: Colour = Colour { rgba: [0; 4] };

    /// An opaque colour.
    pub const fn rgb(r: u8, g: u8, b: u8) -> Colour {
        Colour {
            rgba: [r, g, b, 255],
        }
    }

    /// Reads `transparent`, `#rgb`, `#rrggbb` or `#rrggbbaa`.
    pub fn parse(text: &str) -> Option<Colour> {
        let text = text.trim_ascii();
        if text.eq_ignore_ascii_case("transparent") {
            return Some(Colour::TRANSPARENT);
        }
        let [b'#', digits @ ..] = text.as_bytes() else {
            return None;
        };
        let length = match digits.len() {
            3 => 1,
            6 | 8 => 2,
            _ => return None,
        };
        let mut rgba = [255; 4];
        for (at, &digit) in digits.iter().enumerate() {
            let value = match digit {
                b'0'..=b'9' => digit - b'0',
                b'a'..=b'f' => digit - b'a' + 10,
                b'A'..=b'F' => digit - b'A' + 10,
                _ => return None,
            };
            // A short digit stands for two. The second of two moves the first up.
            let channel = rgba.get_mut(at / length)?;
            *channel = if at % length == 0 {
                17 * value
            } else {
                *channel & 0xF0 | value
            };
        }
        // Every fully transparent colour is the same, so that it is written as `transparent`.
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

/// A checked value of a parameter, which is no text.
pub type Value = AnyValue<'static>;

/// A checked value of a parameter or of an object's property.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyValue<'a> {
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
    /// An outline as text.
    Text(&'a str),
}

impl AnyValue<'_> {
    /// The value of a numeric parameter for JavaScript and JSON: the shortest decimal of the same
    /// `f32`, so that 0.05 stays 0.05. `None` for any other value.
    pub fn as_number(&self) -> Option<f64> {
        match *self {
            AnyValue::Number(x) => Some(decimal::shortest(x)),
            AnyValue::Integer(n) | AnyValue::Seed(n) => Some(f64::from(n)),
            _ => None,
        }
    }
}

impl fmt::Display for AnyValue<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AnyValue::Number(x) => write!(f, "{}", Decimal(decimal::shortest(*x))),
            AnyValue::Integer(n) | AnyValue::Seed(n) => write!(f, "{n}"),
            AnyValue::Choice(text) | AnyValue::Text(text) => f.write_str(text),
            AnyValue::Flag(on) => write!(f, "{on}"),
            AnyValue::Colour(colour) => write!(f, "{colour}"),
        }
    }
}

/// An unchecked value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Input<'a> {
    /// A number, from a slider, JSON or a call.
    Number(f64),
    /// A text, from an attribute or a URL, of any kind of value.
    Text(&'a str),
    /// On or off.
    Flag(bool),
    /// The default.
    Default,
}

impl From<f64> for Input<'_> {
    fn from(number: f64) -> Self {
        Input::Number(number)
    }
}

impl From<f32> for Input<'_> {
    fn from(number: f32) -> Self {
        Input::Number(decimal::shortest(number))
    }
}

impl From<u32> for Input<'_> {
    fn from(number: u32) -> Self {
        Input::Number(number.into())
    }
}

impl From<i32> for Input<'_> {
    fn from(number: i32) -> Self {
        Input::Number(number.into())
    }
}

impl From<bool> for Input<'_> {
    fn from(on: bool) -> Self {
        Input::Flag(on)
    }
}

impl<'a> From<&'a str> for Input<'a> {
    fn from(text: &'a str) -> Self {
        Input::Text(text)
    }
}

impl<'a> Input<'a> {
    /// The number that a text is, or the text.
    pub(crate) fn from_decimal(text: &'a str) -> Input<'a> {
        decimal::parse(text).map_or(Input::Text(text), Input::Number)
    }

    pub(super) fn number(&self) -> Option<f64> {
        match *self {
            Input::Number(x) => Some(x),
            Input::Text(text) => decimal::parse(text.trim_ascii()),
            Input::Flag(_) | Input::Default => None,
        }
        .filter(|x: &f64| x.is_finite())
    }

    pub(super) fn flag(&self) -> Option<bool> {
        match *self {
            Input::Flag(on) => Some(on),
            Input::Text(text) => match text.trim_ascii() {
                // An attribute without a value is on, like HTML's boolean attributes.
                "" | "true" | "1" | "on" => Some(true),
                "false" | "0" | "off" => Some(false),
                _ => None,
            },
            Input::Number(_) | Input::Default => None,
        }
    }
}

impl fmt::Display for Input<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Input::Number(x) => write!(f, "{}", Decimal(*x)),
            Input::Flag(on) => write!(f, "{on}"),
            Input::Default => f.write_str("null"),
            Input::Text(text) => write!(f, "\"{}\"", quoted(text)),
        }
    }
}

/// The start of a text as messages quote it, and an ellipsis if it is long: a text must neither flood a console nor act on
/// a terminal.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 40;
    let start: String = text.chars().take(LONGEST + 1).collect();
    let mut shown = printable(&start);
    if let Some((end, _)) = shown.char_indices().nth(LONGEST) {
        shown.truncate(end);
        shown.push('…');
    }
    shown
}

/// A text in which characters are escaped that control a terminal, have no width or turn the text around.
pub fn printable(text: &str) -> String {
    let acts = |letter: char| {
        letter.is_control()
            || matches!(letter, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
            || matches!(letter, '\u{2060}'..='\u{206f}' | '\u{feff}')
    };
    let mut shown = String::new();
    for letter in text.chars() {
        match acts(letter) {
            true => shown.extend(letter.escape_unicode()),
            false => shown.push(letter),
        }
    }
    shown
}

/// An error of an invalid value. Its message names the parameter, the value and the allowed
/// values.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamError {
    /// The requested id.
    pub id: String,
    /// The sent value.
    pub value: String,
    /// The kind of error.
    pub kind: ParamErrorKind,
}

/// The kinds of errors.
#[derive(Clone, Debug, PartialEq)]
pub enum ParamErrorKind {
    /// No parameter has this id.
    UnknownId {
        /// A similar id, if there is one.
        nearest: Option<&'static str>,
    },
    /// Outside of the range, or not a finite number.
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
    /// Not one of the choices.
    NotAChoice {
        /// The choices.
        choices: &'static [&'static str],
    },
    /// Neither on nor off.
    NotAFlag,
    /// Not a colour.
    NotAColour,
    /// Only this model uses the parameter.
    OfModel(Model),
    /// A property of sources, set in a world or in a scene without a source.
    OfSource,
    /// Another rule of an object; the text names the allowed values.
    Other(&'static str),
}

impl fmt::Display for ParamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ParamError { id, value, kind } = self;
        let mut must_be = |allowed: fmt::Arguments<'_>| {
            write!(f, "{id} = {value} is refused: it must be {allowed}")
        };
        match kind {
            ParamErrorKind::OutOfRange {
                min,
                max,
                unit,
                whole,
            } => {
                let kind = if *whole { "a whole number" } else { "a number" };
                let space = if unit.is_empty() { "" } else { " " };
                let (min, max) = (Decimal(*min), Decimal(*max));
                must_be(format_args!("{kind} from {min} to {max}{space}{unit}"))
            }
            ParamErrorKind::NotAChoice { choices } => {
                must_be(format_args!("one of {}", choices.join(", ")))
            }
            ParamErrorKind::NotAFlag => must_be(format_args!("true or false")),
            ParamErrorKind::NotAColour => {
                must_be(format_args!("transparent, #rgb, #rrggbb or #rrggbbaa"))
            }
            ParamErrorKind::OfModel(model) => {
                let model = model.name();
                write!(
                    f,
                    "{id} = {value} is refused: only the {model} model has it"
                )
            }
            ParamErrorKind::OfSource => write!(
                f,
                "{id} = {value} is refused: it is a property of the first source, and there is none"
            ),
            ParamErrorKind::Other(allowed) => must_be(format_args!("{allowed}")),
            ParamErrorKind::UnknownId { nearest } => {
                write!(f, "there is no parameter \"{id}\"")?;
                match nearest {
                    Some(nearest) => write!(f, "; did you mean \"{nearest}\"?"),
                    None => Ok(()),
                }
            }
        }
    }
}

impl std::error::Error for ParamError {}

impl ParamError {
    /// Smallest and largest allowed value, if the parameter has a range.
    pub fn range(&self) -> Option<(f64, f64)> {
        match self.kind {
            ParamErrorKind::OutOfRange { min, max, .. } => Some((min, max)),
            _ => None,
        }
    }
}

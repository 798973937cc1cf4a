//! The fields of a message, read one after another.
//!
//! A field that is not as it must be reads as nothing, the first such is kept as a
//! refusal, and reading goes on: to leave from the midst of what is half read
//! would be some kilobytes of code more.

use crate::message::{Refused, SentValues};
use crate::quality::Level;
use crate::raw::Raw;

/// What is read, and the first of it that is refused.
pub(crate) struct Fields<'a> {
    /// The message.
    pub raw: &'a Raw,
    refused: Option<Refused>,
}

impl<'a> Fields<'a> {
    pub fn of(raw: &'a Raw) -> Fields<'a> {
        Fields { raw, refused: None }
    }

    /// The first refusal, if there is one.
    pub fn refused(self) -> Option<Refused> {
        self.refused
    }

    /// Whether all was as it must be until now.
    pub fn are_good(&self) -> bool {
        self.refused.is_none()
    }

    /// What was read by somebody else, where it was not refused.
    pub fn keep<T>(&mut self, read: Result<T, Refused>) -> Option<T> {
        match read {
            Ok(read) => Some(read),
            Err(refused) => {
                self.keep_first(refused);
                None
            }
        }
    }

    #[inline(never)]
    fn keep_first(&mut self, refused: Refused) {
        if self.refused.is_none() {
            self.refused = Some(refused);
        }
    }

    /// Refuses the field of that name.
    #[inline(never)]
    pub fn refuse(&mut self, id: &str, allowed: &str) {
        self.keep_first(Refused::field(id, self.raw.field(id), allowed));
    }

    #[inline(never)]
    pub fn whole(&mut self, id: &str, min: u32, max: u32) -> u32 {
        match *self.raw.field(id) {
            Raw::Number(x) if x.fract() == 0.0 && x >= min.into() && x <= max.into() => x as u32,
            ref other => {
                self.keep_first(Refused::whole(id, other, min, max));
                0
            }
        }
    }

    /// A number above 0 and up to `most`, which `allowed` says in words: formatting a
    /// number of its own would bring 20 KB of code.
    pub fn positive(&mut self, id: &str, most: f64, allowed: &str) -> f64 {
        match *self.raw.field(id) {
            Raw::Number(x) if x > 0.0 && x <= most => x,
            ref other => {
                self.keep_first(Refused {
                    range: Some((0.0, most)),
                    ..Refused::field(id, other, allowed)
                });
                0.0
            }
        }
    }

    #[inline(never)]
    pub fn between(&mut self, id: &str, min: f64, max: f64, allowed: &str) -> f64 {
        match *self.raw.field(id) {
            Raw::Number(x) if x >= min && x <= max => x,
            _ => {
                self.refuse(id, allowed);
                0.0
            }
        }
    }

    /// A place \[m\].
    pub fn place(&mut self) -> [f32; 2] {
        let words = "a number from -1000 to 1000";
        ["x", "y"].map(|id| self.between(id, -1000.0, 1000.0, words) as f32)
    }

    pub fn optional_number(&mut self, id: &str) -> Option<f64> {
        match *self.raw.field(id) {
            Raw::Missing => None,
            Raw::Number(x) if x.is_finite() => Some(x),
            _ => {
                self.refuse(id, "a number");
                None
            }
        }
    }

    /// A number from 0 up to `most`, where there is one; `allowed` says that in words.
    #[inline(never)]
    pub fn optional_seconds(&mut self, id: &str, most: f64, allowed: &str) -> Option<f64> {
        match *self.raw.field(id) {
            Raw::Missing => None,
            Raw::Number(x) if x >= 0.0 && x <= most => Some(x),
            ref other => {
                self.keep_first(Refused {
                    range: Some((0.0, most)),
                    ..Refused::field(id, other, allowed)
                });
                None
            }
        }
    }

    /// Bytes; none where nothing is said.
    pub fn optional_bytes(&mut self, id: &str) -> Vec<u8> {
        match self.raw.field(id) {
            Raw::Bytes(bytes) => return bytes.clone(),
            Raw::Missing => {}
            _ => self.refuse(id, "an array of bytes"),
        }
        Vec::new()
    }

    /// True or false; `default`, where there is one, if nothing is said.
    #[inline(never)]
    pub fn flag(&mut self, id: &str, default: Option<bool>) -> bool {
        match (self.raw.field(id), default) {
            (Raw::Flag(on), _) => *on,
            (Raw::Missing, Some(default)) => default,
            _ => {
                self.refuse(id, "true or false");
                false
            }
        }
    }

    pub fn text(&mut self, id: &str) -> String {
        let text = self.optional_text(id);
        if text.is_none() {
            self.refuse(id, "a text");
        }
        text.unwrap_or_default()
    }

    #[inline(never)]
    pub fn optional_text(&mut self, id: &str) -> Option<String> {
        match self.raw.field(id) {
            Raw::Missing => None,
            Raw::Text(text) => Some(text.clone()),
            _ => {
                self.refuse(id, "a text");
                None
            }
        }
    }

    /// A level by its name; nothing where it is `auto`, or nothing is said.
    #[inline(never)]
    pub fn quality(&mut self, id: &str) -> Option<Level> {
        let name = self.optional_text(id)?;
        let level = Level::ALL.into_iter().find(|level| level.name() == name);
        if level.is_none() && name != "auto" {
            self.refuse(id, "one of auto, low, medium, high");
        }
        level
    }

    pub fn values(&mut self, id: &str) -> SentValues {
        if *self.raw.field(id) == Raw::Missing {
            self.refuse(id, VALUES);
        }
        self.optional_values(id)
    }

    #[inline(never)]
    pub fn optional_values(&mut self, id: &str) -> SentValues {
        match self.raw.field(id) {
            Raw::Object(values) => return values.clone(),
            Raw::Missing => {}
            _ => self.refuse(id, VALUES),
        }
        Vec::new()
    }

    #[inline(never)]
    pub fn texts(&mut self, id: &str, allowed: &str) -> Vec<String> {
        let mut texts = Vec::new();
        let Raw::List(list) = self.raw.field(id) else {
            self.refuse(id, allowed);
            return texts;
        };
        for one in list {
            if let Raw::Text(text) = one {
                texts.push(text.clone());
            } else {
                self.keep_first(Refused::field(id, one, allowed));
            }
        }
        texts
    }
}

/// What values must be.
const VALUES: &str = "an object of values by their ids";

//! Scene files as [untrusted values](Untrusted): JSON, with the limits that values of a page have.

use std::fmt;
use std::io::Read;

use hearth_core::params::quoted;
use hearth_settings::untrusted::{MAX_DEPTH, MAX_LENGTH, MAX_TEXT_BYTES, Untrusted};
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

/// Longest scene file \[bytes\]: 64 solids with the largest mask.
pub const MAX_FILE_BYTES: u64 = 64 * MAX_TEXT_BYTES as u64;

/// Reads a JSON text.
///
/// # Errors
/// What is wrong with the text, with line and column.
pub fn read(mut source: impl Read) -> Result<Untrusted, String> {
    let mut bytes = Vec::new();
    let limited = source.by_ref().take(MAX_FILE_BYTES + 1);
    let mut limited = std::io::BufReader::new(limited);
    limited
        .read_to_end(&mut bytes)
        .map_err(|error| error.to_string())?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(format!("the scene has more than {MAX_FILE_BYTES} bytes"));
    }
    let text = str::from_utf8(&bytes)
        .map_err(|error| format!("byte {} is not UTF-8", error.valid_up_to() + 1))?;
    // Some editors write a byte order mark.
    let text = text.trim_start_matches('\u{feff}');
    let mut json = serde_json::Deserializer::from_str(text);
    let value = Value { depth: 0 }.deserialize(&mut json);
    let value = value.and_then(|value| json.end().map(|()| value));
    value.map_err(|error| format!("the scene is no valid JSON: {error}"))
}

/// A value as JSON. Scenes have no others.
pub fn write(value: &Untrusted) -> serde_json::Value {
    match value {
        // Whole numbers have no point.
        Untrusted::Number(number) if (*number as i64) as f64 == *number => (*number as i64).into(),
        Untrusted::Number(number) => (*number).into(),
        Untrusted::Text(text) => text.clone().into(),
        Untrusted::Flag(flag) => (*flag).into(),
        Untrusted::List(items) => items.iter().map(write).collect(),
        Untrusted::Object(fields) => {
            // Builds with other crates keep another order of an object.
            let mut fields: Vec<_> = fields.iter().collect();
            fields.sort_by(|(a, _), (b, _)| a.cmp(b));
            let fields = fields.into_iter();
            fields
                .map(|(name, value)| (name.clone(), write(value)))
                .collect()
        }
        _ => serde_json::Value::Null,
    }
}

/// A value inside that many lists and objects.
#[derive(Clone, Copy)]
struct Value {
    depth: u32,
}

impl<'de> DeserializeSeed<'de> for Value {
    type Value = Untrusted;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Untrusted, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Value {
    type Value = Untrusted;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_bool<E>(self, flag: bool) -> Result<Untrusted, E> {
        Ok(Untrusted::Flag(flag))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Untrusted, E> {
        Ok(Untrusted::Number(number as f64))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Untrusted, E> {
        Ok(Untrusted::Number(number as f64))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Untrusted, E> {
        Ok(Untrusted::Number(number))
    }

    fn visit_unit<E>(self) -> Result<Untrusted, E> {
        Ok(Untrusted::Other("null"))
    }

    fn visit_str<E>(self, text: &str) -> Result<Untrusted, E> {
        Ok(match text.len() {
            0..=MAX_TEXT_BYTES => Untrusted::Text(text.to_owned()),
            _ => Untrusted::Other("a text of more than 66000 letters"),
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<Untrusted, A::Error> {
        if self.depth == MAX_DEPTH {
            while elements.next_element::<IgnoredAny>()?.is_some() {}
            return Ok(Untrusted::Other("an object"));
        }
        let inner = Value {
            depth: self.depth + 1,
        };
        let mut list = Vec::new();
        while let Some(element) = elements.next_element_seed(inner)? {
            // The rest of a longer list is read and dropped.
            if list.len() <= MAX_LENGTH as usize {
                list.push(element);
            }
        }
        Ok(match list.len() <= MAX_LENGTH as usize {
            true => Untrusted::List(list),
            false => Untrusted::Other("more than a thousand elements"),
        })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<Untrusted, A::Error> {
        if self.depth == MAX_DEPTH {
            while fields.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
            return Ok(Untrusted::Other("an object"));
        }
        let inner = Value {
            depth: self.depth + 1,
        };
        let mut read: Vec<(String, Untrusted)> = Vec::new();
        while let Some(name) = fields.next_key::<String>()? {
            if read.len() == MAX_LENGTH as usize {
                return Err(A::Error::custom(
                    "an object has more than a thousand fields",
                ));
            }
            if read.iter().any(|(known, _)| *known == name) {
                let name = quoted(&name);
                return Err(A::Error::custom(format!("the field {name} is there twice")));
            }
            read.push((name, fields.next_value_seed(inner)?));
        }
        Ok(Untrusted::Object(read))
    }
}

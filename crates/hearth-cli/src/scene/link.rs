//! A page's link as a scene: its URL parameters, or its fragment with the compressed settings. `share.js` writes both.

use std::io::{Read, Write, stderr};

use flate2::read::ZlibDecoder;
use hearth_core::params::{Param, printable};
use hearth_settings::untrusted::Untrusted;

use crate::json::{self, MAX_FILE_BYTES};

/// What the fragment of settings begins with.
const FRAGMENT: &str = "fire=";
/// The names of the preset and of the objects.
const PRESET: [&str; 2] = ["scene", "preset"];
const OBJECTS: &str = "objects";

/// Whether a text is an address, or the part of one that names a fire.
pub fn is_link(text: &str) -> bool {
    let starts = ["https://", "http://", "?", "#fire="];
    starts.iter().any(|start| text.starts_with(start))
}

/// The settings file that a link is. What an address says about its page and not about the fire is named on standard
/// error.
///
/// # Errors
/// What is wrong with it.
pub fn settings(link: &str) -> Result<Untrusted, String> {
    let (address, fragment) = link.split_once('#').unwrap_or((link, ""));
    if let Some(letters) = decoded(fragment).strip_prefix(FRAGMENT) {
        let damaged = "the settings of the link are damaged: perhaps its end is missing";
        let bytes = base64(letters).ok_or(damaged)?;
        let mut json = Vec::new();
        let limited = ZlibDecoder::new(&bytes[..]).take(MAX_FILE_BYTES + 1);
        { limited }.read_to_end(&mut json).map_err(|_| damaged)?;
        return json::read(&json[..]);
    }
    let query = address.split_once('?').map_or("", |(_, query)| query);
    let mut fields = Vec::new();
    let (mut values, mut others) = (Vec::new(), Vec::new());
    for pair in query.split('&').filter(|pair| !pair.is_empty()) {
        let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
        let (name, value) = (
            decoded(&name.replace('+', " ")),
            decoded(&value.replace('+', " ")),
        );
        let id = name.replace('-', "_");
        if PRESET.contains(&&*name) {
            fields.push(Untrusted::field_of(PRESET[1], Untrusted::Text(value)));
        } else if name == OBJECTS {
            fields.push(Untrusted::field_of(OBJECTS, json::read(value.as_bytes())?));
        } else if Param::find(&id).is_some() {
            values.push((id, Untrusted::Text(value)));
        } else {
            others.push(printable(&name));
        }
    }
    if !others.is_empty() {
        let words = format!(
            "warning: the link also has {}, which is no part of the scene\n",
            others.join(", ")
        );
        // A warning that nobody reads changes nothing.
        let _ = stderr().write_all(words.as_bytes());
    }
    fields.push(Untrusted::field_of("values", Untrusted::Object(values)));
    Ok(Untrusted::Object(fields))
}

/// A text without percent-encoding. What is no such code stays.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digits = after.get(..2).filter(|_| first == b'%');
        let code = digits.and_then(|digits| str::from_utf8(digits).ok());
        let code = code.and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(code.unwrap_or(first));
        rest = match code {
            Some(_) => after.get(2..).unwrap_or_default(),
            None => after,
        };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The bytes of base64url without padding; `None` if a letter is none of it.
fn base64(letters: &str) -> Option<Vec<u8>> {
    let (mut bytes, mut bits, mut count) = (Vec::new(), 0_u32, 0);
    for letter in letters.trim().bytes() {
        let value = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'-' => 62,
            b'_' => 63,
            _ => return None,
        };
        bits = bits << 6 | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    Some(bytes)
}

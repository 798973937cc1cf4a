//! Untrusted values for tests.

use hearth_settings::untrusted::Untrusted;

/// Named values, as a script sends them.
pub type Sent = Vec<(String, Untrusted)>;

/// A number.
pub fn number(number: f64) -> Untrusted {
    Untrusted::Number(number)
}

/// A text.
pub fn text(text: &str) -> Untrusted {
    Untrusted::Text(text.to_owned())
}

/// An object.
pub fn object<const N: usize>(fields: [(&str, Untrusted); N]) -> Untrusted {
    Untrusted::Object(sent(fields))
}

/// Named values.
pub fn sent<const N: usize>(values: [(&str, Untrusted); N]) -> Sent {
    values.map(|(id, value)| (id.to_owned(), value)).into()
}

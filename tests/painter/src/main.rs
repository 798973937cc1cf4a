//! Draws fires for the tests of pictures, without a browser. `tests/look/painter.mjs` runs it.
//!
//! A request is a line of JSON on the standard input, with the name of a call in `call`. An answer on
//! the standard output is two 32-bit lengths, lowest byte first, then JSON of the first length and
//! bytes of the second: pixels, and light. The JSON of a failed call has the field `error`.

mod calls;
mod fire;
mod foreign;
mod painter;
mod request;

use std::error::Error;
use std::io::{self, BufRead, Write};

use serde_json::{Value, json};

use crate::calls::Calls;
use crate::request::Request;

/// Why a call fails.
type Failure = Box<dyn Error>;

/// What a call answers: JSON and bytes.
type Answer = Result<(Value, Vec<u8>), Failure>;

fn main() -> Result<(), Failure> {
    let mut calls = Calls::new()?;
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let request = serde_json::from_str(&line?).map_err(Failure::from);
        let answer = request.and_then(|request| calls.answer(&Request(request)));
        let (json, bytes) =
            answer.unwrap_or_else(|failure| (json!({ "error": failure.to_string() }), Vec::new()));
        let json = json.to_string();
        for length in [json.len(), bytes.len()] {
            out.write_all(&u32::try_from(length)?.to_le_bytes())?;
        }
        out.write_all(json.as_bytes())?;
        out.write_all(&bytes)?;
        out.flush()?;
    }
    Ok(())
}

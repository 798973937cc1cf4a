//! Why a command failed.

use std::path::Path;
use std::{fmt, io};

use hearth_core::params::printable;
use hearth_settings::untrusted::ValidationError;

/// An error of the command, and with it the exit code.
#[derive(Debug)]
pub enum Error {
    /// The command line or a scene is invalid.
    Use(String),
    /// Valid work failed: a file, the graphics driver, memory.
    Failed(String),
    /// Nobody reads standard output any more.
    Closed,
}

/// Most refusals of a scene that are shown, and most letters of a place.
const MAX_REFUSALS: usize = 20;
const MAX_PLACE: usize = 100;

/// A place as messages show it: a path may have any bytes. Of a long one, its end counts.
pub fn shown(place: impl AsRef<Path>) -> String {
    let text = printable(&place.as_ref().to_string_lossy());
    match text.char_indices().rev().nth(MAX_PLACE) {
        Some((start, _)) => format!("…{}", text.get(start..).unwrap_or_default()),
        None => text,
    }
}

/// That so many bytes are free: an allocation that fails ends the process without a word.
///
/// # Errors
/// They are not.
pub fn need_memory(bytes: usize) -> Result<(), Error> {
    let free = Vec::<u8>::new().try_reserve_exact(bytes);
    free.map_err(|_| Error::Failed(format!("there are no {} MB of memory", bytes >> 20)))
}

impl Error {
    /// The exit code of the command.
    pub fn code(&self) -> u8 {
        match self {
            Error::Use(_) => 2,
            Error::Failed(_) => 1,
            Error::Closed => 0,
        }
    }

    /// An error at a named place, such as a file.
    pub fn at(place: impl AsRef<Path>, error: impl fmt::Display) -> Error {
        Error::Failed(format!("{}: {error}", shown(place)))
    }

    /// A refusal of what a place has.
    pub fn at_use(place: impl AsRef<Path>, error: impl fmt::Display) -> Error {
        Error::Use(format!("{}: {error}", shown(place)))
    }

    /// The refusal of a scene: the place, then a line for each invalid value, of which only some are shown.
    pub fn refused(place: impl AsRef<Path>, errors: &[ValidationError]) -> Error {
        let first = errors.iter().take(MAX_REFUSALS);
        let mut messages: Vec<_> = first.map(|error| error.message.clone()).collect();
        if let Some(more @ 1..) = errors.len().checked_sub(MAX_REFUSALS) {
            messages.push(format!("… and {more} more"));
        }
        Error::Use(format!("{}: {}", shown(place), messages.join("\n  ")))
    }

    /// An error of starting a thread.
    pub fn of_thread(error: io::Error) -> Error {
        Error::Failed(format!("a thread could not be started: {error}"))
    }

    /// An error of standard output.
    pub fn of_output(error: io::Error) -> Error {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Error::Closed,
            _ => Error::at("standard output", error),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Use(message) | Error::Failed(message) => f.write_str(message),
            Error::Closed => f.write_str("standard output is closed"),
        }
    }
}

impl std::error::Error for Error {}

impl From<hearth_render::RenderError> for Error {
    fn from(error: hearth_render::RenderError) -> Error {
        Error::Failed(error.to_string())
    }
}

impl From<crate::OffscreenError> for Error {
    fn from(error: crate::OffscreenError) -> Error {
        let message = error.to_string();
        match error {
            crate::OffscreenError::NoTarget { .. } | crate::OffscreenError::NoDevice { .. } => {
                Error::Use(message)
            }
            _ => Error::Failed(message),
        }
    }
}

//! Why a command failed.

use std::{fmt, io};

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
    pub fn at(place: &str, error: impl fmt::Display) -> Error {
        Error::Failed(format!("{place}: {error}"))
    }

    /// The refusal of a scene: the place, then a line for each invalid value.
    pub fn refused(place: &str, errors: &[ValidationError]) -> Error {
        let messages: Vec<_> = errors.iter().map(|error| &*error.message).collect();
        Error::Use(format!("{place}: {}", messages.join("\n  ")))
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

//! Errors of the graphics driver.

use std::fmt;

/// Why the renderer cannot draw.
#[derive(Clone, Debug, PartialEq)]
pub enum RenderError {
    /// A pair of shaders was not compiled or linked.
    Program {
        /// Name of its files.
        pass: &'static str,
        /// The driver's log.
        log: String,
    },
    /// The driver made no program, texture or framebuffer, as after a lost context.
    Resource {
        /// The pass that needs it.
        pass: &'static str,
    },
    /// No target format can be drawn into.
    NoTarget,
}

impl fmt::Display for RenderError {
    // Written in pieces: formatting them would be larger.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pieces = match self {
            RenderError::Program { pass, log } => [
                "the driver refuses the shaders of the pass \"",
                *pass,
                "\": ",
                log,
            ],
            RenderError::Resource { pass } => [
                "the driver has no graphics memory for the pass \"",
                *pass,
                "\"",
                "",
            ],
            RenderError::NoTarget => [
                "the graphics driver offers no texture format that can be drawn into",
                "",
                "",
                "",
            ],
        };
        pieces.into_iter().try_for_each(|piece| f.write_str(piece))
    }
}

impl std::error::Error for RenderError {}

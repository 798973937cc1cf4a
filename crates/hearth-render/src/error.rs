//! Errors of the graphics driver.

use std::fmt;

/// An error of the renderer.
#[derive(Clone, Debug, PartialEq)]
pub enum RenderError {
    /// A pair of shaders does not compile or link.
    Program {
        /// Name of the pass.
        pass: &'static str,
        /// The driver's log.
        log: String,
    },
    /// The driver creates no program, texture or framebuffer, for example after a lost context.
    Resource {
        /// The pass that needs it.
        pass: &'static str,
    },
    /// No target format is renderable.
    NoTarget,
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pieces = match self {
            RenderError::Program { pass, log } => [
                "the driver rejects the shaders of the pass \"",
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
                "the graphics driver supports no renderable texture format",
                "",
                "",
                "",
            ],
        };
        pieces.into_iter().try_for_each(|piece| f.write_str(piece))
    }
}

impl std::error::Error for RenderError {}

//! What is said when the graphics driver refuses.

use std::fmt;

/// Why the renderer cannot draw.
#[derive(Clone, Debug, PartialEq)]
pub enum RenderError {
    /// A shader pair was not compiled or linked.
    Program {
        /// The pass it belongs to.
        pass: &'static str,
        /// What the driver said.
        log: String,
    },
    /// A texture, buffer or framebuffer could not be made.
    Resource {
        /// The pass it belongs to.
        pass: &'static str,
        /// What the driver said.
        log: String,
    },
    /// No target format can be drawn into.
    NoTarget,
}

impl RenderError {
    /// The driver has none to give, as when the context is lost.
    pub(crate) fn none(pass: &'static str) -> RenderError {
        let log = "it has none to give".to_owned();
        RenderError::Resource { pass, log }
    }
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RenderError::Program { pass, log } => {
                write!(f, "the shaders of the pass \"{pass}\" were refused: {log}")
            }
            RenderError::Resource { pass, log } => {
                write!(f, "the pass \"{pass}\" got no graphics memory: {log}")
            }
            RenderError::NoTarget => {
                f.write_str("the graphics driver offers no texture that can be drawn into")
            }
        }
    }
}

impl std::error::Error for RenderError {}

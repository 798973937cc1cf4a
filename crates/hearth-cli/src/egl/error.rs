//! Why there is no context without a window.

use std::fmt;

/// Debian's packages with EGL, OpenGL ES and their software renderer.
pub const PACKAGES: &str = "libegl1 libgles2 libegl-mesa0 libgl1-mesa-dri";

/// Why there is no context, or no target.
#[derive(Clone, Debug, PartialEq)]
pub enum OffscreenError {
    /// The library EGL 1.5 does not load, for this reason.
    NoEgl(String),
    /// No display has an OpenGL ES 3 context; what each attempt returned.
    NoContext(String),
    /// No device has this number.
    NoDevice {
        /// The requested number.
        requested: usize,
        /// How many devices there are.
        devices: usize,
    },
    /// This thread has another context.
    InUse,
    /// The driver has no target of this size.
    NoTarget {
        /// Width and height \[pixels\].
        size: [u32; 2],
        /// The driver's longest side \[pixels\].
        max_side: u32,
    },
}

impl fmt::Display for OffscreenError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OffscreenError::NoEgl(reason) => write!(
                f,
                "the library EGL 1.5 (libEGL.so.1) does not load: {reason}; Debian's packages are {PACKAGES}"
            ),
            OffscreenError::NoContext(reason) => write!(
                f,
                "no driver offers OpenGL ES 3 without a window: {reason}; Debian's packages for a \
                 machine without a graphics card are {PACKAGES}"
            ),
            OffscreenError::NoDevice { requested, devices } => write!(
                f,
                "no graphics device {requested}: this machine has {devices}, counted from 0"
            ),
            OffscreenError::InUse => f.write_str("this thread already has an offscreen context"),
            OffscreenError::NoTarget {
                size: [width, height],
                max_side,
            } => write!(
                f,
                "the driver has no picture of {width} x {height} pixels; its longest side is {max_side} pixels"
            ),
        }
    }
}

impl std::error::Error for OffscreenError {}

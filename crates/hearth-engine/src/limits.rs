//! Limits of what a fire draws.

use hearth_bindings::Within;

/// A limit of pictures a second: with fewer, the clock would not make up for all of the
/// time between two.
pub type Fps = Within<10, 240>;

/// A limit of pixels of a picture.
pub type Pixels = Within<1024, 16_777_216>;

/// How much earlier than due a frame may come \[ms\]: displays jitter.
const EARLY: f64 = 2.0;

/// Limits that a page sets.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Most pictures a second.
    pub fps: Option<f64>,
    /// Most pixels of one.
    pub pixels: Option<f64>,
}

impl Limits {
    /// The size of the picture for an element of that size, in device pixels. `usual` is
    /// the number of pixels that it may have without a limit of its own.
    pub fn fit(&self, (width, height): (u32, u32), usual: f64) -> (u32, u32) {
        let max = self.pixels.unwrap_or(usual);
        let pixels = f64::from(width) * f64::from(height);
        if pixels <= max {
            return (width, height);
        }
        let scale = (max / pixels).sqrt();
        let side = |side: u32| (f64::from(side) * scale) as u32;
        (side(width).max(1), side(height).max(1))
    }

    /// Least time between two pictures \[ms\].
    pub fn apart(&self) -> f64 {
        self.fps.map_or(0.0, |fps| 1000.0 / fps)
    }

    /// Whether a frame at `now` \[ms\] is one to draw in, where `next` is when the
    /// next one may come.
    pub fn is_due(&self, now: f64, next: &mut f64) -> bool {
        if self.fps.is_none() {
            return true;
        }
        if now < *next - EARLY {
            return false;
        }
        let interval = self.apart();
        // In step with the display. A pause is not made up for.
        *next = if now > *next + interval { now } else { *next } + interval;
        true
    }
}

//! PictureLimits of frame rate and picture size that a page sets.

use hearth_settings::untrusted::Within;

/// A limit of pictures per second. Below 10, the clock would not make up for the time between
/// two pictures.
pub type Fps = Within<10, 240>;

/// A limit of pixels in a picture.
pub type Pixels = Within<1024, 16_777_216>;

/// How early a frame may come \[ms\]: displays jitter.
const TOLERATED_JITTER_MS: f64 = 2.0;

/// The limits of the pictures of a fire.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PictureLimits {
    /// Maximum number of pictures per second.
    pub fps: Option<f64>,
    /// Maximum number of pixels in a picture.
    pub pixels: Option<f64>,
}

impl PictureLimits {
    /// The size of the picture for an element of that size \[device pixels\]. `default` is the
    /// maximum number of pixels if the page sets no limit.
    pub fn fit(&self, (width, height): (u32, u32), default: f64) -> (u32, u32) {
        let max = self.pixels.unwrap_or(default);
        let pixels = f64::from(width) * f64::from(height);
        if pixels <= max {
            return (width, height);
        }
        let scale = (max / pixels).sqrt();
        let side = |side: u32| (f64::from(side) * scale) as u32;
        (side(width).max(1), side(height).max(1))
    }

    /// Minimum interval between two pictures \[ms\]; 0 without a limit.
    pub fn min_interval(&self) -> f64 {
        self.fps.map_or(0.0, |fps| 1000.0 / fps)
    }

    /// Whether to draw in a frame at `now` \[ms\]. `next` is the earliest time of the next
    /// picture.
    pub fn is_due(&self, now: f64, next: &mut f64) -> bool {
        if self.fps.is_none() {
            return true;
        }
        if now < *next - TOLERATED_JITTER_MS {
            return false;
        }
        let interval = self.min_interval();
        // In step with the display. A pause is not made up for.
        *next = if now > *next + interval { now } else { *next } + interval;
        true
    }
}

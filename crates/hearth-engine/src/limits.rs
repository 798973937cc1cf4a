//! How much a fire may draw, and what moves its gas from outside.

use crate::fields::Fields;
use crate::message::Refused;
use crate::raw::Raw;

/// Fewest and most pictures a second that may be asked for: with fewer, the clock
/// would not make up for all of the time between two.
pub const RATES: (f64, f64) = (10.0, 240.0);

/// Fewest and most pixels of a picture that may be asked for.
pub const PIXELS: (f64, f64) = (1024.0, 16_777_216.0);

/// How much early a frame may come and still be the next one of a limited rate
/// \[ms\]: displays jitter.
const EARLY: f64 = 2.0;

/// How far from where it is stirred the gas moves \[m\].
const STIRRED: f32 = 0.12;

/// How quickly stirred gas takes the speed [1/s].
const GRIP: f32 = 60.0;

/// How long a push lasts \[s of fire\]: until the next one, where somebody goes on.
const PUSHED: f64 = 0.05;

/// Limits of what a fire draws.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Most pictures a second.
    pub fps: Option<f64>,
    /// Most pixels of one.
    pub pixels: Option<f64>,
}

/// One of them, or none of its kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Pictures a second.
    Fps(Option<f64>),
    /// Pixels of one.
    Pixels(Option<f64>),
}

impl Limit {
    /// Reads it.
    ///
    /// # Errors
    /// No limit of that name, no number, or one outside the range.
    pub fn parse(raw: &Raw) -> Result<Limit, Refused> {
        let id = raw.field("id");
        // In words: formatting a number would bring more code than all of this.
        let (name, (min, max), allowed, limit): (_, _, _, fn(_) -> _) = match id {
            Raw::Text(name) if name == "fps_limit" => {
                (name, RATES, "a number from 10 to 240", Limit::Fps)
            }
            Raw::Text(name) if name == "max_pixels" => (
                name,
                PIXELS,
                "a number from 1024 to 16777216",
                Limit::Pixels,
            ),
            other => return Err(Refused::field("id", other, "one of fps_limit, max_pixels")),
        };
        match *raw.field("value") {
            Raw::Missing => Ok(limit(None)),
            Raw::Number(x) if x >= min && x <= max => Ok(limit(Some(x))),
            ref other => Err(Refused {
                range: Some((min, max)),
                ..Refused::field(name, other, allowed)
            }),
        }
    }
}

impl Limits {
    /// With this one instead of its like.
    pub fn with(self, limit: Limit) -> Limits {
        match limit {
            Limit::Fps(fps) => Limits { fps, ..self },
            Limit::Pixels(pixels) => Limits { pixels, ..self },
        }
    }

    /// The size of the picture for an element of that size, in device pixels; `usual`:
    /// how many it may have where nobody says otherwise.
    pub fn fit(&self, (width, height): (u32, u32), usual: f64) -> (u32, u32) {
        let most = self.pixels.unwrap_or(usual);
        let pixels = f64::from(width) * f64::from(height);
        if pixels <= most {
            return (width, height);
        }
        let scale = (most / pixels).sqrt();
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
        // In step with the display, but not to make up for a pause.
        *next = if now > *next + interval { now } else { *next } + interval;
        true
    }
}

/// Gas that somebody moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stir {
    /// Where \[m\].
    pub place: [f32; 2],
    /// How fast [m/s].
    pub velocity: [f32; 2],
    /// How long it lasts yet \[s of fire\].
    left: f64,
}

impl Stir {
    /// Reads it.
    ///
    /// # Errors
    /// What is no number, and gas that is too fast.
    pub fn parse(raw: &Raw) -> Result<Stir, Refused> {
        let mut fields = Fields::of(raw);
        let mut speed = |id| fields.between(id, -20.0, 20.0, "a number from -20 to 20") as f32;
        let stir = Stir {
            velocity: [speed("u"), speed("v")],
            place: fields.place(),
            left: PUSHED,
        };
        fields.refused().map_or(Ok(stir), Err)
    }

    /// The acceleration [m/s²] of gas at that place \[m\] and velocity [m/s].
    pub fn push(&self, place: [f32; 2], velocity: [f32; 2]) -> [f32; 2] {
        let [x, y] = [0, 1].map(|axis| (place[axis] - self.place[axis]) / STIRRED);
        let share = 1.0 - (x * x + y * y);
        if share <= 0.0 {
            return [0.0; 2];
        }
        [0, 1].map(|axis| GRIP * share * share * (self.velocity[axis] - velocity[axis]))
    }

    /// A step of that length \[s\] was made; whether it still lasts.
    pub fn lasts(&mut self, step: f64) -> bool {
        self.left -= step;
        self.left > 0.0
    }
}

/// Sparks that somebody throws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sparks {
    /// From where \[m\].
    pub place: [f32; 2],
    /// How many.
    pub count: u32,
}

/// Most sparks that are thrown at once.
pub const MOST_SPARKS: u32 = 200;

impl Sparks {
    /// Reads them.
    ///
    /// # Errors
    /// A place that is none, or a number of sparks outside the range.
    pub fn parse(raw: &Raw) -> Result<Sparks, Refused> {
        let mut fields = Fields::of(raw);
        let sparks = Sparks {
            place: fields.place(),
            count: fields.whole("count", 1, MOST_SPARKS),
        };
        fields.refused().map_or(Ok(sparks), Err)
    }
}

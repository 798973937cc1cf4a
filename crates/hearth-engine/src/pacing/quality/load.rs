//! The share of a frame that a fire takes, and which levels fit.

use super::detail::Detail;

/// Interval of the displays that every fire should keep up with \[ms\]: 60 Hz.
pub const USUAL_INTERVAL_MS: f64 = 1000.0 / 60.0;
/// Maximum share of a frame that another level may be expected to take.
const FITTING_SHARE: f64 = 0.6;
/// Share of a frame from which drawing counts as long, so that fewer pixels than those of the lowest level
/// may help.
const LONG_SHARE_OF_DRAWING: f64 = 0.25;

/// Mean cost of the frames of a window.
pub struct Load {
    /// Detail of these frames.
    pub detail: Detail,
    /// Number of particles at each level, if the level decides it.
    pub particles: Option<[u32; 3]>,
    /// Time of all steps that are due \[ms\].
    pub steps: f64,
    /// Time of drawing \[ms\].
    pub draw: f64,
    /// Whether the picture has fewer pixels if the detail has half as many.
    pub shrinks: bool,
    /// Available time \[ms\].
    pub budget: f64,
    /// Share of the thread that the engine takes.
    pub share: f64,
    /// Interval between two frames \[ms\].
    pub interval: f64,
    /// Whether steps and drawing exceed the budget.
    pub exceeds: bool,
    /// Whether frames come late for another reason that a lower level may remove.
    pub late: bool,
}

impl Load {
    /// Expected time of a frame with another detail \[ms\].
    pub fn expected(&self, detail: Detail) -> f64 {
        // More particles make each step slower, and steps shorter.
        let more = self.particles.map_or(1.0, |numbers| {
            let number = |detail: Detail| f64::from(numbers[detail.level() as usize].max(1));
            number(detail) / number(self.detail)
        });
        let steps = self.steps * more * more.sqrt();
        let drawing = if detail > self.detail {
            2.0
        } else {
            detail.share() / self.detail.share()
        };
        steps + self.draw * drawing
    }

    /// Whether a detail is expected to fit with room to spare.
    pub fn fits(&self, detail: Detail) -> bool {
        self.expected(detail) <= FITTING_SHARE.min(self.share) * self.budget
    }

    /// The finest detail from `finest` down to `coarsest` that fits.
    pub fn finest(&self, mut finest: Detail, coarsest: Detail) -> Option<Detail> {
        while finest >= coarsest {
            if self.fits(finest) {
                return Some(finest);
            }
            if finest == coarsest {
                break;
            }
            finest = finest.coarser();
        }
        None
    }

    /// The finest detail below this one that fits, or the coarsest that helps; `None` without one.
    pub fn lower(&self) -> Option<Detail> {
        let long = self.shrinks && self.draw > LONG_SHARE_OF_DRAWING * self.budget;
        let coarsest = if long && self.detail <= Detail::LOW {
            Detail::COARSEST
        } else {
            Detail::LOW
        };
        if self.detail <= coarsest {
            return None;
        }
        let fitting = self.finest(self.detail.coarser(), coarsest);
        Some(fitting.unwrap_or(coarsest))
    }
}

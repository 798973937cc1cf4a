//! The share of a frame that a fire takes, and which levels fit.

use super::level::Level;

/// Interval of the displays that every fire should keep up with \[ms\]: 60 Hz.
pub const USUAL_INTERVAL: f64 = 1000.0 / 60.0;
/// Maximum share of a frame that another level may be expected to take.
const FITS: f64 = 0.6;

/// Mean cost of the frames of a window.
pub struct Load {
    /// Level of these frames.
    pub level: Level,
    /// Number of particles at each level, if the level decides it.
    pub particles: Option<[u32; 3]>,
    /// Time of all steps that are due \[ms\].
    pub steps: f64,
    /// Time of drawing \[ms\].
    pub draw: f64,
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
    /// Expected time of a frame at another level \[ms\].
    // Inlined into its callers, the engine would be larger.
    #[inline(never)]
    pub fn expected(&self, level: Level) -> f64 {
        // More particles make each step slower, and steps shorter.
        let more = self.particles.map_or(1.0, |numbers| {
            f64::from(numbers[level as usize]) / f64::from(numbers[self.level as usize].max(1))
        });
        let steps = self.steps * more * more.sqrt();
        steps + self.draw * if level > self.level { 2.0 } else { 1.0 }
    }

    /// Whether a level is expected to fit with room to spare.
    pub fn fits(&self, level: Level) -> bool {
        self.expected(level) <= FITS.min(self.share) * self.budget
    }

    /// The highest level below this one that fits, or the lowest level; `None` at the lowest.
    pub fn lower(&self) -> Option<Level> {
        let mut below = Level::ALL.into_iter().rev();
        below
            .find(|level| *level < self.level && self.fits(*level))
            .or((self.level > Level::Low).then_some(Level::Low))
    }
}

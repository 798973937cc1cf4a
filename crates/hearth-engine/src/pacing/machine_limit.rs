//! How many particles the machine steps in time.
//!
//! A page or a link may request more particles than the machine can step. The fire then has
//! fewer, and its statistics report it; `params` keeps the requested number. On a page's own thread
//! a fire starts with at most [`START_PARTICLES`] and gets more if its steps leave room.

/// Longest step on a page's own thread \[ms\]: a task stays under 50 ms if another process triples its time.
pub const MAX_STEP_MS_OF_PAGE: f64 = 16.0;
/// Longest step in a worker \[ms\].
pub const MAX_STEP_MS_OF_WORKER: f64 = 200.0;

/// Most particles of a fire on a page's own thread before its steps are measured.
pub const START_PARTICLES: u32 = 10_000;
/// Fewest particles, which both models allow.
pub const MIN_PARTICLES: u32 = 200;

/// Frames of a measurement. The fastest counts: another process may slow one of them.
const MEASURED_FRAMES: u32 = 3;
/// Share of the longest step that fewer particles aim at.
const AIMED_SHARE: f64 = 0.8;

/// The largest number of particles that a machine steps in time.
#[derive(Clone, Debug)]
pub struct MachineLimit {
    max_step: f64,
    particles: u32,
    /// Shortest step of the present measurement \[ms\], and its frames.
    shortest: f64,
    frames: u32,
    /// Whether the number fell, after which it does not rise.
    fell: bool,
}

impl MachineLimit {
    /// The limit of a page's own thread, or of a worker.
    pub fn new(on_page: bool) -> MachineLimit {
        let (max_step, particles) = if on_page {
            (MAX_STEP_MS_OF_PAGE, START_PARTICLES)
        } else {
            (MAX_STEP_MS_OF_WORKER, u32::MAX)
        };
        MachineLimit {
            max_step,
            particles,
            shortest: f64::INFINITY,
            frames: 0,
            fell: false,
        }
    }

    /// The largest number of particles.
    pub fn particles(&self) -> u32 {
        self.particles
    }

    /// The longest step \[ms\].
    pub fn max_step(&self) -> f64 {
        self.max_step
    }

    /// Restarts the measurement, because the work of a step changes.
    pub fn restart(&mut self) {
        (self.shortest, self.frames, self.fell) = (f64::INFINITY, 0, false);
    }

    /// Adds a frame whose steps of that many `particles` took `step` each \[ms\], in a fire of
    /// which a page requests the `requested` number. Returns the measured time of a step if the limit changed \[ms\].
    pub fn measure(&mut self, step: f64, particles: usize, requested: u32) -> Option<f64> {
        self.shortest = self.shortest.min(step);
        self.frames += 1;
        if self.frames < MEASURED_FRAMES {
            return None;
        }
        let step = std::mem::replace(&mut self.shortest, f64::INFINITY);
        self.frames = 0;
        let old = self.particles.min(requested);
        let new = if step > self.max_step {
            self.fell = true;
            let fits = particles as f64 * AIMED_SHARE * self.max_step / step;
            (fits as u32).max(MIN_PARTICLES).min(old)
        } else {
            let more = requested.min(old.saturating_mul(2));
            // In the worst case each particle is a neighbour of each.
            let ratio = f64::from(more) / f64::from(old);
            if self.fell || ratio * ratio * step > self.max_step {
                old
            } else {
                more
            }
        };
        if new == old {
            return None;
        }
        self.particles = new;
        Some(step)
    }
}

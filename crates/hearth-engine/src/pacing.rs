//! How much work a fire does: the time of its steps, the number of its particles, the detail of its
//! picture.

pub mod averages;
pub mod machine_limit;
pub mod picture_limits;
pub mod quality;
pub mod real_time;
pub mod step_requests;
pub mod thread_budget;

use hearth_core::fps::FpsCounter;
use hearth_core::resolution::{CountInputs, Level, ParticleCount, Resolution, SizeLimit};

use crate::commands::Start;
use averages::Averages;
use machine_limit::MachineLimit;
use quality::Quality;
use real_time::RealTime;

/// Work since the last picture. A fire also burns in frames without a picture.
#[derive(Default)]
pub struct SincePicture {
    /// Time of the steps \[ms\].
    pub steps_ms: f64,
    /// Their length, as far as they were due by the clock [s of fire].
    pub simulated: f64,
}

/// What the frames of a fire cost, and what limits its particles and pixels.
pub struct Pacing {
    /// The level of quality.
    pub quality: Quality,
    /// How much of the due fire time is simulated.
    pub real_time: RealTime,
    /// Pictures per second.
    pub fps: FpsCounter,
    /// Times and quantities of frames.
    pub averages: Averages,
    /// Work since the last picture.
    pub since_picture: SincePicture,
    size_limit: SizeLimit,
    machine_limit: MachineLimit,
}

impl Pacing {
    /// The pacing of a new fire. `on_page`: its thread is the page's own.
    pub fn new(start: &Start<'_>, on_page: bool) -> Pacing {
        let guess = start.guess.unwrap_or(Level::Medium);
        Pacing {
            quality: Quality::new(start.quality, guess),
            real_time: RealTime::default(),
            fps: FpsCounter::new(),
            averages: Averages::default(),
            since_picture: SincePicture::default(),
            size_limit: SizeLimit::of(start.side),
            machine_limit: MachineLimit::new(on_page),
        }
    }

    /// Limits particles and detail as another one does.
    pub fn copy(&mut self, other: &Pacing) {
        self.quality = other.quality.clone();
        self.size_limit = other.size_limit;
        self.machine_limit = other.machine_limit.clone();
    }

    /// Starts after a pause: the interval before the next frame does not count.
    pub fn skip(&mut self) {
        self.fps.skip();
        self.skip_work();
    }

    /// Leaves out the work since the last picture, which does not predict that of the next one.
    pub fn skip_work(&mut self) {
        self.quality.skip();
        self.since_picture = SincePicture::default();
    }

    /// Measures anew, because the work of a step changes.
    pub fn restart(&mut self) {
        self.real_time.forget_losses();
        self.quality.skip();
        self.machine_limit.restart();
    }

    /// Follows the size of the element. Returns whether the number of particles may change.
    pub fn resize(&mut self, side: f64) -> bool {
        let changes = self.size_limit.resize(side);
        if changes {
            self.quality.skip();
        }
        changes
    }

    /// The number of particles, and what limits it. `is_coarse`: the fire warms up with few.
    pub fn particle_count(&self, settings: Resolution, is_coarse: bool) -> ParticleCount {
        self.count_at(self.quality.level(), settings, is_coarse)
    }

    /// The number of particles at each level, if the level decides it.
    pub fn counts_of_levels(&self, settings: Resolution) -> Option<[u32; 3]> {
        let follows = settings == Resolution::Level;
        follows.then(|| Level::ALL.map(|level| self.count_at(level, settings, false).number))
    }

    fn count_at(&self, level: Level, settings: Resolution, is_coarse: bool) -> ParticleCount {
        ParticleCount::of(&CountInputs {
            settings,
            level,
            is_level_requested: self.quality.requested().is_some(),
            size: self.size_limit,
            machine: self.machine_limit.particles(),
            is_coarse,
        })
    }

    /// Limits the `requested` number of particles by the time of a step of that many `particles` \[ms\]. Returns
    /// whether the limit changed.
    pub fn limit_particles(&mut self, step: f64, particles: usize, requested: u32) -> bool {
        let measured = self.machine_limit.measure(step, particles, requested);
        if let Some(step) = measured {
            let now = requested.min(self.machine_limit.particles());
            self.quality
                .explain(step, self.machine_limit.max_step(), now, requested);
        }
        measured.is_some()
    }
}

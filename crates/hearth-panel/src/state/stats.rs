//! The fire's measurements.

/// The fire's measurements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stats {
    /// Smoothed frame rate [Hz].
    pub fps: f64,
    /// Number of live particles.
    pub particles: f64,
    /// Share of the air that sleeps because of the largest number of particles.
    pub asleep: f64,
    /// Duration of a step [ms].
    pub step_ms: f64,
    /// Steps per frame.
    pub steps_per_frame: f64,
    /// Duration of drawing a frame [ms].
    pub draw_ms: f64,
    /// Whether the machine is too slow for the fire's speed.
    pub slowed: bool,
    /// Recent real-time factor: seconds of fire per second.
    pub time_scale: f64,
    /// The present quality.
    pub quality: String,
    /// The reason for that quality.
    pub reason: String,
    /// Durations of the stages of a step [ms per frame].
    pub stages: Vec<(String, f64)>,
    /// Durations of the render passes [ms].
    pub passes: Vec<(String, f64)>,
    /// Whether the GPU timed the passes; otherwise the CPU timed their submission.
    pub on_card: bool,
}

impl Stats {
    /// Duration of a frame, simulated and drawn [ms].
    pub fn frame_ms(&self) -> f64 {
        self.step_ms * self.steps_per_frame + self.draw_ms
    }
}

//! When a fire burns: its clock, its warm-up, and the steps that scripts request.

use glam::Vec2;
use hearth_core::clock::Clock;
use hearth_core::warm_up::WarmUp;
use hearth_core::{Simulation, Stage};

use crate::commands::Start;
use crate::pacing::step_requests::StepRequests;
use crate::pointer::PointerForce;

/// Why a step is due.
#[derive(Clone, Copy)]
pub enum Due {
    /// The fire warms up.
    WarmUp,
    /// A script requests steps up to this age of the fire \[s\].
    Request(f64),
    /// The clock has passed.
    Clock,
}

/// How often a warm-up that was not shown yet starts over with other values: a page may change one in every frame.
const MAX_RESTARTS: u8 = 8;

/// The time of a fire.
pub struct Playback {
    pub(crate) playing: bool,
    pub(super) clock: Clock,
    pub(crate) requests: StepRequests,
    pub(super) warm_up: WarmUp,
    /// Whether a new fire starts before the next step.
    pub(super) starts: bool,
    /// How many fires have started.
    restarts: u8,
    /// The force of a pointer in the next steps.
    pub(crate) pointer: Option<PointerForce>,
    /// Length of the last step [s of fire], an estimate of the next.
    last_step: f64,
}

impl Playback {
    pub fn new(start: &Start<'_>) -> Playback {
        let warm_up = WarmUp::new(start.warm, start.state.to_vec());
        Playback {
            playing: !start.paused,
            clock: Clock::new(),
            requests: StepRequests::default(),
            starts: warm_up.is_enabled(),
            restarts: 0,
            warm_up,
            pointer: None,
            last_step: 0.0,
        }
    }

    /// Stands where another one does, paused.
    pub fn copy(&mut self, other: &Playback) {
        self.playing = false;
        self.starts = other.starts;
        self.warm_up = other.warm_up.clone();
        self.pointer = other.pointer;
    }

    /// Sets the duration of the warm-up of new fires. The answer to `request` follows when the
    /// fire is shown or cannot be drawn.
    pub fn set_warm_up(&mut self, seconds: Option<f64>, request: u32) {
        if let Some(seconds) = seconds {
            self.warm_up.set(seconds);
        }
        self.requests.add(0, 0.0, request);
    }

    /// Starts a new fire before the next step.
    pub fn start(&mut self) {
        self.restarts = self.restarts.saturating_add(u8::from(!self.starts));
        self.starts = true;
    }

    /// Whether values that change start a fire anew that was not shown yet.
    pub fn starts_over(&self) -> bool {
        self.starts || self.restarts < MAX_RESTARTS
    }

    /// Whether the fire is warming up.
    pub fn is_warming(&self) -> bool {
        self.starts || self.warm_up.is_on()
    }

    /// The next step of a fire of that `age` \[s\], if one is due: of the warm-up if the fire `warms`, by the clock if it
    /// `plays`.
    pub fn due(&mut self, warms: bool, plays: bool, age: f64) -> Option<Due> {
        if warms && self.warm_up.is_on() {
            return Some(Due::WarmUp);
        }
        if let Some(request) = self.requests.next_open() {
            return Some(Due::Request(request.end(age)));
        }
        (plays && self.clock.due(self.last_step)).then_some(Due::Clock)
    }

    /// Makes a due step. Returns its length [s of fire].
    pub fn step(
        &mut self,
        due: Due,
        simulation: &mut Simulation,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f64 {
        let end = match due {
            Due::Request(end) => end,
            Due::WarmUp | Due::Clock => f64::INFINITY,
        };
        let length = step(simulation, self.pointer, end, on_stage);
        let pointer = &mut self.pointer;
        if pointer.as_mut().is_some_and(|force| !force.lasts(length)) {
            *pointer = None;
        }
        self.last_step = length;
        length
    }

    /// Drops the steps that are still due by the clock. Returns their length [s of fire].
    pub fn drop_rest(&mut self) -> f64 {
        if self.clock.due(self.last_step) {
            self.clock.drop_rest()
        } else {
            0.0
        }
    }
}

/// Makes a step towards the age `end`, with the force of a pointer. Returns its length [s of fire].
// Inlined into its loop, the whole solver would be compiled twice.
#[inline(never)]
fn step(
    simulation: &mut Simulation,
    pointer: Option<PointerForce>,
    end: f64,
    on_stage: &mut dyn FnMut(Stage),
) -> f64 {
    let start = simulation.time();
    match pointer {
        Some(force) => {
            let acceleration =
                |at: Vec2, v: Vec2| Vec2::from(force.acceleration(at.into(), v.into()));
            simulation.step_towards(end, Some(&acceleration), on_stage);
        }
        None => simulation.step_towards(end, None, on_stage),
    }
    simulation.time() - start
}

//! The panel's copy of the fire's values.
//!
//! The copy holds checked values only. While a request for a parameter is pending, older
//! values of the same parameter are ignored: a slider would otherwise jump under the
//! finger that drags it.

use std::collections::{BTreeMap, VecDeque};

use hearth_core::params::{Domain, Input, PARAMETERS, Param, ParamError, Parameters, Value};

/// The id of the parameter that selects the model.
pub const MODEL: &str = "model";

/// The id of the parameter that selects the edges of the air.
const EDGES: &str = "edges";

/// The qualities that a fire can be set to, as its API names them.
pub const QUALITIES: [&str; 4] = ["auto", "low", "medium", "high"];

/// The length of the history in samples: half a minute at four a second.
pub const HISTORY: usize = 120;

/// An input that has not been checked.
#[derive(Clone, Debug)]
pub enum Entry {
    /// A number.
    Number(f64),
    /// On or off.
    Flag(bool),
    /// A text, which may spell any kind of value.
    Text(String),
}

impl Entry {
    /// The input of the parameter table.
    pub fn input(&self) -> Input<'_> {
        match self {
            Entry::Number(number) => Input::Number(*number),
            Entry::Flag(on) => Input::Flag(*on),
            Entry::Text(text) => Input::Text(text),
        }
    }
}

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

/// The panel's copy of the fire.
#[derive(Debug, Default)]
pub struct Fire {
    /// The checked values.
    pub parameters: Parameters,
    /// The values of the scene that the fire started from, which are the panel's defaults.
    pub scene: Parameters,
    /// Whether the simulation is paused.
    pub paused: bool,
    /// The requested quality.
    pub quality: String,
    /// The latest measurements.
    pub stats: Stats,
    /// Recent frame rates, the oldest first.
    pub history: VecDeque<f32>,
    /// Reasons for refused values, by parameter.
    pub refusals: BTreeMap<&'static str, String>,
    /// The latest other error.
    pub notice: Option<String>,
    pending: BTreeMap<&'static str, u32>,
}

impl Fire {
    /// The value of a parameter in the scene, for the present model.
    pub fn default_of(&self, param: &Param) -> Value {
        let model = self.parameters.model();
        if self.scene.model() == model || param.id == MODEL {
            return param.get(&self.scene);
        }
        let mut scene = self.scene.clone();
        // The name of a model is always accepted.
        let _ = scene.set(MODEL, Input::Text(model.name()));
        param.get(&scene)
    }

    /// Takes a scene's values as the defaults. Values that are missing are those of the
    /// scene's model.
    pub fn start_from<'a>(&mut self, values: impl IntoIterator<Item = (&'a str, Input<'a>)>) {
        let mut scene = Parameters::default();
        let (model, others): (Vec<_>, Vec<_>) =
            values.into_iter().partition(|(id, _)| *id == MODEL);
        for (id, input) in model.into_iter().chain(others) {
            // A refused value comes from another version of the fire.
            let _ = scene.set(id, input);
        }
        self.scene = scene;
    }

    /// The range of a parameter in the present model.
    pub fn range_of(&self, param: &Param) -> (f64, f64) {
        self.domain_of(param).range
    }

    fn domain_of(&self, param: &Param) -> &'static Domain {
        param.any_domain(self.parameters.model())
    }

    /// The parameters of the present model and of its edges, without the model itself.
    pub fn used(&self) -> impl Iterator<Item = &'static Param> + '_ {
        PARAMETERS.iter().filter(|param| {
            let mut unmet = param.unmet_conditions(&self.parameters);
            let used = param.domain(self.parameters.model()).is_some();
            used && param.id != MODEL && unmet.all(|(id, _)| *id != EDGES)
        })
    }

    /// Checks a value without setting it.
    ///
    /// # Errors
    /// Returns the reason why the table refuses the value.
    pub fn check(&self, param: &Param, input: Input<'_>) -> Result<(), ParamError> {
        self.parameters.clone().set(param.id, input)
    }

    /// Sets a value before the fire confirms it, and returns it as the table rounds it.
    ///
    /// # Errors
    /// Returns the reason why the table refuses the value; nothing changes then.
    pub fn set(&mut self, param: &'static Param, input: Input<'_>) -> Result<Value, ParamError> {
        self.parameters.set(param.id, input)?;
        self.refusals.remove(param.id);
        Ok(param.get(&self.parameters))
    }

    /// Takes a value that the fire reports.
    pub fn receive(&mut self, id: &str, input: Input<'_>) {
        let Some(param) = Param::find(id) else {
            return;
        };
        if self.pending.contains_key(param.id) {
            return;
        }
        let before = param.get(&self.parameters);
        // A refused value comes from another version of the fire: the panel keeps the last
        // valid one.
        if self.parameters.set(param.id, input).is_ok() && param.get(&self.parameters) != before {
            self.refusals.remove(param.id);
        }
    }

    /// Counts a request for `id` as pending.
    pub fn sent(&mut self, id: &'static str) {
        *self.pending.entry(id).or_default() += 1;
    }

    /// Counts a request for `id` as answered. Returns whether none is pending any more, so
    /// that the caller reads the fire's value again.
    pub fn answered(&mut self, id: &'static str) -> bool {
        match self.pending.get_mut(id) {
            Some(count) if *count > 1 => {
                *count -= 1;
                false
            }
            _ => {
                self.pending.remove(id);
                true
            }
        }
    }

    /// Takes new measurements.
    pub fn measure(&mut self, stats: Stats) {
        if self.history.len() == HISTORY {
            self.history.pop_front();
        }
        self.history.push_back(stats.fps as f32);
        self.stats = stats;
    }

    /// Whether any value of the present model differs from the scene.
    pub fn is_changed(&self) -> bool {
        self.used().any(|param| self.differs(param))
    }

    /// Whether the value of a parameter differs from the scene.
    pub fn differs(&self, param: &Param) -> bool {
        param.get(&self.parameters) != self.default_of(param)
    }
}

#[cfg(test)]
mod tests {
    use hearth_core::params::Model;

    use super::*;

    fn classic() -> Fire {
        Fire {
            parameters: Parameters::new(Model::Classic),
            scene: Parameters::new(Model::Classic),
            ..Fire::default()
        }
    }

    #[test]
    fn each_kind_of_edges_has_its_own_parameters() {
        let mut fire = Fire::default();
        for (edges, open) in [("open", true), ("periodic", false)] {
            fire.receive(EDGES, Input::Text(edges));
            for (id, shown) in [("floor", open), ("spacing", open), ("seam", !open)] {
                assert_eq!(fire.used().any(|param| param.id == id), shown, "{id}");
            }
            assert!(fire.used().any(|param| param.id == "domain_width"));
        }
    }

    #[test]
    fn parameters_of_the_other_model_are_not_changes() {
        let mut fire = classic();
        fire.receive("wind", Input::Number(2.0));
        assert!(!fire.is_changed());
        fire.receive("viscosity", Input::Number(0.02));
        assert!(fire.is_changed());
        fire.receive(MODEL, Input::Text("combustion"));
        assert_eq!(fire.parameters.wind, 2.0);
        assert!(fire.used().all(|param| param.id != "viscosity"));
        assert!(fire.is_changed());
    }

    #[test]
    fn changes_are_relative_to_the_scene() {
        let mut fire = Fire::default();
        let campfire = [
            ("fuel_power", Input::Number(90.0)),
            ("exposure", Input::Number(0.5)),
        ];
        fire.start_from(campfire);
        assert!(fire.is_changed());
        for (id, input) in campfire {
            fire.receive(id, input);
        }
        assert!(!fire.is_changed());
        // Shared parameters keep the scene's values, all others have the table's.
        fire.receive(MODEL, Input::Text("classic"));
        let default = |id: &str| Param::find(id).map(|param| fire.default_of(param));
        assert_eq!(default("exposure"), Some(Value::Number(0.5)));
        assert_eq!(default("source_width"), Some(Value::Number(0.36)));
    }

    #[test]
    fn an_older_value_does_not_move_a_dragged_slider() {
        let mut fire = classic();
        let viscosity = Param::find("viscosity").expect("the table has viscosity");
        fire.set(viscosity, Input::Number(0.08)).expect("in range");
        fire.sent("viscosity");
        fire.sent("viscosity");
        fire.receive("viscosity", Input::Number(0.01));
        assert_eq!(fire.parameters.viscosity, 0.08);
        assert!(!fire.answered("viscosity"));
        assert!(fire.answered("viscosity"));
        fire.receive("viscosity", Input::Number(0.01));
        assert_eq!(fire.parameters.viscosity, 0.01);
    }

    #[test]
    fn a_refused_value_changes_nothing_and_has_a_reason() {
        let mut fire = classic();
        let viscosity = Param::find("viscosity").expect("the table has viscosity");
        let before = fire.parameters.clone();
        let refused = fire
            .set(viscosity, Input::Text("7"))
            .expect_err("7 is out of range");
        let text = refused.to_string();
        assert!(text.contains("viscosity") && text.contains('7') && text.contains("0.1"));
        assert_eq!(fire.parameters, before);
    }

    #[test]
    fn the_history_keeps_half_a_minute() {
        let mut fire = Fire::default();
        for fps in 0..1000 {
            fire.measure(Stats {
                fps: f64::from(fps),
                ..Stats::default()
            });
        }
        assert_eq!(fire.history.len(), HISTORY);
        assert_eq!(fire.history.back(), Some(&999.0));
    }
}

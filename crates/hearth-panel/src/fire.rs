//! What the panel knows about the fire, and what it asks of it.
//!
//! The panel never owns the fire: it keeps a checked copy of its values, shows
//! that, and sends a [`Command`] for every wish. While a wish for a parameter
//! is under way, older news of the same parameter is not shown, or a slider
//! would jump under the finger that holds it.

use std::collections::{BTreeMap, VecDeque};

use hearth_core::params::{Domain, Input, Model, PARAMETERS, Param, ParamError, Parameters, Value};

use crate::memory::Memory;

/// The id of the parameter that decides which others there are.
pub const MODEL: &str = "model";

/// What a fire can be asked to have for a quality, as its API names it.
pub const QUALITIES: [&str; 4] = ["auto", "low", "medium", "high"];

/// How many samples the history keeps: half a minute at four a second.
pub const HISTORY: usize = 120;

/// Something that the panel asks of the fire.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Set a parameter.
    Set(&'static str, Value),
    /// Put a parameter back to the scene's value.
    Restore(&'static str),
    /// Put all of them back, the model too.
    RestoreAll,
    /// Keep this for the next visit.
    Remember(Memory),
    /// Show the scenes, or hide them.
    Scenes,
    /// Make so much work.
    Quality(&'static str),
    /// Let time pass.
    Play,
    /// Hold it.
    Pause,
    /// Start again, with the same values.
    Reset,
    /// One step, while paused.
    Step,
    /// Take the last step of somebody's back.
    Undo,
    /// Do it again.
    Redo,
    /// Copy this, by its name.
    Copy(&'static str),
    /// Ask for settings.
    Paste,
    /// Save a picture.
    Picture,
    /// Take all of the screen, or give it back.
    Fullscreen,
    /// Show the keys.
    Help,
}

/// How the fire does.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stats {
    /// Frames per second, smoothed.
    pub fps: f64,
    /// Particles alive.
    pub particles: f64,
    /// What a step takes [ms].
    pub step_ms: f64,
    /// Steps made for each frame.
    pub steps_per_frame: f64,
    /// What drawing a frame takes [ms].
    pub draw_ms: f64,
    /// Whether the machine is too slow for the fire's own speed.
    pub slowed: bool,
    /// Seconds of fire for each second of the clock, as it lately was.
    pub time_scale: f64,
    /// The quality that it has.
    pub quality: String,
    /// Why it has that quality.
    pub reason: String,
    /// What the parts of its steps take in a frame [ms].
    pub stages: Vec<(String, f64)>,
    /// What the passes of the picture take [ms].
    pub passes: Vec<(String, f64)>,
    /// Whether the graphics card says so, or only the processor that hands
    /// them over.
    pub on_card: bool,
}

impl Stats {
    /// What a frame takes, simulated and drawn [ms].
    pub fn frame_ms(&self) -> f64 {
        self.step_ms * self.steps_per_frame + self.draw_ms
    }
}

/// The panel's copy of the fire.
#[derive(Debug, Default)]
pub struct Fire {
    /// Every value, checked.
    pub parameters: Parameters,
    /// The values of the scene that it started from: these are its defaults.
    pub scene: Parameters,
    /// Whether time stands still.
    pub paused: bool,
    /// The quality that it was asked to have.
    pub quality: String,
    /// The last numbers that came.
    pub stats: Stats,
    /// Frames per second of the last samples, the oldest first.
    pub history: VecDeque<f32>,
    /// Why a value was refused, by id.
    pub refusals: BTreeMap<&'static str, String>,
    /// What else went wrong.
    pub notice: Option<String>,
    under_way: BTreeMap<&'static str, u32>,
}

impl Fire {
    /// What a parameter has in the scene, in the present model.
    pub fn default_of(&self, param: &Param) -> Value {
        let model = self.parameters.model();
        if self.scene.model() == model || param.id == MODEL {
            return param.get(&self.scene);
        }
        let mut scene = self.scene.clone();
        // A model's name is one of the model's names.
        let _ = scene.set(MODEL, Input::Text(model.name()));
        param.get(&scene)
    }

    /// The fire started from a scene of these values; what it does not name has the
    /// default of the scene's model.
    pub fn start_from<'a>(&mut self, values: impl IntoIterator<Item = (&'a str, Input<'a>)>) {
        let mut scene = Parameters::default();
        let (model, others): (Vec<_>, Vec<_>) =
            values.into_iter().partition(|(id, _)| *id == MODEL);
        for (id, input) in model.into_iter().chain(others) {
            // A value that the table refuses cannot come from this version of the fire.
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

    /// The parameters that the present model uses, without the model itself.
    pub fn used(&self) -> impl Iterator<Item = &'static Param> + use<> {
        let model: Model = self.parameters.model();
        PARAMETERS
            .iter()
            .filter(move |param| param.id != MODEL && param.domain(model).is_some())
    }

    /// Checks a wish and shows it at once.
    ///
    /// # Errors
    /// Says what is wrong with it; nothing changes then.
    pub fn wish(&mut self, param: &'static Param, input: Input<'_>) -> Result<Value, ParamError> {
        self.parameters.set(param.id, input)?;
        self.refusals.remove(param.id);
        Ok(param.get(&self.parameters))
    }

    /// The fire has this value now, whoever set it.
    pub fn learn(&mut self, id: &str, input: Input<'_>) {
        let Some(param) = Param::find(id) else {
            return;
        };
        if self.under_way.contains_key(param.id) {
            return;
        }
        let before = param.get(&self.parameters);
        // A value that the table refuses cannot come from this version of the
        // fire; the panel then keeps showing the last good one.
        if self.parameters.set(param.id, input).is_ok() && param.get(&self.parameters) != before {
            self.refusals.remove(param.id);
        }
    }

    /// A wish for `id` was sent.
    pub fn sent(&mut self, id: &'static str) {
        *self.under_way.entry(id).or_default() += 1;
    }

    /// A wish for `id` was answered; true when none is left under way, so that
    /// the fire's own value should be read again.
    pub fn answered(&mut self, id: &'static str) -> bool {
        match self.under_way.get_mut(id) {
            Some(count) if *count > 1 => {
                *count -= 1;
                false
            }
            _ => {
                self.under_way.remove(id);
                true
            }
        }
    }

    /// The newest numbers.
    pub fn measure(&mut self, stats: Stats) {
        if self.history.len() == HISTORY {
            self.history.pop_front();
        }
        self.history.push_back(stats.fps as f32);
        self.stats = stats;
    }

    /// Whether any value of the model is not the scene's.
    pub fn is_changed(&self) -> bool {
        self.used().any(|param| self.differs(param))
    }

    /// Whether the value of a parameter is not the scene's.
    pub fn differs(&self, param: &Param) -> bool {
        param.get(&self.parameters) != self.default_of(param)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn classic() -> Fire {
        Fire {
            parameters: Parameters::new(Model::Classic),
            scene: Parameters::new(Model::Classic),
            ..Fire::default()
        }
    }

    #[test]
    fn what_the_model_does_not_use_does_not_count() {
        let mut fire = classic();
        fire.learn("wind", Input::Number(2.0));
        assert!(!fire.is_changed());
        fire.learn("viscosity", Input::Number(0.02));
        assert!(fire.is_changed());
        fire.learn(MODEL, Input::Text("combustion"));
        assert_eq!(fire.parameters.wind, 2.0);
        assert!(fire.used().all(|param| param.id != "viscosity"));
        assert!(fire.is_changed());
    }

    #[test]
    fn the_scene_says_what_is_changed() {
        let mut fire = Fire::default();
        let campfire = [
            ("fuel_power", Input::Number(90.0)),
            ("exposure", Input::Number(0.5)),
        ];
        fire.start_from(campfire);
        assert!(fire.is_changed());
        for (id, input) in campfire {
            fire.learn(id, input);
        }
        assert!(!fire.is_changed());
        // What both models share is the scene's in both, the rest is the table's.
        fire.learn(MODEL, Input::Text("classic"));
        let default = |id: &str| Param::find(id).map(|param| fire.default_of(param));
        assert_eq!(default("exposure"), Some(Value::Number(0.5)));
        assert_eq!(default("source_width"), Some(Value::Number(0.36)));
    }

    #[test]
    fn old_news_does_not_move_a_slider_that_is_being_dragged() {
        let mut fire = classic();
        let viscosity = Param::find("viscosity").expect("the table has viscosity");
        fire.wish(viscosity, Input::Number(0.08)).expect("in range");
        fire.sent("viscosity");
        fire.sent("viscosity");
        fire.learn("viscosity", Input::Number(0.01));
        assert_eq!(fire.parameters.viscosity, 0.08);
        assert!(!fire.answered("viscosity"));
        assert!(fire.answered("viscosity"));
        fire.learn("viscosity", Input::Number(0.01));
        assert_eq!(fire.parameters.viscosity, 0.01);
    }

    #[test]
    fn a_refused_wish_changes_nothing_and_says_why() {
        let mut fire = classic();
        let viscosity = Param::find("viscosity").expect("the table has viscosity");
        let before = fire.parameters.clone();
        let refused = fire
            .wish(viscosity, Input::Text("7"))
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

//! The panel's copy of the fire's values.
//!
//! The copy has checked values only. While a request for a parameter is pending, older
//! values of the same parameter are ignored: a slider would otherwise jump under the
//! finger that drags it.

use std::collections::{BTreeMap, VecDeque};

use hearth_core::Scene;
use hearth_core::params::{
    AnyValue, Domain, Input, Kind, PARAMETERS, Param, ParamError, ParamErrorKind, Parameters, Scale,
};
use hearth_core::scene::Object;

pub use crate::state::entry::Entry;
use crate::state::objects::{Fields, OBJECTS, differ, update, value_in};
pub use crate::state::stats::Stats;
use crate::state::subject::{Owner, Subject};

/// The id of the parameter that selects the model.
pub const MODEL: &str = "model";

/// The id of the parameter that selects the edges of the air.
const EDGES: &str = "edges";

/// The qualities that a fire can be set to, as its API names them.
pub const QUALITIES: [&str; 4] = ["auto", "low", "medium", "high"];

/// The largest strength and size on a slider, in those of the scene.
const SCENE_RATIO: f64 = 2.0;

/// The length of the history in samples: half a minute at four a second.
pub const HISTORY_LENGTH: usize = 120;

/// The panel's copy of the fire.
#[derive(Debug, Default)]
pub struct Fire {
    /// The checked values and objects.
    pub objects: Scene,
    /// The scene that the fire started from: the panel's defaults.
    pub scene: Scene,
    /// Whether the simulation is paused.
    pub paused: bool,
    /// The requested quality.
    pub quality: String,
    /// The latest measurements.
    pub stats: Stats,
    /// Recent frame rates, the oldest first.
    pub history: VecDeque<f32>,
    /// Reasons for refused values, by [`Subject::id`].
    pub refusals: BTreeMap<&'static str, String>,
    /// The latest other error.
    pub notice: Option<String>,
    /// The number of pending requests by what they change.
    pending: BTreeMap<&'static str, u32>,
}

impl Fire {
    /// The values of the world.
    pub fn parameters(&self) -> &Parameters {
        self.objects.world()
    }

    /// Whether the properties of an object are those that parameters set.
    pub fn is_first_source(&self, object: &Object<'_>) -> bool {
        self.objects.first_source_id() == Some(object.id)
    }

    /// The present value.
    pub fn value(&self, subject: impl Into<Subject>) -> AnyValue<'_> {
        let subject = subject.into();
        match subject.object {
            None => self.objects.value(subject.param),
            Some(_) => {
                value_in(&self.objects, subject).unwrap_or_else(|| self.domain_of(subject).default)
            }
        }
    }

    /// The value in the scene, for the present model. An object that the scene lacks has the
    /// defaults.
    pub fn default_of(&self, subject: impl Into<Subject>) -> AnyValue<'_> {
        let subject = subject.into();
        let param = subject.param;
        let model = self.parameters().model();
        if subject.object.is_some() {
            return value_in(&self.scene, subject)
                .unwrap_or_else(|| self.domain_of(subject).default);
        }
        if self.scene.model() == model || param.id == MODEL {
            return self.scene.value(param);
        }
        let mut scene = self.scene.clone();
        // The name of a model is always accepted.
        let _ = scene.set(MODEL, model.name());
        scene.value(param)
    }

    /// Takes a scene's values and objects as the defaults. Values that are missing are those of
    /// the scene's model; without objects, the scene has one source.
    pub fn start_from<'a>(
        &mut self,
        values: impl IntoIterator<Item = (&'a str, Input<'a>)>,
        objects: Option<&[Fields]>,
    ) {
        let (model, others): (Vec<_>, Vec<_>) =
            values.into_iter().partition(|(id, _)| *id == MODEL);
        let mut scene = Scene::default();
        for (id, input) in model {
            // A refused value comes from another version of the fire.
            let _ = scene.set(id, input);
        }
        if let Some(objects) = objects {
            update(&mut scene, objects);
        }
        for (id, input) in others {
            let _ = scene.set(id, input);
        }
        self.scene = scene;
    }

    /// Whether the scene has the value: it lacks the properties of an added object.
    pub fn is_of_scene(&self, subject: Subject) -> bool {
        subject.object.is_none() || value_in(&self.scene, subject).is_some()
    }

    /// The range in the present model.
    pub fn range_of(&self, subject: impl Into<Subject>) -> (f64, f64) {
        self.domain_of(subject.into()).range
    }

    /// The range of a slider. A coordinate of an object may be far outside of the domain, and a
    /// slider of all coordinates would be too coarse: it spans the domain and the value. A slider
    /// of ids spans the ids of the solids and the value; one of strength or size follows the scene.
    pub fn slider_range(&self, subject: Subject) -> (f64, f64) {
        let (min, max) = self.range_of(subject);
        if ["source_solid", "hangs_from"].contains(&subject.param.id) {
            let value = self.value(subject).as_number().unwrap_or_default();
            let solids = self
                .objects
                .objects()
                .filter(|object| object.solid().is_some());
            let solids = solids.map(|object| f64::from(object.id));
            return (min, solids.fold(value.max(1.0), f64::max));
        }
        if let Some(most) = self.most_in_scene(subject) {
            return (min, max.min(most));
        }
        let linear = subject.param.kind == Kind::Number(Scale::Linear);
        if subject.object.is_none() || !linear || subject.param.unit != "m" {
            return (min, max);
        }
        let size = ["domain_width", "domain_height"].map(|id| {
            let value = self.parameters().get(id);
            value.and_then(|x| x.as_number()).unwrap_or_default()
        });
        let size = size[0].max(size[1]);
        let value = self.value(subject).as_number().unwrap_or_default();
        (min.max(value.min(-size)), max.min(value.max(size)))
    }

    /// The largest value of a slider whose range follows the scene: the strength and the size of a candle and of
    /// a hero differ by two orders, and one range for both makes a candle a wall of fire. A value beyond it extends it.
    fn most_in_scene(&self, subject: Subject) -> Option<f64> {
        if !["fuel_power", "source_width"].contains(&subject.param.id) {
            return None;
        }
        let of_scene = self.default_of(subject).as_number().filter(|x| *x > 0.0)?;
        let value = self.value(subject).as_number().unwrap_or_default();
        Some(value.max(of_scene * SCENE_RATIO))
    }

    fn domain_of(&self, subject: Subject) -> &'static Domain {
        subject.param.any_domain(self.parameters().model())
    }

    /// The parameters of the present model and of its edges, without the model itself, which stands in another group.
    pub fn used(&self) -> impl Iterator<Item = &'static Param> + '_ {
        PARAMETERS.iter().filter(|param| {
            let mut unmet = param.unmet_conditions(|id| self.objects.get(id));
            let used = param.domain(self.parameters().model()).is_some();
            used && param.id != MODEL && unmet.all(|(id, _)| *id != EDGES)
        })
    }

    /// Checks a value without setting it.
    ///
    /// # Errors
    /// Returns the reason why the table refuses the value.
    pub fn check(&self, subject: Subject, input: Input<'_>) -> Result<(), ParamError> {
        match subject.object {
            None => self.objects.clone().set(subject.id, input),
            Some(owner) => change(&mut self.objects.clone(), owner, input),
        }
    }

    /// Sets a value before the fire confirms it.
    ///
    /// # Errors
    /// Returns the reason why the table refuses the value; nothing changes then.
    pub fn set(&mut self, subject: impl Into<Subject>, input: Input<'_>) -> Result<(), ParamError> {
        let subject = subject.into();
        match subject.object {
            None => self.objects.set(subject.id, input)?,
            Some(owner) => change(&mut self.objects, owner, input)?,
        }
        self.refusals.remove(subject.id);
        Ok(())
    }

    /// Takes a value that the fire reports.
    pub fn receive(&mut self, id: &str, input: Input<'_>) {
        let Some(param) = Param::find(id) else {
            return;
        };
        if self.pending.contains_key(param.id) {
            return;
        }
        let before = self.objects.value(param);
        // The fire reports values of the other model, too. Another refused value comes from another version of the
        // fire: the panel keeps the last valid one.
        if self.objects.set(param.id, input).is_ok() && self.objects.value(param) != before {
            self.refusals.remove(param.id);
        }
    }

    /// Counts a request to set a value as pending. The fire reports all objects at once.
    pub fn sent(&mut self, subject: Subject) {
        *self.pending.entry(reported_with(subject)).or_default() += 1;
    }

    /// Counts such a request as answered. Returns whether none is pending any more, so that the caller reads the
    /// fire's values again.
    pub fn answered(&mut self, subject: Subject) -> bool {
        let id = reported_with(subject);
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

    /// Takes the objects that the fire reports.
    pub fn receive_objects(&mut self, objects: &[Fields]) {
        if self.pending.contains_key(OBJECTS) {
            return;
        }
        let pending = PARAMETERS
            .iter()
            .filter(|param| param.is_of_objects() && self.pending.contains_key(param.id));
        let kept: Vec<_> = pending
            .map(|param| (param.id, self.objects.value(param).to_string()))
            .collect();
        update(&mut self.objects, objects);
        for (id, value) in &kept {
            let _ = self.objects.set(id, value.as_str());
        }
    }

    /// Takes new measurements.
    pub fn measure(&mut self, stats: Stats) {
        if self.history.len() == HISTORY_LENGTH {
            self.history.pop_front();
        }
        self.history.push_back(stats.fps as f32);
        self.stats = stats;
    }

    /// Whether any value of the present model differs from the scene.
    pub fn is_changed(&self) -> bool {
        self.used().any(|param| self.differs(param)) || differ(&self.objects, &self.scene)
    }

    /// Whether a value differs from the scene.
    pub fn differs(&self, subject: impl Into<Subject>) -> bool {
        let subject = subject.into();
        self.value(subject) != self.default_of(subject)
    }
}

/// What the fire reports a value with: its parameter, or the objects.
fn reported_with(subject: Subject) -> &'static str {
    subject.object.map_or(subject.id, |_| OBJECTS)
}

/// Changes a property. A scene names all that is wrong; here it is one value.
fn change(scene: &mut Scene, owner: Owner, input: Input<'_>) -> Result<(), ParamError> {
    let changed = scene.change(owner.id, &[(owner.property, input)]);
    changed.map_err(|mut refused| ParamError {
        // The index of the object means nothing to a visitor.
        id: owner.property.to_owned(),
        ..refused.pop().unwrap_or_else(|| ParamError {
            id: String::new(),
            value: input.to_string(),
            kind: ParamErrorKind::Other("a value of the table"),
        })
    })
}

#[cfg(test)]
mod tests {
    use hearth_core::params::{Model, Value};

    use super::*;

    fn classic() -> Fire {
        Fire {
            objects: Scene::of_model(Model::Classic),
            scene: Scene::of_model(Model::Classic),
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
        assert_eq!(fire.parameters().wind, 0.0);
        assert!(fire.used().all(|param| param.id != "viscosity"));
        assert!(!fire.is_changed());
    }

    #[test]
    fn changes_are_relative_to_the_scene() {
        let mut fire = Fire::default();
        let campfire = [
            ("fuel_power", Input::Number(90.0)),
            ("detail", Input::Number(0.5)),
        ];
        fire.start_from(campfire, None);
        assert!(fire.is_changed());
        for (id, input) in campfire {
            fire.receive(id, input);
        }
        assert!(!fire.is_changed());
        // Shared parameters keep the scene's values, all others have the table's.
        fire.receive(MODEL, Input::Text("classic"));
        let default = |id: &str| Param::find(id).map(|param| fire.default_of(param));
        assert_eq!(default("detail"), Some(Value::Number(0.5)));
        assert_eq!(default("source_width"), Some(Value::Number(0.36)));
    }

    #[test]
    fn an_older_value_does_not_move_a_dragged_slider() {
        let mut fire = classic();
        let viscosity = Param::find("viscosity").expect("the table has viscosity");
        fire.set(viscosity, Input::Number(0.08)).expect("in range");
        fire.sent(viscosity.into());
        fire.sent(viscosity.into());
        fire.receive("viscosity", Input::Number(0.01));
        assert_eq!(fire.parameters().viscosity, 0.08);
        assert!(!fire.answered(viscosity.into()));
        assert!(fire.answered(viscosity.into()));
        fire.receive("viscosity", Input::Number(0.01));
        assert_eq!(fire.parameters().viscosity, 0.01);
    }

    #[test]
    fn a_refused_value_changes_nothing_and_has_a_reason() {
        let mut fire = classic();
        let viscosity = Param::find("viscosity").expect("the table has viscosity");
        let before = fire.parameters().clone();
        let refused = fire
            .set(viscosity, Input::Text("7"))
            .expect_err("7 is out of range");
        let text = refused.to_string();
        assert!(text.contains("viscosity") && text.contains('7') && text.contains("0.1"));
        assert_eq!(fire.parameters(), &before);
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
        assert_eq!(fire.history.len(), HISTORY_LENGTH);
        assert_eq!(fire.history.back(), Some(&999.0));
    }
}

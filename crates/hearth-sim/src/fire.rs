//! The simulation behind `web/sim.js`.

use hearth_bindings::{Record, light, memory, panic, values};
use hearth_core::params::{PARAMETERS, Parameters};
use hearth_core::preset::Preset;
use hearth_core::simulation::ParticleError;
use hearth_core::{Scene, Simulation, SprayError, Vec2};
use hearth_settings::untrusted::{Untrusted, ValidationError};
use hearth_settings::{Change, Settings};
use js_sys::Array;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

use crate::particles;

/// A simulation. Arrays of its particles are copies, in the order of birth.
#[wasm_bindgen]
pub struct Fire {
    settings: Settings,
    simulation: Simulation,
}

#[wasm_bindgen]
impl Fire {
    /// A fire of the preset with these values and objects. Without a `spacing` among them, the
    /// resolution of open air is the number of particles that would fill the domain.
    ///
    /// # Errors
    /// An unknown preset, or a value that is refused.
    #[wasm_bindgen(constructor)]
    pub fn new(preset: Option<String>, ids: Array, values: Array) -> Result<Fire, JsValue> {
        panic::record();
        let preset = preset
            .as_deref()
            .map_or_else(|| Ok(Settings::default()), Settings::of_preset);
        let changed = preset.and_then(|preset| preset.after(&Change::Set(&columns(&ids, &values))));
        let settings = changed.map_err(thrown)?;
        let scene = affordable(None, &settings)?;
        let simulation = Simulation::new(scene);
        Ok(Fire {
            settings,
            simulation,
        })
    }

    /// The place and the text of the last panic; empty before the first.
    pub fn panic() -> String {
        panic::last()
    }

    /// Makes this number of steps.
    pub fn step(&mut self, steps: u32) {
        for _ in 0..steps {
            self.simulation.step();
        }
    }

    /// Makes steps until this number of seconds has passed.
    pub fn advance(&mut self, seconds: f64) {
        self.simulation.advance(seconds);
    }

    /// Starts again with the same values.
    pub fn reset(&mut self) {
        self.simulation.reset();
    }

    /// Simulated time \[s\].
    #[wasm_bindgen(getter)]
    pub fn time(&self) -> f64 {
        self.simulation.time()
    }

    /// Particles alive.
    #[wasm_bindgen(getter)]
    pub fn count(&self) -> usize {
        self.simulation.count()
    }

    /// Power of the combustion [kW/m]; 0 in the classic model.
    #[wasm_bindgen(getter)]
    pub fn power(&self) -> f32 {
        self.simulation.power().unwrap_or_default()
    }

    /// Length of a step \[s\].
    #[wasm_bindgen(getter, js_name = stepLength)]
    pub fn step_length(&self) -> f64 {
        self.simulation.step_length()
    }

    /// Writes the value of a parameter to a field of `into`; without an id, of every parameter.
    /// An unknown id writes nothing.
    pub fn get(&self, into: &Record, id: Option<String>) {
        for param in PARAMETERS {
            if id.as_ref().is_none_or(|id| param.id == id) {
                into.set_value(param.id, self.simulation.scene().value(param));
            }
        }
    }

    /// Sets these values, all or none; null restores a default. Without `values` restores everything.
    ///
    /// # Errors
    /// Every value that is refused and every id that is unknown.
    pub fn set(&mut self, ids: Array, values: Option<Array>) -> Result<(), JsValue> {
        let values = values.map(|values| columns(&ids, &values));
        let change = match &values {
            Some(values) => Change::Set(values),
            None => Change::Preset(Preset::initial().name),
        };
        self.change(&change)
    }

    /// The objects as plain data.
    pub fn objects(&self) -> Array {
        values::object_records(self.simulation.scene())
    }

    /// Sets properties of the object of that id or, without an id, adds an object; without
    /// fields, removes the object. Returns the id of the last object.
    ///
    /// # Errors
    /// There is no object with this id, or every invalid field.
    #[wasm_bindgen(js_name = setObject)]
    pub fn set_object(
        &mut self,
        id: Option<u32>,
        names: Option<Array>,
        values: Option<Array>,
    ) -> Result<u32, JsValue> {
        let fields = names.zip(values);
        let fields = fields.map(|(names, values)| columns(&names, &values));
        let change = match (id, &fields) {
            (Some(id), Some(fields)) => Change::ChangeObject(id, fields),
            (Some(id), None) => Change::RemoveObject(id),
            (None, fields) => Change::AddObject(fields.as_deref().unwrap_or_default()),
        };
        self.change(&change)?;
        let last = self.simulation.scene().objects().last();
        Ok(last.map_or(0, |object| object.id))
    }

    /// Lights what is within a radius of a position \[m\] or, unless `lit`, puts it out; 0 is the
    /// usual radius. With a radius below 0, `place` is the id of a solid with fuel.
    ///
    /// # Errors
    /// There is no fuel.
    pub fn light(&mut self, lit: bool, radius: f64, place: f64, y: f64) -> Result<(), JsValue> {
        light(&mut self.simulation, lit, [radius, place, y]).map_err(|error| thrown(vec![error]))
    }

    /// Sprays a mass of water [g/m] from a position \[m\] with a velocity [m/s].
    ///
    /// # Errors
    /// The model is the classic one.
    pub fn spray(&mut self, x: f32, y: f32, u: f32, v: f32, grams: f32) -> Result<(), JsValue> {
        let (place, velocity) = (Vec2::new(x, y), Vec2::new(u, v));
        let done = self.simulation.spray(place, velocity, 1e-3 * grams);
        done.map_err(|_| {
            let model = Untrusted::Text("classic".into());
            let error = ValidationError::new("model", &model, SprayError::ALLOWED);
            thrown(vec![error])
        })
    }

    /// The ids of the particles.
    pub fn ids(&self) -> Vec<f64> {
        particles::ids(&self.simulation)
    }

    /// One property of all particles; see [`particles::property`].
    pub fn read(&self, name: &str) -> Option<Vec<f32>> {
        particles::property(&self.simulation, name)
    }

    /// The steps since the last call; the first call starts to record them.
    pub fn series(&mut self) -> Vec<f32> {
        self.simulation.record_series(true);
        self.simulation.series_numbers()
    }

    /// Replaces all particles with these, of [`particles::NUMBERS`] numbers each.
    ///
    /// # Errors
    /// As [`Simulation::set_particles`], or there is no memory for so many.
    #[wasm_bindgen(js_name = setParticles)]
    pub fn set_particles(&mut self, numbers: &[f32]) -> Result<(), JsValue> {
        let count = numbers.len() / particles::NUMBERS;
        let set = match self.simulation.check_count(count) {
            Ok(()) if memory::has_room(count) => {
                let particles = particles::particles(numbers);
                self.simulation.set_particles(&particles)
            }
            Ok(()) => Err(ParticleError {
                index: None,
                what: "there is no memory left for so many",
            }),
            refused => refused,
        };
        set.map_err(|refused| {
            let error = Record::new();
            error.set_text("message", &refused.to_string());
            if let Some(index) = refused.index {
                error.set_number("index", index as f64);
            }
            Array::of1(&error).into()
        })
    }
}

impl Fire {
    fn change(&mut self, change: &Change<'_>) -> Result<(), JsValue> {
        let settings = self.settings.after(change).map_err(thrown)?;
        let scene = affordable(Some(self.simulation.parameters()), &settings)?;
        self.simulation.set_scene(scene);
        self.settings = settings;
        Ok(())
    }
}

/// The scene of settings, with memory for its particles.
fn affordable(old: Option<&Parameters>, settings: &Settings) -> Result<Scene, JsValue> {
    let mut scene = settings.scene().clone();
    scene.set_world(settings.completed());
    memory::reserve(old, scene.world(), u32::MAX).map_err(|error| thrown(vec![error]))?;
    Ok(scene)
}

/// Values by their ids, from two arrays of the same length. An array among the values is a
/// list of objects, each as two such arrays.
fn columns(ids: &Array, values: &Array) -> Vec<(String, Untrusted)> {
    let mut pairs = Vec::new();
    for at in 0..ids.length() {
        let id = ids.get(at).as_string().unwrap_or_default();
        pairs.push((id, value_of(&values.get(at))));
    }
    pairs
}

fn value_of(value: &JsValue) -> Untrusted {
    if !Array::is_array(value) {
        return values::scalar(value);
    }
    let list: &Array = value.unchecked_ref();
    let mut objects = Vec::new();
    for at in 0..list.length() {
        let object: Array = list.get(at).unchecked_into();
        let (names, values) = (object.get(0), object.get(1));
        let fields = columns(names.unchecked_ref(), values.unchecked_ref());
        objects.push(Untrusted::Object(fields));
    }
    Untrusted::List(objects)
}

/// The errors from which `web/sim.js` makes a `RangeError`.
fn thrown(errors: Vec<ValidationError>) -> JsValue {
    values::records_of(&errors).into()
}

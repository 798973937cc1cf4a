//! One simulation, as `web/sim.js` holds it.

use hearth_bindings::{Record, Untrusted, ValidationError, settings};
use hearth_core::params::PARAMETERS;
use hearth_core::{Scene, Simulation};
use js_sys::Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::particles;

/// A simulation. Arrays of its particles are copies, in the order of birth.
#[wasm_bindgen]
pub struct Fire {
    simulation: Simulation,
}

#[wasm_bindgen]
impl Fire {
    /// A source about to be lit: the preset's values, and these on top.
    ///
    /// # Errors
    /// An unknown preset, or a value that is refused.
    #[wasm_bindgen(constructor)]
    pub fn new(preset: Option<String>, ids: Array, values: Array) -> Result<Fire, JsValue> {
        let scene = match preset {
            Some(name) => settings::preset(&name)
                .map_err(|error| thrown(vec![error]))?
                .scene(),
            None => Scene::default(),
        };
        let scene = settings::with_values(&scene, &columns(&ids, &values)).map_err(thrown)?;
        Ok(Fire {
            simulation: Simulation::new(scene),
        })
    }

    /// Makes so many steps.
    pub fn step(&mut self, steps: u32) {
        for _ in 0..steps {
            self.simulation.step();
        }
    }

    /// Starts again from nothing, with the same values.
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

    /// Power of the burning [kW/m].
    #[wasm_bindgen(getter)]
    pub fn power(&self) -> f32 {
        self.simulation.power()
    }

    /// Length of a step \[s\].
    #[wasm_bindgen(getter, js_name = stepLength)]
    pub fn step_length(&self) -> f64 {
        self.simulation.step_length()
    }

    /// Puts the value of the parameter of that id into an object; without an id, all. An
    /// unknown id puts nothing.
    pub fn get(&self, into: &Record, id: Option<String>) {
        let parameters = self.simulation.parameters();
        for param in PARAMETERS {
            if id.as_ref().is_none_or(|id| param.id == id) {
                into.set_value(param.id, param.get(parameters));
            }
        }
    }

    /// Sets these, all or none. Without values, puts them back to their defaults, or all
    /// where there are no ids.
    ///
    /// # Errors
    /// Every value that is refused and every id that is unknown.
    pub fn set(&mut self, ids: Array, values: Option<Array>) -> Result<(), JsValue> {
        let old = self.simulation.scene();
        let changed = match values {
            Some(values) => settings::with_values(old, &columns(&ids, &values)),
            None if ids.length() == 0 => Ok(Scene::default()),
            None => settings::with_defaults(old, &columns(&ids, &Array::new())),
        };
        self.simulation.set_scene(changed.map_err(thrown)?);
        Ok(())
    }

    /// The numbers by which particles are known from step to step.
    pub fn ids(&self) -> Vec<f64> {
        particles::ids(&self.simulation)
    }

    /// One property of all particles; see [`particles::property`].
    pub fn read(&self, name: &str) -> Vec<f32> {
        particles::property(&self.simulation, name)
    }

    /// Puts these particles, [`particles::NUMBERS`] each, in the place of all.
    ///
    /// # Errors
    /// As [`Simulation::set_particles`].
    #[wasm_bindgen(js_name = setParticles)]
    pub fn set_particles(&mut self, numbers: &[f32]) -> Result<(), JsValue> {
        let particles = particles::particles(numbers);
        let set = self.simulation.set_particles(&particles);
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

/// Values by their ids, from two arrays. A value that is not there is missing.
fn columns(ids: &Array, values: &Array) -> Vec<(String, Untrusted)> {
    let mut pairs = Vec::new();
    for at in 0..ids.length() {
        let id = ids.get(at).as_string().unwrap_or_default();
        pairs.push((id, Untrusted::scalar(&values.get(at))));
    }
    pairs
}

/// Errors as `web/sim.js` takes them, which makes a `RangeError` of them.
// Its callers would each free the errors.
#[inline(never)]
fn thrown(errors: Vec<ValidationError>) -> JsValue {
    ValidationError::to_array(&errors).into()
}

//! One simulation, as `web/sim.js` holds it.

use hearth_core::params::{PARAMETERS, ParamError, Value};
use hearth_core::{Parameters, Simulation};
use js_sys::{Array, Object, RangeError};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::particles;
use crate::refusal::{self, Sent};
use crate::start;

/// The id of the model, which decides what other ids mean.
const MODEL: &str = "model";

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
        let parameters = start::of_preset(preset.as_deref())
            .map_err(|message| refusal::of_field("preset", preset.as_deref().into(), &message))?;
        let parameters = with_values(&parameters, &ids, &values)?;
        Ok(Fire {
            simulation: Simulation::new(parameters),
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

    /// The value of one parameter.
    ///
    /// # Errors
    /// An unknown id.
    pub fn get(&self, id: String) -> Result<JsValue, JsValue> {
        let parameters = self.simulation.parameters();
        if let Some(value) = parameters.get(&id) {
            return Ok(plain(value));
        }
        // What is unknown cannot be restored either, and that says it in words.
        with_defaults(parameters, &Array::of1(&id.into())).map(|_| JsValue::UNDEFINED)
    }

    /// All values, by id.
    #[wasm_bindgen(getter)]
    pub fn params(&self) -> Object {
        let object = Object::new();
        for param in PARAMETERS {
            let value = param.get(self.simulation.parameters());
            refusal::put(&object, param.id, &plain(value));
        }
        object
    }

    /// Sets these, all or none.
    ///
    /// # Errors
    /// Every value that is refused.
    pub fn set(&mut self, ids: Array, values: Array) -> Result<(), JsValue> {
        let parameters = with_values(self.simulation.parameters(), &ids, &values)?;
        self.simulation.set_parameters(parameters);
        Ok(())
    }

    /// Puts these back to their defaults, all or none; without ids, all values.
    ///
    /// # Errors
    /// Every id that is unknown.
    pub fn restore(&mut self, ids: Array) -> Result<(), JsValue> {
        let parameters = if ids.length() == 0 {
            Parameters::default()
        } else {
            with_defaults(self.simulation.parameters(), &ids)?
        };
        self.simulation.set_parameters(parameters);
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

    /// All numbers of each ember; see [`particles::embers`].
    pub fn embers(&self) -> Vec<f32> {
        particles::embers(self.simulation.embers())
    }

    /// Refuses what is far too many particles, before they are copied.
    ///
    /// # Errors
    /// More than [`particles::MOST`].
    #[wasm_bindgen(js_name = checkCount)]
    pub fn check_count(&self, count: f64) -> Result<(), JsValue> {
        if count > particles::MOST as f64 {
            return Err(RangeError::new(particles::TOO_MANY).into());
        }
        Ok(())
    }

    /// Puts these particles, [`particles::NUMBERS`] each, in the place of all.
    ///
    /// # Errors
    /// As [`Simulation::set_particles`].
    #[wasm_bindgen(js_name = setParticles)]
    pub fn set_particles(&mut self, numbers: &[f32]) -> Result<(), JsValue> {
        let particles = particles::particles(numbers);
        let set = self.simulation.set_particles(&particles);
        set.map_err(|error| refusal::of_particles(&error))
    }
}

fn with_values(
    parameters: &Parameters,
    ids: &Array,
    values: &Array,
) -> Result<Parameters, JsValue> {
    let mut new = parameters.clone();
    let ids = texts(ids);
    let sent: Vec<Sent> = values.iter().map(|value| Sent::of(&value)).collect();
    let inputs = ids.iter().zip(&sent);
    new.set_all(inputs.map(|(id, sent)| (id.as_str(), sent.input())))
        .map(|()| new)
        .map_err(|errors| {
            refusal::of_values(&errors, &|id| {
                // The error shortens the name of an unknown id.
                let at = ids.iter().position(|sent| sent == id);
                at.map_or(JsValue::UNDEFINED, |at| values.get(at as u32))
            })
        })
}

fn texts(ids: &Array) -> Vec<String> {
    ids.iter().filter_map(|id| id.as_string()).collect()
}

/// The model comes first, wherever it stands: it decides about the other defaults.
fn with_defaults(parameters: &Parameters, ids: &Array) -> Result<Parameters, JsValue> {
    let ids = texts(ids);
    let mut new = parameters.clone();
    let mut refused: Vec<ParamError> = Vec::new();
    for models in [true, false] {
        for id in ids.iter().filter(|&id| (id == MODEL) == models) {
            refused.extend(new.restore(id).err());
        }
    }
    if refused.is_empty() {
        Ok(new)
    } else {
        Err(refusal::of_values(&refused, &|_| JsValue::UNDEFINED))
    }
}

/// A value as JavaScript has it.
fn plain(value: Value) -> JsValue {
    match value {
        Value::Flag(on) => on.into(),
        _ => match value.as_number() {
            Some(number) => number.into(),
            None => value.to_string().into(),
        },
    }
}

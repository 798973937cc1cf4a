//! A checked set of values.

use std::ops::Deref;

use super::check::nearest_id;
use super::choices::Model;
use super::entry::Condition;
use super::table::{PARAMETERS, Param, Values};
use super::value::{Input, ParamError, ParamErrorKind, Value};

/// The id of the parameter that says which of them the others are for.
const MODEL: &str = "model";

/// Whether one of these names is chosen.
fn is_chosen(parameters: &Parameters, &(id, names): &Condition) -> bool {
    match parameters.get(id) {
        Some(Value::Choice(name)) => names.contains(&name),
        _ => true,
    }
}

/// A checked set of values: whatever it holds is in range for its model.
///
/// Its values are read as fields (`parameters.viscosity`) and written through
/// [`set`](Parameters::set) alone. Each model keeps its own: a parameter that
/// both use with the same domain has one value, every other one a value for each
/// model. So a change of the model and back loses nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// The present model's values.
    current: Values,
    /// Those of the model that it is not.
    other: Values,
}

impl Default for Parameters {
    fn default() -> Self {
        Parameters::new(Model::default())
    }
}

impl Deref for Parameters {
    type Target = Values;
    fn deref(&self) -> &Values {
        &self.current
    }
}

impl Parameters {
    /// The defaults of both models, of which `model` is the present one.
    pub fn new(model: Model) -> Parameters {
        let other = match model {
            Model::Classic => Model::Combustion,
            Model::Combustion => Model::Classic,
        };
        Parameters {
            current: Values::of_model(model),
            other: Values::of_model(other).belonging_to(model),
        }
    }

    /// The model that these values are for.
    pub fn model(&self) -> Model {
        self.model
    }

    /// Sets the parameter `id`, or says why not and changes nothing. A parameter
    /// that the model does not use is set where it belongs, and waits there.
    ///
    /// # Errors
    /// An unknown id, a value of the wrong kind or one outside the range.
    pub fn set(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let param = Param::find(id).ok_or_else(|| unknown(id, input))?;
        let value = param.check(self.model, input)?;
        self.write(param, value);
        Ok(())
    }

    /// Sets several parameters, all of them or none. The model comes first,
    /// wherever it stands, because it decides what the others may be.
    ///
    /// # Errors
    /// Every value that is refused, in the order in which they were tried.
    pub fn set_all<'a>(
        &mut self,
        values: impl IntoIterator<Item = (&'a str, Input<'a>), IntoIter: Clone>,
    ) -> Result<(), Vec<ParamError>> {
        let values = values.into_iter();
        let mut new = self.clone();
        let mut refused = Vec::new();
        // Sorted, they would need a sort's code, which is more than all of this.
        for models in [true, false] {
            for (id, input) in values.clone() {
                if (id == MODEL) == models
                    && let Err(error) = new.set(id, input)
                {
                    refused.push(error);
                }
            }
        }
        if refused.is_empty() {
            *self = new;
            Ok(())
        } else {
            Err(refused)
        }
    }

    /// The value of the parameter `id`, or `None` where there is none of that
    /// id. One that the model does not use has the value that it would have in
    /// the model it belongs to.
    pub fn get(&self, id: &str) -> Option<Value> {
        Param::find(id).map(|param| param.get(self))
    }

    /// Puts the parameter `id` back to its default.
    ///
    /// # Errors
    /// An unknown id.
    pub fn restore(&mut self, id: &str) -> Result<(), ParamError> {
        let param = Param::find(id).ok_or_else(|| unknown(id, Input::Text("")))?;
        self.write(param, param.any_domain(self.model).default);
        Ok(())
    }

    /// The parameters that the model uses and whose value is not its default,
    /// with that value.
    pub fn changed(&self) -> impl Iterator<Item = (&'static Param, Value)> + '_ {
        PARAMETERS.iter().filter_map(move |param| {
            let default = param.domain(self.model)?.default;
            let value = param.get(self);
            (value != default).then_some((param, value))
        })
    }

    /// Writes a checked value to the present model, to the one it belongs to,
    /// or to both.
    #[inline(never)]
    fn write(&mut self, param: &Param, value: Value) {
        let domain = param.domain(self.model);
        let shared = domain.is_some_and(|domain| domain.model.is_none());
        let before = self.model;
        if domain.is_some() {
            self.current.slot(param.field).put(value);
        }
        if shared || domain.is_none() {
            self.other.slot(param.field).put(value);
        }
        if self.model != before {
            std::mem::swap(&mut self.current, &mut self.other);
        }
    }

    /// Takes on the value that `source` has for `id`, in both models.
    pub(crate) fn copy_both_models(&mut self, id: &str, source: &Parameters) {
        let Some(param) = Param::find(id) else { return };
        let (present, absent) = match source.model == self.model {
            true => (&source.current, &source.other),
            false => (&source.other, &source.current),
        };
        self.current.slot(param.field).put(present.get(param.field));
        self.other.slot(param.field).put(absent.get(param.field));
    }

    /// Distance of neighbouring particles where the gas is as dense as the air
    /// \[m\].
    pub fn spacing(&self) -> f32 {
        match self.model {
            Model::Classic => libm::sqrtf(self.particle_mass / self.rest_density),
            Model::Combustion => {
                libm::sqrtf(self.domain_width * self.domain_height / self.max_particles as f32)
            }
        }
    }

    /// Smoothing length h: particles feel each other up to twice this distance
    /// \[m\].
    pub fn smoothing_length(&self) -> f32 {
        match self.model {
            Model::Classic => self.smoothing_radius,
            Model::Combustion => self.smoothing_ratio * self.spacing(),
        }
    }
}

/// What is said when somebody wants a value for an id that there is not.
#[cold]
#[inline(never)]
fn unknown(id: &str, input: Input<'_>) -> ParamError {
    ParamError {
        id: Input::Text(id).to_string().trim_matches('"').to_owned(),
        value: input.to_string(),
        kind: ParamErrorKind::UnknownId {
            nearest: nearest_id(id),
        },
    }
}

impl Param {
    /// The value in `parameters`: the present model's or, where that does not
    /// use it, the value that it has in the model it belongs to.
    pub fn get(&self, parameters: &Parameters) -> Value {
        match self.domain(parameters.model) {
            Some(_) => parameters.current.get(self.field),
            None => parameters.other.get(self.field),
        }
    }

    /// The choices that would have to be other ones for its value to count, with the
    /// names that would do.
    pub fn unmet_conditions(
        &self,
        parameters: &Parameters,
    ) -> impl Iterator<Item = &'static Condition> {
        let when = self.description().when.iter();
        when.filter(|chosen| !is_chosen(parameters, chosen))
    }

    /// The choices that together leave its value without an effect; empty: it has one,
    /// if it does not wait for others.
    pub fn met_exclusions(&self, parameters: &Parameters) -> &'static [Condition] {
        let unless = self.description().unless;
        if unless.iter().all(|chosen| is_chosen(parameters, chosen)) {
            unless
        } else {
            &[]
        }
    }
}

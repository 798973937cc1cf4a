//! A checked set of values.

use std::ops::Deref;

use super::check::nearest;
use super::choices::Model;
use super::entry::Condition;
use super::table::{PARAMETERS, Param, Values};
use super::value::{AnyValue, Input, ParamError, ParamErrorKind, Value, abbreviated};

/// The id of the model, which decides the domains of the other parameters.
const MODEL: &str = "model";

/// Whether a condition is met.
fn is_met(parameters: &Parameters, &(id, names): &Condition) -> bool {
    match parameters.get(id) {
        Some(Value::Choice(name)) => names.contains(&name),
        _ => true,
    }
}

/// A checked set of values: all are in range for their model.
///
/// Fields read the values (`parameters.viscosity`), and only [`set`](Parameters::set) writes
/// them. A parameter with the same domain in both models has one value, every other parameter a
/// value per model. So a change of the model and back loses nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// The values of the present model.
    current: Values,
    /// The values of the other model.
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
    /// The defaults, with `model` as the present model.
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

    /// The present model.
    pub fn model(&self) -> Model {
        self.model
    }

    /// Sets the parameter `id`, or returns an error and changes nothing. A parameter that the
    /// present model does not use is set in the other model.
    ///
    /// ```
    /// # use hearth_core as hearth_fire;
    /// let mut parameters = hearth_fire::Parameters::default();
    /// parameters.set("fuel_power", 200.0)?;
    /// parameters.set("palette", "copper")?;
    /// # Ok::<(), hearth_fire::params::ParamError>(())
    /// ```
    ///
    /// # Errors
    /// An unknown id, a value of the wrong kind or one outside the range.
    pub fn set<'a>(&mut self, id: &str, value: impl Into<Input<'a>>) -> Result<(), ParamError> {
        self.set_input(id, value.into())
    }

    fn set_input(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let param = Param::find(id).ok_or_else(|| unknown(id, input))?;
        let value = param.check(self.model, input)?;
        self.write(param, value);
        Ok(())
    }

    /// Sets several parameters, all of them or none. The model is set first, because it decides
    /// the domains of the others.
    ///
    /// # Errors
    /// The error of every invalid value, in order.
    pub fn set_all<'a>(
        &mut self,
        values: impl IntoIterator<Item = (&'a str, Input<'a>), IntoIter: Clone>,
    ) -> Result<(), Vec<ParamError>> {
        let values = values.into_iter();
        let mut new = self.clone();
        let mut errors = Vec::new();
        // The model first: it decides which values the others belong to.
        for models in [true, false] {
            for (id, input) in values.clone() {
                if (id == MODEL) == models
                    && let Err(error) = new.set(id, input)
                {
                    errors.push(error);
                }
            }
        }
        if errors.is_empty() {
            *self = new;
            Ok(())
        } else {
            Err(errors)
        }
    }

    /// The value of the parameter `id`, in the other model if the present one does not use it;
    /// `None` for an unknown id.
    pub fn get(&self, id: &str) -> Option<Value> {
        Param::find(id).map(|param| param.get(self))
    }

    /// Restores the default of the parameter `id`.
    ///
    /// # Errors
    /// An unknown id.
    pub fn restore(&mut self, id: &str) -> Result<(), ParamError> {
        self.set(id, Input::Default)
    }

    /// The parameters of the present model whose value is not the default, with that value.
    pub fn changed(&self) -> impl Iterator<Item = (&'static Param, Value)> + '_ {
        PARAMETERS.iter().filter_map(move |param| {
            let default = param.domain(self.model)?.default;
            let value = param.get(self);
            (value != default).then_some((param, value))
        })
    }

    /// Writes a checked value to the present model, to the other one, or to both.
    fn write(&mut self, param: &Param, value: AnyValue<'_>) {
        let domain = param.domain(self.model);
        let shared = domain.is_some_and(|domain| domain.model.is_none());
        let before = self.model;
        if domain.is_some() {
            self.current.put(param, value);
        }
        if shared || domain.is_none() {
            self.other.put(param, value);
        }
        if self.model != before {
            std::mem::swap(&mut self.current, &mut self.other);
        }
    }

    /// Copies the values of `id` in both models from `source`.
    pub(crate) fn copy_both_models(&mut self, id: &str, source: &Parameters) {
        let Some(param) = Param::find(id) else { return };
        let (present, absent) = match source.model == self.model {
            true => (&source.current, &source.other),
            false => (&source.other, &source.current),
        };
        self.current.put(param, present.get(param));
        self.other.put(param, absent.get(param));
    }
}

/// The error of an unknown id.
#[cold]
fn unknown(id: &str, input: Input<'_>) -> ParamError {
    let (start, dots) = abbreviated(id);
    ParamError {
        id: format!("{start}{dots}"),
        value: format!("{input}"),
        kind: ParamErrorKind::UnknownId {
            nearest: nearest(id, &mut PARAMETERS.iter().map(|param| param.id)),
        },
    }
}

impl Param {
    /// The value in the present model of `parameters` or, if that does not use it, in the other
    /// model.
    pub fn get(&self, parameters: &Parameters) -> Value {
        match self.domain(parameters.model) {
            Some(_) => parameters.current.get(self),
            None => parameters.other.get(self),
        }
    }

    /// The unmet conditions of [`Description::when`](super::Description::when).
    pub fn unmet_conditions(
        &self,
        parameters: &Parameters,
    ) -> impl Iterator<Item = &'static Condition> {
        let when = self.description().when.iter();
        when.filter(|chosen| !is_met(parameters, chosen))
    }

    /// The conditions of [`Description::unless`](super::Description::unless) if all are met,
    /// else none.
    pub fn met_exclusions(&self, parameters: &Parameters) -> &'static [Condition] {
        let unless = self.description().unless;
        if unless.iter().all(|chosen| is_met(parameters, chosen)) {
            unless
        } else {
            &[]
        }
    }
}

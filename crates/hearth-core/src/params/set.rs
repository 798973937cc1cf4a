//! A checked set of values.

use std::ops::Deref;

use super::check::nearest;
use super::choices::{Choice, Model};
use super::entry::Condition;
use super::slot::{Slot, Slots};
use super::table::{Field, PARAMETERS, Param, Source, Values};
use super::value::{AnyValue, Input, ParamError, ParamErrorKind, Value, quoted};

/// The id of the model, which decides the domains of the other parameters.
const MODEL: &str = "model";

/// Whether a condition is met.
fn is_met(get: &impl Fn(&str) -> Option<Value>, &(id, names): &Condition) -> bool {
    match get(id) {
        Some(Value::Choice(name)) => names.contains(&name),
        _ => true,
    }
}

/// A struct whose fields are entries of [`PARAMETERS`].
trait Entries: Slots<Field> {
    /// The value of an entry; `None` if it is no field of this struct.
    #[inline(never)]
    fn value(&self, param: &Param) -> Option<Value> {
        let field = param.field?;
        self.clone().slot(field).map(Slot::value)
    }

    /// Writes a checked value, and returns whether it is a field of this struct.
    #[inline(never)]
    fn put(&mut self, param: &Param, value: AnyValue<'_>) -> bool {
        let slot = param.field.and_then(|field| self.slot(field));
        slot.map(|slot| slot.put(value)).is_some()
    }

    /// The values that both models have with the same domain, and the other defaults of `model`.
    #[inline(never)]
    fn in_model(&self, model: Model) -> Self {
        let mut values = Self::of_model(model);
        let is_shared = |param: &&Param| param.domains[0].model.is_none();
        for param in PARAMETERS.iter().filter(is_shared) {
            if let Some(value) = self.value(param) {
                values.put(param, value);
            }
        }
        values
    }
}

impl Entries for Values {}
impl Entries for Source {}

/// The values of a world: all parameters but those of sources, each in range for the model.
///
/// Fields read the values (`parameters.viscosity`), and only [`set`](Parameters::set) writes them. Another model
/// keeps the values of parameters that have the same domain in both models. The others get that model's defaults.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    values: Values,
}

impl Default for Parameters {
    fn default() -> Self {
        Parameters::new(Model::default())
    }
}

impl Deref for Parameters {
    type Target = Values;
    fn deref(&self) -> &Values {
        &self.values
    }
}

impl Parameters {
    /// The defaults of `model`.
    pub fn new(model: Model) -> Parameters {
        Parameters {
            values: Values::of_model(model),
        }
    }

    /// The model.
    pub fn model(&self) -> Model {
        self.model
    }

    /// Sets the parameter `id`, or returns an error and changes nothing.
    ///
    /// ```
    /// # use hearth_core as hearth_fire;
    /// let mut parameters = hearth_fire::Parameters::default();
    /// parameters.set("wind", 0.5)?;
    /// parameters.set("palette", "copper")?;
    /// # Ok::<(), hearth_fire::params::ParamError>(())
    /// ```
    ///
    /// # Errors
    /// An unknown id, a parameter of another model or of sources, a value of the wrong kind or one outside the range.
    pub fn set<'a>(&mut self, id: &str, input: impl Into<Input<'a>>) -> Result<(), ParamError> {
        let input = input.into();
        let param = Param::of_model(id, self.model, input)?;
        let value = param.check(self.model, input)?;
        if let (MODEL, AnyValue::Choice(name)) = (id, value) {
            if let Some(model) = Model::from_name(name).filter(|model| *model != self.model) {
                self.values = self.values.in_model(model);
                self.values.put(param, value);
            }
            return Ok(());
        }
        match self.values.put(param, value) {
            true => Ok(()),
            false => Err(param.error(input, ParamErrorKind::OfSource)),
        }
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
        let mut new = self.clone();
        model_first(values, &mut |id, input| new.set(id, input))?;
        *self = new;
        Ok(())
    }

    /// The value of the parameter `id`; `None` for an unknown id and a parameter of sources.
    pub fn get(&self, id: &str) -> Option<Value> {
        self.values.value(Param::find(id)?)
    }

    /// Restores the default of the parameter `id`.
    ///
    /// # Errors
    /// Those of [`set`](Parameters::set).
    pub fn restore(&mut self, id: &str) -> Result<(), ParamError> {
        self.set(id, Input::Default)
    }
}

/// Sets values with the model first, because it decides the domains of the others.
///
/// # Errors
/// The error of every value that is refused, in order.
pub(crate) fn model_first<'a>(
    values: impl IntoIterator<Item = (&'a str, Input<'a>), IntoIter: Clone>,
    set: &mut dyn FnMut(&'a str, Input<'a>) -> Result<(), ParamError>,
) -> Result<(), Vec<ParamError>> {
    let values = values.into_iter();
    let mut errors = Vec::new();
    for models in [true, false] {
        for (id, input) in values.clone() {
            if (id == MODEL) == models {
                errors.extend(set(id, input).err());
            }
        }
    }
    if errors.is_empty() {
        Ok(())
    } else {
        Err(errors)
    }
}

/// The error of an unknown id.
#[cold]
fn unknown(id: &str, input: Input<'_>) -> ParamError {
    ParamError {
        id: quoted(id),
        value: format!("{input}"),
        kind: ParamErrorKind::UnknownId {
            nearest: nearest(id, &mut PARAMETERS.iter().map(|param| param.id)),
        },
    }
}

impl Source {
    /// The values of a source in another model: see [`Parameters`].
    pub(crate) fn in_model(&self, model: Model) -> Source {
        Entries::in_model(self, model)
    }

    /// The defaults of a model.
    pub fn new(model: Model) -> Source {
        Slots::of_model(model)
    }

    /// The value of an entry; `None` if it is no property of a source.
    pub fn get(&self, param: &Param) -> Option<Value> {
        self.value(param)
    }

    /// Sets the property that is an entry of [`PARAMETERS`].
    pub(crate) fn set(
        &mut self,
        param: &Param,
        model: Model,
        input: Input<'_>,
    ) -> Result<(), ParamError> {
        let value = param.check(model, input)?;
        self.put(param, value);
        Ok(())
    }
}

impl Param {
    /// The parameter with this id, if `model` uses it.
    ///
    /// # Errors
    /// An unknown id, or a parameter that only the other model uses.
    pub(crate) fn of_model(
        id: &str,
        model: Model,
        input: Input<'_>,
    ) -> Result<&'static Param, ParamError> {
        let param = Param::find(id).ok_or_else(|| unknown(id, input))?;
        match param.only_in(model) {
            Some(other) => Err(param.error(input, ParamErrorKind::OfModel(other))),
            None => Ok(param),
        }
    }

    /// The only model that uses it, if that is another one than `model`.
    pub fn only_in(&self, model: Model) -> Option<Model> {
        match self.domain(model) {
            Some(_) => None,
            None => self.domains[0].model,
        }
    }

    /// Whether it is a property of objects.
    pub fn is_of_objects(&self) -> bool {
        !self.property.is_empty()
    }

    /// The unmet conditions of [`Description::when`](super::Description::when), where `get` returns a value by its id.
    pub fn unmet_conditions(
        &self,
        get: impl Fn(&str) -> Option<Value>,
    ) -> impl Iterator<Item = &'static Condition> {
        let when = self.description().when.iter();
        when.filter(move |chosen| !is_met(&get, chosen))
    }

    /// The conditions of [`Description::unless`](super::Description::unless) if all are met,
    /// else none.
    pub fn met_exclusions(&self, get: impl Fn(&str) -> Option<Value>) -> &'static [Condition] {
        let unless = self.description().unless;
        if unless.iter().all(|chosen| is_met(&get, chosen)) {
            unless
        } else {
            &[]
        }
    }
}

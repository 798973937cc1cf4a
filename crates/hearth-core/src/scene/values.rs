//! The values of a scene by the ids of parameters. A property of sources is that of the first one.

use super::kinds::Values;
use super::{Scene, Stored};
use crate::params::{Input, Model, Param, ParamError, ParamErrorKind, Source, Value, model_first};

impl Scene {
    /// The value of a parameter: of the world or of the first source. Without a source, and in another model, it is
    /// the default.
    pub fn value(&self, param: &Param) -> Value {
        let of_source = || self.read_first_source(|source| source.get(param));
        let value = self.world.get(param.id).or_else(of_source);
        value.unwrap_or(param.any_domain(self.model()).default)
    }

    /// The value of the parameter with this id.
    pub fn get(&self, id: &str) -> Option<Value> {
        Param::find(id).map(|param| self.value(param))
    }

    /// Sets a parameter of the world or of the first source, or returns an error and changes nothing. Another model
    /// keeps what both models have, and the rest gets that model's defaults.
    ///
    /// # Errors
    /// An unknown id, a parameter of another model, one of sources in a scene without any, a value of the wrong kind
    /// or one outside the range.
    pub fn set<'a>(&mut self, id: &str, input: impl Into<Input<'a>>) -> Result<(), ParamError> {
        self.put(id, input.into())
    }

    fn put(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let model = self.model();
        let param = Param::of_model(id, model, input)?;
        if param.is_of_objects() {
            let mut objects = self.objects.iter_mut();
            let first = objects.find_map(Stored::source_mut);
            return match first {
                Some(source) => source.set(param, model, input),
                None => {
                    param.check(model, input)?;
                    Err(param.error(input, ParamErrorKind::OfSource))
                }
            };
        }
        self.world.set(id, input)?;
        self.set_model_of_sources(model);
        Ok(())
    }

    /// Converts the sources, which are those of the model `before`.
    pub(super) fn set_model_of_sources(&mut self, before: Model) {
        let model = self.model();
        if model != before {
            for source in self.objects.iter_mut().filter_map(Stored::source_mut) {
                *source = source.in_model(model);
            }
        }
    }

    /// Sets several parameters, all of them or none. The model is set first, because it decides the domains of the
    /// others.
    ///
    /// # Errors
    /// The error of every invalid value, in order.
    pub fn set_all<'a>(
        &mut self,
        values: impl IntoIterator<Item = (&'a str, Input<'a>), IntoIter: Clone>,
    ) -> Result<(), Vec<ParamError>> {
        let mut new = self.clone();
        model_first(values, &mut |id, input| new.put(id, input))?;
        *self = new;
        Ok(())
    }
}

impl Stored {
    /// The values of a source.
    fn source_mut(&mut self) -> Option<&mut Source> {
        match &mut self.values {
            Values::Source(source) => Some(source),
            Values::Solid(_) => None,
        }
    }
}

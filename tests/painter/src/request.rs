//! The fields of a request.

use serde_json::Value;

use crate::Failure;

/// A request, or a part of it.
#[derive(Debug)]
pub struct Request(pub Value);

impl Request {
    /// A text; empty without the field.
    pub fn text(&self, field: &str) -> &str {
        self.0[field].as_str().unwrap_or_default()
    }

    /// A number; zero without the field.
    pub fn number(&self, field: &str) -> f64 {
        self.0[field].as_f64().unwrap_or_default()
    }

    /// A number that is one.
    pub fn required(&self, field: &str) -> Result<f64, Failure> {
        let number = self.0[field].as_f64();
        number.ok_or_else(|| format!("the request has no number `{field}`: {}", self.0).into())
    }

    /// Width and height [pixels].
    pub fn size(&self) -> Result<[u32; 2], Failure> {
        Ok([
            self.required("width")? as u32,
            self.required("height")? as u32,
        ])
    }

    /// The requests in a list.
    pub fn list(&self, field: &str) -> Vec<Request> {
        let list = self.0[field].as_array().into_iter().flatten();
        list.cloned().map(Request).collect()
    }

    /// Parameters and their values, as a person would write them.
    pub fn values(&self) -> Vec<(String, String)> {
        let values = self.0["values"].as_object().into_iter().flatten();
        let text = |value: &Value| {
            value
                .as_str()
                .map_or_else(|| value.to_string(), str::to_owned)
        };
        values
            .map(|(id, value)| (id.clone(), text(value)))
            .collect()
    }
}

//! How the world of a fire is seen, as a message says it.

use hearth_render::{Camera, Fit};

use crate::fields::Fields;
use crate::message::Refused;
use crate::raw::Raw;

/// Reads how the domain fits the picture, and where it stands in it.
///
/// # Errors
/// The first field that is not as it must be.
pub fn parse(raw: &Raw) -> Result<Camera, Refused> {
    let mut fields = Fields::of(raw);
    let name = match raw.field("fit") {
        Raw::Text(name) => name.as_str(),
        _ => "",
    };
    let fit = Fit::ALL.iter().find(|(known, _)| *known == name);
    if fit.is_none() {
        fields.refuse("fit", "one of height, contain, cover, width");
    }
    let align = ["x", "y"].map(|id| fields.between(id, 0.0, 1.0, "a number from 0 to 1") as f32);
    let fit = fit.map_or(Fit::default(), |(_, fit)| *fit);
    fields.refused().map_or(Ok(Camera { fit, align }), Err)
}

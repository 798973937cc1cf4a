//! What is open in the panel besides the groups.

use egui::ecolor::Hsva;

use crate::state::subject::Subject;

/// The open parts of the panel.
#[derive(Clone, Debug, Default)]
pub struct Open {
    /// The field for exact input.
    pub field: Option<Field>,
    /// The colour whose sliders are open.
    pub colour: Option<OpenColour>,
    /// The choice whose list is unfolded.
    pub choice: Option<&'static str>,
    /// The parameter whose description stands in its row.
    pub description: Option<&'static str>,
    /// Whether the tools are unfolded, where the panel is low.
    pub tools: bool,
    /// Whether copy and paste are unfolded.
    pub sharing: bool,
    /// Whether they are unfolded only while the page's own controls of them have the focus.
    pub shares_for_focus: bool,
}

impl Open {
    /// The field of a row, if it is open.
    pub fn field_of(&self, subject: Subject) -> Option<&Field> {
        self.field.as_ref().filter(|field| field.subject == subject)
    }
}

/// A field for exact input.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Its value.
    pub subject: Subject,
    /// The present text.
    pub text: String,
    /// The text at first.
    pub before: String,
    /// Whether it has not been shown yet: its first frame takes the focus.
    pub fresh: bool,
}

/// A colour whose sliders are open. Hue and saturation are kept here because black and
/// grey have none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenColour {
    /// The id of its parameter.
    pub id: &'static str,
    /// The position of the sliders.
    pub hsva: Hsva,
}

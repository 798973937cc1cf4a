//! The state of the panel. No view is imported here.
//!
//! Views read [`State`] and return [`Action`]s; [`crate::Panel`] applies the actions
//! after the frame, so all views of a frame show the same state.

mod action;
mod command;
mod conditions;
mod controller;
mod entry;
pub mod fire;
mod fire_objects;
mod memory;
pub mod objects;
mod open;
mod pointer;
mod stats;
mod subject;

use hearth_core::params::{Model, Param};
use hearth_core::scene::Object;

pub use self::action::Action;
pub use self::command::Command;
pub use self::controller::{ControllerState, CopyForm};
pub use self::fire::{Fire, MODEL};
pub use self::memory::Memory;
pub use self::objects::{Fields, OBJECTS, is_on, name_of};
pub use self::open::{Field, Open, OpenColour};
pub use self::pointer::{Gesture, Pointer};
pub use self::subject::{Owner, Subject};
use crate::search;
use crate::theme::Measures;

/// The group of the model.
pub const PHYSICS: &str = "Physics";

/// The name of copy and paste, for [`State::reveal`].
pub const SHARE: &str = "share";

/// The name of the tools, for [`State::reveal`].
pub const TOOLS: &str = "tools";

/// The name of the search field, for [`State::reveal`].
pub const SEARCH: &str = "search";

/// The name of the quality, for [`State::reveal`].
pub const QUALITY: &str = "quality";

/// The group of the simplest controls, which includes the quality.
pub const BASICS: &str = "Basics";

/// The input device that the panel is laid out for.
#[derive(Clone, Copy, Debug)]
pub struct Device {
    /// Whether the last press came from a finger.
    pub finger: bool,
    /// Sizes for a finger or a mouse.
    pub measures: Measures,
}

/// The search.
#[derive(Clone, Debug, Default)]
pub struct Search {
    /// The query.
    pub text: String,
    /// Whether the field takes the focus in the next frame.
    pub focus: bool,
}

/// What the next frame scrolls to.
#[derive(Clone, Debug, Default)]
pub struct Reveal {
    /// The marked parameter, which the page's own controls point at.
    pub marked: Option<&'static str>,
    /// Whether the marked row scrolls into view.
    pub row: bool,
    /// Whether the tools scroll into view.
    pub tools: bool,
    /// Whether the quality scrolls into view.
    pub quality: bool,
    /// Whether the objects scroll into view.
    pub objects: bool,
    /// Whether the rows scroll to their start.
    pub start: bool,
}

/// Where the rows of the last frame stood, so that a change above a row does not move it.
#[derive(Clone, Debug, Default)]
pub struct Anchor {
    /// The model of those rows.
    pub model: Model,
    /// The top of each visible row, the uppermost first.
    pub tops: Vec<(&'static str, f32)>,
    /// The choice that has just changed.
    pub chosen: Option<&'static str>,
}

/// The panel's state.
#[derive(Debug)]
pub struct State {
    /// The fire's values.
    pub fire: Fire,
    /// The panel controller's state.
    pub controller: ControllerState,
    /// The id of the selected object, if there still is one.
    pub selected: Option<u32>,
    /// What persists between visits.
    pub memory: Memory,
    /// The parameters to show, in this order and without groups; `None` shows all.
    pub only: Option<Vec<&'static Param>>,
    /// The input device.
    pub device: Device,
    /// The search.
    pub search: Search,
    /// What is open.
    pub open: Open,
    /// What the next frame scrolls to.
    pub reveal: Reveal,
    /// The rows of the last frame.
    pub anchor: Anchor,
}

/// The group of a parameter on the panel: the model, on which all others depend, is a choice of the physics.
pub fn group_of(param: &Param) -> &'static str {
    if param.id == MODEL {
        PHYSICS
    } else {
        param.group()
    }
}

impl State {
    /// The state of a panel without a message from its fire.
    pub fn new(measures: Measures) -> State {
        State {
            fire: Fire::default(),
            controller: ControllerState::default(),
            selected: None,
            memory: Memory::default(),
            only: None,
            device: Device {
                finger: false,
                measures,
            },
            search: Search::default(),
            open: Open::default(),
            reveal: Reveal::default(),
            anchor: Anchor::default(),
        }
    }

    /// Scrolls to the row of a parameter, or of a property of the selected object, and marks it;
    /// or scrolls to [`SHARE`], [`TOOLS`], [`QUALITY`], [`OBJECTS`] or [`SEARCH`], which takes the
    /// focus. Any other id removes the mark. What [`SHARE`] has unfolded folds again with the next id.
    pub fn reveal(&mut self, id: &str) {
        let model = self.fire.parameters().model();
        let param = Param::find(id).filter(|param| param.domain(model).is_some());
        self.reveal.marked = param.map(|param| param.id);
        if id == SHARE {
            self.open.shares_for_focus |= !self.open.sharing;
            self.open.sharing = true;
        } else if std::mem::take(&mut self.open.shares_for_focus) {
            self.open.sharing = false;
        }
        match id {
            SHARE | TOOLS | SEARCH => {
                self.search.focus |= id == SEARCH;
                self.open.tools = true;
                self.reveal.tools = true;
                self.reveal.row = true;
            }
            QUALITY => {
                self.reveal.quality = true;
                self.memory.folded.remove(BASICS);
                self.search.text.clear();
            }
            OBJECTS => {
                self.reveal.objects = true;
                self.show_objects();
            }
            _ => {}
        }
        if let Some(object) = self.selected_object() {
            let mut properties = self.fire.properties(object);
            if let Some(found) = properties.find(|property| property.id == id) {
                self.reveal.marked = Some(found.id);
                self.reveal.row = true;
                self.show_objects();
            }
        }
        if let Some(param) = param {
            self.reveal.row = true;
            self.memory.folded.remove(group_of(param));
            if !search::matches(&self.search.text, param) {
                self.search.text.clear();
            }
        }
    }

    /// The selected object.
    pub fn selected_object(&self) -> Option<Object<'_>> {
        self.fire.object(self.selected?)
    }

    /// Unfolds the objects.
    fn show_objects(&mut self) {
        self.memory.folded.remove(OBJECTS);
        self.search.text.clear();
    }

    /// Closes a field whose parameter the present model does not use or whose object is gone.
    pub fn close_stale_field(&mut self) {
        let fire = &self.fire;
        let used = |subject: Subject| match subject.object {
            None => fire.used().any(|param| param.id == subject.id),
            Some(owner) => fire
                .object(owner.id)
                .is_some_and(|object| fire.properties(object).any(|other| other == subject)),
        };
        self.open.field.take_if(|field| !used(field.subject));
    }

    /// The row that keeps its height on the screen, and that height. Another model has
    /// other rows: the uppermost visible row that both models have stays. A choice may
    /// add a line to other rows: its own row stays.
    pub fn anchor(&self) -> Option<(&'static str, f32)> {
        let mut tops = self.anchor.tops.iter().copied();
        if self.fire.parameters().model() == self.anchor.model {
            return tops.find(|&(id, _)| Some(id) == self.anchor.chosen);
        }
        tops.find(|&(id, _)| self.fire.used().any(|param| param.id == id))
    }
}

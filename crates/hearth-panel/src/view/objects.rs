//! The objects: buttons to add, duplicate, delete and order, and to act on the fire at one, a list to
//! select one, and the properties of the selected one.
//!
//! The properties of the first source are parameters, whose rows stand in their own groups. A
//! note names these groups, so that no value has two rows.

use egui::{Id, Rect, Ui, vec2};
use hearth_core::params::Model;
use hearth_core::scene::{KINDS, Kind, MAX_OBJECTS, Object};

use crate::search;
use crate::state::fire::Entry;
use crate::state::{Action, Command, State, Subject, is_on, name_of};
use crate::theme;
use crate::view::button::{self, Face};
use crate::view::icons::Icon;
use crate::view::layout::{paragraph, scroll_into_view, strip};
use crate::view::output::Output;
use crate::view::row;

/// Entries of the list per line.
const PER_LINE: usize = 2;

/// Buttons per line.
const BUTTONS_PER_LINE: usize = 4;

/// Width of the button that switches an object.
const EYE_WIDTH: f32 = 30.0;

/// Maximum height of a line of the list.
const MAX_LINE_HEIGHT: f32 = 36.0;

/// What acts on the fire at the selected object: name, label and hint.
const ACTIONS: [(&str, &str, &str); 5] = [
    (
        "ignite",
        "Ignite",
        "Light the selected solid, or a source that water has put out",
    ),
    (
        "extinguish",
        "Extinguish",
        "Put out the selected solid: cool it and its flames",
    ),
    ("water", "Water", "Spray water on the selected object"),
    ("sparks", "Sparks", "Throw sparks from the selected object"),
    ("blow", "Blow", "Blow at the selected object from its left"),
];

/// Shows the content of the group.
pub fn show(state: &State, out: &mut Output, ui: &mut Ui) {
    let top = ui.cursor().top();
    let gap = state.device.measures.gap;
    buttons(state, out, ui);
    let all: Vec<Object<'_>> = state.fire.objects.objects().collect();
    let height = state.device.measures.control.min(MAX_LINE_HEIGHT);
    for (at, line) in all.chunks(PER_LINE).enumerate() {
        let rect = strip(ui, height);
        if at == 0 {
            out.record(ui, "objects", rect);
        }
        for (rect, &object) in button::split(rect, PER_LINE, 4.0).zip(line) {
            entry(state, out, ui, rect, object);
        }
        ui.add_space(4.0);
    }
    if all.is_empty() {
        paragraph(
            ui,
            "No objects. Add a source to start a fire.",
            theme::weak(),
        );
    }
    ui.add_space(gap);
    if let Some(object) = state.selected_object() {
        if state.fire.is_first_source(&object) {
            paragraph(ui, &groups_of(object.kind, object.model()), theme::weak());
        }
        for property in state.fire.properties(object) {
            row::show(state, out, ui, property);
        }
    }
    if state.reveal.objects {
        let rows = ui.max_rect().x_range();
        scroll_into_view(ui, Rect::from_x_y_ranges(rows, top..=ui.cursor().top()));
    }
}

/// Shows what matches the search: of each kind, the properties of the selected object or of the
/// first one, and the objects whose names match. Returns whether there is anything.
pub fn results(state: &State, out: &mut Output, ui: &mut Ui) -> bool {
    let query = &*state.search.text;
    let mut any = false;
    for &kind in KINDS {
        let found = search::properties(query, kind, state.fire.parameters().model());
        let named = |object: &Object<'_>| search::names(query, &name_of(*object));
        let of_kind = |object: &Object<'_>| object.kind.name == kind.name;
        let all = || state.fire.objects.objects().filter(of_kind);
        let Some(best) = found.first() else {
            for object in all().filter(named) {
                any = true;
                line(state, out, ui, object);
            }
            continue;
        };
        any = true;
        let has_effect = |object: &Object<'_>| {
            let property = Subject::of(object.id, kind, *best);
            property.is_some_and(|property| state.fire.unmet_conditions(property).is_empty())
        };
        let others = || all().filter(|object| !state.fire.is_first_source(object));
        let selected = others().find(|object| state.selected == Some(object.id));
        match selected
            .or_else(|| others().find(has_effect))
            .or_else(|| others().next())
        {
            Some(object) => {
                line(state, out, ui, object);
                for property in found {
                    if let Some(property) = Subject::of(object.id, kind, property) {
                        row::show(state, out, ui, property);
                    }
                }
            }
            // The parameters are those of the first source.
            None if kind.is_of_parameters() => {}
            None => {
                let label = best.entry().map_or("", |param| param.description().label);
                let text = format!("{label} is a property of a {}: add one.", kind.name);
                paragraph(ui, &text, theme::weak());
            }
        }
    }
    any
}

/// Shows an object on a line of its own.
fn line(state: &State, out: &mut Output, ui: &mut Ui, object: Object<'_>) {
    let rect = strip(ui, state.device.measures.control.min(MAX_LINE_HEIGHT));
    entry(state, out, ui, rect, object);
    ui.add_space(4.0);
}

/// Shows an object in a list; a click selects it, another one deselects it. Its eye switches it off
/// and on.
fn entry(state: &State, out: &mut Output, ui: &Ui, rect: Rect, object: Object<'_>) {
    let selected = state.selected == Some(object.id);
    let key = format!("object:{}", object.id);
    let face = Face {
        lit: selected,
        ..Face::text("")
    };
    let response = button::show(ui, rect, Id::new(&key), face);
    let eye = rect.with_min_x(rect.right() - EYE_WIDTH);
    let room = rect.shrink2(vec2(8.0, 0.0)).with_max_x(eye.left());
    button::left_text(ui, room, &name_of(object));
    out.record(ui, key, rect.with_max_x(eye.left()));
    if let Some(switch) = switch_of(state, object) {
        let on = is_on(object);
        let key = format!("enabled:{}", object.id);
        let (icon, hint) = match on {
            true => (Icon::Eye, "Switch off: it neither acts nor is drawn"),
            false => (Icon::ClosedEye, "Switch on"),
        };
        let pressed = button::show(ui, eye, Id::new(&key), Face::bare(icon));
        out.record(ui, key, eye);
        if pressed.on_hover_text(hint).clicked() {
            out.push(Action::Set(switch, Entry::Flag(!on)));
        }
    }
    if response.clicked() {
        out.push(Action::Select((!selected).then_some(object.id)));
    }
}

/// What switches an object off and on.
fn switch_of(state: &State, object: Object<'_>) -> Option<Subject> {
    let property = object.kind.property("enabled")?;
    if state.fire.is_first_source(&object) {
        return property.entry().map(Subject::from);
    }
    Subject::of(object.id, object.kind, property)
}

/// The buttons, and why one is disabled.
fn buttons(state: &State, out: &mut Output, ui: &mut Ui) {
    let selected = state.selected_object();
    let full = |kind: &Kind| state.fire.is_full(kind);
    let adds = KINDS.iter().map(|kind| {
        let label = format!("Add {}", kind.name);
        (label, Command::Add(kind.name), !full(kind), kind.doc)
    });
    let id = selected.map_or(0, |object| object.id);
    let is_body = selected.is_some_and(|object| object.kind.is_body);
    let copies = selected.is_some_and(|object| !full(object.kind));
    let edits = [
        (
            "Duplicate",
            Command::Duplicate(id),
            copies,
            "Duplicate the selected object",
        ),
        (
            "Delete",
            Command::Remove(id),
            selected.is_some(),
            "Delete the selected object",
        ),
        (
            "To back",
            Command::Order(id, false),
            is_body,
            "Draw the selected solid behind the others",
        ),
        (
            "To front",
            Command::Order(id, true),
            is_body,
            "Draw the selected solid before the others",
        ),
    ];
    let edits = edits.map(|(label, command, on, hint)| (label.to_owned(), command, on, hint));
    let all: Vec<_> = adds.chain(edits).collect();
    let acts = ACTIONS.map(|(name, label, hint)| {
        let command = Command::Act(name, id);
        (label.to_owned(), command, selected.is_some(), hint)
    });
    for line in all.chunks(BUTTONS_PER_LINE).chain([&acts[..]]) {
        let rect = strip(ui, state.device.measures.control);
        let words: Vec<&str> = line.iter().map(|(label, ..)| label.as_str()).collect();
        let parts = button::split_by_words(ui, rect, &words, 4.0);
        for (rect, (label, command, enabled, hint)) in parts.into_iter().zip(line) {
            let key = format!("action:{}", label.to_lowercase().replace(' ', ":"));
            let face = Face {
                enabled: *enabled,
                ..Face::text(label)
            };
            let response = button::show(ui, rect, Id::new(&key), face);
            out.record(ui, key, rect);
            if response.on_hover_text(*hint).clicked() && *enabled {
                out.send(command.clone());
            }
        }
        ui.add_space(4.0);
    }
    for kind in KINDS.iter().filter(|kind| full(kind)) {
        let text = format!("A scene has at most {MAX_OBJECTS} {}s.", kind.name);
        paragraph(ui, &text, theme::weak());
    }
}

/// Where the properties of the first source are.
fn groups_of(kind: &Kind, model: Model) -> String {
    let used = kind
        .properties()
        .filter(|property| !property.is_common())
        .filter_map(|property| property.param(model));
    let mut groups: Vec<&str> = used.map(|param| param.group()).collect();
    groups.sort_unstable();
    groups.dedup();
    format!(
        "The first source: its properties are in {}.",
        groups.join(" and ")
    )
}

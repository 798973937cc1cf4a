//! Applies the actions of the views to the state.

use hearth_core::params::{Input, Param};

use crate::state::fire::Entry;
use crate::state::{Action, Command, State};

/// Applies `action` to `state`, and adds the commands for the host to `commands`.
pub fn apply(state: &mut State, commands: &mut Vec<Command>, action: Action) {
    let mut update = Update { state, commands };
    update.apply(action);
}

struct Update<'a> {
    state: &'a mut State,
    commands: &'a mut Vec<Command>,
}

impl Update<'_> {
    fn apply(&mut self, action: Action) {
        let open = &mut self.state.open;
        match action {
            Action::Send(command) => self.send(command),
            Action::Set(param, entry) => self.set(param, &entry, true),
            Action::Slide(param, entry) => self.set(param, &entry, false),
            Action::Choose(param, name) => self.choose(param, name),
            Action::Restore(param) => {
                open.field = None;
                self.state.fire.refusals.remove(param.id);
                self.send(Command::Restore(param.id));
            }
            Action::RestoreAll => {
                open.field = None;
                self.state.fire.refusals.clear();
                self.send(Command::RestoreAll);
            }
            Action::Quality(name) => {
                name.clone_into(&mut self.state.fire.quality);
                self.send(Command::Quality(name));
            }
            Action::Scenes => {
                self.state.fire.refusals.clear();
                self.send(Command::Scenes);
            }
            Action::OpenField(field) => open.field = Some(field),
            Action::Type(field) => {
                if open.field_of(field.id).is_some() {
                    open.field = Some(field);
                }
            }
            Action::CloseField(id) => {
                open.field.take_if(|field| field.id == id);
            }
            Action::Refuse(id, reason) => {
                let refusals = &mut self.state.fire.refusals;
                match reason {
                    Some(reason) => refusals.insert(id, reason),
                    None => refusals.remove(id),
                };
            }
            Action::OpenColour(colour) => open.colour = colour,
            Action::OpenChoice(id) => open.choice = id,
            Action::Describe(id) => open.description = id,
            Action::Unmark => self.state.reveal.marked = None,
            Action::ToggleTools => {
                open.tools ^= true;
                // The tools unfold above the rows.
                self.state.reveal.start = open.tools;
            }
            Action::ToggleSharing => open.sharing ^= true,
            Action::ToggleTimes => {
                self.state.memory.times ^= true;
                self.remember();
            }
            Action::ToggleGroup(name) => {
                let folded = &mut self.state.memory.folded;
                if !folded.remove(name) {
                    folded.insert(name);
                }
                self.remember();
            }
            Action::Search(text) => self.state.search.text = text,
            Action::SearchFocused => self.state.search.focus = false,
        }
    }

    fn send(&mut self, command: Command) {
        // The next command dismisses the last error.
        self.state.fire.notice = None;
        self.commands.push(command);
    }

    fn remember(&mut self) {
        self.send(Command::Remember(self.state.memory.clone()));
    }

    /// Sets a value and sends it: `always`, or only a change. A refused value is not sent.
    fn set(&mut self, param: &'static Param, entry: &Entry, always: bool) {
        let before = param.get(&self.state.fire.parameters);
        if let Ok(now) = self.state.fire.set(param, entry.input())
            && (always || now != before)
        {
            self.state.open.field.take_if(|field| field.id == param.id);
            self.send(Command::Set(param.id, now));
        }
    }

    fn choose(&mut self, param: &'static Param, name: &'static str) {
        if let Ok(now) = self.state.fire.set(param, Input::Text(name)) {
            self.state.anchor.chosen = Some(param.id);
            self.send(Command::Set(param.id, now));
        }
    }
}

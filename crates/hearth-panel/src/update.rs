//! Applies the actions of the views to the state.

use crate::panel::Panel;
use crate::state::fire::Entry;
use crate::state::{Action, Command, Subject};

impl Panel {
    /// Applies an action, and adds the commands for the host.
    pub(crate) fn apply(&mut self, action: Action) {
        let open = &mut self.state.open;
        match action {
            Action::Send(command) => self.send(command),
            Action::Set(subject, entry) => self.set(subject, &entry, true),
            Action::Slide(subject, entry) => self.set(subject, &entry, false),
            Action::Choose(subject, name) => {
                self.state.anchor.chosen = Some(subject.id);
                self.set(subject, &Entry::Text(name.to_owned()), true);
            }
            Action::Restore(subject) => {
                open.field = None;
                self.state.fire.refusals.remove(subject.id);
                self.send(Command::Restore(subject));
            }
            Action::Select(id) => self.select(id),
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
                if open.field_of(field.subject).is_some() {
                    open.field = Some(field);
                }
            }
            Action::CloseField(id) => {
                open.field.take_if(|field| field.subject.id == id);
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
            Action::ToggleSharing => {
                open.sharing ^= true;
                open.shares_for_focus = false;
            }
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
    fn set(&mut self, subject: Subject, entry: &Entry, always: bool) {
        let fire = &mut self.state.fire;
        let before = Entry::from(fire.value(subject));
        if fire.set(subject, entry.input()).is_err() {
            return;
        }
        let now = Entry::from(fire.value(subject));
        if always || now != before {
            let field = &mut self.state.open.field;
            field.take_if(|field| field.subject == subject);
            self.send(Command::Set(subject, now));
        }
    }

    /// Selects an object. What was typed for another one counts, and what was open of it closes:
    /// the rows of both have the same names.
    fn select(&mut self, id: Option<u32>) {
        let field = self.state.open.field.take();
        if let Some(field) = field.filter(|field| field.subject.object.is_some())
            && field.text != field.before
        {
            let entry = self.state.fire.typed(field.subject, &field.text);
            self.set(field.subject, &entry, false);
        }
        let parameters = |id: &str| Subject::is_parameter(id);
        self.state.fire.refusals.retain(|id, _| parameters(id));
        let open = &mut self.state.open;
        open.choice = open.choice.filter(|id| parameters(id));
        open.description = open.description.filter(|id| parameters(id));
        self.state.selected = id;
        self.send(Command::Select(id));
    }
}

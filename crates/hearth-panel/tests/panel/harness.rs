//! A harness that uses a panel without a browser: it paints frames, and sends pointer and
//! keys to the rectangles of the controls.
//!
//! A character that the font lacks fails, so no test paints a replacement box.

use egui::{Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, Shape, vec2};
use hearth_core::params::{Choice, Input, Model, Param, Value};
use hearth_panel::Panel;
use hearth_panel::state::{Command, MODEL};
use hearth_panel::theme::{self, Measures};

pub struct Harness {
    pub ctx: egui::Context,
    pub panel: Panel,
    pub size: egui::Vec2,
    pub time: f64,
}

impl Harness {
    /// A panel of the classic model.
    pub fn new(size: Size) -> Harness {
        Harness::of_model(Model::Classic, size)
    }

    pub fn of_model(model: Model, (width, height, measures): Size) -> Harness {
        let ctx = egui::Context::default();
        theme::apply(&ctx, None);
        let mut harness = Harness {
            ctx,
            panel: Panel::new(measures),
            size: vec2(width, height),
            time: 0.0,
        };
        harness
            .panel
            .state
            .fire
            .receive(MODEL, Input::Text(model.name()));
        harness
            .panel
            .state
            .fire
            .start_from([(MODEL, Input::Text(model.name()))], None);
        harness.wait();
        harness
    }

    /// The parameters of the present model.
    pub fn used(&self) -> Vec<&'static Param> {
        self.panel.state.fire.used().collect()
    }

    pub fn frame(&mut self, events: Vec<Event>) {
        self.frame_with(Modifiers::NONE, events);
    }

    /// A frame with modifier keys.
    pub fn frame_with(&mut self, modifiers: Modifiers, events: Vec<Event>) {
        self.time += 0.1;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            time: Some(self.time),
            events,
            modifiers,
            ..RawInput::default()
        };
        self.paint(input);
    }

    /// The texts of a frame, and where they are painted.
    fn paint(&mut self, input: RawInput) -> Vec<(String, Rect)> {
        let output = self.ctx.run(input, |ctx| self.panel.show(ctx));
        let shapes = output.shapes.iter().map(|clipped| &clipped.shape);
        let texts = shapes.filter_map(|shape| match shape {
            Shape::Text(text) => {
                let rect = text.galley.rect.translate(text.pos.to_vec2());
                Some((text.galley.text().to_owned(), rect))
            }
            _ => None,
        });
        let texts: Vec<_> = texts.collect();
        for (text, _) in &texts {
            // "?" is what egui shows for a letter that the font lacks, so it counts as none.
            let known = |c| {
                c == '?'
                    || self
                        .ctx
                        .fonts_mut(|fonts| fonts.has_glyph(&theme::body(), c))
            };
            assert!(
                text.chars().all(known),
                "the font lacks letters of {text:?}"
            );
        }
        texts
    }

    /// Every text that is painted.
    pub fn texts(&mut self) -> Vec<String> {
        let painted = self.painted_texts();
        painted.into_iter().map(|(text, _)| text).collect()
    }

    /// Every text that is painted, and where.
    pub fn painted_texts(&mut self) -> Vec<(String, Rect)> {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            time: Some(self.time),
            ..RawInput::default()
        };
        self.paint(input)
    }

    pub fn wait(&mut self) {
        for _ in 0..3 {
            self.frame(Vec::new());
        }
    }

    pub fn rect(&self, name: &str) -> Rect {
        *self
            .panel
            .rectangles()
            .get(name)
            .unwrap_or_else(|| panic!("{name} is not in sight"))
    }

    pub fn in_sight(&self, name: &str) -> bool {
        self.panel.rectangles().contains_key(name)
    }

    pub fn reveal(&mut self, id: &str) {
        self.panel.state.reveal(id);
        self.wait();
    }

    pub fn button(&mut self, pos: Pos2, pressed: bool) {
        self.frame(vec![
            Event::PointerMoved(pos),
            Event::PointerButton {
                pos,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            },
        ]);
    }

    pub fn click(&mut self, name: &str) {
        let pos = self.rect(name).center();
        self.frame(vec![Event::PointerMoved(pos)]);
        self.button(pos, true);
        self.button(pos, false);
        self.wait();
    }

    pub fn drag(&mut self, from: Pos2, to: Pos2) {
        self.frame(vec![Event::PointerMoved(from)]);
        self.button(from, true);
        for part in 1..=3 {
            let pos = from + (to - from) * (part as f32 / 3.0);
            self.frame(vec![Event::PointerMoved(pos)]);
        }
        self.button(to, false);
        self.wait();
    }

    pub fn key(&mut self, key: Key) {
        for pressed in [true, false] {
            self.frame(vec![Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::NONE,
            }]);
        }
        self.wait();
    }

    pub fn value(&self, id: &str) -> Value {
        let value = self.panel.state.fire.objects.get(id);
        value.unwrap_or_else(|| panic!("there is no {id}"))
    }
}

/// The command that sets a parameter.
pub fn set(id: &str, value: Value) -> Command {
    let param = Param::find(id).unwrap_or_else(|| panic!("there is no {id}"));
    Command::Set(param.into(), value.into())
}

/// Width, height, and sizes for mouse or finger.
pub type Size = (f32, f32, Measures);

pub const TALL: Size = (340.0, 900.0, Measures::FINE);
pub const LOWER: Size = (340.0, 600.0, Measures::FINE);
pub const PHONE: Size = (360.0, 288.0, Measures::COARSE);

/// Every model.
pub fn models() -> impl Iterator<Item = Model> {
    Model::NAMES
        .iter()
        .filter_map(|name| Model::from_name(name))
}

//! The search field.

use egui::{Align, Id, Key, Margin, Rect, RichText, TextEdit, Ui, UiBuilder, pos2, vec2};

use crate::browser_text;
use crate::state::{Action, Search};
use crate::theme;
use crate::view::button::{self, Face};
use crate::view::icons::Icon;
use crate::view::output::Output;

/// Shows the field in `rect`.
pub fn show(search: &Search, out: &mut Output, ui: &mut Ui, rect: Rect) {
    let mut text = search.text.clone();
    let margin = Margin {
        left: 28,
        right: 26,
        top: 2,
        bottom: 2,
    };
    let mut lay_out = browser_text::lay_out;
    let edit = TextEdit::singleline(&mut text)
        .layouter(&mut lay_out)
        .id(Id::new("search"))
        .hint_text(RichText::new("Search").color(theme::weak()))
        .desired_width(rect.width())
        .min_size(rect.size())
        .vertical_align(Align::Center)
        .char_limit(60)
        .margin(margin);
    let output = ui
        .scope_builder(UiBuilder::new().max_rect(rect), |ui| edit.show(ui))
        .inner;
    browser_text::paint_typed(ui, &output, &text);
    let response = output.response;
    if search.focus {
        response.request_focus();
        out.push(Action::SearchFocused);
    }
    let escape = ui.input(|input| input.key_pressed(Key::Escape));
    if response.lost_focus() && escape && !text.is_empty() {
        text.clear();
        response.request_focus();
    }
    let glass = pos2(rect.left() + 15.0, rect.center().y);
    Icon::Search.paint(ui.painter(), glass, 14.0, theme::weak());
    out.record(ui, "search", rect);
    if !text.is_empty() {
        let cross = Rect::from_center_size(
            pos2(rect.right() - 14.0, rect.center().y),
            vec2(26.0, rect.height()),
        );
        let id = Id::new("search-clear");
        if button::show(ui, cross, id, Face::bare(Icon::Cross)).clicked() {
            text.clear();
        }
    }
    if text != search.text {
        out.push(Action::Search(text));
    }
}

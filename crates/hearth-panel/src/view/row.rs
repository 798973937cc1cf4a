//! The row of a parameter: its control, and below it notes on its value.

use egui::{Id, Rect, Sense, Shape, Ui, vec2};
use hearth_core::params::{AnyValue, Kind};

use crate::cost;
use crate::format::{bound_text, text_in_short, value_text, with_unit};
use crate::state::{MODEL, State, Subject};
use crate::theme;
use crate::view::layout::{paragraph, scroll_into_view};
use crate::view::output::Output;
use crate::view::{choices, colour, control, title};

/// Opacity of a control without effect. It can still be set, so its text keeps a contrast
/// of 4.5:1 on every ground.
const IDLE_OPACITY: f32 = 0.8;

/// What the choice of the model means.
const CLASSIC: &str =
    "Classic is the model of the paper: hot particles rise and cool. Nothing in it burns down.";

/// Shows the row of a parameter or a property.
pub fn show(state: &State, out: &mut Output, ui: &mut Ui, subject: impl Into<Subject>) {
    let subject = subject.into();
    framed(state, out, ui, subject, true, |out, ui| {
        match subject.param.kind {
            Kind::Number(scale) => control::number(state, out, ui, subject, scale, false),
            Kind::Integer(scale) => control::number(state, out, ui, subject, scale, true),
            Kind::Seed => control::seed(state, out, ui, subject),
            Kind::Flag => control::flag(state, out, ui, subject),
            Kind::Choice(names) => choices::show(state, out, ui, subject, names),
            Kind::Colour => colour::show(state, out, ui, subject),
            Kind::Text(_) => control::text(state, out, ui, subject),
        }
        if subject.id == MODEL {
            paragraph(ui, CLASSIC, theme::weak());
        }
    });
    ui.add_space(state.device.measures.gap);
}

/// Shows the control that `content` paints, below it the texts about its value, and behind
/// it the mark of a revealed row. `scrolls`: whether the row can scroll into view.
pub fn framed(
    state: &State,
    out: &mut Output,
    ui: &mut Ui,
    subject: Subject,
    scrolls: bool,
    content: impl FnOnce(&mut Output, &mut Ui),
) {
    let ground = ui.painter().add(Shape::Noop);
    let top = ui.cursor().top();
    let idle = title::idle(&state.fire, subject);
    ui.scope(|ui| {
        if idle.is_some() {
            ui.multiply_opacity(IDLE_OPACITY);
        }
        content(out, ui);
    });
    if let Some(reason) = idle {
        paragraph(ui, &reason, theme::weak());
    }
    if let Some(refusal) = state.fire.refusals.get(subject.id) {
        paragraph(ui, refusal, theme::ERROR);
    }
    if state.open.description == Some(subject.id) {
        paragraph(ui, &description(state, subject), theme::weak());
    }
    let space = ui.max_rect();
    let rect = Rect::from_x_y_ranges(space.x_range(), top..=ui.cursor().top());
    hover(state, out, ui, subject, rect);
    if state.reveal.marked == Some(subject.id) {
        let fill = Shape::rect_filled(rect.expand2(vec2(8.0, 2.0)), 6.0, theme::RAISED);
        ui.painter().set(ground, fill);
        if state.reveal.row && scrolls {
            scroll_into_view(ui, rect);
        }
    }
}

/// The tooltip of the whole row, unless it would disturb what the pointer does.
fn hover(state: &State, out: &mut Output, ui: &Ui, subject: Subject, rect: Rect) {
    let row = ui.interact(rect, Id::new(("row", subject.id)), Sense::hover());
    if row.contains_pointer() {
        out.hovered = Some(subject);
    }
    let quiet = std::mem::take(&mut out.quiet);
    let typed = state.open.field.is_some() || state.open.choice == Some(subject.id);
    let busy = typed || out.pointer.acts || state.device.finger;
    if row.contains_pointer() && !quiet && !busy {
        out.tooltip = Some((description(state, subject), rect));
    }
}

/// What a parameter does, its value in the scene, its range and its attribute.
fn description(state: &State, subject: Subject) -> String {
    let scene = match &*state.controller.preset {
        _ if !state.fire.is_of_scene(subject) => "Default",
        "" => "Default",
        preset => preset,
    };
    let default = match state.fire.default_of(subject) {
        AnyValue::Text(text) => text_in_short(subject.param.id, text),
        value => value_text(&value),
    };
    let default = with_unit(&default, subject.param.unit);
    let mut text = format!("{}\n{scene} {default}", subject.param.description().doc);
    if let Kind::Number(_) | Kind::Integer(_) | Kind::Seed = subject.param.kind {
        let (min, max) = state.fire.range_of(subject);
        text += &format!(
            " · from {} to {}",
            bound_text(min, ""),
            bound_text(max, subject.param.unit)
        );
    }
    if cost::costly_from(subject).is_some() {
        text += "\nExpensive towards the end of its slider";
    }
    match subject.object {
        None => text + "\nAttribute " + &subject.id.replace('_', "-"),
        Some(owner) => text + "\nProperty " + owner.property,
    }
}

#[cfg(test)]
mod tests {
    use egui::Color32;

    use super::*;

    /// Relative luminance, as WCAG 2 defines it.
    fn luminance(colour: Color32) -> f64 {
        let [r, g, b, _] = colour.to_array().map(|byte| {
            let part = f64::from(byte) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                ((part + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    #[test]
    fn dimmed_text_keeps_its_contrast() {
        let on = |ground: Color32, ink: Color32| ground.lerp_to_gamma(ink, IDLE_OPACITY);
        // The panel, a marked row, and buttons on both, lit ones included.
        for behind in [theme::GROUND, theme::RAISED] {
            let words = [
                (behind, theme::TEXT),
                (behind, theme::weak()),
                (behind, theme::ACCENT),
                (on(behind, theme::RAISED), theme::TEXT),
                (on(behind, theme::HOVERED), theme::TEXT),
                (on(behind, theme::EMBER), theme::TEXT),
            ];
            for (ground, ink) in words {
                let [ground, ink] =
                    [ground, on(ground, ink)].map(|colour| luminance(colour) + 0.05);
                let contrast = ink / ground;
                assert!(contrast >= 4.5, "{contrast} in {ink:?} on {ground:?}");
            }
        }
    }
}

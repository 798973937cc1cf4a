//! The slider: a rail with a knob, for a mouse and for a finger.
//!
//! A press of a mouse moves the knob at once. For a finger the first few points of its
//! path decide: sideways moves the knob, up or down scrolls the panel, and a tap sets the
//! value. egui's own slider takes every touch as a drag, so that each swipe over the panel
//! would change a value.

use egui::{Id, Key, Rect, Response, Sense, Stroke, StrokeKind, Ui, Vec2, pos2, vec2};

use crate::state::Gesture;
use crate::theme;

/// Length of a finger's path that decides its direction [points].
const DECISIVE_PATH: f32 = 7.0;

/// Motion of the knob relative to the pointer, with the shift key.
const FINE_MOTION: f32 = 0.1;

/// Steps per page key.
const STEPS_PER_PAGE: f32 = 10.0;

/// A move of the knob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moved {
    /// To this fraction of the rail.
    To(f32),
    /// By steps, from keys or a wheel.
    Steps(f32),
}

/// The look of a slider.
pub struct Rail<'a> {
    /// Position of the knob, 0 to 1.
    pub fraction: f32,
    /// Position of the default, if it is marked.
    pub mark: Option<f32>,
    /// Start of the costly values, if there are any.
    pub costly: Option<f32>,
    /// Colours along the rail instead of the ordinary fill.
    pub colours: Option<&'a dyn Fn(f32) -> egui::Color32>,
}

/// Shows a slider in `rect`; `gesture` lives as long as the press.
pub fn show(
    ui: &Ui,
    rect: Rect,
    id: Id,
    rail: &Rail<'_>,
    finger: bool,
    gesture: &mut Option<(Id, Gesture)>,
) -> Option<Moved> {
    let response = ui
        .interact(rect, id, Sense::click_and_drag())
        .on_hover_and_drag_cursor(egui::CursorIcon::ResizeHorizontal);
    let knob = (rect.height() * 0.42).min(9.0);
    let (left, right) = (rect.left() + knob, rect.right() - knob);
    let to = |x: f32| Moved::To(((x - left) / (right - left)).clamp(0.0, 1.0));
    let now = left + (right - left) * rail.fraction;
    let moved = follow(ui, &response, finger, gesture, now, to).or_else(|| keys(ui, &response));
    let fraction = match moved {
        Some(Moved::To(fraction)) => fraction,
        Some(Moved::Steps(_)) | None => rail.fraction,
    };
    if ui.is_rect_visible(rect) {
        paint(ui, rect, rail, fraction, (left, right, knob), &response);
    }
    moved
}

fn follow(
    ui: &Ui,
    response: &Response,
    finger: bool,
    gesture: &mut Option<(Id, Gesture)>,
    knob: f32,
    to: impl Fn(f32) -> Moved,
) -> Option<Moved> {
    let pos = response.interact_pointer_pos()?;
    if !response.is_pointer_button_down_on() && !response.clicked() {
        return None;
    }
    let start = if finger {
        Gesture::Undecided(pos)
    } else {
        Gesture::Slide
    };
    let mut now = match *gesture {
        Some((id, now)) if id == response.id => now,
        _ => start,
    };
    if let Gesture::Undecided(origin) = now {
        let way = pos - origin;
        if way.length() > DECISIVE_PATH {
            now = if way.x.abs() >= way.y.abs() {
                Gesture::Slide
            } else {
                Gesture::Scroll
            };
        }
    }
    let fine = ui.input(|input| input.modifiers.shift);
    now = match now {
        Gesture::Slide if fine => Gesture::Fine(pos.x, knob),
        Gesture::Fine(..) if !fine => Gesture::Slide,
        now => now,
    };
    *gesture = Some((response.id, now));
    match now {
        Gesture::Slide => {
            response.request_focus();
            Some(to(pos.x))
        }
        Gesture::Fine(start, from) => {
            response.request_focus();
            // The knob rests while the pointer does, even if the value is rounded.
            (pos.x != start).then(|| to(from + (pos.x - start) * FINE_MOTION))
        }
        Gesture::Undecided(_) => response.clicked().then(|| to(pos.x)),
        Gesture::Scroll => {
            let way = ui.input(|input| input.pointer.delta().y);
            ui.scroll_with_delta_animation(vec2(0.0, way), egui::style::ScrollAnimation::none());
            None
        }
    }
}

/// The arrow and page keys move the focused slider by steps, Home and End to its ends.
fn keys(ui: &Ui, response: &Response) -> Option<Moved> {
    if !response.has_focus() {
        return None;
    }
    let filter = egui::EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    ui.input(|input| {
        if input.key_pressed(Key::Home) {
            return Some(Moved::To(0.0));
        }
        if input.key_pressed(Key::End) {
            return Some(Moved::To(1.0));
        }
        let steps: f32 = [
            (Key::ArrowRight, 1.0),
            (Key::ArrowUp, 1.0),
            (Key::ArrowLeft, -1.0),
            (Key::ArrowDown, -1.0),
            (Key::PageUp, STEPS_PER_PAGE),
            (Key::PageDown, -STEPS_PER_PAGE),
        ]
        .into_iter()
        .map(|(key, steps)| input.num_presses(key) as f32 * steps)
        .sum();
        (steps != 0.0).then_some(Moved::Steps(steps))
    })
}

fn paint(
    ui: &Ui,
    rect: Rect,
    rail: &Rail<'_>,
    fraction: f32,
    (left, right, knob): (f32, f32, f32),
    response: &Response,
) {
    let painter = ui.painter();
    let y = rect.center().y;
    let at = |fraction: f32| left + (right - left) * fraction;
    let thick = if rail.colours.is_some() { 8.0 } else { 4.0 };
    let line = |from: f32, to: f32| {
        Rect::from_min_max(pos2(from, y - thick / 2.0), pos2(to, y + thick / 2.0))
    };
    match rail.colours {
        Some(colours) => {
            const SEGMENTS: u32 = 24;
            let mut band = egui::Mesh::default();
            for piece in 0..=SEGMENTS {
                let part = piece as f32 / SEGMENTS as f32;
                let (x, colour) = (at(part), colours(part));
                band.colored_vertex(pos2(x, y - thick / 2.0), colour);
                band.colored_vertex(pos2(x, y + thick / 2.0), colour);
                if piece > 0 {
                    let corner = 2 * piece;
                    band.add_triangle(corner - 2, corner - 1, corner);
                    band.add_triangle(corner - 1, corner, corner + 1);
                }
            }
            painter.add(egui::Shape::mesh(band));
            painter.rect_stroke(
                line(left, right),
                1.0,
                Stroke::new(1.0, theme::line()),
                StrokeKind::Outside,
            );
        }
        None => {
            painter.rect_filled(line(left - 2.0, right + 2.0), 2.0, theme::RAISED);
            painter.rect_filled(line(left - 2.0, at(fraction)), 2.0, theme::ACCENT);
        }
    }
    if let Some(costly) = rail.costly {
        let above = pos2(at(costly), y - 6.0)..=pos2(right, y - 6.0);
        painter.line_segment([*above.start(), *above.end()], (1.5, theme::ERROR));
    }
    if let Some(mark) = rail.mark {
        let tick = Rect::from_center_size(pos2(at(mark), y), Vec2::new(1.5, 10.0));
        painter.rect_filled(tick, 0.0, theme::weak());
    }
    let centre = pos2(at(fraction), y);
    let held = response.hovered() || response.is_pointer_button_down_on();
    let fill = if held { theme::ACCENT } else { theme::TEXT };
    painter.circle(centre, knob, fill, Stroke::new(1.5, theme::GROUND));
    if response.has_focus() {
        painter.circle_stroke(centre, knob + 2.0, Stroke::new(1.0, theme::ACCENT));
    }
}

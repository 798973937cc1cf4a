//! Texts from right to left, such as Hebrew or Arabic names. egui neither orders nor joins their letters, so
//! the browser draws them as pictures. Letters of other scripts that the font lacks come from the browser one by
//! one, through eframe.

use egui::{Align2, Color32, ColorImage, Context, Id, Rect, TextureHandle, Ui, pos2};

use crate::theme;

/// Draws a line of text in white, with letters of so many pixels; `None` if it cannot.
pub type Draw = fn(text: &str, pixels: f32) -> Option<ColorImage>;

/// The pictures that are kept.
const MOST_PICTURES: usize = 128;

/// A picture of a text, with its scale.
type Picture = (String, f32, TextureHandle);

/// Sets what draws texts from right to left.
pub fn draw_with(ctx: &Context, draw: Draw) {
    ctx.data_mut(|data| data.insert_temp(Id::NULL, draw));
}

/// Whether a text has letters that are read from right to left.
pub fn is_from_right(text: &str) -> bool {
    text.chars().any(|c| {
        matches!(c,
            '\u{590}'..='\u{8ff}' | '\u{fb1d}'..='\u{fdff}' | '\u{fe70}'..='\u{fefc}'
            | '\u{10800}'..='\u{10fff}' | '\u{1e800}'..='\u{1eeff}')
    })
}

/// Paints a text in `room`, cut at its edges. Returns its rectangle; `None` if egui paints it as well.
pub fn paint(ui: &Ui, room: Rect, align: Align2, text: &str, ink: Color32) -> Option<Rect> {
    let picture = is_from_right(text).then(|| picture(ui.ctx(), text))??;
    let size = picture.size_vec2() / ui.ctx().pixels_per_point();
    let rect = align.align_size_within_rect(size, room);
    let rect = match rect.width() > room.width() {
        true => rect.translate(room.left_center() - rect.left_center()),
        false => rect,
    };
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    let painter = ui.painter_at(room.intersect(ui.clip_rect()));
    painter.image(picture.id(), rect, whole, ink);
    Some(rect.intersect(room))
}

fn picture(ctx: &Context, text: &str) -> Option<TextureHandle> {
    let draw: Draw = ctx.data(|data| data.get_temp(Id::NULL))?;
    let pixels = theme::body().size * ctx.pixels_per_point();
    let id = Id::unique("pictures of texts");
    let mut kept: Vec<Picture> = ctx.data(|data| data.get_temp(id)).unwrap_or_default();
    let known = kept.iter().find(|(of, at, _)| of == text && *at == pixels);
    if let Some((.., picture)) = known {
        return Some(picture.clone());
    }
    let picture = ctx.load_texture(text, draw(text, pixels)?, egui::TextureOptions::LINEAR);
    if kept.len() >= MOST_PICTURES {
        kept.clear();
    }
    kept.push((text.to_owned(), pixels, picture.clone()));
    ctx.data_mut(|data| data.insert_temp(id, kept));
    Some(picture)
}

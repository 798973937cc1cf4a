//! Texts with letters that the font lacks. The browser draws them as pictures, with the fonts of the system.
//!
//! A line of text is one picture, because egui neither orders nor joins letters from right to left. A text that wraps or
//! is typed has a picture for each letter.

use std::sync::Arc;

use egui::text::{LayoutJob, TextFormat};
use egui::text_edit::TextEditOutput;
use egui::{
    Align2, Color32, ColorImage, Context, FontId, Galley, Id, Pos2, Rect, TextBuffer,
    TextureHandle, Ui, pos2, vec2,
};

use crate::theme;

/// Draws a line of text in white, with letters of so many pixels; `None` if it cannot.
pub type Draw = fn(text: &str, pixels: f32) -> Option<ColorImage>;

/// Empty pixels at both ends of a picture.
pub const MARGIN: u32 = 1;

/// The pictures that are kept.
const MOST_PICTURES: usize = 256;

/// What is laid out in place of a letter, in a size that gives it the width of the letter's picture.
const PLACEHOLDER: &str = "—";

/// A picture of a text, with its scale.
type Picture = (String, f32, TextureHandle);

/// Sets what draws the pictures.
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

/// The letters of a text that the font lacks. egui shows a question mark for each, and counts that as missing too.
pub fn missing(ctx: &Context, text: &str) -> Vec<char> {
    let known = |letter: char| letter == '?' || letter.is_control();
    ctx.fonts_mut(|fonts| {
        let mut is_missing = |letter| !known(letter) && !fonts.has_glyph(&theme::body(), letter);
        text.chars().filter(|&letter| is_missing(letter)).collect()
    })
}

/// Paints a text in `room`, cut at its edges. Returns its rectangle; `None` if egui paints it as well.
pub fn paint(ui: &Ui, room: Rect, align: Align2, text: &str, ink: Color32) -> Option<Rect> {
    if missing(ui.ctx(), text).is_empty() {
        return None;
    }
    let picture = picture(ui.ctx(), text, theme::body().size)?;
    let size = picture.size_vec2() / ui.ctx().pixels_per_point();
    let rect = align.align_size_within_rect(size, room);
    let rect = match rect.width() > room.width() {
        true => rect.translate(room.left_center() - rect.left_center()),
        false => rect,
    };
    show(ui, room, &picture, rect, ink);
    Some(rect.intersect(room))
}

/// A text laid out with room for the letters that the font lacks, and their pictures.
pub struct Letters {
    /// The text; a transparent dash stands in place of each picture.
    pub galley: Arc<Galley>,
    /// Of each glyph of the galley, or of none.
    pictures: Vec<Option<TextureHandle>>,
}

impl Letters {
    fn typed(ui: &Ui, text: &str) -> Letters {
        Letters::of(ui.ctx(), text, &theme::body(), theme::TEXT, f32::INFINITY)
    }

    /// Lays a text out in lines of at most `width`. A long one has no pictures.
    pub fn of(ctx: &Context, text: &str, font: &FontId, ink: Color32, width: f32) -> Letters {
        let simple = TextFormat::simple(font.clone(), ink);
        let missing = missing(ctx, text);
        let mut pictures = Vec::new();
        let mut job = LayoutJob::default();
        job.wrap.max_width = width;
        if missing.is_empty() || missing.len() > MOST_PICTURES {
            job.append(text, 0.0, simple);
        } else {
            let (row, dash) =
                ctx.fonts_mut(|fonts| (fonts.row_height(font), fonts.glyph_width(font, '—')));
            for letter in text.chars() {
                let shown = letter.to_string();
                let is_missing = missing.contains(&letter);
                let picture = is_missing.then(|| picture(ctx, &shown, font.size));
                let picture = picture.flatten();
                let mut format = simple.clone();
                if let Some(picture) = &picture {
                    let pixels = picture.size()[0] as f32 - 2.0 * MARGIN as f32;
                    format.color = Color32::TRANSPARENT;
                    format.line_height = Some(row);
                    format.font_id.size *= pixels / ctx.pixels_per_point() / dash;
                    job.append(PLACEHOLDER, 0.0, format);
                } else {
                    job.append(&shown, 0.0, format);
                }
                // The end of a line has no glyph.
                if letter != '\n' {
                    pictures.push(picture);
                }
            }
        }
        let galley = ctx.fonts_mut(|fonts| fonts.layout_job(job));
        Letters { galley, pictures }
    }

    /// Paints the pictures over the galley, which is at `at`.
    pub fn paint(&self, ui: &Ui, room: Rect, at: Pos2, ink: Color32) {
        let mut pictures = self.pictures.iter();
        for row in &self.galley.rows {
            for (glyph, picture) in row.glyphs.iter().zip(&mut pictures) {
                let Some(picture) = picture else {
                    continue;
                };
                let middle = vec2(glyph.pos.x + glyph.advance_width / 2.0, row.size.y / 2.0);
                let middle = at + row.pos.to_vec2() + middle;
                let size = picture.size_vec2() / ui.ctx().pixels_per_point();
                show(ui, room, picture, Rect::from_center_size(middle, size), ink);
            }
        }
    }
}

/// Lays out what is typed in a field of one line.
pub fn lay_out(ui: &Ui, typed: &dyn TextBuffer, _width: f32) -> Arc<Galley> {
    Letters::typed(ui, typed.as_str()).galley
}

/// Paints the letters of a field that the font lacks.
pub fn paint_typed(ui: &Ui, field: &TextEditOutput, typed: &str) {
    let letters = Letters::typed(ui, typed);
    letters.paint(ui, field.text_clip_rect, field.galley_pos, theme::TEXT);
}

fn show(ui: &Ui, room: Rect, picture: &TextureHandle, rect: Rect, ink: Color32) {
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    let painter = ui.painter_at(room.intersect(ui.clip_rect()));
    painter.image(picture.id(), rect, whole, ink);
}

fn picture(ctx: &Context, text: &str, size: f32) -> Option<TextureHandle> {
    let draw: Draw = ctx.data(|data| data.get_temp(Id::NULL))?;
    let pixels = size * ctx.pixels_per_point();
    let id = Id::new("pictures of texts");
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

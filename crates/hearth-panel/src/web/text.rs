//! Texts that the browser draws, with its own fonts, order and joints of letters.

use egui::ColorImage;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use crate::browser_text::MARGIN;
use crate::system_font::{self, COLUMNS, EM, Letter, ORIGIN, ROWS};
use crate::theme;

/// Height of a line, in sizes of its letters.
const LINE_HEIGHT: f32 = 1.5;

/// The middle of letters, which is below that of their line, in heights of a line.
const MIDDLE: f64 = 0.55;

/// The font of the page.
const FAMILY: &str = "system-ui, sans-serif";

/// The largest difference of an opacity from what was drawn, which some browsers add lest pages recognise them.
const NOISE: u8 = 8;

/// Draws a line of text in white, with letters of so many pixels.
pub fn draw(text: &str, pixels: f32) -> Option<ColorImage> {
    let (canvas, context) = canvas()?;
    let font = format!("{pixels}px {FAMILY}");
    context.set_font(&font);
    let width = context.measure_text(text).ok()?.width().ceil() as u32 + 2 * MARGIN;
    let height = (pixels * LINE_HEIGHT).ceil() as u32;
    canvas.set_width(width);
    canvas.set_height(height);
    // Another size resets the context.
    context.set_font(&font);
    context.set_text_baseline("middle");
    context.set_fill_style_str("white");
    context
        .fill_text(text, MARGIN.into(), MIDDLE * f64::from(height))
        .ok()?;
    let (right, bottom) = (f64::from(width), f64::from(height));
    let data = context.get_image_data(0.0, 0.0, right, bottom).ok()?.data();
    let size = [width as usize, height as usize];
    Some(ColorImage::from_rgba_unmultiplied(size, &data))
}

/// The letters of the panel in the font of the page; `None` where the browser hides what it draws.
pub fn system_font() -> Option<Vec<u8>> {
    let (canvas, context) = canvas()?;
    canvas.set_width(COLUMNS);
    canvas.set_height(ROWS);
    context.set_font(&format!("{EM}px {FAMILY}"));
    let (right, bottom) = (f64::from(COLUMNS), f64::from(ROWS));
    let picture = || {
        let data = context.get_image_data(0.0, 0.0, right, bottom).ok()?.data();
        Some(data.iter().skip(3).step_by(4).copied().collect::<Vec<u8>>())
    };
    context.fill_rect(0.0, 0.0, right, bottom / 2.0);
    let (filled, empty) = picture()?
        .split_at_checked((COLUMNS * ROWS / 2) as usize)
        .map(|(filled, empty)| {
            (
                filled.iter().all(|&opacity| opacity >= 255 - NOISE),
                empty.iter().all(|&opacity| opacity <= NOISE),
            )
        })?;
    if !filled || !empty {
        return None;
    }
    let (left, base) = ORIGIN;
    let letters = theme::letters().map(|letter| {
        let text = letter.to_string();
        context.clear_rect(0.0, 0.0, right, bottom);
        context.fill_text(&text, left.into(), base.into()).ok()?;
        Some(Letter {
            letter,
            advance: context.measure_text(&text).ok()?.width() as f32,
            picture: picture()?,
        })
    });
    let letters: Vec<Letter> = letters.collect::<Option<_>>()?;
    let line = context.measure_text("x").ok()?;
    let [ascent, descent] = [
        line.font_bounding_box_ascent(),
        line.font_bounding_box_descent(),
    ];
    Some(system_font::font(&letters, ascent as f32, descent as f32))
}

/// A canvas that is read as often as it is drawn.
fn canvas() -> Option<(HtmlCanvasElement, CanvasRenderingContext2d)> {
    let document = web_sys::window()?.document()?;
    let canvas: HtmlCanvasElement = document.create_element("canvas").ok()?.dyn_into().ok()?;
    let options = js_sys::Object::new();
    js_sys::Reflect::set(&options, &"willReadFrequently".into(), &JsValue::TRUE).ok()?;
    let context = canvas
        .get_context_with_context_options("2d", &options)
        .ok()??;
    Some((canvas, context.dyn_into().ok()?))
}

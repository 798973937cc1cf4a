//! Texts that the browser draws, with its own fonts, order and joints of letters.

use egui::ColorImage;
use wasm_bindgen::JsCast;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use crate::browser_text::MARGIN;

/// Height of a line, in sizes of its letters.
const LINE_HEIGHT: f32 = 1.5;

/// The middle of letters, which is below that of their line, in heights of a line.
const MIDDLE: f64 = 0.55;

/// Draws a line of text in white, with letters of so many pixels.
pub fn draw(text: &str, pixels: f32) -> Option<ColorImage> {
    let document = web_sys::window()?.document()?;
    let canvas: HtmlCanvasElement = document.create_element("canvas").ok()?.dyn_into().ok()?;
    let context = canvas.get_context("2d").ok()??;
    let context: CanvasRenderingContext2d = context.dyn_into().ok()?;
    let font = format!("{pixels}px system-ui, sans-serif");
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

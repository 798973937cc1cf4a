//! Colours, measures and the font.
//!
//! The panel is darker than the fire beside it and has no animations, so that it does not distract.
//! The font is that of the page (`system_font`). Where the browser hides what it draws, the font is a subset of Ubuntu
//! Light (`font/README.md`).

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use egui::{
    Color32, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, FontTweak, Stroke, Vec2,
};

/// The background of the panel.
pub const GROUND: Color32 = Color32::from_rgb(22, 18, 16);
/// The background of buttons, fields and rails.
pub const RAISED: Color32 = Color32::from_rgb(46, 38, 33);
/// The same under the pointer.
pub const HOVERED: Color32 = Color32::from_rgb(66, 53, 45);
/// The colour of thin lines; lighter where more contrast is preferred.
pub fn line() -> Color32 {
    if CONTRAST.load(Ordering::Relaxed) {
        Color32::from_rgb(190, 176, 164)
    } else {
        Color32::from_rgb(58, 48, 42)
    }
}
/// The colour of text.
pub const TEXT: Color32 = Color32::from_rgb(240, 230, 220);
/// The colour of secondary text: a contrast of 7:1, and the full contrast of text where more
/// contrast is preferred.
pub fn weak() -> Color32 {
    if CONTRAST.load(Ordering::Relaxed) {
        TEXT
    } else {
        Color32::from_rgb(180, 165, 152)
    }
}
/// The accent colour.
pub const ACCENT: Color32 = Color32::from_rgb(255, 146, 64);
/// The accent colour behind text.
pub const EMBER: Color32 = Color32::from_rgb(118, 58, 22);
/// The colour of errors.
pub const ERROR: Color32 = Color32::from_rgb(255, 122, 106);

/// Whether more contrast is preferred.
static CONTRAST: AtomicBool = AtomicBool::new(false);

/// Turns the higher contrast of lines and secondary text on or off.
pub fn prefer_contrast(more: bool) {
    CONTRAST.store(more, Ordering::Relaxed);
}

const FONT: &[u8] = include_bytes!("../font/Ubuntu-Light-derivative-Hearth.ttf");
const FONT_NAME: &str = "Ubuntu Light derivative Hearth";

/// The size of letters of the page's font as a share of the sizes below, which are set for narrow letters.
const SYSTEM_SIZE: f32 = 0.93;

/// The letters that both fonts have, beside those of ASCII.
const LETTERS: &str = "\u{a0}°±²³·¹×÷βρ–—‘’“”•…₀₁₂−";

/// Sizes in points, for a mouse or for a finger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// Height of a line with a label in it.
    pub line: f32,
    /// Height of a slider.
    pub rail: f32,
    /// Height of a button, a field or a switch's row.
    pub control: f32,
    /// Space between rows.
    pub gap: f32,
}

impl Measures {
    /// For a mouse.
    pub const FINE: Measures = Measures {
        line: 20.0,
        rail: 18.0,
        control: 28.0,
        gap: 7.0,
    };
    /// For a finger: every target is at least 36 points high.
    pub const COARSE: Measures = Measures {
        line: 36.0,
        rail: 36.0,
        control: 40.0,
        gap: 8.0,
    };
}

/// The font of ordinary text.
pub fn body() -> FontId {
    FontId::proportional(14.5)
}

/// The font of units, hints and ranges.
pub fn small() -> FontId {
    FontId::proportional(13.0)
}

/// The letters of the panel's own texts, in the order of their codes.
pub fn letters() -> impl Iterator<Item = char> {
    (' '..='~').chain(LETTERS.chars())
}

/// Applies the font of the system, if there is one, and the panel's style to a context.
pub fn apply(ctx: &egui::Context, system: Option<Vec<u8>>) {
    let own = FontData::from_static(FONT);
    let system = system.map(|font| {
        let tweak = FontTweak {
            scale: SYSTEM_SIZE,
            ..FontTweak::default()
        };
        ("system", FontData::from_owned(font).tweak(tweak))
    });
    let mut fonts = FontDefinitions::empty();
    let mut names = Vec::new();
    for (name, font) in system.into_iter().chain([(FONT_NAME, own)]) {
        fonts.font_data.insert(name.to_owned(), Arc::new(font));
        names.push(name.to_owned());
    }
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.insert(family, names.clone());
    }
    ctx.set_fonts(fonts);
    ctx.set_theme(egui::Theme::Dark);
    // A long press is a click, as elsewhere on a page.
    ctx.options_mut(|options| options.input_options.max_click_duration = f64::INFINITY);
    ctx.all_styles_mut(|style| {
        style.override_font_id = Some(body());
        style.animation_time = 0.0;
        style.interaction.tooltip_delay = 0.6;
        style.interaction.selectable_labels = false;
        style.spacing.tooltip_width = 270.0;
        style.spacing.item_spacing = Vec2::new(6.0, 0.0);
        style.spacing.scroll.floating = true;
        style.spacing.scroll.bar_width = 8.0;
        style.spacing.scroll.dormant_handle_opacity = 0.35;

        let visuals = &mut style.visuals;
        visuals.panel_fill = GROUND;
        visuals.window_fill = Color32::from_rgb(34, 28, 24);
        visuals.window_stroke = Stroke::new(1.0, line());
        visuals.extreme_bg_color = Color32::from_rgb(14, 11, 10);
        visuals.override_text_color = Some(TEXT);
        visuals.error_fg_color = ERROR;
        visuals.selection.bg_fill = EMBER;
        visuals.selection.stroke = Stroke::new(1.0, ACCENT);
        visuals.text_cursor.stroke.color = ACCENT;
        let widgets = &mut visuals.widgets;
        for state in [
            &mut widgets.noninteractive,
            &mut widgets.inactive,
            &mut widgets.hovered,
            &mut widgets.active,
            &mut widgets.open,
        ] {
            state.corner_radius = CornerRadius::same(5);
            state.bg_stroke = Stroke::new(1.0, line());
            state.fg_stroke.color = TEXT;
        }
        widgets.active.bg_stroke.color = ACCENT;
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::{DESCRIPTIONS, Kind, PARAMETERS};
    use hearth_core::preset::Preset;

    #[test]
    fn the_font_has_every_character_of_the_parameter_table() {
        let own: String = letters().collect();
        assert!(own.chars().is_sorted());
        let mut texts: Vec<&str> = vec![&own];
        for (param, about) in PARAMETERS.iter().zip(DESCRIPTIONS) {
            texts.extend([param.id, about.group, param.unit, about.label, about.doc]);
            if let Kind::Choice(names) = param.kind {
                texts.extend(names);
            }
        }
        let presets = Preset::all().iter();
        texts
            .extend(presets.flat_map(|preset| [preset.name, preset.label(), preset.description()]));

        let ctx = egui::Context::default();
        apply(&ctx, None);
        let _ = ctx.run(egui::RawInput::default(), |ctx| {
            for text in &texts {
                // egui counts what it shows for a missing one as missing.
                for character in text.chars().filter(|c| !c.is_control() && *c != '?') {
                    assert!(
                        ctx.fonts_mut(|f| f.has_glyph(&body(), character)),
                        "the font lacks {character:?} of {text:?}; see font/README.md"
                    );
                }
            }
        });
    }
}

//! Options that several commands have, and their values.

use std::ffi::OsStr;
use std::io::{Write, stderr};
use std::rc::Rc;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use hearth_core::params::Colour;
use hearth_core::resolution::Level;
use hearth_render::{Camera, Fit, SharedResources, TargetFormat};
use hearth_settings::{Settings, export};

use crate::error::Error;
use crate::painter::{PictureOptions, resources};
use crate::scene::Setting;
use crate::{Fire, Offscreen, json, scene};

/// Longest age of a fire, that of a call of the element [s of fire].
const MAX_SECONDS: f64 = 1000.0;
/// Longest warm-up, that of the element [s of fire].
const MAX_WARM: f64 = 30.0;

/// How a fire burns.
#[derive(Args, Clone)]
pub struct FireOptions {
    /// Sets a parameter; repeat it for others. docs/parameters.md lists all.
    #[arg(long, value_name = "ID=VALUE", value_parser = setting)]
    set: Vec<Setting>,
    /// Seed of the random numbers: the same seed gives the same picture.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    seed: Option<String>,
    /// Level of quality: particles, and resolution of the light.
    #[arg(long, default_value = "high", value_parser = levels())]
    pub quality: Level,
    /// The first seconds of the age burn with few particles, as the element's warm-up.
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = warm_up, allow_negative_numbers = true)]
    warm: f64,
    /// How the domain fits the picture.
    #[arg(long, default_value = "height", value_parser = fits())]
    fit: Fit,
}

/// What is behind the fire of a picture, and what the picture says of it.
#[derive(Args, Clone)]
pub struct PictureOfFire {
    /// What is behind the fire, in place of its wall and ground: #rrggbb, black, white or transparent [default: that of the scene].
    #[arg(long, value_name = "COLOUR", value_parser = background)]
    background: Option<(String, Colour)>,
    /// Writes scene and seed into the file, as a text that is a settings file.
    #[arg(long)]
    describe: bool,
}

/// The values of a fire with nothing behind and under it but that colour.
pub fn bare(background: String) -> Vec<Setting> {
    let none = || "none".to_owned();
    let values = [
        ("background", background),
        ("backdrop", none()),
        ("ground", none()),
    ];
    values.map(|(id, value)| (id.to_owned(), value)).into()
}

impl PictureOfFire {
    /// The values that it sets. As in a film of a page, a background takes the place of the scene's wall and ground.
    pub fn values(&self) -> Vec<Setting> {
        let Some((_, colour)) = &self.background else {
            return Vec::new();
        };
        bare(colour.to_string())
    }

    /// The text of a file.
    pub fn text(&self, settings: &Settings) -> Option<String> {
        self.describe
            .then(|| json::write(&export(settings)).to_string())
    }
}

/// Where it is drawn.
#[derive(Args, Clone, Copy)]
pub struct DriverOptions {
    /// Number of the graphics device, as `hearth info` counts them [default: the first that works].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    device: Option<u16>,
    /// Format of the fields and of the light: half floats, or eight bits with visible steps [default:
    /// rgba16f if the driver has it].
    #[arg(long, value_parser = formats())]
    format: Option<TargetFormat>,
}

impl FireOptions {
    /// The camera.
    pub fn camera(&self) -> Camera {
        Camera {
            fit: self.fit,
            ..Camera::default()
        }
    }

    /// The pictures of that size.
    pub fn picture(&self, size: [u32; 2], supersampling: u32) -> PictureOptions {
        PictureOptions {
            size,
            supersampling,
            level: self.quality,
            camera: self.camera(),
        }
    }

    /// The settings of a scene, with other values beside those of the command line.
    ///
    /// # Errors
    /// There is no such scene, or a value is refused.
    pub fn settings(&self, scene: &OsStr, others: &[Setting]) -> Result<Settings, Error> {
        let seed = self.seed.iter();
        let seed = seed.map(|seed| ("seed".to_owned(), seed.clone()));
        let values: Vec<_> = self.set.iter().chain(others).cloned().chain(seed).collect();
        scene::settings(scene, &values)
    }

    /// What the bits of a fire follow from, besides its settings.
    pub fn burning(&self) -> impl std::fmt::Debug {
        (self.quality.name(), self.warm, self.camera())
    }

    /// A fire of these settings before its first step, for pictures of that size.
    pub fn fire(&self, settings: &Settings, size: [u32; 2]) -> Fire {
        let mut fire = Fire::new(settings.clone(), self.quality, self.warm);
        fire.set_visible_area(size, self.camera());
        fire
    }
}

impl DriverOptions {
    /// A context on this thread, and the resources of its fires.
    ///
    /// # Errors
    /// The machine has no such driver, device or format.
    pub fn open(&self) -> Result<(Offscreen, Rc<SharedResources>), Error> {
        let offscreen = Offscreen::on(self.device.map(usize::from))?;
        let shared = resources(&offscreen, self.format)?;
        Ok((offscreen, shared))
    }

    /// Writes to standard error that pictures have eight bits although nobody asked for them.
    pub fn warn(&self, shared: &SharedResources) {
        if self.format.is_none() && shared.target_format() == TargetFormat::Rgba8 {
            let words = "warning: the driver does not draw into half floats; the light has eight bits, with visible steps";
            // A warning that nobody reads changes nothing.
            let _ = writeln!(stderr(), "{words}");
        }
    }
}

/// A size as `640x360` or `640×360` \[pixels\].
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once(['x', '×', 'X']);
    let side = |text: &str| text.parse().ok().filter(|&side: &u32| side > 0);
    let sides = sides.and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| "it must be a width and a height in pixels, as 1280x720".to_owned())
}

/// An age of a fire \[s\].
pub fn age(text: &str) -> Result<f64, String> {
    seconds(text, MAX_SECONDS)
}

fn warm_up(text: &str) -> Result<f64, String> {
    seconds(text, MAX_WARM)
}

fn seconds(text: &str, max: f64) -> Result<f64, String> {
    let number = text
        .parse()
        .ok()
        .filter(|number| (0.0..=max).contains(number));
    number.ok_or_else(|| format!("it must be a number of seconds from 0 to {max}"))
}

/// An interval between pictures \[s\]: a number, or a fraction as `1/30`.
pub fn interval(text: &str) -> Result<f64, String> {
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    let parts = above.parse::<f64>().ok().zip(below.parse::<f64>().ok());
    let interval = parts.map(|(above, below)| above / below);
    let interval = interval.filter(|interval| *interval > 0.0 && *interval <= MAX_SECONDS);
    interval.ok_or_else(|| {
        format!(
            "it must be a number of seconds above 0, up to {MAX_SECONDS}, or a fraction as 1/30"
        )
    })
}

/// A background: its label and its colour.
pub fn background(text: &str) -> Result<(String, Colour), String> {
    let named = match text.trim() {
        "black" => Some(Colour::rgb(0, 0, 0)),
        "white" => Some(Colour::rgb(255, 255, 255)),
        other => Colour::parse(other),
    };
    let named = named.map(|colour| (text.trim().to_owned(), colour));
    named.ok_or_else(|| {
        "it must be black, white, transparent, or a colour as #888 or #336699".to_owned()
    })
}

fn setting(text: &str) -> Result<Setting, String> {
    let parts = text.split_once('=');
    let parts = parts.map(|(id, value)| (id.trim().to_owned(), value.to_owned()));
    parts.ok_or_else(|| "it must be the id of a parameter and its value, as bloom=0.5".to_owned())
}

/// A parser of one of these names.
pub fn named<T: Clone + Send + Sync + 'static>(
    values: Vec<(&'static str, T)>,
) -> impl TypedValueParser<Value = T> {
    let names = values.iter().map(|(name, _)| *name);
    PossibleValuesParser::new(names).try_map(move |name| {
        let found = values.iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| value.clone()).ok_or("unknown")
    })
}

fn levels() -> impl TypedValueParser<Value = Level> {
    named(Level::ALL.map(|level| (level.name(), level)).to_vec())
}

fn fits() -> impl TypedValueParser<Value = Fit> {
    named(Fit::ALL.to_vec())
}

fn formats() -> impl TypedValueParser<Value = TargetFormat> {
    let formats = [TargetFormat::Rgba16F, TargetFormat::Rgba8];
    named(formats.map(|format| (format.name(), format)).to_vec())
}

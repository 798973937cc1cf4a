//! `hearth sprites`: a sheet of pictures for game engines.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use clap::Args;
use hearth_settings::Settings;

use super::film::rate;
use super::options::{DriverOptions, FireOptions, age, bare, named, size};
use super::progress::{Counter, Progress};
use crate::error::Error;
use crate::film::{Clock, Rate};
use crate::output::Output;
use crate::painter::Painter;
use crate::picture::{Picture, png_of_rgba};
use crate::scene::Setting;
use crate::sprites::atlas::{self, Description};
use crate::sprites::light;
use crate::sprites::motion::{self, Moment};
use crate::sprites::{Grid, bounds, sheet};
use hearth_render::Viewport;

/// Most tiles of a sheet.
const MAX_TILES: i64 = 1024;

/// Arguments of `hearth sprites`.
#[derive(Args)]
#[command(after_help = SHEETS)]
pub struct Sprites {
    /// A preset (`hearth scenes` lists them), a settings file, a page's link, or - for a file on standard input.
    scene: OsString,
    /// The new PNG file; further sheets and the atlas stand beside it.
    #[arg(long, short, value_name = "FILE.png")]
    out: OsString,
    /// Replaces existing files.
    #[arg(long)]
    force: bool,
    /// The sheets: what is seen, its light or its smoke alone, or motion vectors.
    #[arg(long, value_name = "SHEET,…", value_delimiter = ',', default_value = "colour", value_parser = named(Layer::ALL.to_vec()))]
    sheets: Vec<Layer>,
    /// The description that an engine reads: TexturePacker's JSON (PixiJS, Phaser), or a resource of Godot.
    #[arg(long, value_name = "json|tres", value_parser = named(Atlas::ALL.to_vec()))]
    atlas: Option<Atlas>,
    /// Adds columns and rows to the names, as flame_8x4.png, which Unity's importers read.
    #[arg(long)]
    grid_in_name: bool,
    /// Number of tiles.
    #[arg(long, value_name = "N", default_value = "32", value_parser = clap::value_parser!(u32).range(1..=MAX_TILES), allow_negative_numbers = true)]
    count: u32,
    /// Tiles in a row.
    #[arg(long, value_name = "N", default_value = "8", value_parser = clap::value_parser!(u32).range(1..=MAX_TILES), allow_negative_numbers = true)]
    columns: u32,
    /// Pictures a second, as 30, 29.97 or 30000/1001.
    #[arg(long, value_name = "RATE", default_value = "30", value_parser = rate, allow_negative_numbers = true)]
    fps: Rate,
    /// Age of the fire in seconds at the first picture.
    #[arg(long, value_name = "SECONDS", default_value = "3", value_parser = age, allow_negative_numbers = true)]
    from: f64,
    /// Width and height of a tile in pixels.
    #[arg(long, value_name = "W×H", default_value = "128x128", value_parser = size)]
    tile: [u32; 2],
    /// Draws so many pixels for one along each side, and takes the mean of their light.
    #[arg(long, value_name = "1..4", default_value = "2", value_parser = clap::value_parser!(u32).range(1..=4), allow_negative_numbers = true)]
    supersample: u32,
    /// Transparent pixels around each tile.
    #[arg(long, value_name = "PIXELS", default_value = "1", value_parser = clap::value_parser!(u32).range(0..=64), allow_negative_numbers = true)]
    gutter: u32,
    /// Cuts off what is transparent in all tiles.
    #[arg(long)]
    trim: bool,
    /// The sides of the sheet are powers of two.
    #[arg(long)]
    power_of_two: bool,
    /// Colours are multiplied by alpha; otherwise those of the edge go on where nothing is seen.
    #[arg(long)]
    premultiplied: bool,
    #[command(flatten)]
    fire: FireOptions,
    #[command(flatten)]
    driver: DriverOptions,
}

const SHEETS: &str = "\
The first sheet has the name of --out, others have theirs behind it, as flame-motion.png.
Motion vectors lead from a tile to the next one: red to the right, green downwards, 128 is none, and 1 and 255 are the
pixels that the atlas and the last line on standard output state. With them, all sheets show the fire in one plane.";

/// A sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layer {
    Colour,
    Emission,
    Smoke,
    Motion,
}

impl Layer {
    const ALL: [(&'static str, Layer); 4] = [
        ("colour", Layer::Colour),
        ("emission", Layer::Emission),
        ("smoke", Layer::Smoke),
        ("motion", Layer::Motion),
    ];

    fn name(self) -> &'static str {
        let known = Layer::ALL.iter().find(|(_, layer)| *layer == self);
        known.map_or("", |(name, _)| name)
    }

    /// The visible layers of a fire, and nothing else.
    fn values(self) -> Vec<Setting> {
        let layers = match self {
            Layer::Emission => "fire",
            Layer::Smoke => "smoke",
            Layer::Colour | Layer::Motion => return Vec::new(),
        };
        let mut values = bare("transparent".to_owned());
        values.push(("layers".to_owned(), layers.to_owned()));
        values
    }
}

/// A description of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Atlas {
    Json,
    Tres,
}

impl Atlas {
    const ALL: [(&'static str, Atlas); 2] = [("json", Atlas::Json), ("tres", Atlas::Tres)];
}

impl Sprites {
    /// Draws the sheets.
    ///
    /// # Errors
    /// A value is refused, or the driver or the disk fails.
    pub fn run(&self) -> Result<(), Error> {
        let out = Path::new(&self.out);
        let stem = out
            .file_stem()
            .filter(|_| out.extension() == Some("png".as_ref()));
        let Some(stem) = stem else {
            return Err(Error::at_use(out, "a sheet ends with .png"));
        };
        let mut grid = Grid {
            count: self.count,
            columns: self.columns.min(self.count),
            tile: self.tile,
            kept: [0, 0, self.tile[0], self.tile[1]],
            gutter: self.gutter,
            is_power_of_two: self.power_of_two,
        };
        grid.size()?;
        let mut sheets = Vec::new();
        for layer in &self.sheets {
            if !sheets.contains(layer) {
                sheets.push(*layer);
            }
        }
        let sheets: Vec<_> = sheets
            .iter()
            .enumerate()
            .map(|(at, layer)| {
                let name = self.file(stem, (at > 0).then_some(layer.name()), &grid, "png");
                Output::new(&name, self.force).map(|output| (*layer, output))
            })
            .collect::<Result<_, _>>()?;
        let atlas = self.atlas.map(|atlas| {
            let ending = match atlas {
                Atlas::Json => "json",
                Atlas::Tres => "tres",
            };
            let name = self.file(stem, None, &grid, ending);
            Output::new(&name, self.force).map(|output| (atlas, output))
        });
        let atlas = atlas.transpose()?;
        let mut tiles = Vec::new();
        for (layer, _) in &sheets {
            if *layer != Layer::Motion {
                tiles.push((*layer, self.pictures(*layer)?));
            }
        }
        let vectors = match self.has_motion() {
            true => {
                let seen = tiles.iter().find(|(layer, _)| *layer == Layer::Colour);
                let seen = seen.map(|(_, pictures)| pictures.clone());
                self.vectors(&seen.map_or_else(|| self.pictures(Layer::Motion), Ok)?)?
            }
            false => Vec::new(),
        };
        // The one behind the last tile is not on the sheet.
        for (_, pictures) in &mut tiles {
            pictures.truncate(self.count as usize);
        }
        if self.trim {
            let all: Vec<_> = tiles
                .iter()
                .flat_map(|(_, pictures)| pictures)
                .cloned()
                .collect();
            grid.kept = bounds(&all);
        }
        let largest = motion::largest(vectors.iter().flatten());
        let size = grid.size()?;
        for (layer, output) in &sheets {
            let tiles: Vec<_> = match tiles.iter().find(|(known, _)| known == layer) {
                Some((_, pictures)) => pictures.iter().map(|picture| self.bytes(picture)).collect(),
                None => vectors
                    .iter()
                    .map(|vectors| motion::encoded(vectors, largest))
                    .collect(),
            };
            output.write(&png_of_rgba(size, &sheet(&grid, &tiles)?)?)?;
        }
        if let Some((atlas, output)) = atlas {
            let image = self.file(stem, None, &grid, "png");
            let image = image.file_name().unwrap_or_default().to_string_lossy();
            let description = Description {
                image: &image,
                name: &stem.to_string_lossy(),
                grid,
                size,
                rate: self.fps,
                is_premultiplied: self.premultiplied,
                motion: self.has_motion().then_some(largest),
            };
            let text = match atlas {
                Atlas::Json => atlas::json(&description),
                Atlas::Tres => atlas::tres(&description),
            };
            output.write(text.as_bytes())?;
        }
        match self.has_motion() {
            true => crate::output::print(format!("motion: {largest} pixels\n").as_bytes()),
            false => Ok(()),
        }
    }

    fn has_motion(&self) -> bool {
        self.sheets.contains(&Layer::Motion)
    }

    /// The name of a file beside that of `--out`.
    fn file(&self, stem: &OsStr, layer: Option<&str>, grid: &Grid, ending: &str) -> PathBuf {
        let layer = layer.map(|layer| format!("-{layer}")).unwrap_or_default();
        let tiles = match self.grid_in_name {
            true => format!("_{}x{}", grid.columns, grid.rows()),
            false => String::new(),
        };
        let mut name = stem.to_owned();
        name.push(format!("{layer}{tiles}.{ending}"));
        Path::new(&self.out).with_file_name(name)
    }

    /// The bytes of a tile.
    fn bytes(&self, picture: &Picture) -> Vec<u8> {
        match self.premultiplied {
            true => picture.pixels().flatten().collect(),
            false => picture.bled(),
        }
    }

    /// The values of a sheet: motion is that of one plane.
    fn values(&self, layer: Layer) -> Vec<Setting> {
        let mut values = layer.values();
        if self.has_motion() {
            values.push(("depth".to_owned(), "1".to_owned()));
        }
        values
    }

    /// The pictures of a sheet, and the one behind the last if motion leads to it.
    fn pictures(&self, layer: Layer) -> Result<Vec<Picture>, Error> {
        let settings = self.fire.settings(&self.scene, &self.values(layer))?;
        let (offscreen, shared) = self.driver.open()?;
        self.driver.warn(&shared);
        let clock = self.clock(&settings);
        let options = self.fire.picture(self.tile, self.supersample);
        let mut painter = Painter::new(&offscreen, &shared, options)?;
        let mut fire = self.fire.fire(&settings, self.tile);
        let progress = Progress::new(clock.age(self.count));
        progress.name(layer.name());
        let mut counter = Counter::new(&progress);
        let mut pictures = Vec::new();
        for number in 0..self.count + u32::from(self.has_motion()) {
            fire.advance(clock.age(number), &mut |age| counter.at(age));
            pictures.push(painter.paint(&mut fire)?);
        }
        progress.finish();
        Ok(pictures)
    }

    /// The motion vectors from each picture to the next one.
    fn vectors(&self, pictures: &[Picture]) -> Result<Vec<Vec<[f32; 2]>>, Error> {
        let settings = self
            .fire
            .settings(&self.scene, &self.values(Layer::Motion))?;
        let mut fire = self.fire.fire(&settings, self.tile);
        let clock = self.clock(&settings);
        let values = settings.parameters();
        let domain = [values.domain_width, values.domain_height];
        let viewport = Viewport::new(self.tile, domain, self.fire.camera());
        fire.advance(self.from, &mut |_| {});
        let mut before = Moment::of(fire.simulation());
        let mut vectors = Vec::new();
        for (number, pair) in (1..).zip(pictures.windows(2)) {
            fire.advance(clock.age(number), &mut |_| {});
            let now = Moment::of(fire.simulation());
            let gas = before.displacements(&now, viewport, self.tile);
            vectors.push(light::followed(&gas, &pair[0], &pair[1]));
            before = now;
        }
        Ok(vectors)
    }

    /// When the tiles are.
    fn clock(&self, settings: &Settings) -> Clock {
        Clock {
            from: self.from,
            rate: self.fps,
            speed: settings.parameters().time_scale.into(),
        }
    }
}

//! `hearth sheet`: scenes × moments × backgrounds in one picture.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use std::ffi::OsString;

use clap::Args;
use hearth_core::params::Colour;
use hearth_core::preset::Preset;
use hearth_settings::Settings;

use super::options::{DriverOptions, FireOptions, age, background, interval, size};
use super::progress::{Counter, Progress};
use crate::error::{Error, need_memory, shown};
use crate::output::Output;
use crate::painter::Painter;
use crate::picture::{Picture, blended, png_of_rgb};
use crate::{font, scene};

/// Most pixels of a sheet.
const MAX_PIXELS: u64 = 100_000_000;
/// Most pictures of a strip.
const MAX_STRIP: i64 = 240;
/// Most fires that burn at once; a driver in software takes further cores.
const MAX_THREADS: usize = 4;
/// Space around a tile \[pixels\].
const MARGIN: u32 = 2;
/// Columns of a tile from which its label has pixels of two by two.
const LARGE_TILE: u32 = 240;
const PAPER: [u8; 3] = [38, 38, 38];
const INK: [u8; 3] = [235, 235, 235];

/// Arguments of `hearth sheet`.
#[derive(Args)]
pub struct Sheet {
    /// Presets, settings files or links of pages [default: all presets].
    scenes: Vec<OsString>,
    /// Ages of the fires in seconds.
    #[arg(long, value_name = "SECONDS,…", value_delimiter = ',', default_value = "5", value_parser = age, allow_negative_numbers = true)]
    at: Vec<f64>,
    /// Number of pictures from each moment on.
    #[arg(long, value_name = "N", default_value = "1", value_parser = clap::value_parser!(i64).range(1..=MAX_STRIP), allow_negative_numbers = true)]
    strip: i64,
    /// Seconds between the pictures of a strip.
    #[arg(long, value_name = "SECONDS", default_value = "1/30", value_parser = interval, allow_negative_numbers = true)]
    every: f64,
    /// What is behind the fires, their walls and grounds stay: colours as of `hearth render`; the paper of the sheet shows through.
    #[arg(long, value_name = "COLOUR,…", value_delimiter = ',', default_value = "black", value_parser = background)]
    background: Vec<(String, Colour)>,
    /// Tiles in a row [default: those of a scene].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), allow_negative_numbers = true)]
    columns: Option<u32>,
    /// Width and height of a tile in pixels.
    #[arg(long, value_name = "W×H", default_value = "320x240", value_parser = size)]
    tile: [u32; 2],
    /// Draws so many pixels for one along each side, and takes the mean of their light.
    #[arg(long, value_name = "1..4", default_value = "1", value_parser = clap::value_parser!(u32).range(1..=4), allow_negative_numbers = true)]
    supersample: u32,
    /// The new PNG file, or - for standard output.
    #[arg(long, short, value_name = "FILE")]
    out: OsString,
    /// Replaces an existing file.
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    fire: FireOptions,
    #[command(flatten)]
    driver: DriverOptions,
}

/// Pictures of a scene, each with its age \[s\].
type Row = Vec<(f64, Picture)>;

impl Sheet {
    /// Draws the sheet.
    ///
    /// # Errors
    /// A value is refused, or the driver or the disk fails.
    pub fn run(&self) -> Result<(), Error> {
        let presets = Preset::all()
            .iter()
            .map(|preset| OsString::from(preset.name));
        let scenes = match self.scenes.is_empty() {
            true => presets.collect(),
            false => self.scenes.clone(),
        };
        if scenes.iter().filter(|scene| *scene == "-").count() > 1 {
            let words = "standard input (-) is one scene, and is named twice";
            return Err(Error::Use(words.to_owned()));
        }
        let moments = self.moments();
        let of_scene = moments.len() as u64 * self.background.len() as u64;
        let layout = Layout::new(self, of_scene, scenes.len() as u64 * of_scene)?;
        let output = Output::of_png(&self.out, self.force)?;
        let [width, height] = layout.size.map(|side| side as usize);
        need_memory(2 * 3 * width * height)?;
        // Every scene is checked before the first burns.
        let checked = scenes.iter().map(|scene| self.fire.settings(scene, &[]));
        let settings = checked.collect::<Result<Vec<_>, _>>()?;
        let rows = self.rows(&scenes, &settings, &moments)?;
        let mut canvas = Canvas::new(layout);
        let mut tile = 0;
        for (scene, row) in scenes.iter().zip(rows) {
            for (moment, picture) in row {
                for (name, colour) in &self.background {
                    let label = format!("{} {}", scene::label(scene), seconds(moment));
                    let label = match self.background.len() {
                        1 => label,
                        _ => format!("{label} {name}"),
                    };
                    canvas.draw(tile, &picture, over_paper(*colour), &label);
                    tile += 1;
                }
            }
        }
        let [width, height] = layout.size;
        output.write(&png_of_rgb(width, height, &canvas.rgb)?)
    }

    /// The ages of the pictures of a scene, in order \[s\].
    fn moments(&self) -> Vec<f64> {
        let strips = self.at.iter().flat_map(|start| {
            (0..self.strip).map(move |picture| start + picture as f64 * self.every)
        });
        let mut moments: Vec<_> = strips.collect();
        moments.sort_by(f64::total_cmp);
        moments.dedup();
        moments
    }

    /// The pictures of all scenes. Each thread has a context, and takes the next scene.
    fn rows(
        &self,
        scenes: &[OsString],
        settings: &[Settings],
        moments: &[f64],
    ) -> Result<Vec<Row>, Error> {
        let last = moments.last().copied().unwrap_or(0.0);
        let progress = Progress::new(last * scenes.len() as f64);
        let (next, rows) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let work = |warns: bool| -> Result<(), Error> {
            let (offscreen, shared) = self.driver.open()?;
            if warns {
                self.driver.warn(&shared);
            }
            loop {
                let number = next.fetch_add(1, Ordering::Relaxed);
                let Some((scene, settings)) = scenes.get(number).zip(settings.get(number)) else {
                    return Ok(());
                };
                progress.name(&shown(scene));
                let options = self.fire.picture(self.tile, self.supersample);
                let mut painter = Painter::new(&offscreen, &shared, options)?;
                let mut fire = self.fire.fire(settings, self.tile);
                let mut counter = Counter::new(&progress);
                let mut row = Row::new();
                for &moment in moments {
                    fire.burn(moment, &mut |age| counter.at(age));
                    row.push((moment, painter.paint(&mut fire)?));
                }
                let mut rows = rows.lock().unwrap_or_else(PoisonError::into_inner);
                rows.push((number, row));
            }
        };
        let done = thread::scope(|scope| {
            let (work, next) = (&work, &next);
            let threads = 0..cores.min(scenes.len()).min(MAX_THREADS);
            let start = |thread| {
                thread::Builder::new().spawn_scoped(scope, move || {
                    let done = work(thread == 0);
                    if done.is_err() {
                        // The others finish their scenes, and take no more.
                        next.store(scenes.len(), Ordering::Relaxed);
                    }
                    done
                })
            };
            // Fewer threads draw the same pictures.
            let threads: Vec<_> = threads.map_while(|thread| start(thread).ok()).collect();
            if threads.is_empty() {
                return vec![Ok(work(true))];
            }
            threads
                .into_iter()
                .map(|thread| thread.join())
                .collect::<Vec<_>>()
        });
        progress.finish();
        for done in done {
            done.map_err(|_| Error::Failed("a thread ended without its pictures".to_owned()))??;
        }
        let mut rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
        rows.sort_by_key(|(number, _)| *number);
        Ok(rows.into_iter().map(|(_, row)| row).collect())
    }
}

/// A background over the paper.
fn over_paper(colour: Colour) -> [u8; 3] {
    let [r, g, b, alpha] = colour.rgba.map(u32::from);
    let over = |value: u32| (value * alpha / 255) as u8;
    blended([over(r), over(g), over(b), alpha as u8], PAPER)
}

/// Seconds of a label, with at most three decimals.
fn seconds(time: f64) -> String {
    let text = format!("{time:.3}");
    format!("{} s", text.trim_end_matches('0').trim_end_matches('.'))
}

/// Where the tiles of a sheet are.
#[derive(Clone, Copy)]
struct Layout {
    size: [u32; 2],
    tile: [u32; 2],
    columns: u32,
    /// Side of a label's pixel.
    scale: u32,
}

impl Layout {
    /// The layout of `tiles` tiles, of which a scene has `of_scene`.
    fn new(sheet: &Sheet, of_scene: u64, tiles: u64) -> Result<Layout, Error> {
        let scale = if sheet.tile[0] >= LARGE_TILE { 2 } else { 1 };
        let columns = u64::from(sheet.columns.unwrap_or(u32::MAX)).min(match sheet.columns {
            Some(_) => tiles,
            None => of_scene,
        });
        let layout = Layout {
            size: [0; 2],
            tile: sheet.tile,
            columns: columns as u32,
            scale,
        };
        let [width, height] = layout.cell().map(u64::from);
        let (width, height) = (columns * width, tiles.div_ceil(columns) * height);
        if width.saturating_mul(height) > MAX_PIXELS {
            return Err(Error::Use(format!(
                "the sheet has {width} x {height} pixels; it may have {MAX_PIXELS} in all"
            )));
        }
        Ok(Layout {
            size: [width as u32, height as u32],
            ..layout
        })
    }

    /// Width and height of a tile with its label and margin.
    fn cell(&self) -> [u32; 2] {
        let label = (font::SIZE[1] + 2) * self.scale;
        let [width, height] = self.tile;
        [
            width.saturating_add(2 * MARGIN),
            height.saturating_add(2 * MARGIN + label),
        ]
    }
}

/// The pixels of a sheet.
struct Canvas {
    layout: Layout,
    rgb: Vec<u8>,
}

impl Canvas {
    fn new(layout: Layout) -> Canvas {
        let [width, height] = layout.size;
        Canvas {
            layout,
            rgb: PAPER.repeat(width as usize * height as usize),
        }
    }

    fn set(&mut self, [x, y]: [u32; 2], colour: [u8; 3]) {
        let at = (y as usize * self.layout.size[0] as usize + x as usize) * 3;
        if let Some(pixel) = self.rgb.get_mut(at..at + 3) {
            pixel.copy_from_slice(&colour);
        }
    }

    /// Draws the tile of that number over a colour, with its label above.
    fn draw(&mut self, number: u32, picture: &Picture, behind: [u8; 3], label: &str) {
        let Layout {
            tile: [width, height],
            columns,
            scale,
            ..
        } = self.layout;
        let cell = self.layout.cell();
        let left = number % columns * cell[0] + MARGIN;
        let top = number / columns * cell[1] + MARGIN;
        for [x, y] in font::pixels(label) {
            for (right, down) in (0..scale * scale).map(|at| (at % scale, at / scale)) {
                let column = x * scale + right;
                if column < width {
                    self.set([left + column, top + y * scale + down], INK);
                }
            }
        }
        let top = top + cell[1] - height - 2 * MARGIN;
        for (pixel, at) in picture.pixels().zip(0..width * height) {
            self.set(
                [left + at % width, top + at / width],
                blended(pixel, behind),
            );
        }
    }
}

//! The samples of a history on the graphics card: a ring of rows of one texture.

use crate::constants::{PARTICLES_PER_ROW, TEXELS_PER_PARTICLE};
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::history::{History, Sample};
use crate::target::{bind, texture};

/// Half floats of a row.
const HALVES_PER_ROW: usize = PARTICLES_PER_ROW * TEXELS_PER_PARTICLE * 4;

/// Where a sample is.
struct Place {
    /// Number of the sample.
    number: u64,
    /// Its first row and number of rows.
    rows: [u32; 2],
}

/// The texture of a history. It grows with the history.
pub struct Ring<G: Graphics> {
    texture: Option<G::Texture>,
    /// Rows of the texture, and their maximum.
    rows: u32,
    max_rows: u32,
    /// The row after the newest sample.
    head: u32,
    places: Vec<Place>,
}

impl<G: Graphics> Ring<G> {
    /// A ring without a texture, which grows up to `max_rows` rows.
    pub fn new(max_rows: u32) -> Ring<G> {
        Ring {
            texture: None,
            rows: 0,
            max_rows,
            head: 0,
            places: Vec::new(),
        }
    }

    /// Uploads the samples that are new.
    pub fn upload(&mut self, gl: &G, history: &History) -> Result<(), RenderError> {
        let rows = |sample: &Sample| sample.count.div_ceil(PARTICLES_PER_ROW) as u32;
        let samples = history.samples();
        let largest = samples.iter().map(rows).max().unwrap_or(0);
        // The last rows stay empty if the next sample does not fit there.
        let needed = samples.iter().map(rows).sum::<u32>() + 2 * largest;
        if needed > self.rows && self.rows < self.max_rows {
            self.allocate(gl, (needed + needed / 8).min(self.max_rows))?;
        }
        let Some(texture) = &self.texture else {
            return Ok(());
        };
        let known = self.places.last().map(|place| place.number);
        for sample in samples
            .iter()
            .filter(|sample| known.is_none_or(|known| sample.number > known))
        {
            let count = rows(sample);
            if count > self.rows {
                continue;
            }
            let first = if self.head + count > self.rows {
                0
            } else {
                self.head
            };
            self.head = first + count;
            let is_apart =
                |&Place {
                     rows: [other, count],
                     ..
                 }: &Place| { other >= self.head || other + count <= first };
            self.places.retain(is_apart);
            self.places.push(Place {
                number: sample.number,
                rows: [first, count],
            });
            bind(gl, 0, texture);
            replace_rows(gl, first, &sample.texels);
        }
        Ok(())
    }

    /// Replaces the texture by an empty one of so many rows.
    fn allocate(&mut self, gl: &G, rows: u32) -> Result<(), RenderError> {
        self.destroy(gl);
        gl.active_texture(0);
        let made = texture(gl, "gas", glow::CLAMP_TO_EDGE)?;
        let width = (PARTICLES_PER_ROW * TEXELS_PER_PARTICLE) as u32;
        let (internal, kind) = TargetFormat::Rgba16F.constants();
        gl.allocate_texture(internal, kind, [width, rows]);
        self.texture = Some(made);
        (self.rows, self.head) = (rows, 0);
        self.places.clear();
        Ok(())
    }

    /// The first row of a sample.
    pub fn row(&self, sample: &Sample) -> Option<u32> {
        let mut places = self.places.iter();
        places
            .find(|place| place.number == sample.number)
            .map(|place| place.rows[0])
    }

    /// The texture.
    pub fn texture(&self) -> Option<&G::Texture> {
        self.texture.as_ref()
    }

    /// Frees the texture.
    pub fn destroy(&mut self, gl: &G) {
        if let Some(texture) = self.texture.take() {
            gl.delete_texture(&texture);
        }
    }
}

/// Replaces rows of the bound texture from `first` on; the last one need not be full.
fn replace_rows<G: Graphics>(gl: &G, first: u32, texels: &[u16]) {
    let (full, rest) = texels.split_at(texels.len() / HALVES_PER_ROW * HALVES_PER_ROW);
    let full_rows = (full.len() / HALVES_PER_ROW) as u32;
    let size = [full, rest].map(|part| (part.len().min(HALVES_PER_ROW) / 4) as u32);
    if !full.is_empty() {
        gl.replace_halves([0, first], [size[0], full_rows], full);
    }
    if !rest.is_empty() {
        gl.replace_halves([0, first + full_rows], [size[1], 1], rest);
    }
}

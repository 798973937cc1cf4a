//! Animated PNG.

use std::io;

use super::{Encoder, Header, Plays};
use crate::error::Error;
use crate::output::Output;
use crate::picture::{Picture, describe};

/// Writes the film into memory, and then the file.
pub struct Apng {
    output: Output,
    writer: png::Writer<Shared>,
    file: Shared,
}

/// Bytes that the writer fills and the film takes.
#[derive(Clone, Default)]
struct Shared(std::rc::Rc<std::cell::RefCell<Vec<u8>>>);

impl io::Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn failed(error: png::EncodingError) -> Error {
    Error::at("APNG", error)
}

impl Apng {
    pub fn new(output: Output, header: Header) -> Result<Apng, Error> {
        let file = Shared::default();
        let [width, height] = header.size;
        let mut encoder = png::Encoder::new(file.clone(), width, height);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        describe(&mut encoder, header.text.as_deref()).map_err(failed)?;
        let plays = match header.plays {
            Plays::Once => 1,
            Plays::Forever => 0,
        };
        encoder.set_animated(header.count, plays).map_err(failed)?;
        let (seconds, pictures) = (header.rate.seconds, header.rate.pictures);
        let delay = u16::try_from(seconds)
            .ok()
            .zip(u16::try_from(pictures).ok());
        let (seconds, pictures) = delay.unwrap_or((
            (header.rate.time(1) * 60_000.0).round().min(65_535.0) as u16,
            60_000,
        ));
        encoder.set_frame_delay(seconds, pictures).map_err(failed)?;
        // The next picture replaces the last one.
        encoder.set_blend_op(png::BlendOp::Source).map_err(failed)?;
        let writer = encoder.write_header().map_err(failed)?;
        Ok(Apng {
            output,
            writer,
            file,
        })
    }
}

impl Encoder for Apng {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        self.writer
            .write_image_data(&picture.straight())
            .map_err(failed)
    }

    fn finish(self: Box<Self>) -> Result<(), Error> {
        self.writer.finish().map_err(failed)?;
        let file = self.file.0.take();
        self.output.write(&file)
    }
}

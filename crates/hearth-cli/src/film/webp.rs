//! Animated WebP: colours with little loss, and exact alpha.

use webp_animation::{
    AnimParams, Encoder as WebPEncoder, EncoderOptions, EncodingConfig, EncodingType,
};

use super::{Encoder, Header, Plays};
use crate::error::Error;
use crate::output::Output;
use crate::picture::Picture;

/// Times are in milliseconds.
const PER_SECOND: f64 = 1000.0;
/// Quality of colours with loss, of 100.
const QUALITY: f32 = 90.0;

/// Writes the film into memory, and then the file.
pub struct WebP {
    output: Output,
    header: Header,
    encoder: WebPEncoder,
    next: u32,
}

fn failed(error: webp_animation::Error) -> Error {
    Error::at("WebP", format!("{error:?}"))
}

impl WebP {
    pub fn new(output: Output, header: Header) -> Result<WebP, Error> {
        let [width, height] = header.size;
        let options = EncoderOptions {
            anim_params: AnimParams {
                loop_count: match header.plays {
                    Plays::Once => 1,
                    Plays::Forever => 0,
                },
            },
            encoding_config: Some(match header.is_lossless {
                true => EncodingConfig {
                    encoding_type: EncodingType::Lossless,
                    ..EncodingConfig::default()
                },
                false => EncodingConfig::new_lossy(QUALITY),
            }),
            ..EncoderOptions::default()
        };
        let encoder = WebPEncoder::new_with_options((width, height), options).map_err(failed)?;
        Ok(WebP {
            output,
            header,
            encoder,
            next: 0,
        })
    }

    /// Time of a picture \[ms\].
    fn time(&self, number: u32) -> i32 {
        self.header.rate.ticks(number, PER_SECOND) as i32
    }
}

/// A file with a text: XMP, whose flag is in the first chunk.
fn described(mut file: Vec<u8>, text: &str) -> Vec<u8> {
    const FLAGS: usize = 20;
    let escaped = text.replace('&', "&amp;").replace('<', "&lt;");
    let mut chunk = format!(
        "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\
         <rdf:Description xmlns:dc=\"http://purl.org/dc/elements/1.1/\"><dc:description>{escaped}</dc:description>\
         </rdf:Description></rdf:RDF></x:xmpmeta>"
    )
    .into_bytes();
    let length = chunk.len() as u32;
    if chunk.len() % 2 == 1 {
        chunk.push(0);
    }
    if let Some(flags) = file.get_mut(FLAGS) {
        *flags |= 4;
    }
    file.extend(b"XMP ");
    file.extend(length.to_le_bytes());
    file.extend(chunk);
    let size = (file.len() as u32 - 8).to_le_bytes();
    file.get_mut(4..8)
        .into_iter()
        .for_each(|field| field.copy_from_slice(&size));
    file
}

impl Encoder for WebP {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        let time = self.time(self.next);
        self.next += 1;
        self.encoder
            .add_frame(&picture.bled(), time)
            .map_err(failed)
    }

    fn finish(self: Box<Self>) -> Result<(), Error> {
        let end = self.time(self.next);
        let file = self.encoder.finalize(end).map_err(failed)?;
        self.output.write(&match &self.header.text {
            None => file.to_vec(),
            Some(text) => described(file.to_vec(), text),
        })
    }
}

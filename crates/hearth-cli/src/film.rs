//! Films: pictures of a fire at exact moments, in a file format of their own.

mod apng;
mod archive;
pub mod checkpoint;
mod ffmpeg;
mod gif;
pub mod seam;
pub mod sound;
mod webp;

use std::ffi::OsStr;

use crate::error::Error;
use crate::output::{self, Output};
use crate::picture::Picture;

/// Most bytes of a film that is kept in memory until its end.
const MAX_BYTES: u64 = 2 << 30;

/// The file format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A folder with a PNG file for each picture, or PNG files one after another on standard output.
    Png,
    /// A zip archive of PNG files.
    Zip,
    /// Animated PNG.
    Apng,
    /// Animated WebP: colours with little loss, exact alpha.
    WebP,
    /// Animated GIF: 255 colours, and alpha of one bit.
    Gif,
    /// VP9 in WebM, by `ffmpeg`.
    WebM,
    /// H.264 in MP4, by `ffmpeg`: opaque.
    Mp4,
    /// The sound alone, as WAV.
    Wav,
    /// Bytes of red, green, blue and straight alpha, rows from the top, without a header.
    Rgba,
}

impl Format {
    /// All, by their names.
    pub const ALL: [(&'static str, Format); 9] = [
        ("png", Format::Png),
        ("zip", Format::Zip),
        ("apng", Format::Apng),
        ("webp", Format::WebP),
        ("gif", Format::Gif),
        ("webm", Format::WebM),
        ("mp4", Format::Mp4),
        ("wav", Format::Wav),
        ("rgba", Format::Rgba),
    ];

    /// The format of a file of that name. A name without an ending is a folder.
    pub fn of_name(name: &str) -> Option<Format> {
        let file = name.rsplit(['/', '\\']).next().unwrap_or_default();
        match file.rsplit_once('.') {
            None => Some(Format::Png),
            Some((_, ending)) => {
                let ending = ending.to_ascii_lowercase();
                // A picture that moves has the ending of one that does not.
                let name = if ending == "png" { "apng" } else { &ending };
                let mut all = Format::ALL.iter();
                all.find(|(known, _)| *known == name)
                    .map(|(_, format)| *format)
            }
        }
    }
}

/// What a film is: the same in each part of it.
#[derive(Clone, Debug)]
pub struct Header {
    /// Width and height \[pixels\].
    pub size: [u32; 2],
    /// Pictures a second.
    pub rate: Rate,
    /// Number of the first picture.
    pub first: u32,
    /// Number of pictures.
    pub count: u32,
    /// How often it plays.
    pub plays: Plays,
    /// Whether colours are exact in WebP, WebM and MP4.
    pub is_lossless: bool,
    /// Whether nothing of it is transparent.
    pub is_opaque: bool,
    /// Whether alpha is a grey below each picture of MP4.
    pub is_stacked: bool,
    /// A text about the fire.
    pub text: Option<String>,
}

/// How often a film plays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plays {
    /// Once.
    Once,
    /// For ever.
    Forever,
}

/// Pictures a second, as a fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rate {
    /// Pictures.
    pub pictures: u32,
    /// In so many seconds.
    pub seconds: u32,
}

impl Rate {
    /// Time of the picture of that number \[s\].
    pub fn time(self, number: u32) -> f64 {
        f64::from(number) * f64::from(self.seconds) / f64::from(self.pictures)
    }

    /// Time of the picture of that number in units of which a second has so many, rounded.
    fn ticks(self, number: u32, per_second: f64) -> i64 {
        (self.time(number) * per_second).round() as i64
    }
}

/// When the pictures of a film are. A film plays as fast as the element does.
#[derive(Clone, Copy, Debug)]
pub struct Clock {
    /// Age of the fire at the first picture \[s\].
    pub from: f64,
    /// Pictures a second.
    pub rate: Rate,
    /// The parameter `time_scale`: seconds of fire in a second of the film.
    pub speed: f64,
}

impl Clock {
    /// Age of the fire at the picture of that number \[s\].
    pub fn age(&self, number: u32) -> f64 {
        self.from + self.elapsed(number)
    }

    /// Time of fire in that many pictures \[s\].
    pub fn elapsed(&self, pictures: u32) -> f64 {
        self.rate.time(pictures) * self.speed
    }
}

/// Receives the pictures of a film in order.
pub trait Encoder {
    /// Takes the next picture.
    ///
    /// # Errors
    /// The disk, the reader of standard output or the encoder takes no more.
    fn add(&mut self, picture: &Picture) -> Result<(), Error>;

    /// Writes what is left. Without it, a file has not been written.
    ///
    /// # Errors
    /// As for a picture.
    fn finish(self: Box<Self>) -> Result<(), Error>;
}

/// The encoder of a film, with the WAV file of its sound if it has one.
///
/// # Errors
/// The output is not free, or the film needs more memory than it may have.
pub fn encoder(
    format: Format,
    name: &OsStr,
    replace: bool,
    header: Header,
    sound: Option<Vec<u8>>,
) -> Result<Box<dyn Encoder>, Error> {
    if name == "-" {
        return match format {
            Format::Png | Format::Rgba => {
                Output::new(name, replace)?;
                Ok(Box::new(Pipe(format, header.text)))
            }
            Format::WebM | Format::Mp4 => Err(Error::Use(
                "ffmpeg writes WebM and MP4 into a file: name one".to_owned(),
            )),
            _ => file(format, Output::new(name, replace)?, header, sound),
        };
    }
    match format {
        Format::Png => Ok(Box::new(archive::Folder::new(name, replace, header)?)),
        _ => file(format, Output::new(name, replace)?, header, sound),
    }
}

/// The encoder of a film in a file.
fn file(
    format: Format,
    output: Output,
    header: Header,
    sound: Option<Vec<u8>>,
) -> Result<Box<dyn Encoder>, Error> {
    let [width, height] = header.size.map(u64::from);
    let kept = match format {
        Format::Gif => width * height * u64::from(header.count) * 4,
        _ => 0,
    };
    if kept > MAX_BYTES {
        return Err(Error::Use(format!(
            "the film would take {} MB of memory; it may take {} MB: make it smaller or shorter",
            kept >> 20,
            MAX_BYTES >> 20,
        )));
    }
    Ok(match format {
        Format::Zip => Box::new(archive::Archive::new(output, header)),
        Format::Apng => Box::new(apng::Apng::new(output, header)?),
        Format::WebP => Box::new(webp::WebP::new(output, header)?),
        Format::Gif => Box::new(gif::Gif::new(output, header)),
        Format::WebM | Format::Mp4 => Box::new(ffmpeg::Ffmpeg::new(format, output, header, sound)?),
        Format::Png | Format::Rgba | Format::Wav => Box::new(Raw(output, Vec::new())),
    })
}

/// Pictures one after another on standard output.
struct Pipe(Format, Option<String>);

impl Encoder for Pipe {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        match self.0 {
            Format::Png => output::print(&picture.png(self.1.as_deref())?),
            _ => output::print(&picture.straight()),
        }
    }

    fn finish(self: Box<Self>) -> Result<(), Error> {
        Ok(())
    }
}

/// Pictures one after another in a file, without a header.
struct Raw(Output, Vec<u8>);

impl Encoder for Raw {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        self.1.extend(picture.straight());
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), Error> {
        self.0.write(&self.1)
    }
}

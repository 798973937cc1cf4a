//! WebM and MP4, by the program `ffmpeg`. It reads pictures from its standard input and writes one file.

use std::ffi::OsString;
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStderr, ChildStdin, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};

use hearth_core::params::printable;

use super::{Encoder, Format, Header};
use crate::error::Error;
use crate::output::{self, Output};
use crate::picture::Picture;

const PROGRAM: &str = "ffmpeg";
/// Longest end of what the program has said, in an error \[bytes\].
const LAST_WORDS: usize = 300;

/// The program that runs, the file that it writes, and that of the sound which it reads.
static RUNNING: Mutex<Option<(Child, [PathBuf; 2])>> = Mutex::new(None);

fn running() -> MutexGuard<'static, Option<(Child, [PathBuf; 2])>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the program, and removes what it has written.
fn abandon() {
    if let Some((mut child, files)) = running().take() {
        // Both have happened already after a film that is whole.
        let _ = child.kill();
        let _ = child.wait();
        for file in files {
            let _ = fs::remove_file(file);
        }
    }
}

/// Sends the pictures of a film to `ffmpeg`.
pub struct Ffmpeg {
    output: Output,
    input: Option<ChildStdin>,
    errors: Option<ChildStderr>,
    alpha: Alpha,
}

/// What becomes of alpha.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Alpha {
    /// The film has its own.
    Own,
    /// It is a grey below the picture.
    Stacked,
    /// There is none.
    None,
}

/// The arguments: a list, which no shell reads.
fn arguments(format: Format, header: &Header, part: &Path, sound: Option<&Path>) -> Vec<OsString> {
    let [width, height] = header.size;
    let height = height << u32::from(header.is_stacked);
    let rate = format!("{}/{}", header.rate.pictures, header.rate.seconds);
    let size = format!("{width}x{height}");
    let input = format!(
        "-hide_banner -loglevel error -nostdin -y -f rawvideo -pix_fmt rgba -s {size} -r {rate} -i pipe:0"
    );
    let video = "-vf scale=out_color_matrix=bt709:out_range=tv";
    let audio = match (sound, format) {
        (None, _) => "",
        (_, Format::Mp4) => "-c:a aac -b:a 192k -flags:a +bitexact",
        _ => "-c:a libopus -b:a 160k -flags:a +bitexact",
    };
    let codec = match (format, header.is_lossless) {
        // Alpha as a grey has sharp edges.
        (Format::Mp4, false) if header.is_stacked => {
            "-f mp4 -c:v libx264 -crf 4 -pix_fmt yuv420p -movflags +faststart"
        }
        (Format::Mp4, false) => "-f mp4 -c:v libx264 -crf 14 -pix_fmt yuv420p -movflags +faststart",
        (Format::Mp4, true) => "-f mp4 -c:v libx264 -qp 0 -pix_fmt yuv444p -movflags +faststart",
        // From 2 on, alpha differs by more than 3 of 255.
        (_, false) if !header.is_opaque => {
            "-f webm -c:v libvpx-vp9 -crf 1 -b:v 0 -pix_fmt yuva420p -auto-alt-ref 0"
        }
        (_, false) => "-f webm -c:v libvpx-vp9 -crf 10 -b:v 0 -pix_fmt yuv420p",
        (_, true) => "-f webm -c:v libvpx-vp9 -lossless 1 -pix_fmt yuva420p -auto-alt-ref 0",
    };
    // The same pictures give the same bytes, and the file contains no version and no time.
    let exact = "-colorspace bt709 -color_primaries bt709 -color_trc bt709 -threads 1 -fflags +bitexact \
                 -flags:v +bitexact -map_metadata -1";
    let words = |words: &str| {
        words
            .split_whitespace()
            .map(OsString::from)
            .collect::<Vec<_>>()
    };
    let file = |path: &Path| {
        let mut name = OsString::from("file:");
        name.push(path);
        name
    };
    let sound = sound.map(|path| [words("-i"), vec![file(path)]].concat());
    let text = header.text.iter();
    let text = text.flat_map(|text| ["-metadata".into(), format!("comment={text}").into()]);
    [
        words(&input),
        sound.unwrap_or_default(),
        words(video),
        words(codec),
        words(audio),
        words(exact),
        text.collect(),
        vec![file(part)],
    ]
    .concat()
}

impl Ffmpeg {
    pub fn new(
        format: Format,
        output: Output,
        header: Header,
        sound: Option<Vec<u8>>,
    ) -> Result<Ffmpeg, Error> {
        let part = output.part().ok_or_else(|| {
            Error::Use(
                "ffmpeg writes WebM and MP4 into a file: name one that is no device".to_owned(),
            )
        })?;
        let alpha = match format {
            Format::Mp4 if header.is_stacked => Alpha::Stacked,
            Format::Mp4 => Alpha::None,
            _ => Alpha::Own,
        };
        let [width, height] = header.size;
        if alpha != Alpha::Own && (width % 2 != 0 || height % 2 != 0) {
            return Err(Error::Use(format!(
                "MP4 has an even width and height, and the film has {width} x {height}"
            )));
        }
        let heard = part.with_extension("wav");
        if let Some(sound) = &sound {
            fs::write(&heard, sound).map_err(|error| Error::at(&heard, error))?;
        }
        let heard_path = sound.is_some().then_some(&*heard);
        let mut child = Command::new(PROGRAM)
            .args(arguments(format, &header, &part, heard_path))
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| {
                let _ = fs::remove_file(&heard);
                Error::Failed(format!(
                    "{PROGRAM}, which writes WebM and MP4, does not start: {error}; \
                     apng, webp, gif and zip need no other program"
                ))
            })?;
        let (input, errors) = (child.stdin.take(), child.stderr.take());
        output::at_end(abandon);
        *running() = Some((child, [part, heard]));
        Ok(Ffmpeg {
            output,
            input,
            errors,
            alpha,
        })
    }

    /// The error of a program that has ended: what it said last.
    fn last_words(&mut self) -> Error {
        let mut said = String::new();
        if let Some(errors) = &mut self.errors {
            // It has closed its input, so it ends.
            let _ = errors.read_to_string(&mut said);
        }
        let said = printable(said.trim());
        let start = said.len().saturating_sub(LAST_WORDS);
        let start = (start..said.len()).find(|&at| said.is_char_boundary(at));
        let end = said.get(start.unwrap_or(0)..).unwrap_or_default();
        Error::Failed(format!("{PROGRAM} failed: {end}"))
    }
}

impl Encoder for Ffmpeg {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        let bytes = match self.alpha {
            Alpha::Own => picture.bled(),
            Alpha::Stacked => picture.stacked(),
            Alpha::None if picture.pixels().any(|pixel| pixel[3] != 255) => {
                return Err(Error::Use(
                    "MP4 has no alpha, and the fire is transparent: name a --background, --stacked-alpha, or one of \
                     webm, webp and apng"
                        .to_owned(),
                ));
            }
            Alpha::None => picture.straight(),
        };
        let written = self.input.as_mut().map(|input| input.write_all(&bytes));
        match written {
            Some(Err(_)) => Err(self.last_words()),
            _ => Ok(()),
        }
    }

    fn finish(mut self: Box<Self>) -> Result<(), Error> {
        // The end of its input is the end of the film.
        drop(self.input.take());
        let ended = running().as_mut().map(|(child, _)| child.wait());
        if !ended.is_some_and(|ended| ended.is_ok_and(|status| status.success())) {
            return Err(self.last_words());
        }
        let part = running().as_ref().map(|(_, [part, _])| part.clone());
        part.map_or(Ok(()), |part| self.output.take(&part))
    }
}

impl Drop for Ffmpeg {
    fn drop(&mut self) {
        abandon();
    }
}

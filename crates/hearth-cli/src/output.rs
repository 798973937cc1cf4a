//! Where a picture goes: a new file, complete or not at all, or standard output.

use std::fs::{self, OpenOptions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::Error;
use crate::film::ffmpeg;

const EXISTS: &str = "the file exists; --force replaces it";

/// An output that is free.
#[derive(Debug)]
pub enum Output {
    /// Standard output.
    Standard,
    /// A new file, or one in the place of an old one.
    File {
        /// Its path.
        path: PathBuf,
        /// Whether it may replace another.
        replace: bool,
    },
    /// What is no file, as a pipe with a name.
    Device(PathBuf),
}

/// While it is locked, a file is written. An interrupt waits for that.
static WRITING: Mutex<()> = Mutex::new(());

fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on, an interrupt ends the process between two files, with the shell's code for it.
pub fn end_between_files_on_interrupt() {
    const INTERRUPTED: i32 = 130;
    // Without a handler, an interrupt ends the process at once.
    let _ = ctrlc::set_handler(|| {
        let _no_file = writing();
        ffmpeg::abandon();
        std::process::exit(INTERRUPTED);
    });
}

impl Output {
    /// The output of that name, `-` for standard output. It is checked before a fire burns for it.
    ///
    /// # Errors
    /// There is such a file and `replace` is not set, its folder is missing, or standard output is
    /// a terminal.
    pub fn new(name: &str, replace: bool) -> Result<Output, Error> {
        if name == "-" {
            return match io::stdout().is_terminal() && !replace {
                true => Err(Error::Use(
                    "standard output is a terminal, which shows no picture; \
                     redirect it, name a file, or add --force"
                        .to_owned(),
                )),
                false => Ok(Output::Standard),
            };
        }
        let path = PathBuf::from(name);
        if path.is_dir() {
            return Err(Error::at(name, "is a folder"));
        }
        if path.exists() && !path.is_file() {
            return Ok(Output::Device(path));
        }
        if path.exists() && !replace {
            return Err(Error::at(name, EXISTS));
        }
        if !folder(&path).is_dir() {
            return Err(Error::at(name, "its folder does not exist"));
        }
        Ok(Output::File { path, replace })
    }

    /// The file beside its place in which another program may write it; `None` where there is no file.
    pub fn part(&self) -> Option<PathBuf> {
        match self {
            Output::File { path, .. } => Some(part_of(path)),
            _ => None,
        }
    }

    /// Moves a [part](Output::part) that is whole to its place.
    ///
    /// # Errors
    /// There is another file by now, or the disk fails.
    pub fn take(&self, part: &Path) -> Result<(), Error> {
        let Output::File { path, replace } = self else {
            return Ok(());
        };
        let name = path.display().to_string();
        let _writing = writing();
        if path.exists() && !replace {
            return Err(Error::at(&name, EXISTS));
        }
        fs::rename(part, path).map_err(|error| Error::at(&name, error))
    }

    /// The output of a picture: a name with another ending than `.png` is refused.
    ///
    /// # Errors
    /// As of [`new`](Output::new).
    pub fn of_png(name: &str, replace: bool) -> Result<Output, Error> {
        let ending = Path::new(name).extension();
        if ending.is_some_and(|ending| !ending.eq_ignore_ascii_case("png")) {
            let words = format!(
                "{name}: a picture is a PNG and ends with .png; `hearth film` writes other formats"
            );
            return Err(Error::Use(words));
        }
        Output::new(name, replace)
    }

    /// Writes bytes: all of them, or nothing to the file.
    ///
    /// # Errors
    /// The disk or the reader of standard output takes no more.
    pub fn write(&self, bytes: &[u8]) -> Result<(), Error> {
        let (path, replace) = match self {
            Output::Standard => return print(bytes),
            Output::Device(path) => {
                let written = OpenOptions::new().write(true).open(path);
                let written = written.and_then(|mut device| device.write_all(bytes));
                return written.map_err(|error| Error::at(&path.display().to_string(), error));
            }
            Output::File { path, replace } => (path, *replace),
        };
        let name = path.display().to_string();
        let _writing = writing();
        if path.exists() && !replace {
            return Err(Error::at(&name, EXISTS));
        }
        let temporary = part_of(path);
        let written = OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(&temporary)
            .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
            .and_then(|()| fs::rename(&temporary, path));
        written.map_err(|error| {
            // The error of writing is the one that counts.
            let _ = fs::remove_file(&temporary);
            Error::at(&name, error)
        })
    }
}

/// Writes to standard output.
///
/// # Errors
/// Nobody reads it, or it takes no more.
pub fn print(bytes: &[u8]) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    let written = out.write_all(bytes).and_then(|()| out.flush());
    written.map_err(Error::of_output)
}

fn part_of(path: &Path) -> PathBuf {
    folder(path).join(format!(".hearth-{}.part", std::process::id()))
}

fn folder(path: &Path) -> &Path {
    let parent = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    parent.unwrap_or(Path::new("."))
}

//! Where a picture goes: a new file, complete or not at all, or standard output.

use std::ffi::OsStr;
use std::fs::{self, OpenOptions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

use signal_hook::consts::signal::*;
use signal_hook::iterator::Signals;
use signal_hook::low_level;

use crate::error::{Error, shown};

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

/// What a signal does before it ends the process.
static AT_END: Mutex<Option<fn()>> = Mutex::new(None);

/// From now on, a signal does this before it ends the process.
pub fn at_end(act: fn()) {
    *AT_END.lock().unwrap_or_else(PoisonError::into_inner) = Some(act);
}

fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on, a signal ends the process between two files, with the shell's code for an interrupt. The limit of a file's
/// size is an error of writing.
///
/// # Errors
/// There is no memory for the thread that waits for signals.
pub fn end_between_files_on_signals() -> Result<(), Error> {
    const INTERRUPTED: i32 = 130;
    let ending = [
        SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU,
    ];
    let Ok(mut signals) = Signals::new(ending.iter().chain(&[SIGXFSZ])) else {
        // Without a handler, a signal ends the process at once.
        return Ok(());
    };
    let waits = thread::Builder::new().spawn(move || {
        if signals.forever().any(|signal| signal != SIGXFSZ) {
            let _no_file = writing();
            let at_end = *AT_END.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(at_end) = at_end {
                at_end();
            }
            // The driver's destructors would run under the thread that draws.
            low_level::exit(INTERRUPTED);
        }
    });
    waits.map(drop).map_err(Error::of_thread)
}

/// The file that a path names, and whether there is something: a symbolic link is written through.
///
/// # Errors
/// The links have no end.
fn target(path: &Path) -> Result<(PathBuf, bool), Error> {
    const MOST_LINKS: usize = 40;
    let mut end = path.to_owned();
    for links in 0..MOST_LINKS {
        match fs::read_link(&end) {
            Ok(next) => end = folder(&end).join(next),
            Err(_) => {
                let exists = links > 0 || end.exists();
                return Ok((end, exists));
            }
        }
    }
    Err(Error::at(path, "its symbolic links have no end"))
}

impl Output {
    /// The output of that name, `-` for standard output. It is checked before a fire burns for it.
    ///
    /// # Errors
    /// There is such a file and `replace` is not set, its folder is missing, or standard output is
    /// a terminal.
    pub fn new(name: impl AsRef<OsStr>, replace: bool) -> Result<Output, Error> {
        let name = name.as_ref();
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
        let (path, exists) = target(&path)?;
        if exists && !replace {
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
        let _writing = writing();
        if path.exists() && !replace {
            return Err(Error::at(path, EXISTS));
        }
        fs::rename(part, path).map_err(|error| Error::at(path, error))
    }

    /// The output of a picture: a name with another ending than `.png` is refused.
    ///
    /// # Errors
    /// As of [`new`](Output::new).
    pub fn of_png(name: &OsStr, replace: bool) -> Result<Output, Error> {
        let ending = Path::new(name).extension();
        if ending.is_some_and(|ending| !ending.eq_ignore_ascii_case("png")) {
            let name = shown(name);
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
                return written.map_err(|error| Error::at(path, error));
            }
            Output::File { path, replace } => (path, *replace),
        };
        let _writing = writing();
        if path.exists() && !replace {
            return Err(Error::at(path, EXISTS));
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
            Error::at(path, error)
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

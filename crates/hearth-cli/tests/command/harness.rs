//! Runs the command in a folder of the test's own, and reads its pictures.

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// A picture that is cheap to draw: few particles, for a short time.
pub const CHEAP: [&str; 6] = ["--quality", "low", "--at", "0.1", "--size", "48x32"];

/// What a run of the command left.
#[derive(Debug)]
pub struct Run {
    /// The exit code; -1 after a signal.
    pub code: i32,
    pub out: Vec<u8>,
    pub errors: String,
}

impl Run {
    /// Standard output as text.
    pub fn text(&self) -> &str {
        str::from_utf8(&self.out).expect("text")
    }

    /// Asserts a refusal of wrong use, without a panic, with a message that has these words.
    pub fn refuses(&self, words: &[&str]) {
        assert_eq!(self.code, 2, "{self:?}");
        assert!(!self.errors.contains("panicked"), "{}", self.errors);
        for words in words {
            assert!(self.errors.contains(words), "{words:?} in {}", self.errors);
        }
    }
}

/// An empty folder of a test.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(test: &str) -> Folder {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("hearth-command")
            .join(test);
        if folder.exists() {
            fs::remove_dir_all(&folder).expect("an old folder");
        }
        fs::create_dir_all(&folder).expect("a folder");
        Folder(folder)
    }

    /// The names of its files.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the folder");
        let names = entries.map(|entry| entry.expect("a file").file_name());
        let mut names: Vec<_> = names
            .map(|name| name.to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.0.join(name)).expect(name)
    }

    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), bytes).expect(name);
    }

    /// The command in this folder.
    pub fn command(&self, arguments: &[impl AsRef<OsStr>]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hearth"));
        command.args(arguments).current_dir(&self.0);
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    /// Runs the command with nothing on standard input.
    pub fn run(&self, arguments: &[impl AsRef<OsStr>]) -> Run {
        self.feed(arguments, b"")
    }

    /// Runs the command with the words of a line.
    pub fn hearth(&self, line: &str) -> Run {
        self.run(&line.split_whitespace().collect::<Vec<_>>())
    }

    /// Standard output of a run of the command that succeeds without a warning.
    pub fn done(&self, line: &str) -> Vec<u8> {
        let run = self.hearth(line);
        assert_eq!((run.code, &*run.errors), (0, ""), "{line}");
        run.out
    }

    /// Runs the command with Mesa's driver, without its extensions of that name.
    pub fn without_extension(&self, name: &str, arguments: &[impl AsRef<OsStr>]) -> Run {
        let missing = ["", "_float", "_half_float"].map(|end| format!("-{name}{end}"));
        let mut command = self.command(arguments);
        command.env("MESA_EXTENSION_OVERRIDE", missing.join(" "));
        ended(command.spawn().expect("the command"))
    }

    /// Runs the command with these bytes on standard input.
    pub fn feed(&self, arguments: &[impl AsRef<OsStr>], input: &[u8]) -> Run {
        let mut child = self.command(arguments).spawn().expect("the command");
        let mut stdin = child.stdin.take().expect("standard input");
        // A command that needs no input, or refuses it early, closes it.
        let _ = stdin.write_all(input);
        drop(stdin);
        ended(child)
    }
}

/// Waits for the end of the command.
pub fn ended(child: Child) -> Run {
    let output = child.wait_with_output().expect("the end of the command");
    Run {
        code: output.status.code().unwrap_or(-1),
        out: output.stdout,
        errors: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

/// A decoded PNG.
#[derive(Debug, PartialEq)]
pub struct Png {
    pub size: [u32; 2],
    /// Bytes of a pixel: 3 or 4.
    pub channels: usize,
    pub data: Vec<u8>,
    pub is_srgb: bool,
}

impl Png {
    pub fn decode(file: &[u8]) -> Png {
        let mut reader = png::Decoder::new(std::io::Cursor::new(file))
            .read_info()
            .expect("a PNG");
        let mut data = vec![0; reader.output_buffer_size().expect("a size")];
        let frame = reader.next_frame(&mut data).expect("a picture");
        data.truncate(frame.buffer_size());
        Png {
            size: [frame.width, frame.height],
            channels: frame.color_type.samples(),
            is_srgb: reader.info().srgb.is_some(),
            data,
        }
    }

    pub fn pixel(&self, [x, y]: [u32; 2]) -> &[u8] {
        let at = (y * self.size[0] + x) as usize * self.channels;
        &self.data[at..at + self.channels]
    }

    /// Its pixels.
    pub fn pixels(&self) -> impl Iterator<Item = &[u8]> {
        self.data.chunks_exact(self.channels)
    }
}

//! PNG files: in a folder, or in a zip archive.

use std::ffi::OsStr;
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::{Encoder, Header};
use crate::error::Error;
use crate::output::Output;
use crate::picture::Picture;

/// The name of the file of a picture. Parts of a film have the numbers of the whole.
fn name(number: u32) -> String {
    format!("{number:05}.png")
}

/// A folder, which may have other files.
pub struct Folder {
    path: PathBuf,
    replace: bool,
    next: u32,
    text: Option<String>,
}

impl Folder {
    pub fn new(folder: &OsStr, replace: bool, header: Header) -> Result<Folder, Error> {
        let path = Path::new(folder);
        fs::create_dir_all(path).map_err(|error| Error::at(folder, error))?;
        let folder = Folder {
            path: path.to_owned(),
            replace,
            next: header.first,
            text: header.text,
        };
        // A film that would end at a file begins with none.
        for number in header.first..header.first.saturating_add(header.count) {
            folder.output(number)?;
        }
        Ok(folder)
    }

    fn output(&self, number: u32) -> Result<Output, Error> {
        let path = self.path.join(name(number));
        Output::new(&path, self.replace)
    }
}

impl Encoder for Folder {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        let output = self.output(self.next)?;
        self.next += 1;
        output.write(&picture.png(self.text.as_deref())?)
    }

    fn finish(self: Box<Self>) -> Result<(), Error> {
        Ok(())
    }
}

/// A zip archive without times.
pub struct Archive {
    output: Output,
    zip: ZipWriter<Cursor<Vec<u8>>>,
    next: u32,
    text: Option<String>,
}

impl Archive {
    pub fn new(output: Output, header: Header) -> Archive {
        Archive {
            output,
            zip: ZipWriter::new(Cursor::default()),
            next: header.first,
            text: header.text,
        }
    }
}

impl Encoder for Archive {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        let png = picture.png(self.text.as_deref())?;
        // A PNG is compressed already.
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        let started = self.zip.start_file(name(self.next), options);
        self.next += 1;
        started.map_err(|error| Error::at("zip", error))?;
        self.zip
            .write_all(&png)
            .map_err(|error| Error::at("zip", error))
    }

    fn finish(self: Box<Self>) -> Result<(), Error> {
        let file = self.zip.finish().map_err(|error| Error::at("zip", error))?;
        self.output.write(&file.into_inner())
    }
}

//! The shader files and their includes.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Consecutive lines of a file.
pub struct Piece<'a> {
    /// Name of the file.
    pub file: &'a str,
    /// The lines.
    pub lines: Vec<&'a str>,
}

/// All files of a folder by name.
pub struct Files(BTreeMap<String, String>);

impl Files {
    /// Reads a folder.
    ///
    /// # Errors
    /// The folder or a file in it cannot be read.
    pub fn read(folder: &Path) -> Result<Files, String> {
        let describe = |error: std::io::Error| format!("{}: {error}", folder.display());
        let mut files = BTreeMap::new();
        for entry in fs::read_dir(folder).map_err(describe)? {
            let path = entry.map_err(describe)?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let text = fs::read_to_string(&path).map_err(describe)?;
            files.insert(name.into_owned(), text);
        }
        Ok(Files(files))
    }

    /// The names in alphabetical order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// Whether a file exists.
    pub fn has(&self, name: &str) -> bool {
        self.0.contains_key(name)
    }

    /// The pieces of a file after those of its includes, each once.
    ///
    /// # Errors
    /// An included file does not exist.
    pub fn folded<'a>(&'a self, name: &str) -> Result<Vec<Piece<'a>>, String> {
        let mut pieces = Vec::new();
        self.fold(name, &mut Vec::new(), &mut pieces)?;
        Ok(pieces)
    }

    fn fold<'a>(
        &'a self,
        name: &str,
        seen: &mut Vec<&'a str>,
        pieces: &mut Vec<Piece<'a>>,
    ) -> Result<(), String> {
        let known = self.0.get_key_value(name);
        let (file, text) = known.ok_or_else(|| format!("no shader file {name}"))?;
        if seen.contains(&file.as_str()) {
            return Ok(());
        }
        seen.push(file);
        let mut lines = Vec::new();
        for line in text.lines() {
            let Some(included) = line.strip_prefix("#include ") else {
                lines.push(line);
                continue;
            };
            let included = included.trim().trim_matches('"');
            self.fold(included, seen, pieces)
                .map_err(|error| format!("{file}: {error}"))?;
        }
        pieces.push(Piece { file, lines });
        Ok(())
    }
}

#[cfg(test)]
impl<const N: usize> From<[(&str, &str); N]> for Files {
    fn from(files: [(&str, &str); N]) -> Files {
        Files(
            files
                .map(|(name, text)| (name.to_owned(), text.to_owned()))
                .into(),
        )
    }
}

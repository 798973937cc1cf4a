//! The shader files, and how one includes another.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A piece of a file between two includes: its file, its documentation-bearing lines.
pub struct Piece<'a> {
    /// Name of the file.
    pub file: &'a str,
    /// Its lines.
    pub lines: Vec<&'a str>,
}

/// All files of the folder, by their names.
pub struct Files(BTreeMap<String, String>);

impl Files {
    /// Reads a folder.
    ///
    /// # Errors
    /// The folder, or a file in it, cannot be read.
    pub fn read(folder: &Path) -> Result<Files, String> {
        let complain = |error: std::io::Error| format!("{}: {error}", folder.display());
        let mut files = BTreeMap::new();
        for entry in fs::read_dir(folder).map_err(complain)? {
            let path = entry.map_err(complain)?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let text = fs::read_to_string(&path).map_err(complain)?;
            files.insert(name.into_owned(), text);
        }
        Ok(Files(files))
    }

    /// The names, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// Whether there is a file of that name.
    pub fn has(&self, name: &str) -> bool {
        self.0.contains_key(name)
    }

    /// The pieces of a file, with those that it includes, each once, before their first use.
    ///
    /// # Errors
    /// A file includes one that does not exist.
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
        let (file, text) = known.ok_or_else(|| format!("there is no shader file {name}"))?;
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
                .map_err(|said| format!("{file}: {said}"))?;
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

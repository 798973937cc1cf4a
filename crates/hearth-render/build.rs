//! Takes out of the shaders what only their readers need, comments and blanks: the
//! engine carries their text, and a page downloads it.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let shaders = Path::new("../../shaders");
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    println!("cargo::rerun-if-changed={}", shaders.display());
    for entry in fs::read_dir(shaders)? {
        let entry = entry?;
        let source = fs::read_to_string(entry.path())?;
        let bare: String = source
            .lines()
            .map(|line| line.split("//").next().unwrap_or_default().trim())
            .filter(|line| !line.is_empty())
            .flat_map(|line| [without_blanks(line), "\n".into()])
            .collect();
        fs::write(out.join(entry.file_name()), bare)?;
    }
    Ok(())
}

/// `line` with only those blanks that keep two words, or two signs, apart.
fn without_blanks(line: &str) -> String {
    let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let sign = |c: char| c == '+' || c == '-';
    let mut kept = String::with_capacity(line.len());
    let mut rest = line.chars().peekable();
    while let Some(c) = rest.next() {
        let (before, after) = (kept.chars().next_back(), rest.peek().copied());
        let apart = |of: fn(char) -> bool| before.is_some_and(of) && after.is_some_and(of);
        if c != ' ' || apart(word) || apart(sign) {
            kept.push(c);
        }
    }
    kept
}

//! Takes out of the shaders what only their readers need, comments and blanks: the
//! engine carries their text, and a page downloads it.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let shaders = Path::new("../../shaders");
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    println!("cargo::rerun-if-changed={}", shaders.display());
    // Tests, and a driver's complaints, go by lines.
    let readable = env::var("PROFILE").is_ok_and(|profile| profile != "release");
    for entry in fs::read_dir(shaders)? {
        let entry = entry?;
        let source = fs::read_to_string(entry.path())?;
        let bare = bare(&source, readable);
        fs::write(out.join(entry.file_name()), bare)?;
    }
    Ok(())
}

/// What a compiler reads of it: lines for it alone, and code with blanks only where
/// two words would become one; in lines, if it is to be `readable`.
fn bare(source: &str, readable: bool) -> String {
    let lines = source
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default().trim())
        .filter(|line| !line.is_empty());
    let mut kept = String::with_capacity(source.len());
    for line in lines {
        if line.starts_with('#') {
            if !kept.is_empty() && !kept.ends_with('\n') {
                kept.push('\n');
            }
            kept.push_str(line);
            kept.push('\n');
            continue;
        }
        for word in line.split_whitespace() {
            if let (Some(last), Some(first)) = (kept.chars().last(), word.chars().next())
                && (is_of_word(last) && is_of_word(first) || last == first && "+-".contains(last))
            {
                kept.push(' ');
            }
            kept.push_str(word);
        }
        if readable {
            kept.push('\n');
        }
    }
    kept.push('\n');
    kept
}

fn is_of_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || letter == '.'
}

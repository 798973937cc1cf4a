//! Takes comments and indentation out of the shaders: the engine carries their
//! text, and a page downloads it.

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
            .flat_map(|line| [line, "\n"])
            .collect();
        fs::write(out.join(entry.file_name()), bare)?;
    }
    Ok(())
}

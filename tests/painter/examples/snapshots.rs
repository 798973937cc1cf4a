//! Burns every fire that is kept and writes it into a folder.
//! `cargo xtask goldens --snapshots` runs this.

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

/// Most bytes of one file.
const LARGEST: usize = 60 * 1024;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.ok_or("usage: snapshots FOLDER")?;
    fs::create_dir_all(&folder)?;
    let kept = hearth_painter::fires::all()?;
    // A fire that is gone leaves no snapshot behind.
    for entry in fs::read_dir(&folder)? {
        let path = entry?.path();
        let name = path.file_stem().and_then(|name| name.to_str());
        if name.is_none_or(|name| !kept.contains_key(name)) {
            fs::remove_file(path)?;
        }
    }
    for (name, snapshot) in kept {
        let file = snapshot.write();
        if file.len() > LARGEST {
            return Err(format!("{name} takes {} bytes, more than {LARGEST}", file.len()).into());
        }
        println!("{name}: {:.1} KB", file.len() as f64 / 1000.0);
        fs::write(folder.join(format!("{name}.bin")), file)?;
    }
    Ok(())
}

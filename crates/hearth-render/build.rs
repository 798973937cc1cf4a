//! Compiles the shader files of `shaders/`, a link to the folder of the repository and a folder of the package, to the module `shaders`: for each pass the source of its
//! two stages, its samplers, and its uniforms as a Rust struct.

use std::path::{Path, PathBuf};
use std::{env, fs};

#[path = "src/constants.rs"]
mod constants;
#[path = "build/glsl/mod.rs"]
mod glsl;
#[path = "build/values.rs"]
mod values;
#[path = "build/write.rs"]
mod write;

fn main() -> Result<(), String> {
    let folder = Path::new("shaders");
    println!("cargo::rerun-if-changed={}", folder.display());
    println!("cargo::rerun-if-changed=build");
    println!("cargo::rerun-if-changed=src/constants.rs");
    let files = glsl::Files::read(folder)?;
    let programs = glsl::programs(&files, &values::shared())?;
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    fs::write(out.join("shaders.rs"), write::module(&programs)).map_err(|error| error.to_string())
}

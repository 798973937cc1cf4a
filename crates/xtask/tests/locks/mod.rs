//! The lock files of cargo.

use std::path::{Path, PathBuf};
use std::{fs, io};

/// The checkout.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The crates of a `Cargo.lock`: name, version, registry and checksum; a crate of the
/// checkout has neither of these.
pub fn locked(file: &str) -> io::Result<Vec<[String; 4]>> {
    let lock = fs::read_to_string(root().join(file))?.replace("\r\n", "\n");
    let field = |entry: &str, name: &str| {
        let start = format!("{name} = ");
        let line = entry.lines().find_map(|line| line.strip_prefix(&start));
        line.unwrap_or_default().trim_matches('"').to_owned()
    };
    let entries = lock.split("\n[[package]]\n").skip(1);
    let fields = ["name", "version", "source", "checksum"];
    Ok(entries
        .map(|entry| fields.map(|name| field(entry, name)))
        .collect())
}

/// Every `Cargo.lock` of the checkout.
pub const LOCKS: [&str; 2] = ["Cargo.lock", "benches/peers/Cargo.lock"];

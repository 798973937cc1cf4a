//! Folders, in the checkout and outside it.

use std::env;
use std::path::{Path, PathBuf};

/// The checkout: the folder of the workspace's `Cargo.toml`.
pub fn root() -> PathBuf {
    // The variable is right even where two checkouts share a target folder. The checkout
    // is two folders above this package.
    env::var_os("CARGO_MANIFEST_DIR")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from)
        .ancestors()
        .nth(2)
        .map(Path::to_path_buf)
        .unwrap_or_default()
}

/// The folder of all that is made of the checkout.
pub(crate) fn dist() -> PathBuf {
    root().join("dist")
}

/// The site that `cargo xtask build` makes.
pub fn site() -> PathBuf {
    dist().join("site")
}

/// The site that Trunk makes: the `dist` of `Trunk.toml`.
pub(crate) fn trunk_site() -> PathBuf {
    dist().join("trunk")
}

/// Tools that take minutes to compile, outside the checkout, so that all checkouts of a
/// machine share them.
pub fn tools() -> PathBuf {
    let home = || env::var_os("HOME").or_else(|| env::var_os("USERPROFILE"));
    env::var_os("XDG_CACHE_HOME")
        .filter(|folder| !folder.is_empty())
        .map(PathBuf::from)
        .or_else(|| home().map(|home| PathBuf::from(home).join(".cache")))
        .unwrap_or_else(env::temp_dir)
        .join("hearth/tools")
}

/// The scripts that make the package.
pub(crate) fn packaging() -> PathBuf {
    root().join("crates/xtask/packaging")
}

/// `path` relative to the checkout.
pub(crate) fn shown(path: &Path) -> String {
    let path = path.strip_prefix(root()).unwrap_or(path);
    path.display().to_string()
}

//! Where things lie: in the checkout, and outside it.

use std::env;
use std::path::{Path, PathBuf};

/// The checkout: the folder of the workspace's `Cargo.toml`.
pub fn root() -> PathBuf {
    // cargo says where this crate lies: when it runs it, which is right even
    // where two checkouts share a target folder, and when it compiled it. The
    // checkout is two folders above.
    env::var_os("CARGO_MANIFEST_DIR")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from)
        .ancestors()
        .nth(2)
        .map(Path::to_path_buf)
        .unwrap_or_default()
}

/// The site that `cargo xtask build` lays out.
pub fn site() -> PathBuf {
    root().join("dist").join("site")
}

/// The same site as Trunk lays it out: the `dist` of `Trunk.toml`.
pub fn trunk_site() -> PathBuf {
    root().join("dist").join("trunk")
}

/// Tools that take minutes to compile are kept here, outside the checkout, so
/// that only a new machine builds them.
pub fn tools() -> PathBuf {
    let home = || env::var_os("HOME").or_else(|| env::var_os("USERPROFILE"));
    env::var_os("XDG_CACHE_HOME")
        .filter(|folder| !folder.is_empty())
        .map(PathBuf::from)
        .or_else(|| home().map(|home| PathBuf::from(home).join(".cache")))
        .unwrap_or_else(env::temp_dir)
        .join("hearth")
        .join("tools")
}

/// `path` as a person in the checkout would write it.
pub fn shown(path: &Path) -> String {
    path.strip_prefix(root())
        .unwrap_or(path)
        .display()
        .to_string()
}

//! The stage that builds and serves the page with Trunk, as those do who have
//! it, and compares it with ours.

use std::collections::BTreeMap;
use std::fs;
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, bail};

use super::browser;
use crate::{paths, process, script, site, tools};

/// `trunk build --release` gives the same files, and the page burns; so does the
/// one that `trunk serve` serves.
pub(super) fn same_page(skip_browser: bool) -> Result<()> {
    tools::wasm_target()?;
    tools::wasm_bindgen_cli()?;
    tools::trunk()?;
    process::run(trunk().args(["build", "--release"]))?;
    compare(&paths::site(), &minified(&paths::trunk_site())?)?;
    if skip_browser {
        return Ok(());
    }
    browser::smoke(&paths::trunk_site(), None)?;
    let served = Served::start()?;
    browser::smoke(&paths::trunk_site(), Some(&served.address))
}

/// A copy of the site in `folder` with its scripts made small, which Trunk leaves as they
/// are written.
fn minified(folder: &Path) -> Result<PathBuf> {
    let copy = site::target_folder()?.join("trunk-minified");
    if copy.exists() {
        fs::remove_dir_all(&copy).with_context(|| format!("cannot clear {}", copy.display()))?;
    }
    site::copy_folder(folder, &copy)?;
    script::minify(&copy.join("web"))?;
    Ok(copy)
}

fn trunk() -> Command {
    let mut trunk = process::command("trunk");
    // Trunk takes the usual value of this one, 1, for a mistake.
    trunk.env_remove("NO_COLOR").env("TRUNK_OFFLINE", "true");
    trunk
}

/// A `trunk serve` that ends when this is dropped.
struct Served {
    trunk: Child,
    address: String,
}

impl Served {
    /// Starts it and waits until it answers. It does so when it has built.
    fn start() -> Result<Served> {
        // Nobody else is given this port at once, so it is still free for Trunk.
        let port = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?
            .local_addr()?
            .port();
        let trunk = trunk()
            .args(["serve", "--port", &port.to_string()])
            .stdin(Stdio::null())
            .spawn()
            .context("cannot start `trunk serve`")?;
        let mut served = Served {
            trunk,
            address: format!("http://127.0.0.1:{port}/"),
        };
        while TcpStream::connect((Ipv4Addr::LOCALHOST, port)).is_err() {
            if let Some(status) = served.trunk.try_wait()? {
                bail!("`trunk serve` ended instead of serving ({status})");
            }
            thread::sleep(Duration::from_millis(200));
        }
        Ok(served)
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        // It may have ended by itself; either way it is gone afterwards.
        let _ = self.trunk.kill();
        let _ = self.trunk.wait();
    }
}

/// Fails unless both folders hold the same files. A page may differ in blank
/// space, and wasm in the names of functions, which our build leaves out.
fn compare(ours: &Path, theirs: &Path) -> Result<()> {
    let (ours, theirs) = (files(ours)?, files(theirs)?);
    let mut complaints = Vec::new();
    for (name, content) in &ours {
        match theirs.get(name) {
            None => complaints.push(format!("Trunk leaves out {name}")),
            Some(_) if name.ends_with(".wasm") => {}
            Some(other) if name.ends_with(".html") => {
                if words(content) != words(other) {
                    complaints.push(format!("Trunk's {name} is another"));
                }
            }
            Some(other) if content != other => {
                complaints.push(format!("Trunk's {name} is another"));
            }
            Some(_) => {}
        }
    }
    let added = theirs.keys().filter(|name| !ours.contains_key(*name));
    complaints.extend(added.map(|name| format!("Trunk adds {name}")));
    if !complaints.is_empty() {
        bail!("{}", complaints.join("\n"));
    }
    Ok(())
}

/// Every file under `folder`: its path there, with `/` between, and its content.
fn files(folder: &Path) -> Result<BTreeMap<String, Vec<u8>>> {
    let mut found = BTreeMap::new();
    let mut open = vec![(String::new(), folder.to_path_buf())];
    while let Some((prefix, folder)) = open.pop() {
        let listed =
            fs::read_dir(&folder).with_context(|| format!("cannot read {}", folder.display()))?;
        for entry in listed {
            let entry = entry?;
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                open.push((format!("{name}/"), entry.path()));
            } else {
                found.insert(name, fs::read(entry.path())?);
            }
        }
    }
    Ok(found)
}

fn words(html: &[u8]) -> Vec<String> {
    String::from_utf8_lossy(html)
        .split_whitespace()
        .map(str::to_owned)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn site(name: &str, files: &[(&str, &str)]) -> Result<PathBuf> {
        let folder =
            std::env::temp_dir().join(format!("hearth-trunk-{}-{name}", std::process::id()));
        fs::create_dir_all(folder.join("web"))?;
        for (path, content) in files {
            fs::write(folder.join(path), content)?;
        }
        Ok(folder)
    }

    #[test]
    fn differences_that_matter_are_named() -> Result<()> {
        let ours = site(
            "ours",
            &[
                ("index.html", "<p>a</p>\n\n<p>b</p>\n"),
                ("web/a.wasm", "1"),
                ("web/a.js", "1"),
                ("web/b.js", "1"),
            ],
        )?;
        let same = site(
            "same",
            &[
                ("index.html", "<p>a</p>\n<p>b</p>"),
                ("web/a.wasm", "2"),
                ("web/a.js", "1"),
                ("web/b.js", "1"),
            ],
        )?;
        let other = site(
            "other",
            &[
                ("index.html", "<p>a</p>"),
                ("web/a.wasm", "1"),
                ("web/a.js", "2"),
                ("web/c.js", "1"),
            ],
        )?;
        compare(&ours, &same)?;
        let said = compare(&ours, &other).err().map(|error| error.to_string());
        assert_eq!(
            said.as_deref(),
            Some(
                "Trunk's index.html is another\nTrunk's web/a.js is another\n\
                 Trunk leaves out web/b.js\nTrunk adds web/c.js"
            )
        );
        for folder in [ours, same, other] {
            fs::remove_dir_all(folder)?;
        }
        Ok(())
    }
}

//! Stages that build and serve the page with [Trunk](https://trunkrs.dev), and compare it
//! with the site.

use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, bail, ensure};
use xshell::Cmd;

use super::browser;
use crate::shell::Shell;
use crate::{glue, paths, script, site, tools};

/// `trunk build --release` gives the files of the site.
pub(super) fn same_site() -> Result<()> {
    tools::wasm_target()?;
    tools::wasm_bindgen_cli()?;
    tools::trunk()?;
    let sh = Shell::new()?;
    trunk(&sh).args(["build", "--release"]).run()?;
    // Trunk leaves scripts as they are written: they are minified in a copy.
    let copy = tools::target()?.join("trunk-minified");
    sh.remove_path(&copy)?;
    site::copy_folder(&sh, &paths::trunk_site(), &copy)?;
    glue::shorten(&sh, &copy.join("web"))?;
    script::minify(&copy.join("web"))?;
    compare(&sh, &paths::site(), &copy)
}

/// The pages of `trunk build` and of `trunk serve` burn.
pub(super) fn page_burns() -> Result<()> {
    browser::smoke(&paths::trunk_site(), None)?;
    let served = Served::start()?;
    browser::smoke(&paths::trunk_site(), Some(&served.address))
}

fn trunk(sh: &Shell) -> Cmd<'_> {
    // Trunk rejects the usual value of NO_COLOR, 1.
    let trunk = sh.cmd("trunk").env_remove("NO_COLOR");
    trunk.env("TRUNK_OFFLINE", "true")
}

/// A `trunk serve` that ends when this is dropped.
struct Served {
    trunk: Child,
    address: String,
}

impl Served {
    /// Starts it and waits until it answers, which it does once it has built the page.
    fn start() -> Result<Served> {
        // The system does not reuse a port at once, so this one stays free for Trunk.
        let port = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?
            .local_addr()?
            .port();
        let sh = Shell::new()?;
        let trunk = Command::from(trunk(&sh))
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
        // Both fail where Trunk has ended by itself.
        let _ = self.trunk.kill();
        let _ = self.trunk.wait();
    }
}

/// Fails unless both folders hold the same files. White space of pages may differ, and
/// wasm, whose function names our build removes.
fn compare(sh: &Shell, ours: &Path, theirs: &Path) -> Result<()> {
    let (ours, theirs) = (site::files(sh, ours)?, site::files(sh, theirs)?);
    let words = |html: &[u8]| -> Vec<String> {
        let html = String::from_utf8_lossy(html);
        html.split_whitespace().map(str::to_owned).collect()
    };
    let mut differences = Vec::new();
    for (name, content) in &ours {
        let same = match theirs.get(name) {
            None => {
                differences.push(format!("Trunk omits {name}"));
                continue;
            }
            Some(_) if name.ends_with(".wasm") => true,
            Some(other) if name.ends_with(".html") => words(content) == words(other),
            Some(other) => content == other,
        };
        if !same {
            differences.push(format!("Trunk's {name} differs"));
        }
    }
    let added = theirs.keys().filter(|name| !ours.contains_key(*name));
    differences.extend(added.map(|name| format!("Trunk adds {name}")));
    ensure!(differences.is_empty(), "{}", differences.join("\n"));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_differences_that_matter_are_named() -> Result<()> {
        let sh = Shell::new()?;
        let folder = sh.create_temp_dir()?;
        for (site, files) in [
            ("ours", "index.html:a\n\nb a.wasm:1 a.js:1 b.js:1"),
            ("same", "index.html:a\nb\n a.wasm:2 a.js:1 b.js:1"),
            ("other", "index.html:a a.wasm:1 a.js:2 web/c.js:1"),
        ] {
            let site = folder.path().join(site);
            for (path, content) in files.split(' ').filter_map(|file| file.split_once(':')) {
                sh.write_file(site.join(path), content)?;
            }
        }
        let [ours, same, other] = ["ours", "same", "other"].map(|site| folder.path().join(site));
        compare(&sh, &ours, &same)?;
        let error = compare(&sh, &ours, &other)
            .err()
            .map(|error| error.to_string());
        let named = "Trunk's a.js differs\nTrunk omits b.js\nTrunk's index.html differs\n\
                     Trunk adds web/c.js";
        assert_eq!(error.as_deref(), Some(named));
        Ok(())
    }
}

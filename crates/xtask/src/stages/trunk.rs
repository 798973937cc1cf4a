//! Stages that build and serve the page with [Trunk](https://trunkrs.dev), and compare it
//! with the site.

use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};
use xshell::{Cmd, cmd};

use super::browser;
use crate::shell::Shell;
use crate::{parts, paths, script, site, tools};

/// `trunk build --release` gives the files of the site.
pub(super) fn same_files() -> Result<()> {
    let sh = Shell::new()?;
    build(&sh)?;
    // Trunk leaves scripts as they are written: they are minified in a copy.
    let copy = tools::target()?.join("trunk-minified");
    sh.remove_path(&copy)?;
    site::copy_folder(&sh, &paths::trunk_site(), &copy)?;
    parts::divide(&sh, &copy.join("web"))?;
    script::minify(&copy.join("web"))?;
    let (scripts, site) = (paths::packaging(), paths::site());
    Ok(cmd!(sh, "node {scripts}/same.mjs {site} {copy}").run()?)
}

/// The pages of `trunk build` and of `trunk serve` burn.
pub(super) fn page_burns() -> Result<()> {
    build(&Shell::new()?)?;
    browser::smoke(&paths::trunk_site(), None)?;
    let served = Served::start()?;
    browser::smoke(&paths::trunk_site(), Some(&served.address))
}

fn build(sh: &Shell) -> Result<()> {
    tools::wasm_target()?;
    tools::wasm_bindgen_cli()?;
    tools::trunk()?;
    Ok(trunk(sh)?.args(["build", "--release"]).run()?)
}

fn trunk(sh: &Shell) -> Result<Cmd<'_>> {
    // The same flags as the site's, so that nothing is compiled again.
    let (name, flags) = tools::portable_paths()?;
    // Trunk rejects the usual value of NO_COLOR, 1.
    let trunk = sh.cmd("trunk").env_remove("NO_COLOR").env(name, flags);
    Ok(trunk.env("TRUNK_OFFLINE", "true"))
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
        let trunk = Command::from(trunk(&sh)?)
            .args(["serve", "--port", &port.to_string()])
            .stdin(Stdio::null())
            .spawn()
            .context("cannot start `trunk serve`")?;
        let mut served = Served {
            trunk,
            address: format!("http://127.0.0.1:{port}/"),
        };
        let deadline = Instant::now() + Duration::from_mins(20);
        while TcpStream::connect((Ipv4Addr::LOCALHOST, port)).is_err() {
            if let Some(status) = served.trunk.try_wait()? {
                bail!("`trunk serve` ended instead of serving ({status})");
            }
            ensure!(
                Instant::now() < deadline,
                "`trunk serve` did not answer in 20 minutes"
            );
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

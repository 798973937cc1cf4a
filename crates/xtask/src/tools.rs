//! The tools that Hearth's commands need beyond cargo: found where they are,
//! installed where they are not and that is allowed, and otherwise named with
//! the line that installs them.
//!
//! `serve` and `build` need the wasm target and Node. Tests also need
//! Chromium with its driver, Firefox, WebKit's driver, a screen for these two,
//! wasm-bindgen's test runner, valgrind, the reference compiler of GLSL and Trunk.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::{paths, process};

/// The version of wasm-bindgen of this workspace; its command line tools must
/// be of the same. A test compares it with `Cargo.lock`.
const WASM_BINDGEN: &str = "0.2.130";
/// The version of Trunk that is known to work.
const TRUNK: &str = "0.21.14";
/// The target of everything that runs in a browser.
pub const WASM: &str = "wasm32-unknown-unknown";
/// Oldest Node that the tools run in which npm installs.
const NODE_MAJOR: u32 = 20;

/// The PATH of this process with the tools' folder before it.
pub fn path() -> Option<OsString> {
    let present = env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(paths::tools().join("bin")).chain(env::split_paths(&present));
    env::join_paths(folders).ok()
}

/// Makes sure that rustc can compile to wasm.
///
/// # Errors
/// The target is missing and cannot be added.
pub fn wasm_target() -> Result<()> {
    let folder = process::output(process::command("rustc").args([
        "--print",
        "target-libdir",
        "--target",
        WASM,
    ]))?;
    if Path::new(folder.trim()).is_dir() {
        return Ok(());
    }
    if process::find("rustup").is_none() {
        bail!(
            "this Rust cannot compile to {WASM}, and there is no rustup to add that target; \
             install Rust with rustup (https://rustup.rs), or your distribution's \
             package of Rust's standard library for {WASM}"
        );
    }
    println!("Adding Rust's {WASM} target …");
    process::run(process::command("rustup").args(["target", "add", WASM]))
}

/// Makes sure that the tools for tests of wasm are there.
///
/// # Errors
/// They could not be installed.
pub fn wasm_bindgen_cli() -> Result<()> {
    // Its published lock file names versions that no longer build, so without.
    crate_tool(
        "wasm-bindgen-test-runner",
        "wasm-bindgen-cli",
        WASM_BINDGEN,
        false,
    )
}

/// Makes sure that Trunk is there.
///
/// # Errors
/// It could not be installed.
pub fn trunk() -> Result<()> {
    // Its newer dependencies do not fit together, so with its lock file.
    crate_tool("trunk", "trunk", TRUNK, true)
}

fn crate_tool(program: &str, package: &str, version: &str, locked: bool) -> Result<()> {
    if let Some(file) = process::find(program) {
        let said = process::output(process::command(file).arg("--version")).unwrap_or_default();
        if said.split_whitespace().nth(1) == Some(version) {
            return Ok(());
        }
    }
    println!("Installing {package} {version} (a few minutes, once on a machine) …");
    let mut install = process::cargo();
    install
        .args([
            "install",
            package,
            "--version",
            version,
            "--force",
            "--root",
        ])
        .arg(paths::tools());
    if locked {
        install.arg("--locked");
    }
    // It runs for seconds and compiles for minutes: do not optimise it much.
    install
        .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "1")
        .env("CARGO_PROFILE_RELEASE_LTO", "off")
        .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
    process::run(&mut install)
}

/// Chromium and the driver that steers it.
#[derive(Debug)]
pub struct Browser {
    /// Chromium, or Chrome.
    pub chromium: PathBuf,
    /// Its WebDriver.
    pub driver: PathBuf,
}

/// Finds Chromium and its driver, and installs Debian's where they are missing.
///
/// # Errors
/// They are missing and cannot be installed; the error says what to do.
pub fn browser() -> Result<Browser> {
    if let Some(browser) = find_browser() {
        return Ok(browser);
    }
    apt_install(&["chromium", "chromium-driver"]).context(
        "no Chromium with its chromedriver: install Debian's packages chromium and \
         chromium-driver, or name the programs in HEARTH_CHROMIUM and CHROMEDRIVER, \
         or leave the browser out with --skip-browser",
    )?;
    find_browser().context("chromium and chromium-driver are installed, but not on the PATH")
}

/// A program that tests of all browsers need beside Chromium.
struct Program {
    /// The variable that names it, for a person and for the tests.
    variable: &'static str,
    names: &'static [&'static str],
    package: &'static str,
    /// The browsers that need it, as `HEARTH_BROWSERS` calls them.
    browsers: &'static [&'static str],
}

/// What draws without a graphics card, where the browsers do not bring it themselves.
const SOFTWARE_GL: [&str; 3] = ["libgl1", "libegl1", "libgl1-mesa-dri"];

const PROGRAMS: &[Program] = &[
    Program {
        variable: "HEARTH_FIREFOX",
        names: &["firefox-esr", "firefox"],
        package: "firefox-esr",
        browsers: &["firefox"],
    },
    // It comes with WebKitGTK's small browser.
    Program {
        variable: "HEARTH_WEBKIT_DRIVER",
        names: &["WebKitWebDriver"],
        package: "webkit2gtk-driver",
        browsers: &["webkit"],
    },
    // Neither draws without a window.
    Program {
        variable: "HEARTH_XVFB",
        names: &["Xvfb"],
        package: "xvfb",
        browsers: &["firefox", "webkit"],
    },
];

impl Program {
    fn find(&self) -> Option<PathBuf> {
        named(self.variable).or_else(|| self.names.iter().copied().find_map(process::find))
    }

    /// Whether one of the browsers in this list needs it; an empty one names all.
    fn is_wanted(&self, browsers: &str) -> bool {
        browsers.is_empty()
            || browsers
                .split(',')
                .any(|name| self.browsers.contains(&name.trim()))
    }
}

/// Finds what drives Firefox and WebKit, and installs Debian's where it is missing;
/// with each program the variable that tests look for. `HEARTH_BROWSERS` leaves some
/// out.
///
/// # Errors
/// One is missing and cannot be installed; the error says what to do.
pub fn other_browsers() -> Result<Vec<(&'static str, PathBuf)>> {
    let browsers = env::var("HEARTH_BROWSERS").unwrap_or_default();
    let needed = || {
        PROGRAMS
            .iter()
            .filter(|program| program.is_wanted(&browsers))
    };
    if needed().any(|program| program.find().is_none()) {
        let packages: Vec<_> = needed()
            .map(|program| program.package)
            .chain(SOFTWARE_GL)
            .collect();
        apt_install(&packages).context(
            "no Firefox, WebKit or screen for them: install Debian's packages firefox-esr, \
             webkit2gtk-driver and xvfb, or name the programs in HEARTH_FIREFOX, \
             HEARTH_WEBKIT_DRIVER and HEARTH_XVFB, or leave browsers out, as with \
             HEARTH_BROWSERS=chromium or --skip-browser",
        )?;
    }
    needed()
        .map(|program| {
            let found = program.find().with_context(|| {
                let Program { package, names, .. } = program;
                format!(
                    "{package} is installed, but {} is not on the PATH",
                    names[0]
                )
            })?;
            Ok((program.variable, found))
        })
        .collect()
}

/// Makes sure that valgrind is there.
///
/// # Errors
/// It is missing and cannot be installed.
pub fn valgrind() -> Result<()> {
    if process::find("valgrind").is_none() {
        apt_install(&["valgrind", "libc6-dbg"])
            .context("no valgrind: install Debian's packages valgrind and libc6-dbg")?;
    }
    Ok(())
}

/// Makes sure that the reference compiler of GLSL is there.
///
/// # Errors
/// It is missing and cannot be installed.
pub fn glslang() -> Result<PathBuf> {
    const NAME: &str = "glslangValidator";
    let find = || named("HEARTH_GLSLANG").or_else(|| process::find(NAME));
    if find().is_none() {
        apt_install(&["glslang-tools"]).context(
            "no glslangValidator: install Debian's package glslang-tools, or name the \
             program in HEARTH_GLSLANG",
        )?;
    }
    find().with_context(|| format!("glslang-tools is installed, but {NAME} is not on the PATH"))
}

/// Makes sure that `img2webp` is there, which makes an animation of pictures.
///
/// # Errors
/// It is missing and cannot be installed.
pub fn webp() -> Result<()> {
    if process::find("img2webp").is_none() {
        apt_install(&["webp"]).context("no img2webp: install Debian's package webp")?;
    }
    Ok(())
}

/// The program that a variable names.
fn named(variable: &str) -> Option<PathBuf> {
    env::var_os(variable)
        .map(PathBuf::from)
        .filter(|file| file.is_file())
}

fn find_browser() -> Option<Browser> {
    let chromium = named("HEARTH_CHROMIUM").or_else(|| {
        [
            "chromium",
            "chromium-browser",
            "google-chrome-stable",
            "google-chrome",
        ]
        .into_iter()
        .find_map(process::find)
    })?;
    let driver = named("CHROMEDRIVER").or_else(|| process::find("chromedriver"))?;
    Some(Browser { chromium, driver })
}

/// Makes sure that Node and npm are there, and Node is not too old.
///
/// # Errors
/// They are missing or too old and cannot be installed.
pub fn node() -> Result<()> {
    let say = || {
        format!(
            "Hearth is built with Node {NODE_MAJOR} or newer and npm: install it \
             from https://nodejs.org or as Debian's packages nodejs and npm"
        )
    };
    if process::find("node").is_none() || process::find("npm").is_none() {
        apt_install(&["nodejs", "npm"]).with_context(say)?;
    }
    let said = process::output(process::command("node").arg("--version")).with_context(say)?;
    match major(&said) {
        Some(major) if major >= NODE_MAJOR => Ok(()),
        _ => bail!("Node {} is too old: {}", said.trim(), say()),
    }
}

/// `v20.1.2` → 20.
fn major(version: &str) -> Option<u32> {
    version
        .trim()
        .strip_prefix('v')?
        .split('.')
        .next()?
        .parse()
        .ok()
}

/// Installs Debian packages where that needs no password.
fn apt_install(packages: &[&str]) -> Result<()> {
    let by_hand = || format!("run: sudo apt-get install {}", packages.join(" "));
    if process::find("apt-get").is_none() {
        bail!(
            "this is no Debian; look for the like of: {}",
            packages.join(", ")
        );
    }
    let apt_get = |arguments: &[&str]| {
        let mut apt_get = if is_root() {
            process::command("apt-get")
        } else {
            let mut sudo = process::command("sudo");
            sudo.args(["-n", "apt-get"]);
            sudo
        };
        apt_get.env("DEBIAN_FRONTEND", "noninteractive");
        process::run(apt_get.args(arguments))
    };
    if !is_root() {
        process::output(process::command("sudo").args(["-n", "true"])).with_context(by_hand)?;
    }
    println!("Installing Debian's {} …", packages.join(" and "));
    let mut install = vec!["install", "-y", "--no-install-recommends"];
    install.extend(packages);
    // A fresh machine often has no list of packages, or an old one.
    if apt_get(&install).is_err() {
        apt_get(&["update"])
            .and_then(|()| apt_get(&install))
            .with_context(by_hand)?;
    }
    Ok(())
}

fn is_root() -> bool {
    process::output(process::command("id").arg("-u")).is_ok_and(|id| id.trim() == "0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tools_are_of_the_version_of_the_bindings() -> Result<()> {
        let lock = std::fs::read_to_string(paths::root().join("Cargo.lock"))?;
        let entry = format!("name = \"wasm-bindgen\"\nversion = \"{WASM_BINDGEN}\"");
        assert!(lock.replace("\r\n", "\n").contains(&entry));
        Ok(())
    }

    #[test]
    fn only_what_the_wanted_browsers_need_is_looked_for() {
        let wanted = |browsers: &str| -> Vec<_> {
            PROGRAMS
                .iter()
                .filter(|program| program.is_wanted(browsers))
                .map(|program| program.package)
                .collect()
        };
        assert_eq!(wanted(""), ["firefox-esr", "webkit2gtk-driver", "xvfb"]);
        assert_eq!(wanted("chromium, webkit"), ["webkit2gtk-driver", "xvfb"]);
        assert!(wanted("chromium").is_empty());
    }

    #[test]
    fn versions_of_node_are_read() {
        assert_eq!(major("v20.11.1\n"), Some(20));
        assert_eq!(major("20"), None);
        assert_eq!(major(""), None);
    }

    #[test]
    fn own_tools_come_first() {
        let first = path().and_then(|path| env::split_paths(&path).next());
        assert_eq!(first, Some(paths::tools().join("bin")));
    }
}

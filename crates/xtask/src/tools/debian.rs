//! Programs, libraries and fonts that Debian has: a missing one is installed where that needs no password, else
//! named with the command that installs it.

use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use anyhow::{Context, Result, anyhow, ensure};
use xshell::cmd;

use crate::shell::{Shell, find};

/// While this lives, no other thread installs.
pub(crate) fn installing() -> MutexGuard<'static, ()> {
    static ONE: Mutex<()> = Mutex::new(());
    ONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A program that Debian has.
pub(crate) struct Program {
    /// The environment variable that names another program; empty: none.
    variable: &'static str,
    names: Names,
    packages: Names,
}

type Names = &'static [&'static str];

const CHROMIUM: Program = Program::new(
    "HEARTH_CHROMIUM",
    &["chromium", "chromium-browser", "google-chrome"],
    &["chromium"],
);
const SHELL: Names = &["chromium-headless-shell"];
/// Chromium without what a window needs: its pages take less of the processor.
const HEADLESS_SHELL: Program = Program::new("", SHELL, SHELL);
pub(crate) const CHROMEDRIVER: Program =
    Program::new("CHROMEDRIVER", &["chromedriver"], &["chromium-driver"]);
const FIREFOX: Program = Program::new(
    "HEARTH_FIREFOX",
    &["firefox-esr", "firefox"],
    &["firefox-esr"],
);
/// It comes with WebKitGTK's small browser.
const WEBKIT: Program = Program::new(
    "HEARTH_WEBKIT_DRIVER",
    &["WebKitWebDriver"],
    &["webkit2gtk-driver"],
);
/// Firefox and WebKit draw into windows only, and with these libraries where there is no
/// graphics card.
const XVFB: Program = Program::new(
    "HEARTH_XVFB",
    &["Xvfb"],
    &["xvfb", "libgl1", "libegl1", "libgl1-mesa-dri"],
);
pub(crate) const VALGRIND: Program = Program::new("", &["valgrind"], &["valgrind", "libc6-dbg"]);
/// It compiles libFuzzer.
pub(crate) const COMPILER: Program = Program::new("CXX", &["c++", "g++", "clang++"], &["g++"]);
/// It lets system calls of the command fail.
const STRACE: Program = Program::new("HEARTH_STRACE", &["strace"], &["strace"]);
/// The reference compiler of GLSL.
pub(crate) const GLSLANG: Program =
    Program::new("HEARTH_GLSLANG", &["glslangValidator"], &["glslang-tools"]);
/// Makes an animation of pictures.
pub(crate) const IMG2WEBP: Program = Program::new("", &["img2webp"], &["webp"]);
/// Makes a JPEG of a picture.
pub(crate) const CJPEG: Program =
    Program::new("HEARTH_CJPEG", &["cjpeg"], &["libjpeg-turbo-progs"]);

impl Program {
    const fn new(variable: &'static str, names: Names, packages: Names) -> Program {
        Program {
            variable,
            names,
            packages,
        }
    }

    /// The program, installed if it is missing.
    pub(crate) fn get(&self) -> Result<PathBuf> {
        let Program {
            names,
            packages,
            variable,
        } = self;
        let _only = installing();
        if let Some(found) = self.found() {
            return Ok(found);
        }
        apt_install(packages).with_context(|| match *variable {
            "" => format!("{} is missing", names[0]),
            _ => format!("{} is missing; {variable} may name it", names[0]),
        })?;
        let not_found = || anyhow!("{} is installed, but not on the PATH", names[0]);
        self.found().with_context(not_found)
    }

    /// The variable in which scripts look for the program, and the program.
    pub(crate) fn variable(&self) -> Result<(&'static str, PathBuf)> {
        Ok((self.variable, self.get()?))
    }

    fn found(&self) -> Option<PathBuf> {
        let named = env::var_os(self.variable).map(PathBuf::from);
        named
            .filter(|file| file.is_file())
            .or_else(|| self.names.iter().copied().find_map(find))
    }
}

/// What the command `hearth` draws with where there is no graphics card.
const GRAPHICS_DRIVER: Names = &["libegl1", "libgles2", "libegl-mesa0", "libgl1-mesa-dri"];
/// Where Debian has the first of them.
const EGL: &str = "libEGL.so.1";

const CHINESE_FONT: Names = &["fonts-droid-fallback"];

/// Installs a font with the letters of a test in Chinese, which come with no browser.
pub(crate) fn chinese_font() -> Result<()> {
    let _only = installing();
    if has_chinese_font()? {
        return Ok(());
    }
    apt_install(CHINESE_FONT).context("there is no Chinese font")
}

fn has_chinese_font() -> Result<bool> {
    let sh = Shell::new()?;
    let fonts = cmd!(sh, "fc-list :lang=zh").quiet().ignore_status().read();
    Ok(fonts.is_ok_and(|fonts| !fonts.is_empty()))
}

/// Installs at once what the quick stages or `all` need of Debian, or names every package in one message. On other
/// systems each stage names what it lacks.
pub(crate) fn whole_ring(all: bool, browser: bool) -> Result<()> {
    let _only = installing();
    if find("apt-get").is_none() {
        return Ok(());
    }
    let mut packages = missing(all, browser, |program| program.found().is_some());
    if !has_library(EGL) {
        packages.extend(GRAPHICS_DRIVER);
    }
    if all && browser && !has_chinese_font()? {
        packages.extend(CHINESE_FONT);
    }
    if packages.is_empty() {
        return Ok(());
    }
    let once: BTreeSet<_> = packages.into_iter().collect();
    let packages: Vec<_> = once.into_iter().collect();
    apt_install(&packages).context("programs are missing")
}

/// The packages of the programs that a ring needs and that are not there.
fn missing(all: bool, browser: bool, there: impl Fn(&Program) -> bool) -> Vec<&'static str> {
    let mut needed = vec![&GLSLANG];
    if browser {
        needed.extend([&CHROMIUM, &CHROMEDRIVER]);
    }
    if all {
        needed.extend([&VALGRIND, &COMPILER]);
    }
    if all && browser {
        needed.extend(needed_by(&wanted_browsers()));
    }
    let lacking = needed.into_iter().filter(|program| !there(program));
    lacking
        .flat_map(|program| program.packages)
        .copied()
        .collect()
}

/// Whether a folder of Debian's libraries has this one.
fn has_library(name: &str) -> bool {
    let folders = fs::read_dir("/usr/lib").into_iter().flatten().flatten();
    let mut all = folders
        .map(|folder| folder.path())
        .chain(["/usr/lib".into()]);
    all.any(|folder| folder.join(name).exists())
}

/// Installs EGL and a driver of OpenGL ES if the command `hearth` finds none.
pub(crate) fn graphics_driver(command: &Path) -> Result<()> {
    let (_only, sh) = (installing(), Shell::new()?);
    let finds_one = || cmd!(sh, "{command} info").quiet().ignore_stdout().run();
    if finds_one().is_ok() {
        return Ok(());
    }
    apt_install(GRAPHICS_DRIVER).context("there is no driver of OpenGL ES 3")?;
    Ok(finds_one()?)
}

/// Chromium, with its driver beside it.
pub fn chromium() -> Result<PathBuf> {
    let hint = "this stage needs a browser (`--skip-browser` leaves such stages out)";
    CHROMEDRIVER.get().context(hint)?;
    // Not every distribution has it: tests then drive Chromium.
    HEADLESS_SHELL.get().ok();
    CHROMIUM.get().context(hint)
}

/// The variable in which tests find the browsers of a run; a caller may leave some out by it.
pub(crate) const BROWSERS: &str = "HEARTH_BROWSERS";

/// What drives Firefox and WebKit, each with the variable in which tests look for it, and the names of all browsers.
pub fn browsers() -> Result<Vec<(&'static str, PathBuf)>> {
    let wanted = wanted_browsers();
    let mut variables = needed_by(&wanted)
        .into_iter()
        .map(Program::variable)
        .collect::<Result<Vec<_>>>()?;
    let names = [&["chromium"], &*wanted].concat().join(",");
    variables.push((BROWSERS, names.into()));
    Ok(variables)
}

/// A variable of a test with the program that lets system calls fail.
pub fn strace() -> Result<(&'static str, PathBuf)> {
    STRACE.variable()
}

/// The browsers beside Chromium that `HEARTH_BROWSERS` does not leave out.
pub(crate) fn wanted_browsers() -> Vec<&'static str> {
    among(&env::var(BROWSERS).unwrap_or_default())
}

/// The browsers beside Chromium in this list; an empty list names both.
fn among(browsers: &str) -> Vec<&'static str> {
    let named = |name: &&str| browsers.split(',').any(|it| it.trim() == *name);
    let both = ["firefox", "webkit"].into_iter();
    both.filter(|name| browsers.is_empty() || named(name))
        .collect()
}

/// What these browsers beside Chromium need.
fn needed_by(browsers: &[&str]) -> Vec<&'static Program> {
    let program = |name: &&str| {
        if *name == "firefox" {
            &FIREFOX
        } else {
            &WEBKIT
        }
    };
    let display = (!browsers.is_empty()).then_some(&XVFB);
    browsers.iter().map(program).chain(display).collect()
}

/// What a person runs to install Debian packages.
fn by_hand(packages: &[&str]) -> String {
    format!("run: sudo apt-get install {}", packages.join(" "))
}

/// Installs Debian packages where that needs no password.
pub(super) fn apt_install(packages: &[&str]) -> Result<()> {
    ensure!(
        find("apt-get").is_some(),
        "this is not Debian: install the equivalents of its packages {}",
        packages.join(", ")
    );
    let by_hand = || by_hand(packages);
    let sh = Shell::new()?;
    sh.set_var("DEBIAN_FRONTEND", "noninteractive");
    let is_root = cmd!(sh, "id -u").read().is_ok_and(|id| id == "0");
    let sudo: &[&str] = if is_root { &[] } else { &["sudo", "-n"] };
    if !is_root {
        cmd!(sh, "sudo -n true")
            .quiet()
            .run()
            .with_context(by_hand)?;
    }
    // `env` runs the rest of its line, with or without sudo in front.
    let install = cmd!(
        sh,
        "env {sudo...} apt-get install -y --no-install-recommends {packages...}"
    );
    // A new machine often has an old list of packages, or none.
    if install.run().is_err() {
        let update = cmd!(sh, "env {sudo...} apt-get update").run();
        update.and_then(|()| install.run()).with_context(by_hand)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_programs_of_the_wanted_browsers_are_needed() {
        let packages = |browsers: &str| -> Vec<_> {
            let needed = needed_by(&among(browsers));
            needed.iter().map(|program| program.packages[0]).collect()
        };
        assert_eq!(packages(""), ["firefox-esr", "webkit2gtk-driver", "xvfb"]);
        assert_eq!(packages("chromium, webkit"), ["webkit2gtk-driver", "xvfb"]);
        assert!(packages("chromium").is_empty());
    }

    #[test]
    fn a_bare_machine_is_told_of_every_package_at_once() {
        let every = missing(true, true, |_| false);
        for program in [&CHROMIUM, &CHROMEDRIVER, &GLSLANG, &VALGRIND, &COMPILER] {
            assert!(
                program
                    .packages
                    .iter()
                    .all(|package| every.contains(package))
            );
        }
        let message = by_hand(&every);
        assert!(message.starts_with("run: sudo apt-get install glslang-tools chromium "));
        assert!(every.iter().all(|package| message.contains(package)));
        assert_eq!(missing(false, false, |_| false), GLSLANG.packages);
        assert!(missing(true, true, |_| true).is_empty());
    }
}

//! The static site: the wasm modules, the files of `web/`, the page and examples.
//!
//! cargo compiles, wasm-bindgen's command line makes the modules as a library
//! of this program: its version is that of the bindings by `Cargo.lock`, and
//! nobody has to install it. Every URL of the site is relative, so the folder
//! works wherever it is put.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, anyhow, bail};
use wasm_bindgen_cli_support::Bindgen;

use crate::{paths, process, script, tools};

/// A crate that becomes a wasm module.
pub(crate) struct Module {
    /// Its name, and that of the module.
    pub package: &'static str,
    /// The profile that it is compiled with.
    pub profile: &'static str,
}

const MODULES: [Module; 3] = [
    Module {
        package: "hearth-engine",
        profile: "engine",
    },
    Module {
        package: "hearth-sim",
        profile: "engine",
    },
    Module {
        package: "hearth-panel",
        profile: "panel",
    },
];

/// Builds the whole site in `dist/site`.
///
/// # Errors
/// A tool that is missing, code that does not compile, a disk that is full.
pub fn build() -> Result<()> {
    tools::wasm_target()?;
    script::tools()?;
    let start = Instant::now();
    println!("Building the site (the first time takes some minutes) …");
    // The last part of each is one long link on one core, and profiles do not
    // share a folder: so all at once, those of one profile by one cargo.
    let profiles: BTreeSet<_> = MODULES.iter().map(|module| module.profile).collect();
    thread::scope(|scope| {
        let builds = profiles.into_iter().map(|profile| {
            let modules = MODULES
                .iter()
                .filter(move |module| module.profile == profile);
            scope.spawn(move || compile_together(modules))
        });
        // Started before the first is waited for.
        let builds: Vec<_> = builds.collect();
        let mut first_error = Ok(());
        for build in builds {
            let built = build
                .join()
                .unwrap_or_else(|_| Err(anyhow!("a build ended unexpectedly")));
            first_error = first_error.and(built);
        }
        first_error
    })?;

    let site = paths::site();
    if site.exists() {
        fs::remove_dir_all(&site)
            .with_context(|| format!("cannot clear {}", paths::shown(&site)))?;
    }
    copy_folder(&paths::root().join("web"), &site.join("web"))?;
    for module in &MODULES {
        let wasm = site.join("web").join("wasm");
        bind(module, module.package, &wasm)?;
        keep_types(module.package, &wasm)?;
    }
    script::minify(&site.join("web"))?;
    copy_pages(&paths::root().join("examples"), &site.join("examples"))?;
    let page = paths::root().join("index.html");
    let html = fs::read_to_string(&page)
        .with_context(|| format!("cannot read {}", paths::shown(&page)))?;
    fs::write(site.join("index.html"), without_trunk_links(&html))?;
    println!(
        "Built {} in {:.0} s.",
        paths::shown(&site),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}

/// Compiles `module` to wasm.
pub(crate) fn compile(module: &Module) -> Result<()> {
    compile_together([module])
}

/// Compiles modules of one profile to wasm.
fn compile_together<'a>(modules: impl IntoIterator<Item = &'a Module>) -> Result<()> {
    let mut cargo = process::cargo();
    cargo.args(["build", "--target", tools::WASM, "--lib"]);
    for (at, module) in modules.into_iter().enumerate() {
        if at == 0 {
            cargo.args(["--profile", module.profile]);
        }
        cargo.args(["--package", module.package]);
    }
    process::run(&mut cargo)
}

/// Where cargo leaves what it builds, which a person may have moved.
pub(crate) fn target_folder() -> Result<PathBuf> {
    let described =
        process::output(process::cargo().args(["metadata", "--format-version", "1", "--no-deps"]))?;
    let described: serde_json::Value = serde_json::from_str(&described)?;
    described["target_directory"]
        .as_str()
        .map(PathBuf::from)
        .context("cargo does not say where its target folder is")
}

/// Makes `name.js` and `name_bg.wasm` of the compiled `module`.
pub(crate) fn bind(module: &Module, name: &str, into: &Path) -> Result<()> {
    // cargo's own profile has a folder of another name.
    let profile = match module.profile {
        "dev" => "debug",
        other => other,
    };
    let wasm = target_folder()?
        .join(tools::WASM)
        .join(profile)
        .join(format!("{}.wasm", module.package.replace('-', "_")));
    if !wasm.is_file() {
        bail!("{} gave no {}", module.package, wasm.display());
    }
    Bindgen::new()
        .input_path(wasm)
        .out_name(name)
        .web(true)
        .and_then(|bindgen| {
            bindgen
                .typescript(true)
                .omit_default_module_path(false)
                .remove_name_section(true)
                .remove_producers_section(true)
                .generate(into)
        })
        .with_context(|| format!("cannot make the bindings of {}", module.package))
}

/// Moves the types of a module from `wasm` to `dist/types/wasm`: the `types` stage reads them,
/// visitors do not.
fn keep_types(name: &str, wasm: &Path) -> Result<()> {
    let types = paths::site().with_file_name("types").join("wasm");
    fs::create_dir_all(&types)?;
    let file = format!("{name}.d.ts");
    fs::rename(wasm.join(&file), types.join(file))?;
    Ok(fs::remove_file(wasm.join(format!("{name}_bg.wasm.d.ts")))?)
}

/// Copies a folder with all that lies in it.
pub(crate) fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    let listed =
        fs::read_dir(from).with_context(|| format!("cannot read {}", paths::shown(from)))?;
    for entry in listed {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy_folder(&entry.path(), &target)?;
        } else {
            fs::copy(entry.path(), target)?;
        }
    }
    Ok(())
}

/// Copies the pages that stand in the folder itself: what lies deeper needs packages.
fn copy_pages(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    let listed =
        fs::read_dir(from).with_context(|| format!("cannot read {}", paths::shown(from)))?;
    for entry in listed {
        let path = entry?.path();
        if path.extension().is_some_and(|ending| ending == "html") {
            fs::copy(&path, to.join(path.file_name().unwrap_or_default()))?;
        }
    }
    Ok(())
}

/// `html` without the `<link data-trunk …>` lines, which tell Trunk what to
/// build and mean nothing to a browser.
fn without_trunk_links(html: &str) -> String {
    let mut kept = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(start) = rest.find("<link") {
        let end = rest[start..]
            .find('>')
            .map_or(rest.len(), |length| start + length + 1);
        if rest[start..end].contains("data-trunk") {
            // The line's indentation and end go as well.
            kept.push_str(rest[..start].trim_end_matches([' ', '\t']));
            rest = rest[end..].trim_start_matches([' ', '\t', '\r']);
            rest = rest.strip_prefix('\n').unwrap_or(rest);
        } else {
            kept.push_str(&rest[..end]);
            rest = &rest[end..];
        }
    }
    kept.push_str(rest);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_for_trunk_are_left_out() {
        let html = "<head>\n  <link rel=\"stylesheet\" href=\"a.css\">\n  \
                    <link data-trunk rel=\"rust\"\n    href=\"crates/x\" />\n\
                    <link data-trunk rel=\"copy-dir\" href=\"web\">\r\n  <title>t</title>\n";
        assert_eq!(
            without_trunk_links(html),
            "<head>\n  <link rel=\"stylesheet\" href=\"a.css\">\n  <title>t</title>\n"
        );
    }

    #[test]
    fn html_that_breaks_off_is_kept_whole() {
        assert_eq!(without_trunk_links("<p>é<link rel="), "<p>é<link rel=");
        assert_eq!(without_trunk_links(""), "");
    }

    #[test]
    fn every_module_is_a_crate_of_the_workspace() {
        for module in &MODULES {
            let manifest = paths::root()
                .join("crates")
                .join(module.package)
                .join("Cargo.toml");
            assert!(manifest.is_file(), "{} is missing", manifest.display());
        }
    }
}

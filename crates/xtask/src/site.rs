//! The static site: the wasm modules, the files of `web/`, the page and examples.
//!
//! cargo compiles, and wasm-bindgen's command line binds the modules as a library of this
//! program: `Cargo.lock` pins it to the version of the bindings. Every URL of the site is
//! relative, so the folder works wherever it is put.

use std::path::Path;
use std::time::Instant;
use std::{iter, thread};

use anyhow::{Context, Result, anyhow, ensure};
use wasm_bindgen_cli_support::Bindgen;
use xshell::cmd;

use crate::pages::{self, Places};
use crate::shell::Shell;
use crate::{parts, paths, script, tools};

/// A crate that becomes a wasm module of the same name.
pub struct Module {
    /// The name of the crate.
    pub package: &'static str,
    /// The profile that it is compiled with.
    pub profile: &'static str,
}

impl Module {
    /// The crate of that name, compiled with that profile.
    pub const fn new(package: &'static str, profile: &'static str) -> Module {
        Module { package, profile }
    }
}

const ENGINE: Module = Module::new("hearth-engine", "engine");
const SIM: Module = Module::new("hearth-sim", "engine");
const PANEL: Module = Module::new("hearth-panel", "panel");

/// Builds the whole site in `dist/site`.
pub fn build() -> Result<()> {
    tools::wasm_target()?;
    script::tools()?;
    let _lock = tools::writing(&paths::dist())?;
    let start = Instant::now();
    println!("Building the site (the first time takes some minutes) …");
    // Each build ends in one long link on one core, and profiles share no folder: so both
    // profiles are built at once.
    thread::scope(|scope| {
        let panel = scope.spawn(|| compile(&PANEL, &[]));
        let others = compile(&ENGINE, &[&SIM]);
        let panel = panel.join();
        others.and(panel.unwrap_or_else(|_| Err(anyhow!("the build of the panel panicked"))))
    })?;

    let (root, site) = (paths::root(), paths::site());
    let (sh, web) = (Shell::new()?, site.join("web"));
    sh.remove_path(&site)?;
    copy_folder(&sh, &root.join("web"), &web)?;
    for module in [&ENGINE, &SIM, &PANEL] {
        let wasm = web.join("wasm");
        bind(module, module.package, &wasm)?;
        keep_types(&sh, module.package, &wasm)?;
    }
    parts::divide(&sh, &web)?;
    script::minify(&web)?;
    script::bundle_worlds(&site)?;
    let examples = sh.create_dir(site.join("examples"))?;
    for example in sh.read_dir("examples")? {
        if example.extension() == Some("html".as_ref()) {
            sh.copy_file(example, &examples)?;
        }
    }
    for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
        sh.copy_file(licence, &web)?;
    }
    let packaging = paths::packaging();
    cmd!(sh, "node {packaging}/legal.mjs {web}").run()?;
    let html = sh.read_file("index.html")?;
    sh.write_file(site.join("index.html"), without_trunk_links(&html))?;
    pages::write(&root, &site, &Places::default())?;
    let seconds = start.elapsed().as_secs();
    println!("Built {} in {seconds} s.", paths::shown(&site));
    Ok(())
}

/// Compiles modules to wasm, in the profile of the first.
pub fn compile(first: &Module, others: &[&Module]) -> Result<()> {
    let (sh, wasm, profile) = (Shell::new()?, tools::WASM, first.profile);
    let modules = iter::once(&first).chain(others);
    let packages = modules.flat_map(|module| ["--package", module.package]);
    let cargo = sh.cargo(&format!("build --lib --target {wasm} --profile {profile}"));
    let (name, flags) = tools::portable_paths()?;
    Ok(cargo.args(packages).env(name, flags).run()?)
}

/// Makes `name.js` and `name_bg.wasm` of the compiled `module`.
pub fn bind(module: &Module, name: &str, into: &Path) -> Result<()> {
    let file = format!("{}.wasm", module.package.replace('-', "_"));
    let wasm = tools::target()?
        .join(tools::WASM)
        .join(module.profile)
        .join(file);
    ensure!(
        wasm.is_file(),
        "cargo made no {} of {}",
        wasm.display(),
        module.package
    );
    Bindgen::new()
        .input_path(wasm)
        .out_name(name)
        .web(true)
        .and_then(|bindgen| {
            bindgen
                .typescript(true)
                .omit_default_module_path(false)
                // `wasm-parts` finds dead functions by name, and then removes the names.
                .remove_name_section(false)
                .remove_producers_section(true)
                .generate(into)
        })
        .with_context(|| format!("cannot bind {} to JavaScript", module.package))
}

/// Moves the types of a module from `wasm` to `dist/types/wasm`: the stage `types` reads
/// them, visitors do not.
fn keep_types(sh: &Shell, name: &str, wasm: &Path) -> Result<()> {
    let types = sh.create_dir(paths::site().with_file_name("types").join("wasm"))?;
    sh.copy_file(wasm.join(format!("{name}.d.ts")), types)?;
    sh.remove_path(wasm.join(format!("{name}.d.ts")))?;
    Ok(sh.remove_path(wasm.join(format!("{name}_bg.wasm.d.ts")))?)
}

/// Copies a folder with everything in it.
pub(crate) fn copy_folder(sh: &Shell, from: &Path, to: &Path) -> Result<()> {
    sh.create_dir(to)?;
    for path in sh.read_dir(from)? {
        if path.is_dir() {
            copy_folder(sh, &path, &to.join(path.file_name().unwrap_or_default()))?;
        } else {
            sh.copy_file(path, to)?;
        }
    }
    Ok(())
}

/// `html` without the `<link data-trunk …>` tags, which name to Trunk what to build.
fn without_trunk_links(html: &str) -> String {
    let mut kept = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(start) = rest.find("<link") {
        let end = rest[start..]
            .find('>')
            .map_or(rest.len(), |length| start + length + 1);
        if rest[start..end].contains("data-trunk") {
            // The indentation and the end of the line go as well.
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
    fn links_for_trunk_are_removed() {
        let html = "<head>\n  <link rel=\"stylesheet\" href=\"a.css\">\n  \
                    <link data-trunk rel=\"rust\"\n    href=\"crates/x\" />\n\
                    <link data-trunk rel=\"copy-dir\" href=\"web\">\r\n  <title>t</title>\n";
        assert_eq!(
            without_trunk_links(html),
            "<head>\n  <link rel=\"stylesheet\" href=\"a.css\">\n  <title>t</title>\n"
        );
        // HTML that ends within a tag is kept whole.
        assert_eq!(without_trunk_links("<p>é<link rel="), "<p>é<link rel=");
        assert_eq!(without_trunk_links(""), "");
    }
}

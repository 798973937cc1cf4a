//! The static site: the wasm modules, the files of `web/`, the page and examples.
//!
//! cargo compiles, and wasm-bindgen's command line binds the modules as a library of this
//! program: `Cargo.lock` pins it to the version of the bindings. Every URL of the site is
//! relative, so the folder works wherever it is put.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, anyhow, ensure};
use walrus::RawCustomSection;
use wasm_bindgen_cli_support::Bindgen;
use xshell::cmd;

use crate::shell::Shell;
use crate::{paths, script, tools};

/// A crate that becomes a wasm module of the same name.
pub(crate) struct Module {
    pub package: &'static str,
    /// The profile that it is compiled with.
    pub profile: &'static str,
}

const ENGINE: Module = Module {
    package: "hearth-engine",
    profile: "engine",
};
const SIM: Module = Module {
    package: "hearth-sim",
    profile: "engine",
};
const PANEL: Module = Module {
    package: "hearth-panel",
    profile: "panel",
};

/// Builds the whole site in `dist/site`.
pub(crate) fn build() -> Result<()> {
    tools::wasm_target()?;
    script::tools()?;
    let start = Instant::now();
    println!("Building the site (the first time takes some minutes) …");
    // Each build ends in one long link on one core, and profiles share no folder: so both
    // profiles are built at once.
    thread::scope(|scope| {
        let panel = scope.spawn(|| compile(&[&PANEL]));
        let others = compile(&[&ENGINE, &SIM]);
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
    shorten_imports(&sh, &web)?;
    script::minify(&web)?;
    // Examples in folders of their own need packages.
    let examples = sh.create_dir(site.join("examples"))?;
    for example in sh.read_dir("examples")? {
        if example.extension() == Some("html".as_ref()) {
            sh.copy_file(example, &examples)?;
        }
    }
    let html = sh.read_file("index.html")?;
    sh.write_file(site.join("index.html"), without_trunk_links(&html))?;
    println!(
        "Built {} in {:.0} s.",
        paths::shown(&site),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}

/// Compiles modules of one profile to wasm.
pub(crate) fn compile(modules: &[&Module]) -> Result<()> {
    let sh = Shell::new()?;
    let wasm = tools::WASM;
    let mut cargo = cmd!(sh, "cargo build --lib --target {wasm}");
    for module in modules {
        cargo = cargo.arg("--package").arg(module.package);
    }
    let profile = modules.first().map(|module| ["--profile", module.profile]);
    Ok(cargo.args(profile.into_iter().flatten()).run()?)
}

/// Makes `name.js` and `name_bg.wasm` of the compiled `module`.
pub(crate) fn bind(module: &Module, name: &str, into: &Path) -> Result<()> {
    // The folder of cargo's own profile has another name.
    let profile = match module.profile {
        "dev" => "debug",
        other => other,
    };
    let file = format!("{}.wasm", module.package.replace('-', "_"));
    let wasm = tools::target()?.join(tools::WASM).join(profile).join(file);
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
                .remove_name_section(true)
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

/// Shortens the names between each wasm module and its script, in both files, and writes the
/// version into the module.
/// wasm-bindgen ends each in a hash, so that several versions of a crate may meet in one
/// module; sixteen random letters cannot be compressed.
pub(crate) fn shorten_imports(sh: &Shell, web: &Path) -> Result<()> {
    for wasm in sh.read_dir(web.join("wasm"))? {
        let name = wasm.file_name().unwrap_or_default().to_string_lossy();
        let Some(name) = name.strip_suffix("_bg.wasm") else {
            continue;
        };
        let mut config = walrus::ModuleConfig::new();
        config
            .generate_producers_section(false)
            .generate_name_section(false);
        let mut module = config.parse_file(&wasm)?;
        let script = wasm.with_file_name(format!("{name}.js"));
        let mut code = sh.read_file(&script)?;
        let mut taken = BTreeSet::new();
        for import in module.imports.iter_mut() {
            let hash = |text: &str| text.len() == 16 && u64::from_str_radix(text, 16).is_ok();
            let plain = match import.name.rsplit_once('_') {
                Some((plain, end)) if hash(end) => plain,
                _ => &import.name,
            };
            let mut short = plain.to_owned();
            for number in 1.. {
                if taken.insert(short.clone()) {
                    break;
                }
                short = format!("{plain}{number}");
            }
            if short != import.name {
                code = code.replace(&import.name, &short);
                import.name = short;
            }
        }
        // The element reads the version before it starts the module.
        module.customs.add(RawCustomSection {
            name: "hearth".to_owned(),
            data: env!("CARGO_PKG_VERSION").into(),
        });
        module.emit_wasm_file(&wasm)?;
        sh.write_file(script, code)?;
    }
    Ok(())
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

/// Every file under `folder`, by its path there with `/` between, and its content.
pub(crate) fn files(sh: &Shell, folder: &Path) -> Result<BTreeMap<String, Vec<u8>>> {
    let mut found = BTreeMap::new();
    for path in sh.read_dir(folder)? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() {
            let below = files(sh, &path)?.into_iter();
            found.extend(below.map(|(file, content)| (format!("{name}/{file}"), content)));
        } else {
            found.insert(name.into_owned(), fs::read(&path)?);
        }
    }
    Ok(found)
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

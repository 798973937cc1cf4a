//! The glue, the script that wasm-bindgen makes of a module: shorter, together with the module.

use std::cmp::Reverse;
use std::collections::HashSet;

use anyhow::{Context, Result, ensure};
use walrus::{ElementItems, Module, ModuleConfig};

use crate::{Divided, Part, REST, order, take};

/// Functions that only wasm-bindgen calls while it binds, yet the function table keeps: adapters
/// of closures (JavaScript calls those in use by an export, not by the table) and the wakers of
/// futures, which the engine and the library lack.
const DEAD: [&str; 2] = ["wasm_bindgen::convert::closures::", "js_sys::futures::"];

/// The start of the glue's loader, which reaches to the end.
const LOADER: &str = "let wasmModule, wasmInstance, wasm;";

/// The loader of a compiled module, which the caller has fetched. A `fresh` instance replaces the
/// earlier one, which may be damaged by a panic, and whose memory never shrinks; no object of the
/// earlier one may be used. A `part` of the module is added to the instance.
const SHORT_LOADER: &str = "\
let wasm, ready;
export default ({ module_or_path, fresh, part }) => part
  ? new WebAssembly.Instance(part, { \"rest\": wasm })
  : ready = !fresh && ready || WebAssembly.instantiate(module_or_path, __wbg_get_imports()).then(
    (made) => {
      wasm = made.exports;
      wasm.__wbindgen_start();
      return wasm;
    },
  ).catch((error) => {
    ready = undefined;
    throw error;
  });
";

/// Pieces of the glue that no browser with SIMD needs, and those without show a message instead of
/// a fire: from the first text to the second, and what replaces both.
const PIECES: [[&str; 3]; 6] = [
    [
        "if (cachedDataViewMemory0 === null ||",
        ") {",
        "if (cachedDataViewMemory0?.buffer !== wasm.memory.buffer) {",
    ],
    // Another instance has another memory.
    [
        "if (cachedUint8ArrayMemory0 === null ||",
        ") {",
        "if (cachedUint8ArrayMemory0?.buffer !== wasm.memory.buffer) {",
    ],
    [
        "(typeof FinalizationRegistry === 'undefined')",
        ": new FinalizationRegistry",
        "new FinalizationRegistry",
    ],
    // Of the two ways to pass a text, the short one.
    ["    if (realloc === undefined) {", "\n", ""],
    [
        "return ptr;\n    }\n\n    let len",
        "return ptr;\n}",
        "return ptr;\n}",
    ],
    ["if (!('encodeInto' in cachedTextEncoder)) {", "\n}\n", ""],
];

/// A module by wasm-bindgen and its script, the glue.
pub struct Bound {
    module: Module,
    glue: String,
    /// The version of the module, which the glue and the parts share.
    version: &'static str,
}

impl Bound {
    /// The module of these bytes and its glue.
    ///
    /// # Errors
    /// The module is invalid.
    pub fn new(wasm: &[u8], glue: String, version: &'static str) -> Result<Bound> {
        let module = ModuleConfig::new().parse(wasm)?;
        Ok(Bound {
            module,
            glue,
            version,
        })
    }

    /// Removes what no browser needs, and lets the caller of the glue fetch the module.
    ///
    /// # Errors
    /// The glue is not as it is known.
    pub fn remove_dead(&mut self) -> Result<()> {
        self.glue = short(&self.glue)?;
        remove_dead(&mut self.module, &self.glue);
        Ok(())
    }

    /// Takes a part out of the module; returns it as bytes.
    ///
    /// # Errors
    /// As [`take`].
    pub fn take(&mut self, part: &Part) -> Result<Vec<u8>> {
        let Divided { rest, taken } = take(&self.module.emit_wasm(), part)?;
        self.module = ModuleConfig::new().parse(&rest)?;
        finished(nameless(&taken)?, self.version)
    }

    /// The module with short names, as bytes, and its glue.
    ///
    /// # Errors
    /// The glue is not of this module.
    pub fn finish(mut self) -> Result<(Vec<u8>, String)> {
        let mut module = nameless(&self.module.emit_wasm())?;
        shorten_names(&mut module, &mut self.glue)?;
        name_version(&module, &mut self.glue, self.version)?;
        Ok((finished(module, self.version)?, self.glue))
    }
}

/// The module of these bytes, without the names of its functions.
fn nameless(bytes: &[u8]) -> Result<Module> {
    ModuleConfig::new()
        .generate_producers_section(false)
        .generate_name_section(false)
        .parse(bytes)
}

/// A module as it is downloaded.
fn finished(mut module: Module, version: &str) -> Result<Vec<u8>> {
    // The element reads the version here before it starts the module.
    for import in module.imports.iter_mut() {
        version.clone_into(&mut import.module);
    }
    // A browser finds the features by itself.
    module.customs.remove_raw("target_features");
    order(&module.emit_wasm())
}

/// Removes exports that the glue does not name, and puts another function of the table in the
/// place of dead ones.
fn remove_dead(module: &mut Module, code: &str) {
    let unused: Vec<_> = module
        .exports
        .iter()
        .filter(|export| !code.contains(&format!("wasm.{}", export.name)))
        .map(|export| export.id())
        .collect();
    for export in unused {
        module.exports.delete(export);
    }
    let is_dead = |name: &str| DEAD.iter().any(|part| name.contains(part));
    let dead: HashSet<_> = module
        .funcs
        .iter()
        .filter(|function| function.name.as_deref().is_some_and(is_dead))
        .map(|function| function.id())
        .collect();
    for element in module.elements.iter_mut() {
        if let ElementItems::Functions(functions) = &mut element.items
            && let Some(&kept) = functions.iter().find(|function| !dead.contains(function))
        {
            for function in functions
                .iter_mut()
                .filter(|function| dead.contains(function))
            {
                *function = kept;
            }
        }
    }
    walrus::passes::gc::run(module);
}

/// Gives each import and each private export a name of a letter or two. wasm-bindgen ends imports
/// in a hash, so that several versions of a crate may meet in one module; sixteen random letters
/// cannot be compressed.
fn shorten_names(module: &mut Module, code: &mut String) -> Result<()> {
    let imports = module
        .imports
        .iter_mut()
        .map(|import| (&mut import.name, [" ", ": function"]));
    let private = module
        .exports
        .iter_mut()
        .map(|export| (&mut export.name, ["wasm.", ""]))
        .filter(|(name, _)| name.starts_with("__"));
    let mut names: Vec<_> = imports.chain(private).collect();
    // Longer names first: one may begin with another. Otherwise by name, so that the linker's
    // order does not matter.
    names.sort_by_cached_key(|(name, _)| (Reverse(name.len()), (*name).clone()));
    for (number, (name, [before, after])) in names.into_iter().enumerate() {
        let short = letters(number);
        let long = format!("{before}{name}{after}");
        // Wasm may export what the glue does not use.
        let imported = !after.is_empty();
        ensure!(!imported || code.contains(&long), "the glue lacks {name}");
        *code = code.replace(&long, &format!("{before}{short}{after}"));
        *name = short;
    }
    Ok(())
}

/// Writes the version into the glue, as the name of what wasm imports: short names of other versions
/// mean other functions, and a cache may hold an old file beside a new one.
fn name_version(module: &Module, code: &mut String, version: &str) -> Result<()> {
    let version = format!("\"{version}\"");
    for import in module.imports.iter() {
        *code = code.replace(&format!("\"{}\"", import.module), &version);
    }
    *code = code.replace(&format!("\"{REST}\""), &version);
    ensure!(
        code.contains(&format!("{version}:")),
        "the glue lacks the name of its module"
    );
    Ok(())
}

/// A name of letters: a, b, … z, ba, bb, …
fn letters(number: usize) -> String {
    let letter = char::from(b'a' + (number % 26) as u8);
    match number / 26 {
        0 => letter.to_string(),
        rest => letters(rest) + &letter.to_string(),
    }
}

/// The glue with the short loader and without [`PIECES`].
fn short(code: &str) -> Result<String> {
    let (code, _) = code.split_once(LOADER).context(LOADER)?;
    let mut code = code.to_owned();
    for [from, to, replacement] in PIECES {
        let start = code.find(from).context(from)?;
        let end = code[start..].find(to).context(to)? + start + to.len();
        code.replace_range(start..end, replacement);
    }
    let code = code.replace(", wasm.__wbindgen_realloc", "");
    Ok(code + SHORT_LOADER)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique() {
        let names: HashSet<_> = (0..2000).map(letters).collect();
        assert_eq!(names.len(), 2000);
        assert_eq!([0, 25, 26, 27].map(letters), ["a", "z", "ba", "bb"]);
    }

    #[test]
    fn only_what_is_dead_leaves_a_module() -> Result<()> {
        let mut module = Module::default();
        let function = |module: &mut Module, name: &str| {
            let mut builder = walrus::FunctionBuilder::new(&mut module.types, &[], &[]);
            builder.name(name.to_owned());
            builder.finish(Vec::new(), &mut module.funcs)
        };
        let dead = function(
            &mut module,
            "wasm_bindgen::convert::closures::_::invoke::h0",
        );
        let live = function(&mut module, "core::fmt::write");
        let used = function(&mut module, "used");
        let unused = function(&mut module, "unused");
        let table = module
            .tables
            .add_local(false, 3, None, walrus::RefType::FUNCREF);
        let kind = walrus::ElementKind::Active {
            table,
            offset: walrus::ConstExpr::Value(walrus::ir::Value::I32(1)),
        };
        let items = ElementItems::Functions(vec![dead, live]);
        let element = module.elements.add(kind, items);
        module.tables.get_mut(table).elem_segments.insert(element);
        for (name, id) in [("used", used), ("__unused", unused)] {
            module.exports.add(name, id);
        }
        module.exports.add("table", table);
        remove_dead(&mut module, "wasm.used(); wasm.table;");
        let functions: Vec<_> = module.funcs.iter().map(|one| one.id()).collect();
        assert_eq!(functions, [live, used]);
        for element in module.elements.iter() {
            assert!(
                matches!(&element.items, ElementItems::Functions(all) if all[..] == [live, live])
            );
        }
        Ok(())
    }

    #[test]
    fn unknown_glue_is_refused() {
        assert!(short("export { init as default };").is_err());
    }
}

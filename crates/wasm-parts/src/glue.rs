//! The glue, the script that wasm-bindgen makes of a module, together with the module.

use anyhow::{Context, Result, ensure};
use walrus::{Module, ModuleConfig};
use wasm_encoder::{CustomSection, Section};

use crate::{BASE, Divided, Part, order, take};

/// The start of the glue's loader, which fetches the module and reaches to the end.
const LOADER: &str = "async function __wbg_load(";

/// The loader of a compiled module, which the caller has fetched. A `fresh` instance replaces the
/// earlier one, which may be damaged by a panic, and whose memory never shrinks; no object of the
/// earlier one may be used. A `part` of the module is added to the instance.
const LOADER_OF_COMPILED: &str = "\
let ready;
export default ({ module_or_path, fresh, part }) => part
  ? new WebAssembly.Instance(part, { \"base\": wasm })
  : ready = !fresh && ready || WebAssembly.instantiate(module_or_path, __wbg_get_imports()).then(
    (instance) => __wbg_finalize_init(instance, module_or_path),
  ).catch((error) => {
    ready = undefined;
    throw error;
  });
";

/// The custom section of a module that has the hash of its bytes and those of its parts, which these have as well.
const BUILD: &str = "build";

/// A module by wasm-bindgen and its script, the glue.
pub struct Bound {
    module: Module,
    glue: String,
    /// The version of the module, which the glue and the parts share.
    version: &'static str,
    /// The parts that are taken, by name.
    parts: Vec<(&'static str, Vec<u8>)>,
}

/// What a page loads.
pub struct Files {
    /// The module.
    pub module: Vec<u8>,
    /// Its glue.
    pub glue: String,
    /// Its parts, by name.
    pub parts: Vec<(&'static str, Vec<u8>)>,
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
            parts: Vec::new(),
        })
    }

    /// Lets the caller of the glue fetch the module.
    ///
    /// # Errors
    /// The glue is not as it is known.
    pub fn let_caller_load(&mut self) -> Result<()> {
        let (before, _) = self.glue.split_once(LOADER).context(LOADER)?;
        self.glue = before.to_owned() + LOADER_OF_COMPILED;
        Ok(())
    }

    /// Takes a part out of the module.
    ///
    /// # Errors
    /// The module has neither a function nor a text of the part.
    pub fn take(&mut self, part: &Part) -> Result<()> {
        let Divided { base, taken } = take(&self.module.emit_wasm(), part)?;
        self.module = ModuleConfig::new().parse(&base)?;
        self.parts
            .push((part.name, finished(&taken, self.version)?));
        Ok(())
    }

    /// The module, its glue and its parts. A script compares the hashes in them before it adds a part: a part
    /// imports by number, and of another build it would have other functions.
    ///
    /// # Errors
    /// The glue is not of this module.
    pub fn finish(mut self) -> Result<Files> {
        name_version(&self.module, &mut self.glue, self.version)?;
        let mut module = finished(&self.module.emit_wasm(), self.version)?;
        let parts = self.parts.iter().flat_map(|(_, part)| part);
        let build = hash(module.iter().chain(parts));
        for (name, part) in &mut self.parts {
            append(part, &format!("part:{name}"), &build);
        }
        if !self.parts.is_empty() {
            append(&mut module, BUILD, &build);
        }
        Ok(Files {
            module,
            glue: self.glue,
            parts: self.parts,
        })
    }
}

/// The FNV-1a hash of bytes.
fn hash<'a>(bytes: impl Iterator<Item = &'a u8>) -> [u8; 8] {
    let mixed = |hash: u64, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
    bytes.fold(0xcbf2_9ce4_8422_2325, mixed).to_le_bytes()
}

/// Appends a custom section to the module of these bytes.
fn append(module: &mut Vec<u8>, name: &str, data: &[u8]) {
    let (name, data) = (name.into(), data.into());
    CustomSection { name, data }.append_to(module);
}

/// A module as it is downloaded: without the names of its functions.
fn finished(bytes: &[u8], version: &str) -> Result<Vec<u8>> {
    let mut module = ModuleConfig::new()
        .generate_producers_section(false)
        .generate_name_section(false)
        .parse(bytes)?;
    // The element reads the version here before it starts the module.
    for import in module.imports.iter_mut() {
        version.clone_into(&mut import.module);
    }
    // A browser finds the features by itself.
    module.customs.remove_raw("target_features");
    order(&module.emit_wasm())
}

/// Writes the version into the glue, as the name of what wasm imports: a cache may hold an old file
/// beside a new one.
fn name_version(module: &Module, code: &mut String, version: &str) -> Result<()> {
    let version = format!("\"{version}\"");
    for import in module.imports.iter() {
        *code = code.replace(&format!("\"{}\"", import.module), &version);
    }
    *code = code.replace(&format!("\"{BASE}\""), &version);
    ensure!(
        code.contains(&format!("{version}:")),
        "the glue lacks the name of its module"
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The data of a custom section.
    fn section(wasm: &[u8], name: &str) -> Option<Vec<u8>> {
        let mut module = Module::from_buffer(wasm).ok()?;
        Some(module.customs.remove_raw(name)?.data)
    }

    /// The build of a module that returns a number, and that of its part.
    fn builds(number: i32) -> Result<[Option<Vec<u8>>; 2]> {
        let glue = "{ \"./glue.js\": 1 }".to_owned();
        let mut bound = Bound::new(&crate::tests::module(number).emit_wasm(), glue, "./glue.js")?;
        bound.take(&crate::tests::PART)?;
        let files = bound.finish()?;
        let [(name, part)] = files.parts.as_slice() else {
            panic!("{} parts", files.parts.len());
        };
        Ok([(&files.module, BUILD), (part, &format!("part:{name}"))]
            .map(|(wasm, name)| section(wasm, name)))
    }

    #[test]
    fn a_module_and_its_part_have_the_same_build_and_other_modules_another() -> Result<()> {
        let [module, part] = builds(1)?;
        assert!(module.is_some());
        assert_eq!(part, module);
        assert_eq!(builds(1)?, [module.clone(), module.clone()]);
        assert_ne!(builds(2)?[0], module);
        Ok(())
    }

    #[test]
    fn unknown_glue_is_an_error() -> Result<()> {
        let wasm = Module::default().emit_wasm();
        let glue = "export { init as default };".to_owned();
        assert!(Bound::new(&wasm, glue, "1.0.0")?.let_caller_load().is_err());
        Ok(())
    }
}

//! The glue, the script that wasm-bindgen makes of a module, together with the module.

use anyhow::{Context, Result, ensure};
use walrus::{Module, ModuleConfig, RawCustomSection};

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

    /// Lets the caller of the glue fetch the module.
    ///
    /// # Errors
    /// The glue is not as it is known.
    pub fn let_caller_load(&mut self) -> Result<()> {
        let (before, _) = self.glue.split_once(LOADER).context(LOADER)?;
        self.glue = before.to_owned() + LOADER_OF_COMPILED;
        Ok(())
    }

    /// Takes a part out of the module; returns it as bytes.
    ///
    /// # Errors
    /// The module has no function of the part.
    pub fn take(&mut self, part: &Part) -> Result<Vec<u8>> {
        let Divided { base, taken } = take(&self.module.emit_wasm(), part)?;
        self.module = ModuleConfig::new().parse(&base)?;
        let mut taken = ModuleConfig::new().parse(&taken)?;
        // A script checks it before it adds the part.
        taken.customs.add(RawCustomSection {
            name: format!("part:{}", part.name),
            data: Vec::new(),
        });
        finished(&taken.emit_wasm(), self.version)
    }

    /// The module, as bytes, and its glue.
    ///
    /// # Errors
    /// The glue is not of this module.
    pub fn finish(mut self) -> Result<(Vec<u8>, String)> {
        name_version(&self.module, &mut self.glue, self.version)?;
        Ok((finished(&self.module.emit_wasm(), self.version)?, self.glue))
    }
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

    #[test]
    fn unknown_glue_is_an_error() -> Result<()> {
        let wasm = Module::default().emit_wasm();
        let glue = "export { init as default };".to_owned();
        assert!(Bound::new(&wasm, glue, "1.0.0")?.let_caller_load().is_err());
        Ok(())
    }
}

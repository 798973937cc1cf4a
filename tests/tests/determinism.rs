//! Same seed, same bits: on every run, and natively as in wasm.
//!
//! Natively, runs are compared with one another. Built for wasm and run in
//! Node, the same runs are compared with those of the native program
//! `examples/fingerprint.rs`. `HEARTH_FINGERPRINTS` names a file with what it
//! prints, which `cargo xtask test` writes in each run, once for all stages.

#[cfg(not(target_arch = "wasm32"))]
mod natively {
    use std::collections::HashSet;
    use std::{env, fs, thread};

    use hearth_core::params::{Input, Model, Parameters};
    use hearth_tests::{fingerprint, fingerprints};

    #[test]
    fn the_same_seed_gives_the_same_bits() {
        let elsewhere = || match env::var_os("HEARTH_FINGERPRINTS") {
            Some(file) => fs::read_to_string(file).unwrap(),
            None => fingerprints(),
        };
        // Two threads halve the time, and share nothing either.
        let (prints, again) = thread::scope(|scope| {
            let again = scope.spawn(elsewhere);
            (fingerprints(), again.join().unwrap())
        });
        assert_eq!(prints, again);
        // A platform looks its fires up by name.
        let names: Vec<_> = prints
            .lines()
            .filter_map(|line| line.rsplit_once(' '))
            .map(|(name, _)| name)
            .collect();
        let distinct: HashSet<_> = names.iter().collect();
        assert_eq!(distinct.len(), names.len(), "{prints}");
        // The fires that are kept burning are taken up.
        assert!(!prints.contains(" 0000000000000000"), "{prints}");
    }

    #[test]
    fn another_seed_gives_another_fire() {
        for model in [Model::Classic, Model::Combustion] {
            let mut other = Parameters::new(model);
            assert_eq!(other.set("seed", Input::Number(2.0)), Ok(()));
            assert_ne!(fingerprint(Parameters::new(model)), fingerprint(other));
        }
    }
}

#[cfg(target_arch = "wasm32")]
mod in_wasm {
    use hearth_tests::fingerprints;
    use wasm_bindgen::prelude::*;
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Wasm has no environment, but its compiler has.
    const FILE: Option<&str> = option_env!("HEARTH_FINGERPRINTS");

    #[wasm_bindgen(module = "fs")]
    extern "C" {
        #[wasm_bindgen(js_name = readFileSync, catch)]
        fn read(file: &str, encoding: &str) -> Result<String, JsValue>;
    }

    #[wasm_bindgen_test]
    fn wasm_gives_the_same_bits_as_native() -> Result<(), JsValue> {
        let file = FILE.ok_or("HEARTH_FINGERPRINTS names no file with native fingerprints")?;
        assert_eq!(read(file, "utf8")?, fingerprints());
        Ok(())
    }
}

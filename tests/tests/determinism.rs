//! Same seed, same bits: on every run, and natively as in wasm.
//!
//! Natively, runs are compared with one another. Built for wasm and run in
//! Node, the same runs are compared with those of the native program
//! `examples/fingerprint.rs`, which the wasm test starts itself, so that
//! neither half can be stale.

#[cfg(not(target_arch = "wasm32"))]
mod natively {
    use std::collections::HashSet;
    use std::thread;

    use hearth_core::params::{Input, Model, Parameters};
    use hearth_tests::{fingerprint, fingerprints};

    #[test]
    fn the_same_seed_gives_the_same_bits() {
        // Two threads halve the time, and share nothing either.
        let (prints, again) = thread::scope(|scope| {
            let again = scope.spawn(fingerprints);
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

    #[wasm_bindgen(module = "child_process")]
    extern "C" {
        /// Runs a program to its end and gives what it printed.
        #[wasm_bindgen(js_name = execFileSync, catch)]
        fn run(
            program: &str,
            arguments: Vec<String>,
            options: &JsValue,
        ) -> Result<JsValue, JsValue>;
    }

    /// What the native program prints. Cargo runs tests in their package's
    /// folder, so it finds the workspace by itself.
    fn native_fingerprints() -> Result<String, JsValue> {
        let arguments = ["run", "--quiet", "--example", "fingerprint"];
        let options = js_sys::Object::new();
        js_sys::Reflect::set(&options, &"encoding".into(), &"utf8".into())?;
        let printed = run("cargo", arguments.map(String::from).to_vec(), &options)?;
        printed.as_string().ok_or(printed)
    }

    #[wasm_bindgen_test]
    fn wasm_gives_the_same_bits_as_native() {
        assert_eq!(native_fingerprints(), Ok(fingerprints()));
    }
}

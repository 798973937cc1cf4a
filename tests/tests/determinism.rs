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
    use js_sys::{Function, Promise};
    use wasm_bindgen::prelude::*;
    use wasm_bindgen_futures::JsFuture;
    use wasm_bindgen_test::wasm_bindgen_test;

    #[wasm_bindgen(module = "child_process")]
    extern "C" {
        /// Starts a program, and calls `done` with its error or with what it printed.
        #[wasm_bindgen(js_name = execFile)]
        fn start(program: &str, arguments: Vec<String>, options: &JsValue, done: &JsValue);
    }

    /// Starts the native program and gives what it prints. Cargo runs tests in their package's
    /// folder, so it finds the workspace by itself.
    fn native_fingerprints() -> Promise {
        Promise::new(&mut |resolve: Function, reject: Function| {
            let done = Closure::once_into_js(move |error: JsValue, printed: JsValue| {
                if error.is_null() {
                    resolve.call1(&JsValue::NULL, &printed)
                } else {
                    reject.call1(&JsValue::NULL, &error)
                }
            });
            let arguments = ["run", "--quiet", "--example", "fingerprint"];
            let arguments = arguments.map(String::from).to_vec();
            start("cargo", arguments, &js_sys::Object::new(), &done);
        })
    }

    #[wasm_bindgen_test]
    async fn wasm_gives_the_same_bits_as_native() {
        // The native program runs on another core.
        let native = native_fingerprints();
        let own = fingerprints();
        let printed = JsFuture::from(native).await;
        assert_eq!(printed.map(|text| text.as_string()), Ok(Some(own)));
    }
}

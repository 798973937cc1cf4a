//! Prints the fingerprint of every compared run as this platform computes it. The
//! wasm half of `tests/determinism.rs` runs it to hear the native answer.

fn main() {
    print!("{}", hearth_tests::fingerprints());
}

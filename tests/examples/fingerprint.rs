//! Prints the fingerprint of every compared run as this platform computes it. Tests compare
//! wasm, the library and other runs with it.

fn main() {
    print!("{}", hearth_tests::fingerprints());
}

use crate::harness::{CHEAP, Folder, ended};

#[test]
fn without_a_driver_the_error_names_debians_packages() {
    let folder = Folder::new("without-driver");
    let arguments = [&["render", "candle", "--out", "a.png"], &CHEAP[..]].concat();
    let mut command = folder.command(&arguments);
    // The library finds the drivers by these files.
    command.env("__EGL_VENDOR_LIBRARY_FILENAMES", "/no/such/driver.json");
    let run = ended(command.spawn().expect("the command"));
    assert_eq!(run.code, 1, "{run:?}");
    for words in [
        "OpenGL ES 3",
        "surfaceless",
        "libegl-mesa0",
        "libgl1-mesa-dri",
    ] {
        assert!(run.errors.contains(words), "{}", run.errors);
    }
    assert_eq!(folder.names(), [""; 0]);
}

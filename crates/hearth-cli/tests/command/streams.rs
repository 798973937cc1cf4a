use crate::harness::{CHEAP, Folder, ended};

#[test]
fn a_reader_that_closes_standard_output_ends_the_command_quietly() {
    let folder = Folder::new("closed");
    let picture = [&["render", "candle", "--out", "-"], &CHEAP[..]].concat();
    for arguments in [&["scenes"][..], &["info"], &["--help"], &picture] {
        let mut child = folder.command(arguments).spawn().expect("the command");
        drop(child.stdout.take());
        let run = ended(child);
        assert_eq!((run.code, &*run.errors), (0, ""), "{arguments:?}");
    }
}

#[test]
fn help_and_version_are_no_errors_and_a_missing_command_is() {
    let folder = Folder::new("help");
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["help", "render"],
        &["sheet", "--help"],
    ] {
        let run = folder.run(arguments);
        assert_eq!((run.code, &*run.errors), (0, ""), "{arguments:?}");
        assert!(!run.out.is_empty(), "{arguments:?}");
    }
    folder.run(&[""; 0]).refuses(&["Usage"]);
    folder.run(&["draw"]).refuses(&["draw"]);
}

#[test]
#[cfg(unix)]
fn names_that_are_no_text_are_those_of_files() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let folder = Folder::new("not-text");
    let bytes = OsStr::from_bytes(b"\xff\xfe");
    let out = [OsStr::new("--out"), bytes];
    folder
        .run(&[&[OsStr::new("render"), bytes], &out[..]].concat())
        .refuses(&["there is no preset"]);
    folder.run(&[bytes]).refuses(&[]);
    let arguments = [&["render", "candle"], &CHEAP[..]].concat();
    let arguments: Vec<_> = arguments.into_iter().map(OsStr::new).chain(out).collect();
    assert_eq!(folder.run(&arguments).code, 0, "any name is that of a file");
}

#[test]
fn eight_bits_are_mentioned_only_where_nobody_asked_for_them() {
    let folder = Folder::new("eight-bits");
    let arguments = [
        &["render", "candle", "--format", "rgba8", "--out", "-"],
        &CHEAP[..],
    ]
    .concat();
    let run = folder.run(&arguments);
    assert_eq!((run.code, &*run.errors), (0, ""));
    let arguments = [&["render", "candle", "--out", "-"], &CHEAP[..]].concat();
    let run = folder.without_extension("GL_EXT_color_buffer", &arguments);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.errors.contains("eight bits"), "{}", run.errors);
}

#[test]
fn a_command_without_memory_for_its_threads_says_so() {
    let folder = Folder::new("streams-threads");
    let mut command = folder.command(&["film", "candle", "--seconds", "0.1", "--out", "a.webp"]);
    // No machine has a stack of that size.
    command.env("RUST_MIN_STACK", (1_u64 << 60).to_string());
    let run = ended(command.spawn().expect("the command"));
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.errors.contains("a thread could not be started"));
    assert!(!run.errors.contains("panicked"), "{}", run.errors);
    assert_eq!(folder.names(), [""; 0]);
}

use std::process::Command;
use std::{fs, thread};

use crate::harness::{Folder, Png, Run, ended};

/// Draws a cheap picture with these options.
fn render(folder: &Folder, options: &str) -> Run {
    folder.hearth(&cheap(options))
}

/// The line of a cheap picture with these options.
fn cheap(options: &str) -> String {
    format!("render {options} --quality low --at 0.1 --size 48x32")
}

#[test]
fn a_picture_has_its_size_straight_alpha_and_the_colours_of_srgb() {
    let folder = Folder::new("picture");
    folder.done(&cheap("candle --out a.png"));
    assert_eq!(folder.names(), ["a.png"]);
    let picture = Png::decode(&folder.read("a.png"));
    assert_eq!(
        (picture.size, picture.channels, picture.is_srgb),
        ([48, 32], 4, true)
    );
    assert!(
        picture.pixels().any(|pixel| pixel[3] == 0),
        "no transparent pixel"
    );
    // Premultiplied colours of faint pixels would be at most as high as their alpha.
    assert!(
        picture
            .pixels()
            .any(|pixel| pixel[0] > pixel[3] && pixel[3] > 0)
    );
}

#[test]
fn the_same_command_gives_the_same_bytes_and_another_seed_gives_others() {
    let folder = Folder::new("bytes");
    let seeded = |seed| folder.done(&cheap(&format!("torch --out - --seed {seed}")));
    let first = seeded(7);
    assert!(first.starts_with(b"\x89PNG"));
    assert_eq!(first, seeded(7));
    assert_ne!(first, seeded(8));
}

#[test]
fn standard_output_gets_the_bytes_of_the_file() {
    let folder = Folder::new("standard-output");
    folder.done(&cheap("candle --out a.png"));
    assert!(folder.read("a.png") == folder.done(&cheap("candle --out -")));
}

#[test]
fn only_force_replaces_a_file() {
    let folder = Folder::new("force");
    folder.write("a.png", "mine");
    let run = render(&folder, "candle --out a.png");
    assert_eq!(run.code, 1);
    assert!(run.errors.contains("--force"), "{}", run.errors);
    assert_eq!(folder.read("a.png"), b"mine");
    folder.done(&cheap("candle --out a.png --force"));
    assert!(folder.read("a.png").starts_with(b"\x89PNG"));
}

#[test]
#[cfg(unix)]
fn a_device_is_written_and_stays_a_device() {
    use std::os::unix::fs::FileTypeExt;

    let folder = Folder::new("device");
    folder.done(&cheap("candle --out /dev/null --force"));
    let device = fs::metadata("/dev/null").expect("the device");
    assert!(device.file_type().is_char_device());
    let written = folder.done(&cheap("candle --out /dev/stdout"));
    assert!(written.starts_with(b"\x89PNG"));
}

#[test]
fn an_output_that_cannot_be_written_is_named_before_a_fire_burns() {
    let folder = Folder::new("unwritable");
    fs::create_dir(folder.0.join("folder")).expect("a folder");
    for name in ["no/such/a.png", "folder"] {
        let run = folder.hearth(&format!("render candle --at 1000 --out {name}"));
        assert_eq!(run.code, 1, "{run:?}");
        assert!(run.errors.contains(name), "{}", run.errors);
    }
    assert_eq!(folder.names(), ["folder"]);
}

#[test]
fn a_background_makes_the_picture_opaque() {
    let folder = Folder::new("background");
    let picture = Png::decode(&folder.done(&cheap("candle --out - --background #336699")));
    assert_eq!(picture.channels, 3);
    assert_eq!(picture.pixel([0, 16]), [0x33, 0x66, 0x99]);
}

#[test]
fn a_background_takes_the_place_of_the_wall_and_the_ground() {
    let folder = Folder::new("walls");
    let picture = |options: &str| {
        let line = cheap(&format!("fireside --out - {options}"));
        Png::decode(&folder.done(&line))
    };
    assert_eq!(picture("").channels, 3, "its wall is opaque");
    let bare = picture("--background transparent");
    for corner in [[0, 0], [47, 0], [0, 31], [47, 31]] {
        let alpha = bare.pixel(corner)[3];
        assert!(alpha < 64, "{alpha} at {corner:?}");
    }
    let white = picture("--background white");
    assert_eq!(white.pixel([0, 0]), [255, 255, 255]);
}

#[test]
fn a_supersampled_picture_is_as_large_and_of_other_pixels() {
    let folder = Folder::new("supersample");
    let supersampled = |factor| {
        let line = cheap(&format!("candle --out - --supersample {factor}"));
        Png::decode(&folder.done(&line))
    };
    let [one, two] = [1, 2].map(supersampled);
    assert_eq!(one.size, two.size);
    assert_ne!(one.data, two.data);
    let mean = |picture: &Png| {
        let sum: u64 = picture.pixels().map(|pixel| u64::from(pixel[3])).sum();
        sum as f64 / f64::from(picture.size[0] * picture.size[1])
    };
    let means = [mean(&one), mean(&two)];
    assert!((means[0] - means[1]).abs() < 4.0, "{means:?}");
}

#[test]
fn values_quality_and_warm_up_change_the_picture() {
    let folder = Folder::new("values");
    let line = "render candle --at 1.2 --size 32x48 --out - --quality low";
    let picture = |options: &str| folder.done(&format!("{line} {options}"));
    let plain = picture("");
    for others in [
        "--set exposure=2",
        "--set exposure=2 --set bloom=0",
        "--warm 1",
        "--fit contain",
        "--format rgba8",
    ] {
        let other = picture(others);
        assert!(other.starts_with(b"\x89PNG"), "{others:?}");
        assert!(plain != other, "{others:?}");
    }
}

#[test]
fn wrong_values_are_refused_by_name_and_leave_no_file() {
    let folder = Folder::new("wrong-values");
    for (options, words) in [
        (
            "no-such-scene",
            &["there is no preset \"no-such-scene\"", "candle"][..],
        ),
        (
            "campfir",
            &["there is no preset \"campfir\"; did you mean \"campfire\"?"],
        ),
        (
            "candle --set bloom=-1",
            &["bloom = \"-1\" is refused", "from"],
        ),
        ("candle --set vis=1", &["vis"]),
        ("candle --set viscosity", &["--set", "bloom=0.5"]),
        ("candle --seed -1", &["seed = \"-1\" is refused"]),
        (
            "candle --background red",
            &["--background", "'red'", "white", "transparent"],
        ),
        (
            "candle --quality ultra",
            &["--quality", "low, medium, high"],
        ),
        ("candle --fit stretch", &["--fit", "contain"]),
        ("candle --format rgba32f", &["--format", "rgba16f"]),
        ("candle --supersample 5", &["--supersample", "1..=4"]),
        ("candle --warm 31", &["--warm", "from 0 to 30"]),
        ("candle --device 99", &["no graphics device 99"]),
        ("candle --frames 3", &["--frames"]),
        ("candle torch", &["torch"]),
        ("", &["<SCENE>"]),
        ("--set bloom=1 candle --background", &["--background"]),
        ("candle --device -1", &["--device", "0..=65535"]),
        ("candle --warm -1", &["--warm", "from 0 to 30"]),
        ("candle --supersample -1", &["1..=4"]),
    ] {
        render(&folder, &format!("--out a.png {options}")).refuses(words);
    }
    for (option, values) in [
        ("--at", ["-1", "NaN", "inf", "1001", "soon"]),
        ("--size", ["0x10", "10", "10x", "-4x4", "99999999999x1"]),
    ] {
        for value in values {
            let line = format!("render candle --out a.png {option}={value}");
            folder.hearth(&line).refuses(&[option]);
        }
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn a_size_beyond_the_driver_names_its_limit() {
    let folder = Folder::new("large");
    let info = folder.run(&["info", "--json"]);
    let info: serde_json::Value = serde_json::from_str(info.text()).expect("JSON");
    let longest = info["maxSide"].as_u64().expect("a limit");
    for size in ["100000x100000", "4294967295x1 --supersample 4"] {
        let run = folder.hearth(&format!("render candle --out a.png --size {size}"));
        run.refuses(&[&format!("its longest side is {longest} pixels")]);
    }
    assert_eq!(folder.names(), [""; 0]);
}

/// Threads of a process: the interrupt has a thread of its own, and so has the driver in software.
#[cfg(target_os = "linux")]
fn threads(process: u32) -> usize {
    fs::read_dir(format!("/proc/{process}/task")).map_or(0, Iterator::count)
}

#[test]
#[cfg(target_os = "linux")]
fn an_interrupt_leaves_no_file() {
    let folder = Folder::new("interrupt");
    let arguments = ["render", "fireside", "--at", "1000", "--out", "a.png"];
    for signal in ["INT", "TERM", "HUP", "QUIT", "XCPU"].repeat(3) {
        let child = folder.command(&arguments).spawn().expect("the command");
        while threads(child.id()) < 2 {
            thread::yield_now();
        }
        let kill = Command::new("kill")
            .args(["-s", signal, &child.id().to_string()])
            .status();
        assert!(kill.is_ok_and(|status| status.success()));
        let run = ended(child);
        assert_eq!((run.code, &*run.errors), (130, ""), "{signal}");
        assert_eq!(folder.names(), [""; 0], "{signal}");
    }
}

#[test]
#[cfg(unix)]
fn a_link_is_written_through_and_one_to_nothing_needs_force() {
    use std::os::unix::fs::symlink;

    let folder = Folder::new("links");
    std::fs::create_dir(folder.0.join("other")).expect("a folder");
    folder.write("other/real.png", "kept");
    for (to, name) in [("other/real.png", "a"), ("nowhere.png", "b"), ("c", "c")] {
        symlink(to, folder.0.join(name)).expect("a link");
        let run = render(&folder, &format!("candle --out {name}"));
        assert_eq!(run.code, 1, "{run:?}");
    }
    assert_eq!(folder.read("other/real.png"), b"kept");
    for (name, to) in [("a", "other/real.png"), ("b", "nowhere.png")] {
        folder.done(&cheap(&format!("candle --force --out {name}")));
        assert!(folder.0.join(name).is_symlink(), "{name}");
        assert!(folder.read(to).starts_with(b"\x89PNG"), "{name}");
    }
    assert_eq!(folder.names(), ["a", "b", "c", "nowhere.png", "other"]);
}

#[test]
#[cfg(target_os = "linux")]
fn a_limit_of_the_size_of_files_is_an_error_and_leaves_no_rest() {
    let folder = Folder::new("file-limit");
    let run = format!(
        "ulimit -f 1; exec {} render candle --quality low --at 0.1 --size 99x99 --out a.png",
        env!("CARGO_BIN_EXE_hearth")
    );
    let mut command = Command::new("sh");
    let limited = command.args(["-c", &run]).current_dir(&folder.0).output();
    let limited = limited.expect("a shell");
    let words = String::from_utf8_lossy(&limited.stderr);
    assert!(words.contains("a.png: File too large"), "{words}");
    assert_eq!(limited.status.code(), Some(1));
    assert_eq!(folder.names(), [""; 0]);
}

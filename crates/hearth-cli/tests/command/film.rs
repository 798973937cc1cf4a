//! `hearth film`: which pictures it writes, how many, and what it refuses.

mod formats;
mod loops;

use crate::harness::{Folder, Run};

/// A film of six pictures that is cheap to draw.
const CHEAP: &str = "film default --quality low --size 48x32 --from 0.5 --seconds 0.2";
const COUNT: usize = 6;
/// Bytes of one of them.
const PICTURE: usize = 48 * 32 * 4;

/// The bytes of the pictures with straight alpha.
fn raw(folder: &Folder, options: &str) -> Vec<u8> {
    folder.done(&format!("{CHEAP} --as rgba --out - {options}"))
}

/// Runs the film with that output.
fn film(folder: &Folder, out: &str) -> Run {
    folder.hearth(&format!("{CHEAP} --out {out}"))
}

#[test]
fn a_part_has_the_pictures_of_the_whole_and_their_numbers() {
    let folder = Folder::new("film-part");
    for out in ["whole", "part --frames 2..4"] {
        folder.done(&format!("{CHEAP} --out {out}"));
    }
    for number in 0..COUNT {
        let name = |film: &str| format!("{film}/{number:05}.png");
        let is_in_part = folder.0.join(name("part")).exists();
        assert_eq!(is_in_part, (2..4).contains(&number), "{number}");
        if is_in_part {
            let [whole, part] = ["whole", "part"].map(|film| folder.read(&name(film)));
            assert!(whole == part, "{number}");
        }
    }
    // A film does not end at a file of another one.
    let run = film(&folder, "part");
    assert_eq!(run.code, 1);
    assert!(run.errors.contains("00002.png"), "{}", run.errors);
    assert!(!folder.0.join("part/00000.png").exists());
}

#[test]
fn a_part_from_a_checkpoint_has_the_pictures_and_the_sound_of_the_whole() {
    let folder = Folder::new("film-checkpoint");
    // The part begins later than pictures take to forget those before them.
    let whole = "film torch --quality low --size 48x32 --from 0.5 --seconds 2.2 --fps 20";
    let film = |options: &str| folder.done(&format!("{whole} {options}"));
    film("--frames 0..40 --checkpoint at.state");
    assert_eq!(folder.names(), ["at.state"]);
    for format in ["rgba", "wav"] {
        let part = format!("--as {format} --out - --frames 40..44");
        let resumed = film(&format!("{part} --resume at.state"));
        assert!(film(&part) == resumed, "{format}");
    }
    // A part that draws and resumes writes the state that one from the seed writes.
    film("--frames 38..44 --checkpoint seed.state");
    film("--frames 40..44 --checkpoint resumed.state --resume at.state --as rgba --out -");
    assert!(folder.read("seed.state") == folder.read("resumed.state"));

    let other = "film torch --resume at.state --out - --as rgba";
    let run = folder.hearth(other);
    run.refuses(&["at.state", "another film", "--size"]);
    let state = folder.read("at.state");
    let mut changed = state.clone();
    changed[state.len() / 2] ^= 1;
    for (bytes, words) in [
        (&state[..state.len() / 2], &["wrong.state", "damaged"][..]),
        (&changed, &["damaged"]),
        (b"no state", &["is no checkpoint"]),
        (b"HearthCP9.9.9...........", &["another version"]),
        (&state, &["from 40 on", "first one is 0"]),
    ] {
        folder.write("wrong.state", bytes);
        let resumed = format!("{whole} --out - --as rgba --resume wrong.state");
        folder.hearth(&resumed).refuses(words);
    }
}

#[test]
fn a_film_has_its_seconds_times_its_rate_in_pictures_and_blur_mixes_moments() {
    let folder = Folder::new("film-rate");
    assert_eq!(raw(&folder, "--fps 15").len(), PICTURE * 3);
    let [sharp, blurred] =
        ["1", "4"].map(|moments| raw(&folder, &format!("--motion-blur {moments}")));
    assert_eq!(sharp.len(), blurred.len());
    assert!(sharp != blurred, "blur mixes no moments");
}

#[test]
fn a_film_that_cannot_be_is_refused_before_a_fire_burns() {
    let folder = Folder::new("film-refused");
    for (options, words) in [
        ("a.avi", &["a.avi", ".webp", "folder"][..]),
        ("-", &["--as"]),
        ("- --as webm", &["file"]),
        ("a.gif --seconds 1000 --fps 100 --frames 0..100000", &["MB"]),
        ("a.gif --seconds 0.2 --frames 3..7", &["3..7", "0..6"]),
        ("a.gif --frames 3..3", &["0..300"]),
        ("a.gif --loop --seconds 0.5", &["from 1 to 10"]),
        ("a.wav --describe", &["--describe", "WAV"]),
        ("a.gif --loop --checkpoint c", &["--checkpoint"]),
        ("a.gif --loop --once", &["--loop", "--once"]),
        ("a.gif --fps 0.5", &["1 to 240"]),
        ("a.gif --fps 241", &["1 to 240"]),
        ("a.mp4 --size 47x32", &["even", "47 x 32"]),
        ("a.webm --stacked-alpha", &["--stacked-alpha", "MP4"]),
        ("a.webp --sound", &["--sound", ".wav"]),
        ("a.wav --loop --sound", &["--loop"]),
        ("a.gif --seconds 500", &["15000 MB"]),
        ("a.gif --seconds 1000 --fps 240", &["240000", "100000"]),
    ] {
        let run = folder.hearth(&format!("film default --out {options}"));
        run.refuses(words);
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn a_large_film_says_its_memory_and_is_drawn_and_a_usual_one_says_nothing() {
    let folder = Folder::new("film-memory");
    let film = |size: &str| {
        let line = "film default --quality low --from 0.5 --seconds 0.1 --frames 0..1";
        let run = folder.hearth(&format!("{line} --as rgba --out - --size {size}"));
        assert_eq!(run.code, 0, "{}", run.errors);
        (run.out, run.errors)
    };
    let (picture, said) = film("4096x4096");
    let number = said
        .strip_prefix("memory: about ")
        .and_then(|rest| rest.split(' ').next());
    let megabytes: u32 = number.and_then(|number| number.parse().ok()).expect(&said);
    // Eight copies of the picture take 512.
    assert!((512..2048).contains(&megabytes), "{said}");
    assert_eq!(picture.len(), 4096 * 4096 * 4);
    assert!(picture.iter().any(|byte| *byte > 100), "a fire is seen");
    assert_eq!(film("512x512").1, "");
}

#[test]
fn the_sound_is_as_long_as_the_film_and_that_of_a_part_is_a_part_of_it() {
    let folder = Folder::new("film-sound");
    // A film in slow motion is as long.
    let outs = ["", "", "--frames 2..4", "--set time_scale=0.5"];
    let [whole, again, part, slow] =
        outs.map(|options| folder.done(&format!("{CHEAP} --as wav --out - {options}")));
    // A header has 44 bytes, and a picture lasts for 1600 samples of two channels.
    let lengths = [44 + COUNT * 6400, 44 + 2 * 6400, 44 + COUNT * 6400];
    assert_eq!([whole.len(), part.len(), slow.len()], lengths);
    assert!(whole == again && part[44..] == whole[44 + 2 * 6400..44 + 4 * 6400]);
    assert!(whole[44..].iter().any(|byte| *byte != 0));
}

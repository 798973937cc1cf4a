use std::io::Cursor;

use crate::harness::{Folder, Png, Run, ended};

/// A film of six pictures that is cheap to draw.
const CHEAP: [&str; 11] = [
    "film",
    "default",
    "--quality",
    "low",
    "--size",
    "48x32",
    "--from",
    "0.5",
    "--seconds",
    "0.2",
    "--out",
];
const COUNT: usize = 6;

fn film(folder: &Folder, name: &str, others: &[&str]) -> Run {
    folder.run(&[&CHEAP[..], &[name], others].concat())
}

/// The bytes of the pictures with straight alpha.
fn raw(folder: &Folder, others: &[&str]) -> Vec<u8> {
    let run = film(folder, "-", &[&["--as", "rgba"], others].concat());
    assert_eq!((run.code, &*run.errors), (0, ""));
    run.out
}

#[test]
fn a_part_has_the_pictures_of_the_whole_and_their_numbers() {
    let folder = Folder::new("film-part");
    for (name, others) in [("whole", &[][..]), ("part", &["--frames", "2..4"])] {
        let run = film(&folder, name, others);
        assert_eq!((run.code, &*run.errors), (0, ""));
    }
    for number in 0..COUNT {
        let name = |film: &str| format!("{film}/{number:05}.png");
        let is_in_part = folder.0.join(name("part")).exists();
        assert_eq!(is_in_part, (2..4).contains(&number), "{number}");
        if is_in_part {
            assert!(
                folder.read(&name("whole")) == folder.read(&name("part")),
                "{number}"
            );
        }
    }
    // A film does not end at a file of another one.
    let run = film(&folder, "part", &[]);
    assert_eq!(run.code, 1);
    assert!(run.errors.contains("00002.png"), "{}", run.errors);
    assert!(!folder.0.join("part/00000.png").exists());
}

#[test]
fn a_part_from_a_checkpoint_has_the_pictures_and_the_sound_of_the_whole() {
    let folder = Folder::new("film-checkpoint");
    // The part begins later than pictures take to forget those before them.
    let film = |others: &[&str]| {
        let film = [
            "film",
            "torch",
            "--quality",
            "low",
            "--size",
            "48x32",
            "--from",
            "0.5",
        ];
        let run = folder.run(&[&film[..], &["--seconds", "2.2", "--fps", "20"], others].concat());
        assert_eq!((run.code, &*run.errors), (0, ""));
        run.out
    };
    let part = ["--frames", "40..44"];
    film(&["--frames", "0..40", "--checkpoint", "at.state"]);
    assert_eq!(folder.names(), ["at.state"]);
    for format in ["rgba", "wav"] {
        let out = ["--as", format, "--out", "-"];
        let whole = film(&[&out[..], &part].concat());
        let resumed = film(&[&out[..], &part, &["--resume", "at.state"]].concat());
        assert!(whole == resumed, "{format}");
    }
    // A part that draws and resumes writes the state that one from the seed writes.
    let other = ["--frames", "38..44", "--checkpoint"];
    film(&[&other[..], &["seed.state"]].concat());
    let resumed = [
        "resumed.state",
        "--resume",
        "at.state",
        "--as",
        "rgba",
        "--out",
        "-",
    ];
    let run = folder.run(&[
        "film", "torch", "--resume", "at.state", "--out", "-", "--as", "rgba",
    ]);
    run.refuses(&["at.state", "another film", "--size"]);
    let part = ["--frames", "40..44", "--checkpoint"];
    film(&[&part[..], &resumed].concat());
    assert!(folder.read("seed.state") == folder.read("resumed.state"));

    let state = folder.read("at.state");
    let cheap = [
        "film",
        "torch",
        "--quality",
        "low",
        "--size",
        "48x32",
        "--from",
        "0.5",
        "--seconds",
        "2.2",
    ];
    let resume = [
        "--fps",
        "20",
        "--out",
        "-",
        "--as",
        "rgba",
        "--resume",
        "wrong.state",
    ];
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
        folder.run(&[&cheap[..], &resume].concat()).refuses(words);
    }
}

#[test]
fn a_film_has_its_seconds_times_its_rate_in_pictures_and_blur_mixes_moments() {
    let folder = Folder::new("film-rate");
    assert_eq!(raw(&folder, &["--fps", "15"]).len(), 48 * 32 * 4 * 3);
    let [sharp, blurred] = ["1", "4"].map(|moments| raw(&folder, &["--motion-blur", moments]));
    assert_eq!(sharp.len(), blurred.len());
    assert!(sharp != blurred, "blur mixes no moments");
}

#[test]
fn every_format_has_all_pictures_their_alpha_and_their_times() {
    let folder = Folder::new("film-formats");
    let all = raw(&folder, &[]);
    let picture = |number: usize| &all[48 * 32 * 4 * number..48 * 32 * 4 * (number + 1)];
    let alpha = |rgba: &[u8]| rgba.iter().skip(3).step_by(4).copied().collect::<Vec<_>>();
    for name in ["a.zip", "a.apng", "a.webp", "b.webp", "a.gif"] {
        let others: &[&str] = if name == "b.webp" {
            &["--lossless"]
        } else {
            &[]
        };
        let run = film(&folder, name, others);
        assert_eq!((run.code, &*run.errors), (0, ""), "{name}");
        let file = folder.read(name);
        film(&folder, name, &[others, &["--force"]].concat());
        assert!(folder.read(name) == file, "{name} of another run");
    }

    let mut zip = zip::ZipArchive::new(Cursor::new(folder.read("a.zip"))).expect("a zip");
    assert_eq!(zip.len(), COUNT);
    let mut png = Vec::new();
    std::io::copy(&mut zip.by_name("00005.png").expect("the last"), &mut png).expect("its bytes");
    assert!(Png::decode(&png).data == picture(5));

    let mut apng = png::Decoder::new(Cursor::new(folder.read("a.apng")))
        .read_info()
        .expect("a PNG");
    let animation = apng.info().animation_control().expect("an animation");
    assert_eq!(
        (animation.num_frames, animation.num_plays),
        (COUNT as u32, 0)
    );
    for number in 0..COUNT {
        let mut data = vec![0; 48 * 32 * 4];
        apng.next_frame(&mut data).expect("a picture");
        assert!(data == picture(number), "{number}");
        let control = apng.info().frame_control().expect("its time");
        assert_eq!((control.delay_num, control.delay_den), (1, 30));
    }

    for name in ["a.webp", "b.webp"] {
        let file = folder.read(name);
        let frames: Vec<_> = webp_animation::Decoder::new(&file)
            .expect("a WebP")
            .into_iter()
            .collect();
        assert_eq!(frames.len(), COUNT);
        // A decoder gives the end of each picture [ms].
        assert_eq!(frames.last().map(|frame| frame.timestamp()), Some(200));
        for (number, frame) in frames.iter().enumerate() {
            assert!(
                alpha(frame.data()) == alpha(picture(number)),
                "{name} {number}"
            );
        }
    }

    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let file = folder.read("a.gif");
    let mut gif = options.read_info(&file[..]).expect("a GIF");
    let (mut count, mut hundredths) = (0, 0);
    while let Some(frame) = gif.read_next_frame().expect("a picture") {
        for (seen, wanted) in frame.buffer.chunks(4).zip(picture(count).chunks(4)) {
            assert_eq!(seen[3] == 255, wanted[3] >= 128);
            let is_near = |at: usize| seen[at].abs_diff(wanted[at]) < 48;
            assert!(
                wanted[3] < 128 || (0..3).all(is_near),
                "{seen:?} {wanted:?}"
            );
        }
        count += 1;
        hundredths += frame.delay;
    }
    assert_eq!((count, hundredths), (COUNT, 20));
}

#[test]
fn a_film_that_cannot_be_is_refused_before_a_fire_burns() {
    let folder = Folder::new("film-refused");
    for (name, others, words) in [
        ("a.avi", &[][..], &["a.avi", ".webp", "folder"][..]),
        ("-", &[], &["--as"]),
        ("-", &["--as", "webm"], &["file"]),
        (
            "a.gif",
            &["--seconds", "1000", "--fps", "100", "--frames", "0..100000"],
            &["MB"],
        ),
        (
            "a.gif",
            &["--seconds", "0.2", "--frames", "3..7"],
            &["3..7", "0..6"],
        ),
        ("a.gif", &["--frames", "3..3"], &["0..300"]),
        ("a.gif", &["--loop", "--seconds", "0.5"], &["from 1 to 10"]),
        ("a.wav", &["--describe"], &["--describe", "WAV"]),
        ("a.gif", &["--loop", "--checkpoint", "c"], &["--checkpoint"]),
        ("a.gif", &["--loop", "--once"], &["--loop", "--once"]),
        ("a.gif", &["--fps", "0.5"], &["1 to 240"]),
        ("a.gif", &["--fps", "241"], &["1 to 240"]),
        ("a.mp4", &["--size", "47x32"], &["even", "47 x 32"]),
        ("a.gif", &["--seconds", "500"], &["15000 MB"]),
        (
            "a.gif",
            &["--seconds", "1000", "--fps", "240"],
            &["240000", "100000"],
        ),
    ] {
        let film = ["film", "default", "--out", name];
        folder.run(&[&film[..], others].concat()).refuses(words);
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn the_end_of_a_loop_goes_over_into_its_beginning_as_any_picture_into_the_next() {
    let folder = Folder::new("film-loop");
    let film = [
        "film",
        "default",
        "--quality",
        "low",
        "--size",
        "48x32",
        "--from",
        "0.5",
        "--seconds",
        "1",
        "--loop",
        "--as",
        "rgba",
        "--out",
        "-",
    ];
    let run = |others: &[&str]| {
        let run = folder.run(&[&film[..], others].concat());
        assert_eq!((run.code, &*run.errors), (0, ""));
        run.out
    };
    let all = run(&[]);
    let pictures: Vec<_> = all.chunks(48 * 32 * 4).collect();
    assert_eq!(pictures.len(), 30);
    let light = |pixel: &[u8], at: usize| u32::from(pixel[at]) * u32::from(pixel[3]);
    let distance = |a: &[u8], b: &[u8]| -> u32 {
        let pairs = a.chunks(4).zip(b.chunks(4));
        pairs
            .map(|(a, b)| {
                (0..3)
                    .map(|at| light(a, at).abs_diff(light(b, at)) / 255)
                    .sum::<u32>()
            })
            .sum()
    };
    let mut inside: Vec<_> = pictures
        .windows(2)
        .map(|pair| distance(pair[0], pair[1]))
        .collect();
    inside.sort_unstable();
    let seam = distance(pictures[29], pictures[0]);
    assert!(
        seam <= inside[inside.len() * 95 / 100],
        "{seam} of {inside:?}"
    );
    assert!(run(&["--frames", "20..22"]) == pictures[20..22].concat());
}

#[test]
fn a_large_film_says_its_memory_and_a_usual_one_says_nothing() {
    let folder = Folder::new("film-memory");
    let film = |size: &str| {
        let film = [
            "film",
            "default",
            "--quality",
            "low",
            "--from",
            "0.02",
            "--seconds",
            "0.1",
            "--frames",
            "0..1",
        ];
        let run =
            folder.run(&[&film[..], &["--as", "rgba", "--out", "-", "--size", size]].concat());
        assert_eq!(run.code, 0, "{}", run.errors);
        run.errors
    };
    let said = film("4096x4096");
    let number = said
        .strip_prefix("memory: about ")
        .and_then(|rest| rest.split(' ').next());
    let megabytes: u32 = number.and_then(|number| number.parse().ok()).expect(&said);
    // Eight copies of the picture take 512.
    assert!((512..2048).contains(&megabytes), "{said}");
    assert_eq!(film("512x512"), "");
}

#[test]
fn the_sound_is_as_long_as_the_film_and_that_of_a_part_is_a_part_of_it() {
    let folder = Folder::new("film-sound");
    let mut files = Vec::new();
    for (name, others) in [
        ("a.wav", &[][..]),
        ("b.wav", &[]),
        ("part.wav", &["--frames", "2..4"]),
    ] {
        let run = film(&folder, name, others);
        assert_eq!((run.code, &*run.errors), (0, ""));
        files.push(folder.read(name));
    }
    let [whole, again, part] = &files[..] else {
        panic!("three files");
    };
    // A header has 44 bytes, and a picture lasts for 1600 samples of two channels.
    assert_eq!(
        (whole.len(), part.len()),
        (44 + COUNT * 6400, 44 + 2 * 6400)
    );
    assert!(whole == again && part[44..] == whole[44 + 2 * 6400..44 + 4 * 6400]);
    assert!(whole[44..].iter().any(|byte| *byte != 0));
    // A film in slow motion is as long.
    assert_eq!(
        film(&folder, "slow.wav", &["--set", "time_scale=0.5"]).code,
        0
    );
    assert_eq!(folder.read("slow.wav").len(), whole.len());
    film(&folder, "a.webp", &["--sound"]).refuses(&["--sound", ".wav"]);
    film(&folder, "c.wav", &["--loop", "--sound"]).refuses(&["--loop"]);
}

#[test]
fn a_described_file_has_its_scene_as_a_settings_file_and_the_same_pictures() {
    let folder = Folder::new("film-described");
    let described = ["--describe", "--seed", "7", "--set", "wind=0.5"];
    let settings = r#"{"hearth":3,"values":{"seed":7,"wind":0.5}}"#;
    let has = |name: &str, text: &str| {
        let file = folder.read(name);
        file.windows(text.len()).any(|part| part == text.as_bytes())
    };
    for name in ["a.apng", "a.gif", "a.webp", "a.zip"] {
        let run = film(&folder, name, &described);
        assert_eq!((run.code, &*run.errors), (0, ""));
        assert!(has(name, settings), "{name}");
        film(&folder, name, &["--seed", "7", "--force"]);
        assert!(!has(name, "wind"), "{name}");
    }
    film(
        &folder,
        "a.webp",
        &[&described[..], &["--force", "--lossless"]].concat(),
    );
    let file = folder.read("a.webp");
    let decoder = webp_animation::Decoder::new(&file).expect("a WebP");
    let pictures: Vec<_> = decoder
        .into_iter()
        .map(|frame| frame.data().to_vec())
        .collect();
    let alpha = |rgba: &[u8]| rgba.iter().skip(3).step_by(4).copied().collect::<Vec<_>>();
    let all = raw(&folder, &["--seed", "7", "--set", "wind=0.5"]);
    assert!(alpha(&pictures.concat()) == alpha(&all));
    folder.write("again.json", settings.as_bytes());
    let again = [
        "again.json",
        "--quality",
        "low",
        "--size",
        "48x32",
        "--from",
        "0.5",
    ];
    let out = ["--seconds", "0.2", "--as", "rgba", "--out", "-"];
    assert!(folder.run(&[&["film"][..], &again, &out].concat()).out == all);
}

#[cfg(unix)]
mod by_ffmpeg {
    use super::*;
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    /// Runs the film with this script in the place of `ffmpeg`, or without one.
    fn with(folder: &Folder, script: Option<&str>, name: &str, others: &[&str]) -> Run {
        fs::create_dir_all(folder.0.join("bin")).expect("a folder");
        if let Some(script) = script {
            folder.write("bin/ffmpeg", format!("#!/bin/sh\n{script}\n"));
            let mode = fs::Permissions::from_mode(0o755);
            fs::set_permissions(folder.0.join("bin/ffmpeg"), mode).expect("a program");
        }
        let mut command = folder.command(&[&CHEAP[..], &[name], others].concat());
        let path = match script {
            Some(_) => format!("{}:/usr/bin:/bin", folder.0.join("bin").display()),
            None => folder.0.join("bin").display().to_string(),
        };
        let run = ended(command.env("PATH", path).spawn().expect("the command"));
        fs::remove_dir_all(folder.0.join("bin")).expect("the folder");
        run
    }

    #[test]
    fn it_gets_the_pictures_and_its_file_takes_its_place() {
        let folder = Folder::new("film-ffmpeg");
        // The last argument is the file.
        let script = r#"for last; do :; done; echo "$@" > arguments; cat > "${last#file:}""#;
        let run = with(
            &folder,
            Some(script),
            "a.webm",
            &["--background", "#102030"],
        );
        assert_eq!((run.code, &*run.errors), (0, ""));
        assert_eq!(folder.names(), ["a.webm", "arguments"]);
        assert!(folder.read("a.webm") == raw(&folder, &["--background", "#102030"]));
        let arguments = String::from_utf8(folder.read("arguments")).expect("text");
        for words in [
            "-s 48x32 -r 30/1",
            "libvpx-vp9",
            "-pix_fmt yuv420p",
            "+bitexact",
            "file:",
        ] {
            assert!(arguments.contains(words), "{words:?} in {arguments}");
        }
        // Alpha is at most 3 of 255 off at this quality.
        assert_eq!(with(&folder, Some(script), "a.webm", &["--force"]).code, 0);
        let arguments = String::from_utf8(folder.read("arguments")).expect("text");
        assert!(arguments.contains("-crf 1 -b:v 0 -pix_fmt yuva420p"));
    }

    #[test]
    fn it_gets_the_sound_as_a_file_that_is_gone_later() {
        let folder = Folder::new("film-ffmpeg-sound");
        let script = r#"for last; do case "$last" in file:*wav) wc -c < "${last#file:}" > length;; esac; done; cat > "${last#file:}""#;
        let run = with(&folder, Some(script), "a.webm", &["--sound"]);
        assert_eq!((run.code, &*run.errors), (0, ""));
        assert_eq!(folder.names(), ["a.webm", "length"]);
        assert_eq!(
            folder.read("length"),
            format!("{}\n", 44 + COUNT * 6400).as_bytes()
        );
    }

    #[test]
    fn its_failure_is_told_with_its_last_words_and_leaves_no_file() {
        let folder = Folder::new("film-ffmpeg-fails");
        let script = "cat > /dev/null; echo no such encoder >&2; exit 1";
        let run = with(&folder, Some(script), "a.webm", &[]);
        assert_eq!(run.code, 1);
        assert!(run.errors.contains("no such encoder"), "{}", run.errors);
        let run = with(&folder, Some("exec <&-; exit 1"), "a.webm", &[]);
        assert_eq!(run.code, 1, "{run:?}");
        let run = with(&folder, None, "a.webm", &[]);
        assert_eq!(run.code, 1);
        for words in ["ffmpeg", "webp"] {
            assert!(run.errors.contains(words), "{}", run.errors);
        }
        let script = r#"for last; do :; done; cat > "${last#file:}""#;
        let run = with(&folder, Some(script), "a.mp4", &[]);
        run.refuses(&["alpha", "--background"]);
        assert_eq!(folder.names(), [""; 0]);
    }
}

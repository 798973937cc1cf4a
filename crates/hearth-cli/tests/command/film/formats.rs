//! The files of films, decoded by others.

use std::io::Cursor;

use super::{CHEAP, COUNT, PICTURE, raw};
use crate::harness::{Folder, Png, Run, ended};

fn alpha(rgba: &[u8]) -> Vec<u8> {
    rgba.iter().skip(3).step_by(4).copied().collect()
}

/// The pictures of an animated WebP, with the end of each \[ms\].
fn webp(file: &[u8]) -> Vec<(i32, Vec<u8>)> {
    let decoder = webp_animation::Decoder::new(file).expect("a WebP");
    let frames = decoder.into_iter();
    frames
        .map(|frame| (frame.timestamp(), frame.data().to_vec()))
        .collect()
}

#[test]
fn every_format_has_all_pictures_their_alpha_and_their_times() {
    let folder = Folder::new("film-formats");
    let all = raw(&folder, "");
    let pictures: Vec<_> = all.chunks(PICTURE).collect();
    let file = |out: &str| {
        let [first, again] = [(); 2].map(|()| {
            folder.done(&format!("{CHEAP} --force --out {out}"));
            folder.read(out.split(' ').next().expect("a name"))
        });
        assert!(first == again, "{out} of another run");
        first
    };

    let mut zip = zip::ZipArchive::new(Cursor::new(file("a.zip"))).expect("a zip");
    assert_eq!(zip.len(), COUNT);
    for (number, picture) in pictures.iter().enumerate() {
        let mut png = Vec::new();
        let mut entry = zip.by_name(&format!("{number:05}.png")).expect("an entry");
        std::io::copy(&mut entry, &mut png).expect("its bytes");
        assert!(Png::decode(&png).data == **picture, "{number}");
    }

    let apng = png::Decoder::new(Cursor::new(file("a.apng")));
    let mut apng = apng.read_info().expect("a PNG");
    let animation = apng.info().animation_control().expect("an animation");
    assert_eq!(
        (animation.num_frames, animation.num_plays),
        (COUNT as u32, 0)
    );
    for (number, picture) in pictures.iter().enumerate() {
        let mut data = vec![0; PICTURE];
        apng.next_frame(&mut data).expect("a picture");
        assert!(data == **picture, "{number}");
        let control = apng.info().frame_control().expect("its time");
        assert_eq!((control.delay_num, control.delay_den), (1, 30));
    }

    for out in ["a.webp", "b.webp --lossless"] {
        let frames = webp(&file(out));
        assert_eq!(frames.len(), COUNT);
        assert_eq!(frames.last().map(|(end, _)| *end), Some(200));
        for ((_, frame), picture) in frames.iter().zip(&pictures) {
            assert!(alpha(frame) == alpha(picture), "{out}");
        }
    }

    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let gif = file("a.gif");
    let mut gif = options.read_info(&gif[..]).expect("a GIF");
    let (mut count, mut hundredths) = (0, 0);
    while let Some(frame) = gif.read_next_frame().expect("a picture") {
        for (seen, wanted) in frame.buffer.chunks(4).zip(pictures[count].chunks(4)) {
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
fn a_described_file_has_its_scene_as_a_settings_file_and_the_same_pictures() {
    let folder = Folder::new("film-described");
    let settings = r#"{"hearth":3,"values":{"seed":7,"wind":0.5}}"#;
    let has = |name: &str, text: &str| {
        let file = folder.read(name);
        file.windows(text.len()).any(|part| part == text.as_bytes())
    };
    let all = raw(&folder, "--seed 7 --set wind=0.5");
    for name in ["a.apng", "a.gif", "a.zip", "a.webp"] {
        let seeded = format!("{CHEAP} --seed 7 --force --out {name}");
        folder.done(&seeded);
        assert!(!has(name, "wind"), "{name}");
        folder.done(&format!("{seeded} --describe --set wind=0.5"));
        assert!(has(name, settings), "{name}");
    }
    let frames: Vec<_> = webp(&folder.read("a.webp"))
        .into_iter()
        .map(|(_, frame)| frame)
        .collect();
    assert!(alpha(&frames.concat()) == alpha(&all));
    folder.write("again.json", settings);
    let again = CHEAP.replace("default", "again.json");
    assert!(folder.done(&format!("{again} --as rgba --out -")) == all);
}

/// `ffmpeg`, or another program in its place.
#[cfg(unix)]
mod by_ffmpeg {
    use super::*;
    use std::fs;
    use std::os::unix::fs::PermissionsExt;
    use std::process::Command;

    /// Runs the film with this script in the place of `ffmpeg`, or without one.
    fn with(folder: &Folder, script: Option<&str>, out: &str) -> Run {
        fs::create_dir_all(folder.0.join("bin")).expect("a folder");
        if let Some(script) = script {
            folder.write("bin/ffmpeg", format!("#!/bin/sh\n{script}\n"));
            let mode = fs::Permissions::from_mode(0o755);
            fs::set_permissions(folder.0.join("bin/ffmpeg"), mode).expect("a program");
        }
        let line = format!("{CHEAP} --out {out}");
        let mut command = folder.command(&line.split(' ').collect::<Vec<_>>());
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
        let arguments = |out: &str| {
            let run = with(&folder, Some(script), out);
            assert_eq!((run.code, &*run.errors), (0, ""));
            String::from_utf8(folder.read("arguments")).expect("text")
        };
        let said = arguments("a.webm --background #102030");
        assert_eq!(folder.names(), ["a.webm", "arguments"]);
        assert!(folder.read("a.webm") == raw(&folder, "--background #102030"));
        let words = [
            "-s 48x32 -r 30/1",
            "libvpx-vp9",
            "-pix_fmt yuv420p",
            "+bitexact",
            "file:",
        ];
        assert!(words.iter().all(|words| said.contains(words)), "{said}");
        // Alpha is at most 3 of 255 off at this quality.
        let said = arguments("a.webm --force");
        assert!(said.contains("-crf 1 -b:v 0 -pix_fmt yuva420p"), "{said}");
        let said = arguments("a.mp4 --stacked-alpha");
        assert!(said.contains("-s 48x64 -r 30/1"), "{said}");
        let stacked = folder.read("a.mp4");
        for (seen, picture) in stacked
            .chunks(2 * PICTURE)
            .zip(raw(&folder, "").chunks(PICTURE))
        {
            let (colours, mask) = seen.split_at(PICTURE);
            for ((colour, grey), pixel) in
                colours.chunks(4).zip(mask.chunks(4)).zip(picture.chunks(4))
            {
                assert_eq!(grey, [pixel[3], pixel[3], pixel[3], 255]);
                // Where nothing is seen, colours are those of the edge.
                assert!(colour[3] == 255 && (pixel[3] == 0 || colour[..3] == pixel[..3]));
            }
        }
    }

    #[test]
    fn it_gets_the_sound_as_a_file_that_is_gone_later() {
        let folder = Folder::new("film-ffmpeg-sound");
        let script = r#"for last; do case "$last" in file:*wav) wc -c < "${last#file:}" > length;; esac; done; cat > "${last#file:}""#;
        let run = with(&folder, Some(script), "a.webm --sound");
        assert_eq!((run.code, &*run.errors), (0, ""));
        assert_eq!(folder.names(), ["a.webm", "length"]);
        let length = format!("{}\n", 44 + COUNT * 6400);
        assert_eq!(folder.read("length"), length.as_bytes());
    }

    #[test]
    fn its_failure_is_told_with_its_last_words_and_leaves_no_file() {
        let folder = Folder::new("film-ffmpeg-fails");
        let script = "cat > /dev/null; echo no such encoder >&2; exit 1";
        for (script, words) in [
            (Some(script), &["no such encoder"][..]),
            (Some("exec <&-; exit 1"), &[]),
            (None, &["ffmpeg", "webp"]),
        ] {
            let run = with(&folder, script, "a.webm");
            assert_eq!(run.code, 1, "{run:?}");
            assert!(
                words.iter().all(|words| run.errors.contains(words)),
                "{run:?}"
            );
        }
        let script = r#"for last; do :; done; cat > "${last#file:}""#;
        let run = with(&folder, Some(script), "a.mp4");
        run.refuses(&["alpha", "--background", "--stacked-alpha"]);
        assert_eq!(folder.names(), [""; 0]);
    }

    /// What the program of this machine decodes of a file; `None`, and a word about it, where there is none.
    fn decoded(folder: &Folder, options: &str) -> Option<Vec<u8>> {
        let line = format!("-loglevel error {options} -f rawvideo -pix_fmt rgba -");
        let mut command = Command::new("ffmpeg");
        match command
            .args(line.split(' '))
            .current_dir(&folder.0)
            .output()
        {
            Ok(run) => {
                assert!(
                    run.status.success(),
                    "{}",
                    String::from_utf8_lossy(&run.stderr)
                );
                Some(run.stdout)
            }
            Err(_) => {
                eprintln!("skipped: ffmpeg is not installed");
                None
            }
        }
    }

    #[test]
    fn its_own_decoder_finds_alpha_within_3_of_255_in_webm_and_6_in_mp4() {
        let folder = Folder::new("film-ffmpeg-alpha");
        if decoded(&folder, "-f lavfi -i color=s=2x2:d=0.1").is_none() {
            return;
        }
        let wanted = raw(&folder, "");
        let off = |seen: &[u8]| {
            let pairs = seen.iter().zip(alpha(&wanted));
            assert_eq!(seen.len(), wanted.len() / 4);
            pairs.map(|(seen, wanted)| seen.abs_diff(wanted)).max()
        };
        folder.done(&format!("{CHEAP} --out a.webm"));
        let webm = decoded(&folder, "-c:v libvpx-vp9 -i a.webm").expect("a film");
        let webm = off(&alpha(&webm));
        folder.done(&format!("{CHEAP} --out a.mp4 --stacked-alpha"));
        let mp4 = decoded(&folder, "-i a.mp4").expect("a film");
        // Green has least of the colours of near pixels.
        let greys: Vec<_> = mp4
            .chunks(2 * PICTURE)
            .flat_map(|picture| picture[PICTURE..].iter().skip(1).step_by(4).copied())
            .collect();
        let mp4 = off(&greys);
        assert!(webm <= Some(3), "{webm:?}");
        assert!(mp4 <= Some(6), "{mp4:?}");
    }
}

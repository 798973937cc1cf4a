use serde_json::Value;

use crate::harness::{Folder, Png, Run};

const CHEAP: [&str; 14] = [
    "sprites",
    "default",
    "--quality",
    "low",
    "--tile",
    "48x32",
    "--from",
    "0.5",
    "--count",
    "6",
    "--columns",
    "4",
    "--supersample",
    "1",
];

fn sprites(folder: &Folder, others: &[&str]) -> Run {
    folder.run(&[&CHEAP[..], others].concat())
}

fn json(folder: &Folder, name: &str) -> Value {
    serde_json::from_slice(&folder.read(name)).expect("JSON")
}

#[test]
fn a_tile_is_the_picture_of_a_film_where_the_atlas_says() {
    let folder = Folder::new("sprites");
    let run = sprites(
        &folder,
        &[
            "--out",
            "flame.png",
            "--premultiplied",
            "--trim",
            "--power-of-two",
            "--gutter",
            "3",
            "--atlas",
            "json",
        ],
    );
    assert_eq!((run.code, &*run.errors), (0, ""));
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
        "0.2",
        "--out",
        "film",
    ];
    assert_eq!(folder.run(&film).code, 0);
    let (sheet, atlas) = (
        Png::decode(&folder.read("flame.png")),
        json(&folder, "flame.json"),
    );
    assert!(
        sheet.size.iter().all(|side| side.is_power_of_two()),
        "{:?}",
        sheet.size
    );
    assert_eq!(
        atlas["meta"]["size"],
        serde_json::json!({ "w": sheet.size[0], "h": sheet.size[1] })
    );
    assert_eq!(atlas["meta"]["image"], "flame.png");
    let names = atlas["animations"]["flame"]
        .as_array()
        .expect("an animation");
    assert_eq!(names.len(), 6);
    for (number, name) in names.iter().enumerate() {
        let entry = &atlas["frames"][name.as_str().expect("a name")];
        let side = |of: &str, name: &str| entry[of][name].as_u64().expect(name) as u32;
        let picture = Png::decode(&folder.read(&format!("film/{number:05}.png")));
        for y in 0..side("frame", "h") {
            for x in 0..side("frame", "w") {
                let seen = sheet.pixel([side("frame", "x") + x, side("frame", "y") + y]);
                let at = [
                    side("spriteSourceSize", "x") + x,
                    side("spriteSourceSize", "y") + y,
                ];
                let wanted = picture.pixel(at);
                assert_eq!(seen[3], wanted[3], "alpha of {number} at {at:?}");
                let premultiplied = |at: usize| u32::from(wanted[at]) * u32::from(wanted[3]) / 255;
                assert!((0..3).all(|at| u32::from(seen[at]).abs_diff(premultiplied(at)) <= 1));
            }
        }
        assert_eq!((side("sourceSize", "w"), side("sourceSize", "h")), (48, 32));
    }
}

#[test]
fn each_sheet_has_a_file_and_the_motion_of_rising_gas_is_upwards() {
    let folder = Folder::new("sprites-sheets");
    let run = sprites(
        &folder,
        &[
            "--out",
            "a.png",
            "--sheets",
            "colour,emission,smoke,motion",
            "--grid-in-name",
            "--atlas",
            "tres",
        ],
    );
    assert_eq!((run.code, &*run.errors), (0, ""));
    let names = [
        "a-emission_4x2.png",
        "a-motion_4x2.png",
        "a-smoke_4x2.png",
        "a_4x2.png",
        "a_4x2.tres",
    ];
    assert_eq!(folder.names(), names);
    let sheets = names[..4]
        .iter()
        .map(|name| Png::decode(&folder.read(name)));
    let sheets: Vec<_> = sheets.collect();
    assert!(sheets.iter().all(|sheet| sheet.size == sheets[0].size));
    // Gas rises: green is less than 128.
    let rises = sheets[1].pixels().map(|motion| 128 - i32::from(motion[1]));
    let rises = rises.sum::<i32>() / sheets[1].pixels().count() as i32;
    assert!(rises > 8 && sheets[1].pixel([20, 20])[3] == 255, "{rises}");
    let light = |at: usize| {
        let pixels: &Png = &sheets[at];
        let light = pixels
            .pixels()
            .map(|pixel| u32::from(pixel[0]) * u32::from(pixel[3]));
        light.sum::<u32>()
    };
    let (emission, smoke) = (light(0), light(2));
    assert!(emission > 3 * smoke, "{emission} {smoke}");
    let text = String::from_utf8(folder.read("a_4x2.tres")).expect("text");
    let tags = crate::tres::Reader(&text).headings();
    let of_tile = |tag: &&String| *tag == "sub_resource";
    assert_eq!((tags.len(), tags.iter().filter(of_tile).count()), (9, 6));
    let odd = sprites(&folder, &["--out", "o\"dd\\.png", "--atlas", "tres"]);
    assert_eq!((odd.code, &*odd.errors), (0, ""));
    let odd = String::from_utf8(folder.read("o\"dd\\.tres")).expect("text");
    assert_eq!(crate::tres::Reader(&odd).headings(), tags);
    assert!(
        text.contains("res://a_4x2.png") && text.contains("load_steps=8"),
        "{text}"
    );
    assert!(run.text().starts_with("motion: "), "{}", run.text());
}

/// Difference of a sheet's pictures from the next ones, each warped along its vectors, over that of pictures as they are.
fn warped(folder: &Folder, scene: &str) -> f32 {
    const SIDE: usize = 128;
    let tiles = [
        "--quality",
        "medium",
        "--count",
        "5",
        "--columns",
        "5",
        "--gutter",
        "0",
    ];
    let sheets = [
        "--sheets",
        "colour,motion",
        "--premultiplied",
        "--atlas",
        "json",
    ];
    let out = ["--out", "w.png", "--force"];
    let run = folder.run(&[&["sprites", scene][..], &tiles, &sheets, &out].concat());
    assert_eq!((run.code, &*run.errors), (0, ""));
    let [colour, motion] = ["w.png", "w-motion.png"].map(|name| Png::decode(&folder.read(name)));
    let atlas = json(folder, "w.json");
    let unit = atlas["meta"]["motionPixels"].as_f64().expect("a number") as f32 / 127.0;
    let of = |sheet: &Png, tile: usize, x: usize, y: usize| {
        let pixel = sheet.pixel([(tile * SIDE + x) as u32, y as u32]);
        [0, 1, 2].map(|part| f32::from(pixel[part]))
    };
    let (mut still, mut moved) = (0.0, 0.0);
    for at in 0..4 * SIDE * SIDE {
        let [x, y, tile] = [at % SIDE, at / SIDE % SIDE, at / SIDE / SIDE];
        let vector = of(&motion, tile, x, y).map(|byte| (byte - 128.0) * unit);
        let side = |at: usize, moved: f32| (at as f32 - moved).clamp(0.0, SIDE as f32 - 1.01);
        let [from_x, from_y] = [side(x, vector[0]), side(y, vector[1])];
        // A shader takes the mean of the four nearest pixels, too.
        let mut seen = [0.0; 3];
        for (right, down) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let share = |part: f32, is_far: usize| if is_far == 1 { part } else { 1.0 - part };
            let share = share(from_x.fract(), right) * share(from_y.fract(), down);
            let pixel = of(
                &colour,
                tile,
                from_x as usize + right,
                from_y as usize + down,
            );
            (0..3).for_each(|part| seen[part] += share * pixel[part]);
        }
        let next = of(&colour, tile + 1, x, y);
        let error = |seen: [f32; 3]| {
            (0..3)
                .map(|part| (seen[part] - next[part]).abs())
                .sum::<f32>()
        };
        still += error(of(&colour, tile, x, y));
        moved += error(seen);
    }
    moved / still
}

#[test]
fn a_picture_that_is_warped_along_its_vectors_has_half_the_error_and_never_a_greater_one() {
    let folder = Folder::new("sprites-warp");
    for (scene, most) in [("default", 0.5), ("candle", 1.0)] {
        let share = warped(&folder, scene);
        assert!(share <= most, "{scene}: {share}");
    }
}

#[test]
fn a_sheet_that_cannot_be_is_refused_before_a_fire_burns() {
    let folder = Folder::new("sprites-refused");
    for (others, words) in [
        (&["--out", "a.jpg"][..], &["a.jpg", ".png"][..]),
        (
            &["--out", "a.png", "--sheets", "depth"],
            &["depth", "motion"],
        ),
        (&["--out", "a.png", "--gutter", "65"], &["64"]),
    ] {
        sprites(&folder, others).refuses(words);
    }
    let large = [
        "sprites",
        "default",
        "--tile",
        "4096x4096",
        "--count",
        "64",
        "--out",
        "a.png",
    ];
    folder.run(&large).refuses(&["pixels"]);
    assert_eq!(folder.names(), [""; 0]);
}

#[cfg(unix)]
#[test]
fn a_name_that_is_no_text_is_a_name() {
    use std::os::unix::ffi::OsStrExt;

    let folder = Folder::new("sprites-name");
    let name = std::ffi::OsStr::from_bytes(b"fire-\xff.png");
    let mut command = folder.command(&[&CHEAP[..], &["--atlas", "json", "--out"]].concat());
    let run = crate::harness::ended(command.arg(name).spawn().expect("the command"));
    assert_eq!((run.code, &*run.errors), (0, ""));
    assert!(folder.0.join(name).exists());
}

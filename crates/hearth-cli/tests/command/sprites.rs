use serde_json::Value;

use crate::harness::{Folder, Png};

const CHEAP: &str = "sprites default --quality low --tile 48x32 --from 0.5 --supersample 1";

fn json(folder: &Folder, name: &str) -> Value {
    serde_json::from_slice(&folder.read(name)).expect("JSON")
}

#[test]
fn a_tile_is_the_picture_of_a_film_where_the_atlas_says() {
    let folder = Folder::new("sprites");
    let options =
        "--premultiplied --trim --power-of-two --gutter 3 --atlas json --count 6 --columns 4";
    folder.done(&format!("{CHEAP} --out flame.png {options}"));
    folder.done("film default --quality low --size 48x32 --from 0.5 --seconds 0.2 --out film");
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
fn the_atlas_is_that_of_a_sheet_by_the_page() {
    let folder = Folder::new("sprites-atlas");
    folder.done(&format!("{CHEAP} --count 9 --atlas json --out hearth.png"));
    let known = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/web/sheet.json");
    let known: Value = serde_json::from_slice(&std::fs::read(known).expect("it")).expect("JSON");
    assert_eq!(json(&folder, "hearth.json"), known);
}

#[test]
fn each_sheet_has_a_file_and_the_motion_of_rising_gas_is_upwards() {
    let folder = Folder::new("sprites-sheets");
    let six = format!("{CHEAP} --count 6 --columns 4 --atlas tres --out");
    let said = folder.done(&format!(
        "{six} a.png --sheets colour,emission,smoke,motion --grid-in-name"
    ));
    assert!(said.starts_with(b"motion: "), "{said:?}");
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
    folder.done(&format!("{six} o\"dd\\.png"));
    let odd = String::from_utf8(folder.read("o\"dd\\.tres")).expect("text");
    assert_eq!(crate::tres::Reader(&odd).headings(), tags);
    assert!(
        text.contains("res://a_4x2.png") && text.contains("load_steps=8"),
        "{text}"
    );
}

/// Difference of a sheet's pictures from the next ones, each warped along its vectors, over that of pictures as they are.
fn warped(folder: &Folder, scene: &str) -> f32 {
    const SIDE: usize = 128;
    let options = "--quality medium --count 5 --columns 5 --gutter 0 --premultiplied --force";
    let sheets = "--sheets colour,motion --atlas json --out w.png";
    folder.done(&format!("sprites {scene} {options} {sheets}"));
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
    for (options, words) in [
        ("a.jpg", &["a.jpg", ".png"][..]),
        ("a.png --sheets depth", &["depth", "motion"]),
        ("a.png --gutter 65", &["64"]),
        ("a.png --tile 4096x4096 --count 64", &["pixels"]),
    ] {
        let run = folder.hearth(&format!("sprites default --out {options}"));
        run.refuses(words);
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[cfg(unix)]
#[test]
fn a_name_that_is_no_text_is_a_name() {
    use std::os::unix::ffi::OsStrExt;

    let folder = Folder::new("sprites-name");
    let name = std::ffi::OsStr::from_bytes(b"fire-\xff.png");
    let line = format!("{CHEAP} --count 2 --atlas json --out");
    let mut command = folder.command(&line.split(' ').collect::<Vec<_>>());
    let run = crate::harness::ended(command.arg(name).spawn().expect("the command"));
    assert_eq!((run.code, &*run.errors), (0, ""));
    assert!(folder.0.join(name).exists());
}

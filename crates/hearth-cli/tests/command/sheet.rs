use crate::harness::{Folder, Png};

/// Height of the label above a small tile, and the margins of a tile.
const LABEL: u32 = 9;
const MARGIN: u32 = 2;

fn sheet(folder: &Folder, options: &str) -> Png {
    let line = format!("sheet {options} --quality low --tile 48x32 --out -");
    Png::decode(&folder.done(&line))
}

/// Size of a sheet of tiles.
fn size(columns: u32, rows: u32) -> [u32; 2] {
    [
        columns * (48 + 2 * MARGIN),
        rows * (32 + LABEL + 2 * MARGIN),
    ]
}

#[test]
fn a_sheet_has_a_tile_for_each_scene_moment_and_background() {
    let folder = Folder::new("sheet");
    let options = "candle torch --at 0.1,0.2 --background black,#888";
    assert_eq!(sheet(&folder, options).size, size(4, 2));
    let columns = format!("{options} --columns 3");
    assert_eq!(sheet(&folder, &columns).size, size(3, 3));
}

#[test]
fn a_strip_has_pictures_that_far_apart() {
    let folder = Folder::new("strip");
    let strip = sheet(&folder, "candle --at 0.1 --strip 3 --every 1/30");
    assert_eq!(strip.size, size(3, 1));
    let moments = "candle --at 0.1,0.13333333333333333,0.16666666666666666";
    assert!(strip == sheet(&folder, moments));
}

#[test]
fn a_tile_is_the_rendered_picture_over_its_background() {
    let folder = Folder::new("tile");
    let sheet = sheet(&folder, "candle --at 0.1 --background white");
    let picture = folder.done("render candle --at 0.1 --size 48x32 --quality low --out -");
    let picture = Png::decode(&picture);
    for (x, y) in (0..48).flat_map(|x| (0..32).map(move |y| (x, y))) {
        let tile = sheet.pixel([x + MARGIN, y + MARGIN + LABEL]);
        let &[.., alpha] = picture.pixel([x, y]) else {
            panic!("no alpha");
        };
        for (straight, shown) in picture.pixel([x, y]).iter().zip(tile) {
            let share = f32::from(alpha) / 255.0;
            let blended = f32::from(*straight) * share + 255.0 * (1.0 - share);
            assert!((blended - f32::from(*shown)).abs() <= 2.0, "at {x}, {y}");
        }
    }
}

#[test]
fn labels_differ_by_scene_and_moment() {
    let folder = Folder::new("labels");
    let label = |scene: &str| {
        let sheet = sheet(&folder, &format!("{scene} --at 0"));
        let rows = MARGIN..MARGIN + LABEL;
        let pixels = rows.flat_map(|y| (0..48).map(move |x| [x, y]));
        pixels
            .map(|at| sheet.pixel(at)[0] > 128)
            .collect::<Vec<_>>()
    };
    let [candle, torch] = ["candle", "torch"].map(label);
    assert!(candle.contains(&true));
    assert_ne!(candle, torch);
}

#[test]
fn wrong_sheets_are_refused() {
    let folder = Folder::new("wrong-sheets");
    for (options, words) in [
        ("candle --tile 4294967295x4294967295", &["pixels"][..]),
        ("candle --at 1,soon", &["--at", "soon"]),
        (
            "candle --background red",
            &["--background", "'red'", "white", "transparent"],
        ),
        ("candle --columns 0", &["--columns"]),
        ("candle --strip 0", &["--strip"]),
        ("candle --every 1/0", &["--every"]),
        ("candle --tile 20000x20000", &["pixels"]),
        ("candle nonsense", &["there is no preset \"nonsense\""]),
        ("- -", &["standard input"]),
    ] {
        let run = folder.hearth(&format!("sheet --out a.png {options}"));
        run.refuses(words);
    }
    assert_eq!(folder.names(), [""; 0]);
}

//! Loops: nothing shows where they begin.

use crate::harness::Folder;

const COUNT: usize = 30;
/// Pictures that are mixed with earlier ones at the end of a loop of that many.
const MIXED: usize = 7;
const SIDES: [usize; 2] = [48, 32];

/// Light of each pixel over black, a mean of the channels from 0 to 255.
fn light(picture: &[u8]) -> Vec<f32> {
    let pixels = picture.chunks(4);
    let seen = |pixel: &[u8]| {
        let sum: u32 = pixel[..3].iter().copied().map(u32::from).sum();
        sum as f32 * f32::from(pixel[3]) / (3.0 * 255.0)
    };
    pixels.map(seen).collect()
}

fn distance(a: &[f32], b: &[f32]) -> f32 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum()
}

/// Standard deviation of the light within pictures, a mean of them.
fn contrast(pictures: &[Vec<f32>]) -> f32 {
    let of = |picture: &Vec<f32>| {
        let count = picture.len() as f32;
        let mean = picture.iter().sum::<f32>() / count;
        let squares = picture.iter().map(|light| (light - mean).powi(2));
        (squares.sum::<f32>() / count).sqrt()
    };
    pictures.iter().map(of).sum::<f32>() / pictures.len() as f32
}

#[test]
fn the_end_of_a_loop_goes_over_into_its_beginning_as_any_picture_into_the_next_with_its_contrast() {
    let folder = Folder::new("film-loop");
    for scene in ["default", "candle", "torch", "campfire", "fireplace"] {
        let [width, height] = SIDES;
        let line = format!(
            "film {scene} --quality low --size {width}x{height} --from 0.5 --seconds 1 --loop --as rgba --out -"
        );
        let all = folder.done(&line);
        let bytes: Vec<_> = all.chunks(width * height * 4).collect();
        assert_eq!(bytes.len(), COUNT, "{scene}");
        let pictures: Vec<_> = bytes.iter().map(|picture| light(picture)).collect();
        let pairs = pictures.windows(2);
        let mut inside: Vec<_> = pairs.map(|pair| distance(&pair[0], &pair[1])).collect();
        inside.sort_unstable_by(f32::total_cmp);
        let seam = distance(&pictures[COUNT - 1], &pictures[0]);
        let (usual, mixed) = pictures.split_at(COUNT - MIXED);
        let kept = contrast(mixed) / contrast(usual);
        assert!(
            seam <= inside[inside.len() * 95 / 100],
            "{scene}: {seam} of {inside:?}"
        );
        assert!(kept >= 0.9, "{scene}: {kept} of the contrast");
        if scene == "default" {
            let part = folder.done(&format!("{line} --frames 20..22"));
            assert!(part == bytes[20..22].concat(), "a part");
        }
    }
}

//! Descriptions of a sheet that engines read.

use serde_json::{Map, json};

use super::Grid;
use crate::film::Rate;

/// What a sheet is called and how it plays.
pub struct Description<'a> {
    /// Name of the picture's file, without its folder.
    pub image: &'a str,
    /// Name of the animation.
    pub name: &'a str,
    /// Where its tiles are.
    pub grid: Grid,
    /// Width and height of the sheet \[pixels\].
    pub size: [u32; 2],
    /// Pictures a second.
    pub rate: Rate,
    /// Whether colours are multiplied by alpha.
    pub is_premultiplied: bool,
    /// The displacement of a full component in the sheet of motion vectors \[pixels\], if there is one.
    pub motion: Option<f32>,
}

/// JSON in TexturePacker's form "hash", which PixiJS and Phaser read. PixiJS also reads `animations`; Phaser makes an
/// animation of the frames by their prefix.
pub fn json(description: &Description<'_>) -> String {
    let Grid { tile, kept, .. } = description.grid;
    let [left, top, width, height] = kept;
    let is_trimmed = [width, height] != tile;
    let names: Vec<_> = (0..description.grid.count)
        .map(|number| format!("{}-{number:04}", description.name))
        .collect();
    let frames: Map<_, _> = names
        .iter()
        .zip(0..)
        .map(|(name, number)| {
            let [x, y] = description.grid.corner(number);
            let frame = json!({
                "frame": { "x": x, "y": y, "w": width, "h": height },
                "rotated": false,
                "trimmed": is_trimmed,
                "spriteSourceSize": { "x": left, "y": top, "w": width, "h": height },
                "sourceSize": { "w": tile[0], "h": tile[1] },
                "duration": (description.rate.time(1) * 1000.0).round(),
            });
            (name.clone(), frame)
        })
        .collect();
    let mut animations = Map::new();
    animations.insert(description.name.to_owned(), json!(names));
    let mut meta = json!({
        "app": "hearth",
        "image": description.image,
        "format": "RGBA8888",
        "size": { "w": description.size[0], "h": description.size[1] },
        "scale": "1",
        "frameRate": 1.0 / description.rate.time(1),
        "premultiplied": description.is_premultiplied,
    });
    if let Some(pixels) = description.motion {
        meta["motionPixels"] = json!(pixels);
    }
    let atlas = json!({ "frames": frames, "animations": animations, "meta": meta });
    format!("{atlas:#}\n")
}

/// A resource `SpriteFrames` of Godot 4, for a picture in the root of the project; Godot follows it when both are moved.
pub fn tres(description: &Description<'_>) -> String {
    let Grid {
        tile, kept, count, ..
    } = description.grid;
    let [left, top, width, height] = kept;
    let quoted = |text: &str| text.replace('\\', "\\\\").replace('"', "\\\"");
    let mut text = format!(
        "[gd_resource type=\"SpriteFrames\" load_steps={} format=3]\n\n\
         [ext_resource type=\"Texture2D\" path=\"res://{}\" id=\"1\"]\n",
        count + 2,
        quoted(description.image)
    );
    for number in 0..count {
        let [x, y] = description.grid.corner(number);
        text += &format!(
            "\n[sub_resource type=\"AtlasTexture\" id=\"f{number}\"]\natlas = ExtResource(\"1\")\n\
             region = Rect2({x}, {y}, {width}, {height})\n\
             margin = Rect2({left}, {top}, {}, {})\n",
            tile[0] - width,
            tile[1] - height
        );
    }
    let frames = (0..count).map(|number| {
        format!("{{\n\"duration\": 1.0,\n\"texture\": SubResource(\"f{number}\")\n}}")
    });
    text += &format!(
        "\n[resource]\nanimations = [{{\n\"frames\": [{}],\n\"loop\": true,\n\"name\": &\"{}\",\n\"speed\": {:?}\n}}]\n",
        frames.collect::<Vec<_>>().join(", "),
        quoted(description.name),
        1.0 / description.rate.time(1)
    );
    text
}

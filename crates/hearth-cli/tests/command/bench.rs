use hearth_core::preset::Preset;
use serde_json::Value;

use crate::harness::Folder;

fn json(folder: &Folder, arguments: &[&str]) -> Value {
    let run = folder.run(arguments);
    assert_eq!(run.code, 0, "{}", run.errors);
    serde_json::from_str(run.text()).expect("JSON")
}

#[test]
fn the_scenes_are_the_presets_with_their_descriptions() {
    let folder = Folder::new("scenes");
    let list = json(&folder, &["scenes", "--json"]);
    let names = list
        .as_array()
        .into_iter()
        .flatten()
        .map(|scene| &scene["name"]);
    assert!(names.eq(Preset::all().iter().map(|preset| preset.name)));
    let text = folder.run(&["scenes"]);
    for (line, preset) in text.text().lines().zip(Preset::all()) {
        assert!(
            line.starts_with(preset.name) && line.ends_with(preset.description()),
            "{line}"
        );
    }
}

#[test]
fn the_driver_is_named_with_its_limits() {
    let folder = Folder::new("info");
    let info = json(&folder, &["info", "--json"]);
    assert!(
        info["version"]
            .as_str()
            .is_some_and(|it| it.starts_with("OpenGL ES 3")),
        "{info}"
    );
    assert!(
        info["maxSide"].as_u64().is_some_and(|side| side >= 2048),
        "{info}"
    );
    let format = if info["halfFloat"] == true {
        "rgba16f"
    } else {
        "rgba8"
    };
    assert_eq!(info["format"], format);
    let devices = info["devices"].as_array().map_or(0, Vec::len);
    for device in 0..devices {
        let name = info["devices"][device].as_str().unwrap_or_default();
        let run = folder.run(&["info", "--device", &device.to_string()]);
        // A device without such a driver is listed with the reason.
        let printed = run.text().to_owned() + &run.errors;
        assert!(printed.contains(name), "{name:?} in {printed}");
    }
    let text = folder.run(&["info"]);
    let renderer = info["renderer"].as_str().unwrap_or_default();
    assert!(text.text().contains(renderer), "{}", text.text());
}

#[test]
fn every_drawn_pass_has_a_time() {
    let folder = Folder::new("bench");
    let options = [
        "bench",
        "campfire",
        "--at",
        "0.2",
        "--size",
        "64x48",
        "--pictures",
        "2",
    ];
    let bench = json(&folder, &[&options[..], &["--json"]].concat());
    let passes: Vec<_> = bench["passes"].as_array().into_iter().flatten().collect();
    let names: Vec<_> = passes
        .iter()
        .filter_map(|pass| pass["pass"].as_str())
        .collect();
    for name in ["slices", "ember", "tone_map"] {
        assert!(names.contains(&name), "{names:?}");
    }
    for pass in passes {
        assert!(pass["ms"].as_f64().is_some_and(|ms| ms >= 0.0), "{pass}");
    }
    assert!(
        bench["pictureMs"].as_f64().is_some_and(|ms| ms > 0.0),
        "{bench}"
    );
    let options_of_json = [&options[..], &["--json"]].concat();
    let submitted = folder.without_extension("GL_EXT_disjoint_timer_query", &options_of_json);
    let submitted: Value = serde_json::from_str(submitted.text()).expect("JSON");
    assert_eq!(submitted["timer"], "submit");
    let text = folder.run(&options);
    assert!(
        names.iter().all(|name| text.text().contains(name)),
        "{}",
        text.text()
    );
}

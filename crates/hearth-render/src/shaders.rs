//! What every pair of shaders keeps to, beyond that a driver compiles it: a driver
//! at hand forgives what another one refuses, and leaves out what nobody reads.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use crate::passes::SOURCES;
use crate::program::{HEADER, Source};

/// A rule, and what it has to say about a pass.
type Rule = fn(&Source) -> Vec<String>;

const RULES: [Rule; 6] = [
    what_is_listed_is_declared_and_read,
    what_one_stage_hands_over_the_other_takes,
    only_vectors_and_pictures_are_set,
    nothing_that_a_phone_lacks,
    edges_ascend,
    mipmaps_are_read_by_level,
];

/// The code of both stages, without comments.
fn stages(source: &Source) -> [String; 2] {
    [source.vertex, source.fragment].map(|pieces| {
        let lines = pieces.iter().flat_map(|piece| piece.lines());
        let code = lines.map(|line| line.split("//").next().unwrap_or_default().trim());
        code.flat_map(|line| [line, "\n"]).collect()
    })
}

/// How often a name stands in some code.
fn count(code: &str, name: &str) -> usize {
    let words = code.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    words.filter(|word| *word == name).count()
}

/// What a stage declares with that qualifier: names with their types.
fn declared(code: &str, qualifier: &str) -> BTreeMap<String, String> {
    let lines = code.lines().filter_map(|line| {
        let line = line.strip_suffix(';')?;
        let (flat, line) = match line.strip_prefix("flat ") {
            Some(rest) => ("flat ", rest),
            None => ("", line),
        };
        let (kind, name) = line
            .strip_prefix(qualifier)?
            .strip_prefix(' ')?
            .split_once(' ')?;
        Some((name.to_owned(), format!("{flat}{kind}")))
    });
    lines.collect()
}

fn what_is_listed_is_declared_and_read(source: &Source) -> Vec<String> {
    let stages = stages(source);
    let listed: BTreeSet<String> = source
        .samplers
        .iter()
        .chain(source.uniforms)
        .map(|&name| name.to_owned())
        .collect();
    let mut complaints = Vec::new();
    let mut known = BTreeSet::new();
    for code in &stages {
        for name in declared(code, "uniform").into_keys() {
            if count(code, &name) < 2 {
                complaints.push(format!("{name} is declared and never read"));
            }
            known.insert(name);
        }
    }
    let apart = listed.symmetric_difference(&known);
    complaints.extend(apart.map(|name| format!("{name} is listed or declared, but not both")));
    complaints
}

fn what_one_stage_hands_over_the_other_takes(source: &Source) -> Vec<String> {
    let [vertex, fragment] = stages(source);
    let (given, taken) = (declared(&vertex, "out"), declared(&fragment, "in"));
    let mut complaints = Vec::new();
    for (name, kind) in &taken {
        if given.get(name) != Some(kind) {
            complaints.push(format!(
                "{name} is taken as {kind}, but given as {:?}",
                given.get(name)
            ));
        }
        if count(&fragment, name) < 2 {
            complaints.push(format!("{name} is taken and never read"));
        }
    }
    for name in given.keys().filter(|name| !taken.contains_key(*name)) {
        complaints.push(format!("{name} is given to nobody"));
    }
    let pictures = declared(&fragment, "out");
    if pictures.len() != 1 || pictures.values().any(|kind| kind != "vec4") {
        complaints.push(format!("one vec4 is drawn, not {pictures:?}"));
    }
    complaints
}

fn only_vectors_and_pictures_are_set(source: &Source) -> Vec<String> {
    let mut complaints = Vec::new();
    for (name, kind) in stages(source)
        .iter()
        .flat_map(|code| declared(code, "uniform"))
    {
        let wanted = if source.samplers.contains(&name.as_str()) {
            "sampler2D"
        } else {
            "vec4"
        };
        if kind != wanted {
            complaints.push(format!("{name} is a {kind}, and set as a {wanted}"));
        }
    }
    complaints
}

/// Points of more than a pixel, and numbers of less than 32 bits. What is declared
/// for all shaders is not declared again.
fn nothing_that_a_phone_lacks(source: &Source) -> Vec<String> {
    const LACKING: [&str; 6] = [
        "gl_PointSize",
        "mediump",
        "lowp",
        "precision",
        "version",
        "extension",
    ];
    let code = stages(source).concat();
    LACKING
        .iter()
        .filter(|&&word| count(&code, word) > 0)
        .map(|word| format!("{word} has no place in a shader"))
        .collect()
}

/// GLSL leaves open what `smoothstep` gives from a higher edge to a lower one; a
/// driver may give anything.
fn edges_ascend(source: &Source) -> Vec<String> {
    let code = stages(source).concat();
    let calls = code.split("smoothstep(").skip(1);
    calls
        .filter_map(|call| {
            let mut edges = call.split(',').map(|edge| edge.trim().parse::<f32>().ok());
            let (low, high) = (edges.next()??, edges.next()??);
            (low >= high).then(|| format!("smoothstep from {low} to {high}"))
        })
        .collect()
}

/// Which level of a picture is read follows from neighbouring pixels, and those may
/// have left the shader by then: after that the noise, which has levels, is asked for
/// one.
fn mipmaps_are_read_by_level(source: &Source) -> Vec<String> {
    let [_, fragment] = stages(source);
    let left = fragment.find("return;").unwrap_or(fragment.len());
    if fragment[left..].contains("texture(noise") {
        vec!["the noise is read without a level where pixels have left".to_owned()]
    } else {
        Vec::new()
    }
}

#[test]
fn every_pass_keeps_to_the_rules() {
    let complaints: Vec<_> = SOURCES
        .iter()
        .flat_map(|source| {
            RULES.iter().flat_map(move |rule| {
                rule(source)
                    .into_iter()
                    .map(move |said| format!("{}: {said}", source.pass))
            })
        })
        .collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn every_file_is_of_a_pass() -> std::io::Result<()> {
    let pieces: BTreeSet<&str> = SOURCES
        .iter()
        .flat_map(|source| source.vertex.iter().chain(source.fragment).copied())
        .collect();
    let mut files = 0;
    for entry in fs::read_dir("../../shaders")? {
        let path = entry?.path();
        let bare = fs::read_to_string(
            Path::new(env!("OUT_DIR")).join(path.file_name().unwrap_or_default()),
        )?;
        assert!(
            pieces.contains(bare.as_str()),
            "no pass is made of {}",
            path.display()
        );
        files += 1;
    }
    assert_eq!(files, pieces.len());
    Ok(())
}

/// A pass that keeps to every rule.
const GOOD: Source = Source {
    pass: "good",
    vertex: &[
        "uniform vec4 world;\nout vec2 uv;\nflat out vec4 heat;\nvoid main() {\nuv = world.xy;\nheat = vec4(1.0);\ngl_Position = vec4(0.0);\n}\n",
    ],
    fragment: &[
        "in vec2 uv;\nflat in vec4 heat;\nuniform sampler2D noise;\nout vec4 light;\nvoid main() {\nlight = textureLod(noise, uv, 0.0) * heat * smoothstep(0.1, 0.4, uv.x);\n}\n",
    ],
    samplers: &["noise"],
    uniforms: &["world"],
};

#[test]
fn every_rule_can_be_broken() {
    for rule in RULES {
        assert_eq!(rule(&GOOD), Vec::<String>::new());
    }
    // Of the rule of that number: the vertex shader or the fragment shader with this
    // in place of that.
    for (rule, fragment, old, new) in [
        (0, false, "world.xy", "vec2(0.0)"),
        (0, false, "uniform vec4 world", "uniform vec4 other"),
        (
            0,
            true,
            "uniform sampler2D noise",
            "uniform sampler2D grain",
        ),
        (1, false, "out vec2 uv", "out vec3 uv"),
        (1, false, "flat out vec4 heat", "out vec4 heat"),
        (1, true, "in vec2 uv;\n", ""),
        (1, true, "uv, 0.0) * heat", "uv, 0.0)"),
        (1, true, "out vec4 light", "out vec3 light"),
        (2, false, "uniform vec4 world", "uniform vec2 world"),
        (2, true, "sampler2D noise", "sampler3D noise"),
        (3, false, "gl_Position", "gl_PointSize = 2.0; gl_Position"),
        (
            3,
            true,
            "in vec2 uv",
            "precision mediump float;\nin vec2 uv",
        ),
        (4, true, "0.1, 0.4", "0.4, 0.1"),
        (
            5,
            true,
            "light = textureLod(noise, uv, 0.0)",
            "if (uv.x > 0.5) return;\nlight = texture(noise, uv)",
        ),
    ] {
        let piece = [GOOD.vertex[0], GOOD.fragment[0]][usize::from(fragment)];
        let broken = piece.replace(old, new);
        assert_ne!(broken, piece, "{old}");
        // A rule is about one text for as long as the program runs, as the real ones are.
        let broken: &'static [&'static str] = vec![&*broken.leak()].leak();
        let source = Source {
            vertex: if fragment { GOOD.vertex } else { broken },
            fragment: if fragment { broken } else { GOOD.fragment },
            ..GOOD
        };
        assert!(!RULES[rule](&source).is_empty(), "{old} → {new}");
    }
}

/// What the reference compiler of Khronos says of a pass; nothing where all is well.
/// Drivers forgive what it does not.
fn validated(source: &Source, validator: &OsStr, folder: &Path) -> std::io::Result<String> {
    let stages = [("vert", source.vertex), ("frag", source.fragment)];
    let mut files = Vec::new();
    for (kind, pieces) in stages {
        let file = folder.join(format!("{}.{kind}", source.pass));
        fs::write(&file, HEADER.to_owned() + &pieces.concat())?;
        files.push(file);
    }
    // Linked too: so it compares what one stage gives with what the other takes.
    let output = Command::new(validator).arg("-l").args(&files).output()?;
    let said = String::from_utf8_lossy(&output.stdout);
    let complaints = said.lines().filter(|line| {
        let named = files.iter().any(|file| Path::new(line) == file);
        !named && !line.is_empty()
    });
    Ok(complaints.collect::<Vec<_>>().join("\n"))
}

/// `cargo xtask test shaders` names the validator.
#[test]
#[ignore = "cargo xtask test shaders runs it, with the validator that it needs"]
fn every_shader_is_valid_glsl() -> std::io::Result<()> {
    let validator = env::var_os("HEARTH_GLSLANG").unwrap_or_default();
    let folder = env::temp_dir().join(format!("hearth-shaders-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let mut complaints = Vec::new();
    for source in SOURCES {
        let said = validated(source, &validator, &folder)?;
        if !said.is_empty() {
            complaints.push(format!("{}: {said}", source.pass));
        }
    }
    // It sees what is wrong within a stage and between them.
    let wrong = [
        "void main() { gl_Position = vec2(0.0); }",
        "out vec3 uv;\nflat out vec4 heat;\nvoid main() { uv = vec3(0.0); heat = vec4(0.0); gl_Position = heat; }",
    ];
    for vertex in wrong {
        let vertex: &'static [&'static str] = vec![vertex].leak();
        let said = validated(&Source { vertex, ..GOOD }, &validator, &folder)?;
        assert!(said.contains("ERROR"), "of {vertex:?} it says {said:?}");
    }
    fs::remove_dir_all(&folder)?;
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    Ok(())
}

//! What every pair of shaders keeps to, beyond that a driver compiles it: one driver forgives
//! what another refuses.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use std::{env, fs, io};

use crate::glsl::{self, Files, Program};
use crate::passes::PASSES;
use crate::shaders::{HEADER, SOURCES};
use crate::values;

const FOLDER: &str = "../../shaders";

/// Name and text of both stages: vertex, then fragment.
struct Pair {
    name: String,
    stages: [String; 2],
}

/// A rule, and its complaints about a pair.
type Rule = fn(&Pair) -> Vec<String>;

const RULES: [Rule; 4] = [
    stages_agree,
    nothing_that_phones_lack,
    edges_ascend,
    mipmaps_are_read_by_level,
];

fn pairs(programs: &[Program], short: bool) -> Vec<Pair> {
    let pair = |program: &Program| Pair {
        name: program.name.clone(),
        stages: program.stages.each_ref().map(|stage| stage.text(short)),
    };
    programs.iter().map(pair).collect()
}

fn programs() -> Vec<Program> {
    let files = Files::read(Path::new(FOLDER)).expect("the folder is there");
    glsl::programs(&files, &values::shared()).expect("the build compiled them")
}

/// How often a name stands in some code.
fn count(code: &str, name: &str) -> usize {
    let words = code.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    words.filter(|word| *word == name).count()
}

/// Names and types of what a stage declares with that qualifier.
fn declared(code: &str, qualifier: &str) -> BTreeMap<String, String> {
    let lines = code.lines().filter_map(|line| {
        let line = line.split_once(';')?.0;
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

fn stages_agree(pair: &Pair) -> Vec<String> {
    let [vertex, fragment] = &pair.stages;
    let (given, taken) = (declared(vertex, "out"), declared(fragment, "in"));
    let mut complaints = Vec::new();
    for (name, kind) in &taken {
        if given.get(name) != Some(kind) {
            let given = given.get(name);
            complaints.push(format!("{name} is taken as {kind}, but given as {given:?}"));
        }
        if count(fragment, name) < 2 {
            complaints.push(format!("{name} is taken and never read"));
        }
    }
    for name in given.keys().filter(|name| !taken.contains_key(*name)) {
        complaints.push(format!("{name} is given and not taken"));
    }
    let drawn = declared(fragment, "out");
    if drawn.len() != 1 || drawn.values().any(|kind| kind != "vec4") {
        complaints.push(format!("one vec4 is drawn, not {drawn:?}"));
    }
    complaints
}

/// Points of more than a pixel, and numbers of less than 32 bits. What the header declares for
/// all shaders is not declared again.
fn nothing_that_phones_lack(pair: &Pair) -> Vec<String> {
    const LACKING: [&str; 6] = [
        "gl_PointSize",
        "mediump",
        "lowp",
        "precision",
        "version",
        "extension",
    ];
    let code = pair.stages.concat();
    let found = LACKING.iter().filter(|&&word| count(&code, word) > 0);
    found.map(|word| format!("{word} is not allowed")).collect()
}

/// GLSL leaves open what `smoothstep` gives from a higher edge to a lower one.
fn edges_ascend(pair: &Pair) -> Vec<String> {
    let code = pair.stages.concat();
    let calls = code.split("smoothstep(").skip(1);
    calls
        .filter_map(|call| {
            let edge = |edge: &str| edge.trim().trim_matches(['(', ')']).replace("- ", "-");
            let mut edges = call.split(',').map(|text| edge(text).parse::<f32>().ok());
            let (low, high) = (edges.next()??, edges.next()??);
            (low >= high).then(|| format!("smoothstep from {low} to {high}"))
        })
        .collect()
}

/// The level that `texture` reads follows from neighbouring pixels, which may have left the
/// shader by then: after that, the noise, which has mipmaps, is read by level.
fn mipmaps_are_read_by_level(pair: &Pair) -> Vec<String> {
    let [_, fragment] = &pair.stages;
    let left = fragment.find("return;").unwrap_or(fragment.len());
    if fragment[left..].contains("texture(noise") {
        vec!["the noise is read without a level after an early return".to_owned()]
    } else {
        Vec::new()
    }
}

#[test]
fn every_pass_keeps_to_the_rules() {
    for pair in pairs(&programs(), false) {
        for rule in RULES {
            assert_eq!(rule(&pair), Vec::<String>::new(), "{}", pair.name);
        }
    }
}

#[test]
fn every_shader_is_of_a_pass_and_every_file_of_a_shader() -> io::Result<()> {
    for (at, source) in SOURCES.iter().enumerate() {
        let drawn = PASSES.iter().any(|row| row.shader as usize == at);
        assert!(drawn, "no pass draws {}", source.name);
    }
    let files = Files::read(Path::new(FOLDER)).expect("the folder is there");
    let used: BTreeSet<&str> = SOURCES
        .iter()
        .flat_map(|source| {
            [
                format!("{}.frag", source.name),
                format!("{}.vert", source.name),
            ]
        })
        .chain(["screen.vert".to_owned()])
        .filter(|name| files.has(name))
        .flat_map(|name| files.folded(&name).expect("the build folded it"))
        .map(|piece| piece.file)
        .collect();
    let all: BTreeSet<&str> = files.names().collect();
    assert_eq!(used, all);
    Ok(())
}

/// The structs of uniforms that passes fill, by the generated module: names and types as GLSL
/// writes them.
fn structs() -> BTreeMap<String, BTreeMap<String, String>> {
    let module = include_str!(concat!(env!("OUT_DIR"), "/shaders.rs"));
    let (_, module) = module.split_once("pub mod uniforms").expect("it is there");
    let structs = module.split("/// Uniforms of `").skip(1);
    structs
        .map(|text| {
            let (name, text) = text.split_once('`').expect("a name");
            let fields = text.split_once("\n}").expect("a body").0.lines();
            let fields = fields.filter_map(|line| {
                let (name, kind) = line.trim().strip_prefix("pub ")?.split_once(": ")?;
                let kind = match kind.trim_end_matches(',') {
                    "f32" => "float".to_owned(),
                    array => format!(
                        "vec{}",
                        array.trim_matches(['[', ']', 'f']).split_once("; ")?.1
                    ),
                };
                Some((name.to_owned(), kind))
            });
            (name.to_owned(), fields.collect())
        })
        .collect()
}

#[test]
fn every_uniform_of_a_struct_is_declared_with_its_type_and_every_declared_one_is_in_the_struct() {
    let structs = structs();
    assert_eq!(structs.len(), SOURCES.len());
    let files = Files::read(Path::new(FOLDER)).expect("the folder is there");
    for (name, fields) in structs {
        let mut declared_anywhere = BTreeMap::new();
        for stage in [format!("{name}.vert"), format!("{name}.frag")] {
            if !files.has(&stage) {
                continue;
            }
            for piece in files.folded(&stage).expect("the build folded it") {
                let mut uniforms = declared(&piece.lines.join("\n"), "uniform");
                uniforms.retain(|_, kind| kind != "sampler2D");
                if piece.file == stage {
                    for (uniform, kind) in &uniforms {
                        assert_eq!(fields.get(uniform), Some(kind), "{name}: {uniform}");
                    }
                }
                declared_anywhere.extend(uniforms);
            }
        }
        for (field, kind) in &fields {
            assert_eq!(declared_anywhere.get(field), Some(kind), "{name}: {field}");
        }
    }
}

#[test]
fn the_ends_of_the_colour_table_are_its_outer_texels() {
    use crate::constants::{COOLEST, ENTRIES, HOTTEST};
    let [scale, offset] = values::table_coordinate();
    let half = 0.5 / ENTRIES as f32;
    let at = |kelvin: f32| kelvin * 1e-3 * scale + offset;
    assert!((at(COOLEST) - half).abs() < 1e-5);
    assert!((at(HOTTEST) - (1.0 - half)).abs() < 1e-5);
}

/// A pair that keeps to every rule.
const GOOD: [&str; 2] = [
    "uniform vec4 world;\nout vec2 uv;\nflat out vec4 heat;\nvoid main() {\nuv = world.xy;\nheat = vec4(1.0);\ngl_Position = vec4(0.0);\n}\n",
    "in vec2 uv;\nflat in vec4 heat;\nuniform sampler2D noise;\nout vec4 light;\nvoid main() {\nlight = textureLod(noise, uv, 0.0) * heat * smoothstep(0.1, 0.4, uv.x);\n}\n",
];

fn pair(stages: [&str; 2]) -> Pair {
    Pair {
        name: "good".to_owned(),
        stages: stages.map(str::to_owned),
    }
}

#[test]
fn every_rule_can_be_broken() {
    for rule in RULES {
        assert_eq!(rule(&pair(GOOD)), Vec::<String>::new());
    }
    // The rule of that number: the vertex or the fragment shader with one text for another.
    for (rule, fragment, old, new) in [
        (0, false, "out vec2 uv", "out vec3 uv"),
        (0, false, "flat out vec4 heat", "out vec4 heat"),
        (0, true, "in vec2 uv;\n", ""),
        (0, true, "uv, 0.0) * heat", "uv, 0.0)"),
        (0, true, "out vec4 light", "out vec3 light"),
        (1, false, "gl_Position", "gl_PointSize = 2.0; gl_Position"),
        (
            1,
            true,
            "in vec2 uv",
            "precision mediump float;\nin vec2 uv",
        ),
        (2, true, "0.1, 0.4", "0.4, 0.1"),
        (2, true, "0.1, 0.4", "0.1, (- 0.4)"),
        (
            3,
            true,
            "light = textureLod(noise, uv, 0.0)",
            "if (uv.x > 0.5) return;\nlight = texture(noise, uv)",
        ),
    ] {
        let mut broken = pair(GOOD);
        let stage = &mut broken.stages[usize::from(fragment)];
        let before = stage.clone();
        *stage = stage.replace(old, new);
        assert_ne!(*stage, before, "{old}");
        assert!(!RULES[rule](&broken).is_empty(), "{old} → {new}");
    }
}

/// The complaints of the reference compiler of Khronos about a pair.
fn validated(pair: &Pair, validator: &OsStr, folder: &Path) -> io::Result<String> {
    let mut files = Vec::new();
    for (kind, text) in ["vert", "frag"].iter().zip(&pair.stages) {
        let file = folder.join(format!("{}.{kind}", pair.name));
        fs::write(&file, HEADER.to_owned() + text)?;
        files.push(file);
    }
    // Linking compares what one stage gives with what the other takes.
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
fn every_shader_is_valid_glsl() -> io::Result<()> {
    let validator = env::var_os("HEARTH_GLSLANG").unwrap_or_default();
    let folder = env::temp_dir().join(format!("hearth-shaders-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let mut shortened = programs();
    glsl::shorten(&mut shortened);
    for pair in pairs(&programs(), false)
        .into_iter()
        .chain(pairs(&shortened, true))
    {
        let said = validated(&pair, &validator, &folder)?;
        assert!(said.is_empty(), "{}: {said}", pair.name);
    }
    // The validator finds what is wrong within a stage and between stages.
    for vertex in [
        "void main() { gl_Position = vec2(0.0); }",
        "out vec3 uv;\nflat out vec4 heat;\nvoid main() { uv = vec3(0.0); heat = vec4(0.0); gl_Position = heat; }",
    ] {
        let said = validated(&pair([vertex, GOOD[1]]), &validator, &folder)?;
        assert!(said.contains("ERROR"), "of {vertex:?} it says {said:?}");
    }
    fs::remove_dir_all(&folder)
}

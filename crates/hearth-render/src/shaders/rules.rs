//! Portability rules of shaders: some drivers accept source that others reject.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use std::{env, fs, io};

use hearth_core::params::{Choice as _, Ground, Material};

use crate::glsl::{self, Files, Program};
use crate::passes::PASSES;
use crate::shaders::{HEADER, SOURCES};
use crate::values;

const FOLDER: &str = "shaders";

/// Name and source of the vertex and the fragment stage.
struct Pair {
    name: String,
    stages: [String; 2],
}

/// Returns the violations of a rule in a pair.
type Rule = fn(&Pair) -> Vec<String>;

const RULES: [Rule; 4] = [
    stages_agree,
    nothing_that_phones_lack,
    edges_ascend,
    mipmaps_are_read_by_level,
];

fn pairs(programs: &[Program]) -> Vec<Pair> {
    let pair = |program: &Program| Pair {
        name: program.name.clone(),
        stages: program.stages.each_ref().map(|stage| stage.text()),
    };
    programs.iter().map(pair).collect()
}

fn programs() -> Vec<Program> {
    let files = Files::read(Path::new(FOLDER)).expect("the shaders");
    glsl::programs(&files, &values::shared()).expect("compiled shaders")
}

/// Number of occurrences of a name.
fn count(code: &str, name: &str) -> usize {
    let words = code.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    words.filter(|word| *word == name).count()
}

/// Names and types of the declarations with a qualifier.
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
        // An array is of four numbers for each element.
        let (name, array) = name.split_once('[').unwrap_or((name, ""));
        let length = if array.is_empty() { "" } else { "[]" };
        Some((name.to_owned(), format!("{flat}{kind}{length}")))
    });
    lines.collect()
}

fn stages_agree(pair: &Pair) -> Vec<String> {
    let [vertex, fragment] = &pair.stages;
    let (given, taken) = (declared(vertex, "out"), declared(fragment, "in"));
    let mut violations = Vec::new();
    for (name, kind) in &taken {
        if given.get(name) != Some(kind) {
            let given = given.get(name);
            violations.push(format!("{name} is taken as {kind}, but given as {given:?}"));
        }
        if count(fragment, name) < 2 {
            violations.push(format!("{name} is taken and never read"));
        }
    }
    for name in given.keys().filter(|name| !taken.contains_key(*name)) {
        violations.push(format!("{name} is given and not taken"));
    }
    let drawn = declared(fragment, "out");
    if drawn.len() != 1 || drawn.values().any(|kind| kind != "vec4") {
        violations.push(format!("one vec4 is drawn, not {drawn:?}"));
    }
    violations
}

/// Points larger than a pixel and numbers of less than 32 bits, and redeclarations of the header.
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

/// `smoothstep` is undefined if the first edge exceeds the second.
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

/// After an early return the implicit level of `texture` is undefined, because neighbouring pixels
/// may have returned. The noise, which has mipmaps, needs an explicit level there.
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
fn materials_and_grounds_have_the_numbers_of_the_core() {
    let shared: BTreeMap<_, _> = values::shared().into_iter().collect();
    let known = |names: &[&str], first: usize, shown: &[&str]| {
        let drawn = names.iter().enumerate().skip(first);
        for (number, name) in drawn.filter(|(_, name)| **name != "none") {
            let name = name.to_uppercase();
            assert!(shown.contains(&&*name), "{name}");
            assert_eq!(shared.get(&*name), Some(&format!("{number}.0")), "{name}");
        }
    };
    known(Material::NAMES, 1, &values::MATERIALS);
    known(Ground::NAMES, 2, &values::GROUNDS);
}

#[test]
fn every_pass_follows_the_rules() {
    for pair in pairs(&programs()) {
        for rule in RULES {
            assert_eq!(rule(&pair), Vec::<String>::new(), "{}", pair.name);
        }
    }
}

#[test]
fn every_shader_belongs_to_a_pass_and_every_file_to_a_shader() -> io::Result<()> {
    for (at, source) in SOURCES.iter().enumerate() {
        let drawn = PASSES.iter().any(|row| row.shader as usize == at);
        assert!(drawn, "no pass draws {}", source.name);
    }
    let files = Files::read(Path::new(FOLDER)).expect("the shaders");
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
        .flat_map(|name| files.folded(&name).expect("resolved includes"))
        .map(|piece| piece.file)
        .collect();
    let all: BTreeSet<&str> = files.names().collect();
    assert_eq!(used, all);
    Ok(())
}

/// The generated structs of uniforms: names and types in GLSL.
fn structs() -> BTreeMap<String, BTreeMap<String, String>> {
    let module = include_str!(concat!(env!("OUT_DIR"), "/shaders.rs"));
    let (_, module) = module.split_once("pub mod uniforms").expect("the module");
    let structs = module.split("/// Uniforms of `").skip(1);
    structs
        .map(|text| {
            let (name, text) = text.split_once('`').expect("a name");
            let fields = text.split_once("\n}").expect("a body").0.lines();
            let fields = fields.filter_map(|line| {
                let (name, kind) = line.trim().strip_prefix("pub ")?.split_once(": ")?;
                let kind = match kind.trim_end_matches(',') {
                    "f32" => "float".to_owned(),
                    vector => {
                        let length = vector.trim_matches(['[', ']', 'f']).split_once("; ")?.1;
                        match length.len() {
                            1 => format!("vec{length}"),
                            _ => "vec4[]".to_owned(),
                        }
                    }
                };
                Some((name.to_owned(), kind))
            });
            (name.to_owned(), fields.collect())
        })
        .collect()
}

#[test]
fn structs_and_shaders_have_the_same_uniforms() {
    let structs = structs();
    assert_eq!(structs.len(), SOURCES.len());
    let files = Files::read(Path::new(FOLDER)).expect("the shaders");
    for (name, fields) in structs {
        let mut declared_anywhere = BTreeMap::new();
        for stage in [format!("{name}.vert"), format!("{name}.frag")] {
            if !files.has(&stage) {
                continue;
            }
            for piece in files.folded(&stage).expect("resolved includes") {
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
    use crate::constants::{COLOUR_ENTRIES, COOLEST_KELVIN, HOTTEST_KELVIN};
    let [scale, offset] = values::table_coordinate();
    let half = 0.5 / COLOUR_ENTRIES as f32;
    let at = |kelvin: f32| kelvin * 1e-3 * scale + offset;
    assert!((at(COOLEST_KELVIN) - half).abs() < 1e-5);
    assert!((at(HOTTEST_KELVIN) - (1.0 - half)).abs() < 1e-5);
}

/// A pair that follows every rule.
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
fn every_rule_finds_its_violations() {
    for rule in RULES {
        assert_eq!(rule(&pair(GOOD)), Vec::<String>::new());
    }
    // The index of a rule, whether the fragment shader changes, and a replacement that breaks it.
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

/// The errors of the reference compiler of Khronos for a pair.
fn validated(pair: &Pair, validator: &OsStr, folder: &Path) -> io::Result<String> {
    let mut files = Vec::new();
    for (kind, text) in ["vert", "frag"].iter().zip(&pair.stages) {
        let file = folder.join(format!("{}.{kind}", pair.name));
        fs::write(&file, HEADER.to_owned() + text)?;
        files.push(file);
    }
    // Linking compares what one stage gives with what the other takes.
    let output = Command::new(validator).arg("-l").args(&files).output()?;
    let report = String::from_utf8_lossy(&output.stdout);
    let violations = report.lines().filter(|line| {
        let named = files.iter().any(|file| Path::new(line) == file);
        !named && !line.is_empty()
    });
    Ok(violations.collect::<Vec<_>>().join("\n"))
}

/// `HEARTH_GLSLANG` is the path of the validator, which `cargo xtask test shaders` sets.
#[test]
#[ignore = "cargo xtask test shaders runs it with the validator"]
fn every_shader_is_valid_glsl() -> io::Result<()> {
    let validator = env::var_os("HEARTH_GLSLANG").unwrap_or_default();
    let folder = env::temp_dir().join(format!("hearth-shaders-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    for pair in pairs(&programs()) {
        let report = validated(&pair, &validator, &folder)?;
        assert!(report.is_empty(), "{}: {report}", pair.name);
    }
    // The validator finds errors within a stage and between stages.
    for vertex in [
        "void main() { gl_Position = vec2(0.0); }",
        "out vec3 uv;\nflat out vec4 heat;\nvoid main() { uv = vec3(0.0); heat = vec4(0.0); gl_Position = heat; }",
    ] {
        let report = validated(&pair([vertex, GOOD[1]]), &validator, &folder)?;
        assert!(report.contains("ERROR"), "{vertex:?}: {report:?}");
    }
    fs::remove_dir_all(&folder)
}

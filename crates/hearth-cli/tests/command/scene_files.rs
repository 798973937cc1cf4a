use hearth_settings::Settings;
use hearth_settings::untrusted::Untrusted;

use crate::harness::{CHEAP, Folder, Run};

/// Draws the scene on standard input.
fn fed(folder: &Folder, scene: impl AsRef<[u8]>) -> Run {
    let arguments = [&["render", "-", "--out", "-"], &CHEAP[..]].concat();
    folder.feed(&arguments, scene.as_ref())
}

#[test]
fn a_file_and_standard_input_draw_the_same_scene_as_the_preset_that_they_name() {
    let folder = Folder::new("files");
    let scene = r#"{"hearth": 3, "preset": "torch"}"#;
    folder.write("my torch.json", scene);
    let of = |name: &str| folder.run(&[&["render", name, "--out", "-"], &CHEAP[..]].concat());
    let preset = of("torch");
    assert_eq!(preset.code, 0, "{}", preset.errors);
    assert_eq!(preset.out, of("my torch.json").out);
    assert_eq!(preset.out, fed(&folder, scene).out);
    assert_eq!(preset.out, fed(&folder, format!("\u{feff}{scene}")).out);
}

#[test]
fn what_a_file_says_neither_acts_on_a_terminal_nor_floods_it() {
    let folder = Folder::new("terminal");
    let acts = "\\u001b]52;c;aGk=\\u0007\\u0000\u{9b}31m\u{202e}\u{feff}";
    let long = format!("{}ü{}", "e".repeat(39), "é".repeat(60_000));
    for text in [acts, &long] {
        for scene in [
            format!(r#"{{"{text}": 1}}"#),
            format!(r#"{{"{text}": 1, "{text}": 1}}"#),
            format!(r#"{{"preset": "{text}"}}"#),
            format!(r#"{{"values": {{"{text}": "{text}"}}}}"#),
            format!(r#"{{"values": {{"model": "{text}", "bloom": "{text}"}}}}"#),
            format!(r#"{{"objects": [{{"kind": "{text}", "{text}": "{text}"}}]}}"#),
            format!(
                r#"{{"objects": [{{"kind": "solid", "{text}": "{text}", "fuel": "{text}"}}]}}"#
            ),
        ] {
            let run = fed(&folder, &scene);
            run.refuses(&[]);
            for line in run.errors.lines() {
                // What names all presets or properties is longer.
                let lists = ["there are", "one of"]
                    .iter()
                    .any(|list| line.contains(list));
                let most = if lists { 450 } else { 300 };
                assert!(line.chars().count() <= most, "{line}");
                assert!(
                    !line.contains(|letter: char| letter.is_control()),
                    "{line:?}"
                );
                assert!(!line.contains(['\u{202e}', '\u{feff}']), "{line:?}");
            }
        }
    }
    let name = "a\u{1b}[31m\u{202e}.json";
    let run = folder.run(&["render", name, "--out", "a.png"]);
    assert!(
        run.errors.contains(r"a\u{1b}[31m\u{202e}.json"),
        "{}",
        run.errors
    );
    let many: Vec<_> = (0..900).map(|at| format!(r#""v{at}": 1"#)).collect();
    let run = fed(&folder, format!(r#"{{"values": {{{}}}}}"#, many.join(",")));
    assert!(run.errors.lines().count() < 30, "{}", run.errors);
}

#[test]
fn values_of_the_command_line_win_over_those_of_the_file() {
    let folder = Folder::new("values-win");
    let draw = |scene: &str, values: &[&str]| {
        let arguments = [&["render", "-", "--out", "-"], &CHEAP[..], values].concat();
        folder.feed(&arguments, scene.as_bytes()).out
    };
    let in_file = draw(r#"{"values": {"exposure": 2}}"#, &[]);
    assert!(in_file.starts_with(b"\x89PNG"));
    assert_eq!(
        in_file,
        draw(r#"{"values": {"exposure": 1}}"#, &["--set", "exposure=2"])
    );
}

#[test]
fn a_refused_file_has_the_messages_of_the_element() {
    let folder = Folder::new("messages");
    let number = Untrusted::Number;
    let object = |fields: &[(&str, Untrusted)]| {
        let fields = fields
            .iter()
            .map(|(name, value)| Untrusted::field_of(name, value.clone()));
        Untrusted::Object(fields.collect())
    };
    let values = [("viscosity", number(-1.0)), ("nonsense", number(1.0))];
    let objects = Untrusted::List(vec![object(&[("kind", Untrusted::Text("cube".into()))])]);
    for (json, value) in [
        (
            r#"{"values": {"viscosity": -1, "nonsense": 1}}"#,
            object(&[("values", object(&values))]),
        ),
        (
            r#"{"objects": [{"kind": "cube"}]}"#,
            object(&[("objects", objects)]),
        ),
        (r#"{"hearth": 2}"#, object(&[("hearth", number(2.0))])),
        (r#"{"viscosity": 1}"#, object(&[("viscosity", number(1.0))])),
        ("[]", Untrusted::List(Vec::new())),
        ("1", number(1.0)),
    ] {
        let errors = Settings::of_file(&value).expect_err("a refusal");
        let messages: Vec<_> = errors.iter().map(|error| &*error.message).collect();
        fed(&folder, json).refuses(&messages);
    }
}

#[test]
fn hostile_files_are_refused_with_the_reason_and_its_place() {
    let folder = Folder::new("hostile");
    let nested = |open: &str, close: &str, depth| open.repeat(depth) + &close.repeat(depth);
    let cases: [(Vec<u8>, &[&str]); 10] = [
        (b"".to_vec(), &["standard input", "JSON", "line 1"]),
        (b"{".to_vec(), &["JSON"]),
        (b"{} {}".to_vec(), &["trailing"]),
        (b"\xff\xfe{}".to_vec(), &["byte 1 is not UTF-8"]),
        (
            b"{\"values\": \"\xff\"}".to_vec(),
            &["byte 13 is not UTF-8"],
        ),
        (
            b"{\"values\": {\"wind\": NaN}}".to_vec(),
            &["JSON", "column"],
        ),
        (
            b"{\"values\": {\"wind\": 1e999}}".to_vec(),
            &["out of range"],
        ),
        (
            b"{\"values\": {\"wind\": 1, \"wind\": 2}}".to_vec(),
            &["wind is there twice", "line 1"],
        ),
        (
            nested("[", "]", 100_000).into_bytes(),
            &["config = \"an array\" is refused"],
        ),
        (vec![b' '; 5_000_000], &["more than", "bytes"]),
    ];
    for (scene, words) in cases {
        fed(&folder, scene).refuses(words);
    }
}

#[test]
fn a_scene_file_that_cannot_be_read_is_named() {
    let folder = Folder::new("unreadable");
    std::fs::create_dir(folder.0.join("folder.json")).expect("a folder");
    for name in ["missing.json", "no/such/scene", "folder.json"] {
        let run = folder.run(&["render", name, "--out", "a.png"]);
        assert_eq!(run.code, 1, "{run:?}");
        assert!(run.errors.contains(name), "{}", run.errors);
    }
}

#[test]
fn a_link_of_a_page_is_a_scene() {
    let folder = Folder::new("link");
    let render = |scene: &str, others: &[&str]| {
        let cheap = [
            "--quality",
            "low",
            "--size",
            "48x32",
            "--at",
            "0.2",
            "--out",
            "-",
        ];
        folder.run(&[&["render", scene][..], &cheap, others].concat())
    };
    let wanted = render(
        "torch",
        &["--set", "fuel_power=150", "--set", "background=#102030"],
    )
    .out;
    // `pageLink` writes both.
    let query = "https://example.org/fire/?scene=torch&fuel-power=150&background=%23102030";
    let fragment = "https://example.org/#fire=eJwNyjEOgCAQBMC_rC0FSGzuMwbxlEQi5AAtCH_XqacjsJMaQFYhCxeuINQkPkDhcbFxAXUcjeOa08sCMotW2Jy_Tknt3v8_GT1rqzHGBzGvGZw";
    for link in [query, fragment, &fragment[20..], &query[25..]] {
        let run = render(link, &[]);
        assert_eq!((run.code, &*run.errors), (0, ""), "{link}");
        assert!(run.out == wanted, "{link}");
    }
    let run = render(&format!("{query}&warm&utm_source=x"), &[]);
    assert!(run.code == 0 && run.out == wanted);
    assert!(run.errors.contains("warm, utm_source"), "{}", run.errors);
    for (link, words) in [
        ("?scene=bonfire", &["bonfire"][..]),
        ("?fuel-power=much", &["fuel_power", "much"]),
        ("?objects=[", &["JSON"]),
        ("#fire=eJw", &["damaged"]),
        ("#fire=%%%", &["damaged"]),
    ] {
        render(link, &[]).refuses(words);
    }
}

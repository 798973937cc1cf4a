//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::links::Base;

xflags::xflags! {
    /// Builds, serves, tests and measures Hearth.
    cmd xtask {
        /// Builds the site, serves it on this machine and opens it.
        cmd serve {
            /// The port; without it 8080, or a free one.
            optional --port number: u16
            /// Opens no browser.
            optional --no-open
        }
        /// Builds the static site in dist/site.
        cmd build {
            /// The address that the site will have: its pages then name it in full to
            /// programs that preview links.
            optional --url address: Base
        }
        /// Builds the npm package in dist/npm.
        cmd package {}
        /// Builds the last commit in another folder and compares the bytes.
        cmd reproduce {}
        /// Checks a change quickly, or everything, or runs the named stages.
        cmd test {
            /// Skips the stages that need a browser.
            optional --skip-browser
            /// Runs every stage but those on demand; otherwise the quick ones.
            optional --all
            /// A stage; `format`, for instance.
            repeated stage: String
        }
        /// Compares the physics with theory; a run of all cases updates docs/evaluation.md.
        cmd validate {
            /// How the names of the cases begin.
            repeated case: String
        }
        /// Drives fires to random corners of all ranges and back, moves solids through them, burns heaps.
        cmd soak {
            /// The number of corners of each model; 0 leaves out the scenes too.
            optional --corners number: u32
            /// The number of crowds of solids of each model.
            optional --crowds number: u32
            /// The number of heaps of burning bodies.
            optional --heaps number: u32
            /// The seed of the corners.
            optional --seed number: u32
            /// The least time; other seeds follow until it has passed.
            optional --hours number: f64
        }
        /// Sends random values, messages, links and bytes to every decoder.
        cmd fuzz {
            /// How long each law is tried.
            optional --minutes number: u32
            /// The seed of the first case.
            optional --seed number: u32
        }
        /// Fails graphics, network and engine in turn; a run of all sections updates docs/evaluation.md.
        cmd faults {
            /// A section; `network`, for instance.
            repeated section: String
        }
        /// Measures speed beside other programs and updates docs/evaluation.md.
        cmd bench {
            /// Counts the instructions of a step instead, and compares them with the recorded ones.
            optional --instructions
            /// With --instructions: records the counts.
            optional --write
            /// A program to measure as well.
            optional --yardstick program: PathBuf
            /// Measures the paper's tables on the site's own page instead.
            optional --page
        }
        /// Draws the golden pictures again.
        cmd goldens {
            /// Simulates the fires again as well.
            optional --snapshots
            /// How the names of the pictures begin.
            repeated name: String
        }
        /// Checks a minute of every scene for flashes and updates their rows of docs/evaluation.md.
        cmd look {
            /// How the names of the scenes begin.
            repeated scene: String
        }
        /// Takes the picture that a link to the page shows.
        cmd poster {}
        /// Takes the small pictures of the scenes.
        cmd thumbnails {
            /// A scene; without one, all.
            repeated scene: String
        }
        /// Takes the animation of the documentation.
        cmd showcase {}
        /// Simulates the scenes that a page may open with, and stores them burning.
        cmd burning {}
        /// Prints the download sizes of the built site.
        cmd size {}
        /// Writes the files that are generated from the parameter table and the scenes.
        cmd codegen {}
    }
}

impl Xtask {
    /// Reads the arguments after `cargo xtask`.
    pub(crate) fn parse(arguments: impl Iterator<Item = OsString>) -> xflags::Result<Xtask> {
        let mut separate: Vec<OsString> = arguments.flat_map(split).collect();
        if separate.first().is_none_or(|command| command == "help") {
            separate = vec!["--help".into()];
        }
        let command = Xtask::from_vec(separate)?;
        match &command.subcommand {
            XtaskCmd::Serve(serve) if serve.port == Some(0) => {
                Err(xflags::Error::new("--port needs a number from 1 to 65535"))
            }
            XtaskCmd::Bench(bench) if bench.write && !bench.instructions => {
                Err(xflags::Error::new("--write needs --instructions"))
            }
            XtaskCmd::Bench(bench)
                if bench.page && (bench.instructions || bench.yardstick.is_some()) =>
            {
                Err(xflags::Error::new("--page takes no other option"))
            }
            XtaskCmd::Bench(bench) if bench.instructions && bench.yardstick.is_some() => Err(
                xflags::Error::new("--yardstick and --instructions exclude each other"),
            ),
            _ => Ok(command),
        }
    }
}

/// `--name=value` as the two arguments that xflags reads.
fn split(argument: OsString) -> Vec<OsString> {
    match argument.to_str().and_then(|text| text.split_once('=')) {
        Some((name, value)) if name.starts_with("--") => vec![name.into(), value.into()],
        _ => vec![argument],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<String, String> {
        let parsed = Xtask::parse(line.split_whitespace().map(OsString::from));
        let command = parsed.map_err(|error| error.to_string())?;
        Ok(format!("{:?}", command.subcommand))
    }

    #[test]
    fn every_command_parses_its_options() {
        for case in [
            "serve → Serve { port: None, no_open: false }",
            "serve --port 90 --no-open → port: Some(90), no_open: true",
            "serve --no-open --port=90 → port: Some(90), no_open: true",
            "build → Build { url: None }",
            "build --url https://a.example → Some(Base(\"https://a.example/\"))",
            "build --url=https://a.example/ → Some(Base(\"https://a.example/\"))",
            "test --skip-browser lint → stage: [\"lint\"], skip_browser: true",
            "validate plume puffing → case: [\"plume\", \"puffing\"]",
            "thumbnails candle → scene: [\"candle\"]",
            "look default → scene: [\"default\"]",
            "goldens --snapshots default → name: [\"default\"], snapshots: true",
            "soak --seed 7 → corners: None, crowds: None, heaps: None, seed: Some(7), hours: None",
            "soak --hours 0.5 → corners: None, crowds: None, heaps: None, seed: None, hours: Some(0.5)",
            "fuzz --minutes 3 → minutes: Some(3), seed: None",
            "bench --yardstick=./other → yardstick: Some(\"./other\")",
            "bench --write --instructions → instructions: true, write: true",
            "bench --page → page: true",
            "package → Package",
            "reproduce → Reproduce",
            "poster → Poster",
            "showcase → Showcase",
            "burning → Burning",
            "size → Size",
            "codegen → Codegen",
        ] {
            let (line, parsed) = case.split_once(" → ").unwrap_or_default();
            let command = parse(line);
            assert!(
                command
                    .as_ref()
                    .is_ok_and(|command| command.contains(parsed)),
                "{line}: {command:?}"
            );
        }
    }

    #[test]
    fn help_lists_every_command() {
        for line in ["", "help", "--help"] {
            let help = parse(line).err().unwrap_or_default();
            for command in ["serve", "test", "bench", "codegen", "--skip-browser"] {
                assert!(help.contains(command), "{line}: {help}");
            }
        }
    }

    #[test]
    fn a_wrong_command_line_is_refused() {
        for (line, named) in [
            ("bake", "bake"),
            ("build now", "now"),
            ("build --url", "--url"),
            ("build --url=nowhere", "https://example.org/fire/"),
            ("test --fast", "--fast"),
            ("serve --host x", "--host"),
            ("serve --port", "--port"),
            ("serve --port 0", "65535"),
            ("serve --port 70000", "--port"),
            ("size 3", "3"),
            ("soak 3", "3"),
            ("soak --corners many", "--corners"),
            ("bench --write", "--instructions"),
            ("bench --instructions --yardstick x", "--yardstick"),
            ("bench --page --yardstick x", "--page"),
        ] {
            let refused = parse(line).err().unwrap_or_default();
            assert!(refused.contains(named), "{line}: {refused}");
        }
    }
}

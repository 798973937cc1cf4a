//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use xtask::arguments::separate;

xflags::xflags! {
    /// Measures Hearth; `cargo xtask help` lists what builds and tests it.
    cmd measure {
        /// Measures speed beside other programs and updates docs/evaluation.md.
        cmd bench {
            /// A program to measure as well.
            optional --yardstick program: PathBuf
        }
        /// Measures the paper's tables on bench.html and updates docs/evaluation.md.
        cmd paper {}
        /// Compares the physics with theory; a run of all cases updates docs/evaluation.md.
        cmd validate {
            /// How the names of the cases begin.
            repeated case: String
        }
        /// Burns scenes and a page for long, drives fires to random corners and back, moves solids through them, burns heaps.
        cmd soak {
            /// The number of corners of each model.
            optional --corners number: u32
            /// The number of crowds of solids of each model.
            optional --crowds number: u32
            /// The number of heaps of burning bodies.
            optional --heaps number: u32
            /// The seed of the corners.
            optional --seed number: u32
            /// The least time; other seeds follow until it has passed.
            optional --hours number: f64
            /// Simulated minutes of each scene at low quality: 1 by default.
            optional --minutes number: f64
            /// The names of scenes, with commas between them: all by default.
            optional --scenes names: String
            /// Minutes of a page that does everything at random: then nothing else is done.
            optional --page number: f64
        }
        /// Sends random values, messages, links and bytes to every decoder and updates docs/evaluation.md.
        cmd fuzz {
            /// One of the decoders that coverage guides: then nothing else is tried.
            optional --decoder name: String
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
        /// Measures which lines own tests of core, settings, engine and scripts reach, and updates docs/evaluation.md.
        cmd coverage {}
        /// Checks a minute of every scene for flashes and updates their rows of docs/evaluation.md; measures fires beside films.
        cmd look {
            /// How the names of the scenes begin.
            repeated scene: String
        }
    }
}

impl Measure {
    /// Reads the arguments after `cargo measure`.
    pub(crate) fn parse(arguments: impl Iterator<Item = OsString>) -> xflags::Result<Measure> {
        Measure::from_vec(separate(arguments))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<String, String> {
        let parsed = Measure::parse(line.split_whitespace().map(OsString::from));
        let command = parsed.map_err(|error| error.to_string())?;
        Ok(format!("{:?}", command.subcommand))
    }

    #[test]
    fn every_command_parses_its_options() {
        for case in [
            "bench --yardstick=./other → yardstick: Some(\"./other\")",
            "paper → Paper",
            "validate plume puffing → case: [\"plume\", \"puffing\"]",
            "soak --seed 7 → corners: None, crowds: None, heaps: None, seed: Some(7), hours: None, minutes: None",
            "soak --hours 0.5 → corners: None, crowds: None, heaps: None, seed: None, hours: Some(0.5)",
            "soak --minutes 60 --scenes forge → minutes: Some(60.0), scenes: Some(\"forge\")",
            "fuzz --minutes 3 → decoder: None, minutes: Some(3), seed: None",
            "faults network → section: [\"network\"]",
            "coverage → Coverage",
            "look default → scene: [\"default\"]",
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
    fn a_wrong_command_line_is_refused() {
        for (line, named) in [
            ("weigh", "weigh"),
            ("soak 3", "3"),
            ("soak --corners many", "--corners"),
            ("paper --yardstick x", "--yardstick"),
        ] {
            let refused = parse(line).err().unwrap_or_default();
            assert!(refused.contains(named), "{line}: {refused}");
        }
    }
}

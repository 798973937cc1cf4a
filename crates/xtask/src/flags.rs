//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::arguments::separate;
use crate::links::Base;

xflags::xflags! {
    /// Builds, serves and tests Hearth; `cargo measure help` lists what measures it.
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
            /// The address of Hearth's sources, which the documentation then links.
            optional --repository address: Base
        }
        /// Writes the pages beside the landing page into a site that Trunk builds.
        cmd pages {
            /// The folder of the site; without it, that of Trunk's hook.
            optional --site folder: PathBuf
        }
        /// Builds the npm package in dist/npm.
        cmd package {}
        /// Makes all that a release needs in dist/release, and says what is left to do by hand.
        cmd publish {
            /// The address that the site will have.
            optional --url address: Base
            /// The address of Hearth's sources.
            optional --repository address: Base
        }
        /// Makes the release of the last commit in another folder too and compares the bytes.
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
        /// Runs every end-to-end test in Chromium, Firefox and WebKitGTK, and writes the table of browsers.
        cmd browsers {
            /// How the names of files begin that run again; without one, all run.
            repeated name: String
        }
        /// Records the instructions of a step and what a first visit downloads; `test cost` compares with the record.
        cmd cost {}
        /// Draws the golden pictures again.
        cmd goldens {
            /// How the names of the pictures begin.
            repeated name: String
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
        cmd prewarmed {}
        /// Builds the site, prints its download sizes and records them, also in the documents.
        cmd size {}
        /// Writes the files that are generated from the parameter table and the scenes.
        cmd codegen {}
    }
}

impl Xtask {
    /// Reads the arguments after `cargo xtask`.
    pub(crate) fn parse(arguments: impl Iterator<Item = OsString>) -> xflags::Result<Xtask> {
        let command = Xtask::from_vec(separate(arguments))?;
        match &command.subcommand {
            XtaskCmd::Serve(serve) if serve.port == Some(0) => {
                Err(xflags::Error::new("--port needs a number from 1 to 65535"))
            }
            _ => Ok(command),
        }
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
            "build → Build { url: None, repository: None }",
            "build --url https://a.example → url: Some(Base(\"https://a.example/\"))",
            "build --repository https://a.example → repository: Some(Base(\"https://a.example/\"))",
            "build --url=https://a.example/ → Some(Base(\"https://a.example/\"))",
            "test --skip-browser lint → stage: [\"lint\"], skip_browser: true",
            "thumbnails candle → scene: [\"candle\"]",
            "goldens default → name: [\"default\"]",
            "pages --site dist → Pages { site: Some(\"dist\") }",
            "package → Package",
            "publish → Publish { url: None, repository: None }",
            "publish --url https://a.example → url: Some(Base(\"https://a.example/\"))",
            "reproduce → Reproduce",
            "browsers keys sound → Browsers { name: [\"keys\", \"sound\"] }",
            "poster → Poster",
            "showcase → Showcase",
            "cost → Cost",
            "prewarmed → Prewarmed",
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
            for command in [
                "serve",
                "test",
                "codegen",
                "--skip-browser",
                "cargo measure",
            ] {
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
        ] {
            let refused = parse(line).err().unwrap_or_default();
            assert!(refused.contains(named), "{line}: {refused}");
        }
    }
}

//! The command line: what may be asked for, and who answers.

use std::process::ExitCode;

use anyhow::{Result, bail};

use crate::links::{self, Base};
use crate::{
    bench, burning, codegen, goldens, look, package, paths, poster, serve, showcase, site, size,
    soak, stages, thumbnails, validate,
};

/// What a person reads who asks for help.
const HELP: &str = "\
cargo xtask <command>

  serve [--port N] [--no-open]          build the site, serve it on this machine, open it
  build [--url ADDRESS]                 build the static site in dist/site, for this address
  package                               build the npm package in dist/npm
  test [--skip-browser] [STAGE...]      check everything, or only these stages
  validate [CASE...]                    hold the physics against theory, and write docs/evaluation.md
  soak [--corners N] [--seed S]         drive fires to random corners of all ranges, and back
  bench [--yardstick PROGRAM]           measure, beside this program too, and write docs/evaluation.md
  bench --instructions [--write]        hold the instructions of a step to those written down, or write them
  goldens [--snapshots] [NAME...]       draw the pictures anew that tests compare with; of new fires too
  look [SCENE...]                       watch fires for flashes and more, and write docs/evaluation.md
  poster                                take the picture that a link to the page shows
  thumbnails [SCENE...]                 take the small pictures of all scenes, or only of these
  showcase                              take the documentation's animation
  burning                               burn the scenes that a page may open on, and keep them burning
  size                                  print the download sizes of the built site
  codegen                               write the files that come from the parameter table and the scenes
  help                                  this text
";

/// A command with its options.
#[derive(Debug, PartialEq, Eq)]
pub enum Command {
    /// Build and serve.
    Serve {
        /// The port that was asked for; none: a usual one, or any free one.
        port: Option<u16>,
        /// Whether to open a browser.
        open: bool,
    },
    /// Build the static site.
    Build {
        /// The address that it will have, if its pages are to tell it.
        url: Option<Base>,
    },
    /// Make the npm package.
    Package,
    /// Check everything, or the named stages.
    Test {
        /// Leave out what needs a browser.
        skip_browser: bool,
        /// The stages to run; none: all.
        names: Vec<String>,
    },
    /// Hold the physics against theory.
    Validate {
        /// How the names of the cases begin that are wanted; none: all.
        names: Vec<String>,
    },
    /// Drive fires to the corners of all ranges.
    Soak {
        /// How many corners of each model; none: as many as are usual.
        corners: Option<u32>,
        /// The seed of their choice; none: always the same.
        seed: Option<u32>,
    },
    /// Measure.
    Bench(bench::Task),
    /// Watch what fires look like.
    Look {
        /// How the names of the scenes begin that are wanted; none: all.
        names: Vec<String>,
    },
    /// Draw the pictures that tests compare with.
    Goldens(goldens::Wanted),
    /// Take the picture that a link shows.
    Poster,
    /// Take the small pictures of scenes.
    Thumbnails {
        /// The scenes; none: all.
        names: Vec<String>,
    },
    /// Take the documentation's animation.
    Showcase,
    /// Keep scenes burning.
    Burning,
    /// Print download sizes.
    Size,
    /// Write generated files.
    Codegen,
    /// Print the help.
    Help,
}

impl Command {
    /// Reads the arguments after `cargo xtask`.
    ///
    /// # Errors
    /// An unknown command or option, said in words.
    pub fn parse(arguments: &[String]) -> Result<Command> {
        let Some((name, options)) = arguments.split_first() else {
            return Ok(Command::Help);
        };
        let mut options = options.iter().map(String::as_str);
        let command = match name.as_str() {
            "serve" => {
                let (mut port, mut open) = (None, true);
                while let Some(option) = options.next() {
                    match option {
                        "--no-open" => open = false,
                        "--port" => port = Some(port_number(options.next().unwrap_or_default())?),
                        other => match other.strip_prefix("--port=") {
                            Some(number) => port = Some(port_number(number)?),
                            None => return unknown(name, other),
                        },
                    }
                }
                Command::Serve { port, open }
            }
            "test" => {
                let (mut skip_browser, mut names) = (false, Vec::new());
                for option in options.by_ref() {
                    match option {
                        "--skip-browser" => skip_browser = true,
                        other if other.starts_with('-') => return unknown(name, other),
                        stage => names.push(stage.to_owned()),
                    }
                }
                Command::Test {
                    skip_browser,
                    names,
                }
            }
            "validate" | "look" | "thumbnails" => {
                let mut names = Vec::new();
                for given in options.by_ref() {
                    if given.starts_with('-') {
                        return unknown(name, given);
                    }
                    names.push(given.to_owned());
                }
                match name.as_str() {
                    "look" => Command::Look { names },
                    "thumbnails" => Command::Thumbnails { names },
                    _ => Command::Validate { names },
                }
            }
            "soak" => {
                let (mut corners, mut seed) = (None, None);
                while let Some(option) = options.next() {
                    let value = match option {
                        "--corners" => &mut corners,
                        "--seed" => &mut seed,
                        other => return unknown(name, other),
                    };
                    *value = Some(whole_number(option, options.next().unwrap_or_default())?);
                }
                Command::Soak { corners, seed }
            }
            "build" => {
                let mut url = None;
                while let Some(option) = options.next() {
                    match option {
                        "--url" => url = Some(Base::parse(options.next().unwrap_or_default())?),
                        other => match other.strip_prefix("--url=") {
                            Some(address) => url = Some(Base::parse(address)?),
                            None => return unknown(name, other),
                        },
                    }
                }
                Command::Build { url }
            }
            "bench" => match bench::Task::parse(options.by_ref()) {
                Ok(task) => Command::Bench(task),
                Err(option) => return unknown(name, &option),
            },
            "goldens" => {
                let mut wanted = goldens::Wanted::default();
                for option in options.by_ref() {
                    match option {
                        "--snapshots" => wanted.snapshots = true,
                        other if other.starts_with('-') => return unknown(name, other),
                        picture => wanted.names.push(picture.to_owned()),
                    }
                }
                Command::Goldens(wanted)
            }
            "poster" => Command::Poster,
            "showcase" => Command::Showcase,
            "package" => Command::Package,
            "burning" => Command::Burning,
            "size" => Command::Size,
            "codegen" => Command::Codegen,
            "help" | "--help" | "-h" => Command::Help,
            other => bail!("there is no command \"{other}\"\n\n{HELP}"),
        };
        match options.next() {
            Some(extra) => unknown(name, extra),
            None => Ok(command),
        }
    }
}

fn unknown(command: &str, option: &str) -> Result<Command> {
    bail!("`{command}` does not know \"{option}\"\n\n{HELP}")
}

fn port_number(text: &str) -> Result<u16> {
    match text.parse() {
        Ok(port) if port > 0 => Ok(port),
        _ => bail!("--port wants a number from 1 to 65535, not \"{text}\""),
    }
}

fn whole_number(option: &str, text: &str) -> Result<u32> {
    match text.parse() {
        Ok(number) => Ok(number),
        Err(_) => bail!("{option} wants a whole number, not \"{text}\""),
    }
}

/// Runs `command` to its end.
///
/// # Errors
/// Whatever stopped it.
pub fn run(command: Command) -> Result<ExitCode> {
    match command {
        Command::Serve { port, open } => {
            site::build()?;
            serve::serve(&paths::site(), port, open)?;
        }
        Command::Build { url } => {
            site::build()?;
            if let Some(base) = url {
                links::make_whole(&paths::site(), &base)?;
            }
            println!(
                "The site is in {}: copy it to any static host.",
                paths::shown(&paths::site())
            );
        }
        Command::Package => package::build()?,
        Command::Test {
            skip_browser,
            names,
        } => {
            return Ok(if stages::run(skip_browser, &names)? {
                ExitCode::SUCCESS
            } else {
                ExitCode::FAILURE
            });
        }
        Command::Validate { names } => validate::run(&names)?,
        Command::Soak { corners, seed } => soak::run(corners, seed)?,
        Command::Bench(task) => bench::run(&task)?,
        Command::Look { names } => look::run(&names)?,
        Command::Goldens(wanted) => goldens::write(&wanted)?,
        Command::Poster => poster::take()?,
        Command::Thumbnails { names } => thumbnails::take(&names)?,
        Command::Showcase => showcase::take()?,
        Command::Size => {
            site::build()?;
            size::check()?;
        }
        Command::Burning => {
            for path in burning::refresh(true)? {
                println!("wrote {}", paths::shown(&path));
            }
        }
        Command::Codegen => {
            let written = codegen::refresh_checkout()?;
            for path in &written {
                println!("wrote {path}");
            }
            let burning = burning::refresh(false)?;
            for path in &burning {
                println!("wrote {}", paths::shown(path));
            }
            if written.is_empty() && burning.is_empty() {
                println!("every generated file is up to date");
            }
        }
        Command::Help => print!("{HELP}"),
    }
    Ok(ExitCode::SUCCESS)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<Command> {
        let words: Vec<_> = line.split_whitespace().map(str::to_owned).collect();
        Command::parse(&words)
    }

    #[test]
    fn options_are_understood() -> Result<()> {
        assert_eq!(parse("")?, Command::Help);
        assert_eq!(
            parse("serve")?,
            Command::Serve {
                port: None,
                open: true
            }
        );
        for line in ["serve --port 90 --no-open", "serve --no-open --port=90"] {
            assert_eq!(
                parse(line)?,
                Command::Serve {
                    port: Some(90),
                    open: false
                }
            );
        }
        assert_eq!(parse("build")?, Command::Build { url: None });
        for line in [
            "build --url https://a.example",
            "build --url=https://a.example/",
        ] {
            assert_eq!(
                parse(line)?,
                Command::Build {
                    url: Some(Base::parse("https://a.example/")?)
                }
            );
        }
        assert_eq!(
            parse("test --skip-browser lint native")?,
            Command::Test {
                skip_browser: true,
                names: vec!["lint".to_owned(), "native".to_owned()]
            }
        );
        assert_eq!(
            parse("validate plume puffing")?,
            Command::Validate {
                names: vec!["plume".to_owned(), "puffing".to_owned()]
            }
        );
        assert_eq!(
            parse("thumbnails candle")?,
            Command::Thumbnails {
                names: vec!["candle".to_owned()]
            }
        );
        assert_eq!(
            parse("look default")?,
            Command::Look {
                names: vec!["default".to_owned()]
            }
        );
        assert_eq!(
            parse("goldens --snapshots default")?,
            Command::Goldens(goldens::Wanted {
                snapshots: true,
                names: vec!["default".to_owned()]
            })
        );
        assert_eq!(
            parse("soak --seed 7")?,
            Command::Soak {
                corners: None,
                seed: Some(7)
            }
        );
        Ok(())
    }

    #[test]
    fn nonsense_is_refused_with_the_help() {
        for line in [
            "bake",
            "build now",
            "test --fast",
            "serve --host x",
            "size 3",
            "package now",
            "validate --fast",
            "thumbnails --all",
            "soak 3",
            "bench --fast",
            "goldens --fast",
            "look --fast",
        ] {
            let said = parse(line).err().map(|error| error.to_string());
            assert!(said.is_some_and(|said| said.contains("cargo xtask <command>")));
        }
        for line in ["serve --port", "serve --port 0", "serve --port 70000"] {
            let said = parse(line).err().map(|error| error.to_string());
            assert!(said.is_some_and(|said| said.contains("65535")));
        }
        for line in ["build --url", "build --url=nowhere"] {
            let said = parse(line).err().map(|error| error.to_string());
            assert!(said.is_some_and(|said| said.contains("--url wants the address")));
        }
        let said = parse("soak --corners many").err().map(|e| e.to_string());
        assert!(said.is_some_and(|said| said.contains("--corners wants a whole number")));
    }
}

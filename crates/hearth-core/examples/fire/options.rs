//! The options of the command line.

use std::error::Error;
use std::path::PathBuf;

use hearth_core::Parameters;
use hearth_core::params::{IN_DOMAIN, Input};

/// The help.
pub const HELP: &str = "\
fire [OPTION...] [ID=VALUE...]

  --frames N     how many pictures, 1 to 10000 (60)
  --out DIR      the folder that they go to, made where it is missing (frames)
  --fps N        pictures for each second of fire, 1 to 1000 (30)
  --start S      seconds of fire before the first picture, 0 to 100 (1)
  --size N       height of a picture in pixels, 16 to 4096 (540)
  ID=VALUE       any parameter, as fuel_power=400 or model=classic
";

/// The options.
#[derive(Clone, Debug)]
pub struct Options {
    /// Number of pictures.
    pub frames: u32,
    /// Output folder.
    pub out: PathBuf,
    /// Pictures per second of fire.
    pub fps: f64,
    /// Seconds of fire before the first one.
    pub start: f64,
    /// Height of a picture in pixels.
    pub height: u32,
    /// The values of the fire.
    pub parameters: Parameters,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            frames: 60,
            out: PathBuf::from("frames"),
            fps: 30.0,
            start: 1.0,
            height: 540,
            parameters: Parameters::default(),
        }
    }
}

impl Options {
    /// Parses the arguments after the program's name.
    ///
    /// # Errors
    /// The first invalid argument. The message names the allowed values.
    pub fn parse(arguments: &[String]) -> Result<Options, Box<dyn Error>> {
        let mut options = Options::default();
        let mut values = Vec::new();
        let mut arguments = arguments.iter().map(String::as_str);
        while let Some(argument) = arguments.next() {
            if let Some((id, value)) = argument.split_once('=')
                && !argument.starts_with('-')
            {
                values.push((id, Input::Text(value)));
                continue;
            }
            let mut value = || {
                let missing = || format!("{argument} needs a value\n\n{HELP}");
                arguments.next().ok_or_else(missing)
            };
            match argument {
                "--frames" => options.frames = whole(argument, value()?, 1, 10_000)?,
                "--out" => options.out = PathBuf::from(value()?),
                "--fps" => options.fps = number(argument, value()?, 1.0, 1000.0)?,
                "--start" => options.start = number(argument, value()?, 0.0, 100.0)?,
                "--size" => options.height = whole(argument, value()?, 16, 4096)?,
                _ => return Err(format!("there is no \"{argument}\"\n\n{HELP}").into()),
            }
        }
        let ids: Vec<_> = values.iter().map(|&(id, _)| id).collect();
        options.parameters.set_all(values).map_err(|errors| {
            let message: Vec<_> = errors.iter().map(ToString::to_string).collect();
            message.join("\n")
        })?;
        options
            .parameters
            .complete(&|id| ids.contains(&id), IN_DOMAIN);
        Ok(options)
    }
}

fn whole(option: &str, text: &str, min: u32, max: u32) -> Result<u32, String> {
    let number = text.parse().ok().filter(|n| (min..=max).contains(n));
    number
        .ok_or_else(|| format!("{option} needs a whole number from {min} to {max}, not \"{text}\""))
}

fn number(option: &str, text: &str, min: f64, max: f64) -> Result<f64, String> {
    let number = text.parse().ok().filter(|x| (min..=max).contains(x));
    number.ok_or_else(|| format!("{option} needs a number from {min} to {max}, not \"{text}\""))
}

#[cfg(test)]
mod tests {
    use hearth_core::params::Model;

    use super::*;

    fn parse(line: &str) -> Result<Options, String> {
        let words: Vec<_> = line.split_whitespace().map(str::to_owned).collect();
        Options::parse(&words).map_err(|error| error.to_string())
    }

    #[test]
    fn what_is_asked_for_is_understood() -> Result<(), String> {
        let options = parse("--frames 5 wind=0.5 --out a/b --fps 60 --start 0 --size 64")?;
        assert_eq!((options.frames, options.height), (5, 64));
        assert_eq!((options.fps, options.start), (60.0, 0.0));
        assert_eq!(options.out, PathBuf::from("a/b"));
        assert_eq!(options.parameters.wind, 0.5);
        // The model is set first, at any position.
        let classic = parse("max_particles=200 model=classic")?;
        assert_eq!(classic.parameters.model(), Model::Classic);
        assert_eq!(classic.parameters.max_particles, 200);
        Ok(())
    }

    #[test]
    fn an_invalid_option_is_an_error_with_a_message() {
        for (line, words) in [
            (
                "--frames 0",
                "--frames needs a whole number from 1 to 10000, not \"0\"",
            ),
            ("--frames 1e9", "from 1 to 10000"),
            ("--frames", "--frames needs a value"),
            (
                "--fps NaN",
                "--fps needs a number from 1 to 1000, not \"NaN\"",
            ),
            ("--start -1", "from 0 to 100"),
            ("--size 1000000", "from 16 to 4096"),
            ("--sise 10", "there is no \"--sise\""),
            ("--frames=5", "there is no \"--frames=5\""),
            ("fire", "there is no \"fire\""),
            ("gravty=5", "did you mean \"gravity\"?"),
            ("gravity=99", "from 0 to 20 m/s²"),
            ("gravity=", "from 0 to 20 m/s²"),
        ] {
            let message = parse(line).err().unwrap_or_default();
            assert!(message.contains(words), "{line}: {message}");
        }
    }
}

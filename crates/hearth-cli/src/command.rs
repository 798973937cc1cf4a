//! The command `hearth`: its arguments, and what runs for each of its commands.

mod bench;
mod film;
mod info;
mod options;
mod progress;
mod render;
mod scenes;
mod sheet;
mod sprites;

use std::ffi::OsString;
use std::io::{self, Write, stderr};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use hearth_core::params::printable;

use crate::error::Error;
use crate::output;

/// Pictures of real fire, simulated and drawn without a browser.
#[derive(Parser)]
#[command(name = "hearth", version, after_help = EXIT_CODES)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "\
Exit codes: 0 done, 1 failed while running, 2 wrong use or an invalid scene, 130 ended by a signal.";

#[derive(Subcommand)]
enum Command {
    /// Draws one picture of a fire as PNG.
    Render(render::Render),
    /// Writes a film of a fire: PNG files, APNG, WebP, GIF, WebM, MP4, or bytes for another program.
    Film(film::Film),
    /// Draws scenes × moments × backgrounds as one labelled picture.
    Sheet(sheet::Sheet),
    /// Draws a sprite sheet for game engines, with motion vectors and an atlas if asked for.
    Sprites(sprites::Sprites),
    /// Lists the presets.
    Scenes(scenes::Scenes),
    /// Shows the graphics driver, its limits and its formats.
    Info(info::Info),
    /// Measures the time of each pass of a picture.
    Bench(bench::Bench),
}

/// Runs the command with these arguments, the name of the program first.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        // Help and version are such errors, too.
        Err(error) => {
            // Nothing is left to do where nobody reads the help.
            let _ = match error.use_stderr() {
                true => tell(&error.render().to_string()),
                false => error.print(),
            };
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    let ready = output::end_between_files_on_signals();
    let done = ready.and_then(|()| match arguments.command {
        Command::Render(render) => render.run(),
        Command::Film(film) => film.run(),
        Command::Sheet(sheet) => sheet.run(),
        Command::Sprites(sprites) => sprites.run(),
        Command::Scenes(scenes) => scenes.run(),
        Command::Info(info) => info.run(),
        Command::Bench(bench) => bench.run(),
    });
    match done {
        Ok(()) | Err(Error::Closed) => ExitCode::SUCCESS,
        Err(error) => {
            // Nothing is left to do where nobody reads the error.
            let _ = tell(&format!("error: {error}\n"));
            ExitCode::from(error.code())
        }
    }
}

/// Writes a message to standard error. What it quotes does not act on the terminal.
fn tell(message: &str) -> io::Result<()> {
    let lines: Vec<_> = message.split('\n').map(printable).collect();
    stderr().write_all(lines.join("\n").as_bytes())
}

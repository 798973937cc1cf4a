//! `hearth scenes`: the presets.

use clap::Args;
use hearth_core::preset::Preset;
use serde_json::json;

use crate::error::Error;
use crate::output;

/// Arguments of `hearth scenes`.
#[derive(Args)]
pub struct Scenes {
    /// Prints JSON.
    #[arg(long)]
    json: bool,
}

impl Scenes {
    /// Prints the presets.
    ///
    /// # Errors
    /// Standard output fails.
    pub fn run(&self) -> Result<(), Error> {
        let presets = Preset::all();
        if self.json {
            let list: Vec<_> = presets
                .iter()
                .map(|preset| {
                    json!({
                        "name": preset.name,
                        "label": preset.label(),
                        "description": preset.description(),
                        "model": preset.world().model().name(),
                    })
                })
                .collect();
            return output::print(format!("{:#}\n", json!(list)).as_bytes());
        }
        let widest = |of: fn(&Preset) -> usize| presets.iter().map(of).max().unwrap_or(0);
        let name = widest(|preset| preset.name.len());
        let label = widest(|preset| preset.label().chars().count());
        let lines = presets.iter().map(|preset| {
            let text = preset.description();
            format!("{:name$}  {:label$}  {text}\n", preset.name, preset.label())
        });
        output::print(lines.collect::<String>().as_bytes())
    }
}

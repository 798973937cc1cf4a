//! Fixed cases whose instructions are counted: `counted CASE` prints how many
//! particles took a step in how many steps; run under callgrind, which counts
//! inside of `measured` alone. `cargo xtask cost` does that.

use std::env;

use hearth_benches::scenes::{self, measured};
use hearth_core::Simulation;

/// The cases, and how many steps of each are counted. What comes before them is
/// short, for callgrind is slow.
fn case(name: &str) -> Result<(Simulation, u32), String> {
    match name {
        "classic block" => Ok((scenes::block(5000, scenes::NEIGHBOURS)?, 20)),
        "classic plume" => Ok((scenes::classic_after(1.0), 40)),
        "combustion" => Ok((scenes::combustion_after(0.3, 3000, 6.0)?, 10)),
        "bodies" => Ok((scenes::bodies(20)?, 20)),
        // The same fire without them, to compare by hand.
        "no bodies" => Ok((scenes::bodies(0)?, 20)),
        _ => Err(format!("there is no case \"{name}\"")),
    }
}

fn main() -> Result<(), String> {
    let name = env::args().nth(1).unwrap_or_default();
    let (mut simulation, steps) = case(&name)?;
    println!("{}", measured(&mut simulation, steps));
    Ok(())
}

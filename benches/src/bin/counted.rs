//! Fixed cases whose instructions are counted: `counted CASE` prints how many
//! particles took a step in how many steps; run under callgrind, which counts
//! inside of `measured` alone. `cargo xtask cost` does that.

use std::env;

use hearth_benches::scenes::{counted, measured};

fn main() -> Result<(), String> {
    let name = env::args().nth(1).unwrap_or_default();
    let (mut simulation, steps) = counted(&name)?;
    println!("{}", measured(&mut simulation, steps));
    Ok(())
}

//! Instructions of wasm that a particle takes in a step, as wasmi counts them: `fuel FILE` prints a line for each case.
//!
//! wasmi is an interpreter, so that the count is the same on every machine. It counts its own instructions: several of
//! wasm may be one of them. `cargo xtask cost` records what is printed.

use std::error::Error;
use std::{env, fs};

use hearth_benches::scenes::IN_WASM;
use wasmi::{Config, Engine, ExternType, Func, Linker, Module, Store, Val};

fn main() -> Result<(), Box<dyn Error>> {
    let file = env::args().nth(1).ok_or("which file of wasm?")?;
    let engine = Engine::new(Config::default().consume_fuel(true));
    let module = Module::new(&engine, fs::read(file)?)?;
    for (number, name) in IN_WASM.iter().enumerate() {
        let [(without, _), (with, particles)] = [
            burnt(&module, number as i32, 0)?,
            burnt(&module, number as i32, 1)?,
        ];
        if particles == 0 {
            return Err(format!("nothing was counted of {name}").into());
        }
        println!("{name}: {}", (with - without).div_ceil(particles));
    }
    Ok(())
}

/// The fuel of a case with its steps or without, and its particles.
fn burnt(module: &Module, case: i32, steps: i32) -> Result<(u64, u64), Box<dyn Error>> {
    let mut store = Store::new(module.engine(), ());
    store.set_fuel(u64::MAX)?;
    let mut linker = Linker::new(module.engine());
    for import in module.imports() {
        // No case calls JavaScript.
        if let ExternType::Func(kind) = import.ty() {
            let unused = Func::new(&mut store, kind.clone(), |_, _, _| {
                Err(wasmi::Error::new("a case calls JavaScript"))
            });
            linker.define(import.module(), import.name(), unused)?;
        }
    }
    let instance = linker.instantiate_and_start(&mut store, module)?;
    // wasm-bindgen adds a hash to the name.
    let name = module.exports().map(|export| export.name());
    let name = { name }.find(|name| name.starts_with("counted"));
    let counted = name.and_then(|name| instance.get_func(&store, name));
    let counted = counted.ok_or("the module does not export `counted`")?;
    let mut particles = [Val::I32(0)];
    counted.call(
        &mut store,
        &[Val::I32(case), Val::I32(steps)],
        &mut particles,
    )?;
    let count = particles[0].i32().unwrap_or_default();
    Ok((u64::MAX - store.get_fuel()?, count as u64))
}

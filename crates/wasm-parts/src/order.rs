//! The order of a module's functions: like ones next to each other, so that a compressor, which
//! finds near repetitions at less cost than far ones, makes the module smaller.

use std::cmp::Reverse;

use anyhow::{Result, anyhow};
use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{CodeSection, FunctionSection, Module};
use wasmparser::{CodeSectionReader, FunctionSectionReader, Parser, Payload};

/// Length of the pieces that functions are compared by \[B\].
const PIECE: usize = 4;

/// Pieces of a module that are compared, about: all of a small one, and of a large one as many as take
/// two seconds.
const COMPARED: usize = 400_000;

/// Bits of the number of a piece.
const BITS: u32 = 18;

/// Puts the functions of the module of these bytes in another order.
///
/// # Errors
/// The module is invalid.
pub fn order(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut imported = 0;
    let mut bodies = Vec::new();
    for payload in Parser::new(0).parse_all(bytes) {
        match payload? {
            Payload::ImportSection(imports) => {
                for import in imports.into_imports() {
                    imported += u32::from(matches!(import?.ty, wasmparser::TypeRef::Func(_)));
                }
            }
            Payload::CodeSectionEntry(body) => bodies.push(body.as_bytes()),
            _ => {}
        }
    }
    let order = by_likeness(&bodies);
    let mut places = vec![0; order.len()];
    for (place, &function) in (imported..).zip(&order) {
        places[function] = place;
    }
    let mut ordered = Ordered {
        imported,
        order,
        places,
    };
    let mut module = Module::new();
    let parsed = ordered.parse_core_module(&mut module, Parser::new(0), bytes);
    parsed.map_err(|error| anyhow!("the module cannot be written: {error}"))?;
    Ok(module.finish())
}

/// The largest function, and after each function the one that repeats most of it for its length.
fn by_likeness(bodies: &[&[u8]]) -> Vec<usize> {
    let every = bodies.iter().map(|body| body.len()).sum::<usize>() / COMPARED + 1;
    let pieces: Vec<_> = bodies.iter().map(|body| pieces(body, every)).collect();
    let mut left: Vec<_> = (0..bodies.len()).collect();
    left.sort_by_key(|&function| (Reverse(bodies[function].len()), function));
    let mut order = Vec::with_capacity(left.len());
    let mut in_last = vec![false; 1 << BITS];
    let mut next = 0;
    while !left.is_empty() {
        let last = left.remove(next);
        order.push(last);
        pieces[last].iter().for_each(|&piece| in_last[piece] = true);
        let likeness = |function: usize| {
            let of = &pieces[function];
            let common = of.iter().filter(|&&piece| in_last[piece]).count() as f64;
            common / ((of.len() as f64).powf(0.7) + 8.0)
        };
        let best = left
            .iter()
            .enumerate()
            .map(|(at, &function)| (at, likeness(function)));
        // Of equals the first.
        let best = best.reduce(|best, other| if other.1 > best.1 { other } else { best });
        next = best.map_or(0, |(at, _)| at);
        pieces[last]
            .iter()
            .for_each(|&piece| in_last[piece] = false);
    }
    order
}

/// The numbers of a function's pieces, each once; of many numbers those that `every` divides.
fn pieces(body: &[u8], every: usize) -> Vec<usize> {
    let number = |piece: &[u8]| {
        let hash = piece.iter().fold(0_u32, |hash, &byte| {
            (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
        });
        (hash.wrapping_mul(0x9e37_79b1) >> (u32::BITS - BITS)) as usize
    };
    let numbers = body.windows(PIECE).map(number);
    let mut pieces: Vec<_> = numbers
        .filter(|number| number.is_multiple_of(every))
        .collect();
    pieces.sort_unstable();
    pieces.dedup();
    pieces
}

/// Writes a module in another order.
struct Ordered {
    /// Imported functions, which come first.
    imported: u32,
    /// The functions, by number without the imported ones.
    order: Vec<usize>,
    /// The new number of each.
    places: Vec<u32>,
}

impl Reencode for Ordered {
    type Error = anyhow::Error;

    fn function_index(&mut self, function: u32) -> Result<u32, Error<Self::Error>> {
        let own = function.checked_sub(self.imported);
        Ok(own.map_or(function, |own| self.places[own as usize]))
    }

    fn parse_function_section(
        &mut self,
        functions: &mut FunctionSection,
        section: FunctionSectionReader<'_>,
    ) -> Result<(), Error<Self::Error>> {
        let types = section.into_iter().collect::<Result<Vec<_>, _>>()?;
        for &function in &self.order {
            functions.function(types[function]);
        }
        Ok(())
    }

    fn parse_code_section(
        &mut self,
        code: &mut CodeSection,
        section: CodeSectionReader<'_>,
    ) -> Result<(), Error<Self::Error>> {
        let bodies = section.into_iter().collect::<Result<Vec<_>, _>>()?;
        for at in 0..self.order.len() {
            utils::parse_function_body(self, code, bodies[self.order[at]].clone())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use walrus::ir::{Instr, Value};
    use walrus::{ExportItem, FunctionBuilder, FunctionKind, ValType};

    /// A module whose exports `0`, `1`, … return their numbers by a call of another function.
    fn module(count: i32) -> Vec<u8> {
        let mut module = walrus::Module::default();
        let types = module.types.add(&[], &[]);
        module.add_import_func("from", "imported", types);
        for number in 0..count {
            let results = [ValType::I32];
            let mut called = FunctionBuilder::new(&mut module.types, &[], &results);
            // Functions of many lengths, of two kinds.
            for _ in 0..(number * 7) % 11 {
                let mut body = called.func_body();
                if number % 2 == 0 {
                    body.i32_const(1).drop();
                } else {
                    body.f64_const(1.0).drop();
                }
            }
            called.func_body().i32_const(number);
            let called = called.finish(Vec::new(), &mut module.funcs);
            let mut caller = FunctionBuilder::new(&mut module.types, &[], &results);
            caller.func_body().call(called);
            let caller = caller.finish(Vec::new(), &mut module.funcs);
            module.exports.add(&number.to_string(), caller);
        }
        module.emit_wasm()
    }

    fn last(module: &walrus::Module, function: walrus::FunctionId) -> Option<&Instr> {
        match &module.funcs.get(function).kind {
            FunctionKind::Local(local) => local
                .block(local.entry_block())
                .instrs
                .last()
                .map(|(last, _)| last),
            _ => None,
        }
    }

    #[test]
    fn functions_keep_what_they_call() -> Result<()> {
        let bytes = order(&module(30))?;
        let module = walrus::Module::from_buffer(&bytes)?;
        assert_eq!(module.exports.iter().count(), 30);
        for export in module.exports.iter() {
            let ExportItem::Function(caller) = export.item else {
                panic!("{} is no function", export.name);
            };
            let Some(Instr::Call(call)) = last(&module, caller) else {
                panic!("{} calls nothing", export.name);
            };
            let Some(Instr::Const(returned)) = last(&module, call.func) else {
                panic!("{} calls another function", export.name);
            };
            assert!(
                matches!(returned.value, Value::I32(number) if number.to_string() == export.name)
            );
        }
        Ok(())
    }

    #[test]
    fn like_functions_are_neighbours() {
        let long = |of: &[u8]| of.repeat(20);
        let bodies = [long(b"abcd"), long(b"wxyz"), long(b"abcd"), long(b"wxyz")];
        let bodies: Vec<_> = bodies.iter().map(Vec::as_slice).collect();
        assert_eq!(by_likeness(&bodies), [0, 2, 1, 3]);
    }

    #[test]
    fn the_order_follows_from_the_module() -> Result<()> {
        let bytes = module(30);
        assert_eq!(order(&bytes)?, order(&bytes)?);
        assert!(order(b"no module").is_err());
        Ok(())
    }
}

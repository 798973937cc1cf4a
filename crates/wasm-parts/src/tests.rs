//! Tests of dividing a module.

use super::*;
use walrus::ValType;

/// A module that returns `number`, in which `main` calls `part::outer`, which calls `part::inner` and `shared`, and
/// whose table has `part::pointed` and `shared`.
pub(crate) fn module(number: i32) -> Module {
    let mut module = Module::default();
    let mut function = |name: &str, result: bool, calls: &[FunctionId]| {
        let results = [ValType::I32];
        let results = if result { &results[..] } else { &[] };
        let mut builder = FunctionBuilder::new(&mut module.types, &[], results);
        builder.name(name.to_owned());
        for &call in calls {
            builder.func_body().call(call);
        }
        if result {
            builder.func_body().i32_const(number);
        }
        builder.finish(Vec::new(), &mut module.funcs)
    };
    let shared = function("shared", false, &[]);
    let inner = function("only::the::part::calls", false, &[shared]);
    let outer = function("part::outer", false, &[inner, shared]);
    let pointed = function("part::pointed", false, &[]);
    let main = function("main", true, &[outer]);
    let memory = module.memories.add_local(false, false, 1, None, None);
    let offset = ConstExpr::Value(Value::I32(64));
    let data = b"first//part part\nsecond\n//end\nthird".to_vec();
    let data = module.data.add(DataKind::Active { memory, offset }, data);
    module.memories.get_mut(memory).data_segments.insert(data);
    let table = module
        .tables
        .add_local(false, 3, Some(3), walrus::RefType::FUNCREF);
    let offset = ConstExpr::Value(Value::I32(1));
    let items = ElementItems::Functions(vec![pointed, shared]);
    let element = module
        .elements
        .add(ElementKind::Active { table, offset }, items);
    module.tables.get_mut(table).elem_segments.insert(element);
    module.exports.add("main", main);
    module.exports.add("memory", memory);
    module
}

pub(crate) const PART: Part = Part {
    name: "part",
    modules: &["part::"],
};

fn names(module: &Module) -> Vec<&str> {
    let local = module.funcs.iter_local();
    let mut names: Vec<_> = local
        .filter_map(|(id, _)| module.funcs.get(id).name.as_deref())
        .collect();
    names.sort_unstable();
    names
}

#[test]
fn a_part_takes_its_functions_and_what_only_they_call() -> Result<()> {
    let Divided { base, taken } = take(&module(1).emit_wasm(), &PART)?;
    let parse = |bytes: &[u8]| ModuleConfig::new().parse(bytes);
    let (base, taken) = (parse(&base)?, parse(&taken)?);
    assert_eq!(
        names(&taken),
        ["only::the::part::calls", "part::outer", "part::pointed"]
    );
    // What remains of `part::outer` calls through the table.
    assert_eq!(names(&base), ["main", "part::outer", "shared"]);
    let exports: Vec<_> = base
        .exports
        .iter()
        .map(|export| export.name.as_str())
        .collect();
    for import in taken.imports.iter() {
        assert_eq!(import.module, BASE);
        assert!(exports.contains(&import.name.as_str()), "{}", import.name);
    }
    // The slot of the pointer, and one after the end of the table.
    let slots: Result<Vec<_>> = taken.elements.iter().map(first_slot).collect();
    assert_eq!(slots?, [1, 3]);
    Ok(())
}

/// The data of the module of these bytes, with their addresses.
fn data(bytes: &[u8]) -> Result<Vec<(i32, String)>> {
    let module = ModuleConfig::new().parse(bytes)?;
    let data = module.data.iter().map(|data| match data.kind {
        DataKind::Active {
            offset: ConstExpr::Value(Value::I32(at)),
            ..
        } => Ok((at, String::from_utf8(data.value.clone())?)),
        _ => bail!("the segment has no place"),
    });
    data.collect()
}

#[test]
fn a_part_takes_its_texts_and_leaves_zeros() -> Result<()> {
    let text = "//part part\nsecond\n//end\n";
    for modules in [PART.modules, &[]] {
        let Divided { base, taken } = take(&module(1).emit_wasm(), &Part { modules, ..PART })?;
        let zeros = "\0".repeat(text.len());
        assert_eq!(data(&base)?, [(64, format!("first{zeros}third"))]);
        assert_eq!(data(&taken)?, [(69, text.to_owned())]);
    }
    Ok(())
}

#[test]
fn a_part_that_is_not_there_is_an_error() {
    let (name, modules) = ("other", &["other::"]);
    assert!(take(&module(1).emit_wasm(), &Part { name, modules }).is_err());
}

//! Makes a wasm module smaller to download: it divides it, [orders](order()) its functions, and shortens
//! it together with its [script](Bound).
//!
//! What few visitors need becomes modules of their own, its parts, which a page fetches when it needs
//! them.
//! A part imports memory, function table, globals and functions of the module that it is taken
//! from, the rest, and puts its own functions into the table. The rest calls them through the
//! table. Both come from one link, so a part fits its own rest and no other.

mod glue;
mod order;
#[cfg(test)]
mod tests;
mod texts;

use std::collections::{BTreeMap, BTreeSet, HashSet};

use anyhow::{Context, Result, bail, ensure};
use walrus::ir::{UnaryOp, Value, Visitor, dfs_in_order};
use walrus::{
    ConstExpr, Element, ElementItems, ElementKind, Export, ExportItem, FunctionBuilder, FunctionId,
    FunctionKind, GlobalKind, ImportKind, ImportedFunction, LocalFunction, Module, ModuleConfig,
    TableId, ValType,
};

use texts::Text;

pub use glue::Bound;
pub use order::order;

/// What a part takes from a module.
pub struct Part<'a> {
    /// Its name, in errors.
    pub name: &'a str,
    /// How the symbols of its functions begin. Functions that only these call move with them.
    pub symbols: &'a [&'a str],
    /// The texts that only its functions read. Zeros are in their places until it is loaded.
    pub texts: fn() -> Vec<&'static str>,
    /// How the symbols of the functions begin that call the part, which they do if it is loaded.
    pub callers: &'a [&'a str],
    /// How the symbol of the function begins that returns whether the part is loaded. It stays.
    pub is_loaded: &'a str,
}

/// The name of the module that a part imports from.
pub const REST: &str = "rest";

/// A module and a part of it, as bytes.
pub struct Divided {
    /// The module without the part.
    pub rest: Vec<u8>,
    /// The part.
    pub taken: Vec<u8>,
}

/// Takes `part` from the module of these bytes.
///
/// # Errors
/// The module is invalid, or names no function of the part.
pub fn take(bytes: &[u8], part: &Part) -> Result<Divided> {
    let mut rest = ModuleConfig::new().parse(bytes)?;
    // A function has the same index in both.
    let mut taken = ModuleConfig::new().parse(bytes)?;
    let moved = moved(&rest, part.symbols);
    ensure!(!moved.is_empty(), "no function of {} is found", part.name);
    check_callers(&rest, &moved, part)?;
    let slots = Slots::new(&mut rest, &moved)?;
    // Numbers are no names of exports but those for parts.
    let names = rest
        .exports
        .iter()
        .filter(|export| export.name.parse::<usize>().is_ok());
    let first_name = names.count();
    let texts = texts::take(&mut rest, (part.texts)())?;
    let imported = keep_only(&mut taken, &moved, texts, &slots, first_name)?;
    leave_calls(&mut rest, &moved, &slots, &imported)?;
    look_for(&mut rest, part, &slots)?;
    walrus::passes::gc::run(&mut rest);
    Ok(Divided {
        rest: rest.emit_wasm(),
        taken: taken.emit_wasm(),
    })
}

/// The functions whose symbols begin so, and those that only they call.
fn moved(module: &Module, symbols: &[&str]) -> BTreeSet<usize> {
    let is_named = |id: FunctionId| {
        let function = module.funcs.get(id);
        let name = function.name.as_deref().unwrap_or_default();
        matches!(function.kind, FunctionKind::Local(_))
            && symbols.iter().any(|text| name.starts_with(text))
    };
    let mut open: Vec<_> = module.exports.iter().filter_map(exported).collect();
    open.extend(module.start);
    open.extend(module.elements.iter().flat_map(functions));
    open.retain(|&id| !is_named(id));
    let mut staying = HashSet::new();
    while let Some(id) = open.pop() {
        if staying.insert(id)
            && let FunctionKind::Local(function) = &module.funcs.get(id).kind
        {
            open.extend(calls(function).filter(|&id| !is_named(id)));
        }
    }
    module
        .funcs
        .iter_local()
        .map(|(id, _)| id)
        .filter(|id| !staying.contains(id))
        .map(|id| id.index())
        .collect()
}

/// Checks that no other functions than those named call the part: a call before it is loaded traps.
fn check_callers(module: &Module, moved: &BTreeSet<usize>, part: &Part) -> Result<()> {
    for (id, function) in module.funcs.iter_local() {
        let called = calls(function).find(|called| moved.contains(&called.index()));
        if let Some(called) = called
            && !moved.contains(&id.index())
        {
            let name = |id| module.funcs.get(id).name.as_deref().unwrap_or("a function");
            let (from, to) = (name(id), name(called));
            let is_known = part.callers.iter().any(|caller| from.starts_with(caller));
            ensure!(is_known, "{from} calls {to}, which moves to {}", part.name);
        }
    }
    Ok(())
}

/// The functions that a function names.
fn calls(function: &LocalFunction) -> impl Iterator<Item = FunctionId> {
    struct Calls(HashSet<FunctionId>);
    impl Visitor<'_> for Calls {
        fn visit_function_id(&mut self, &id: &FunctionId) {
            self.0.insert(id);
        }
    }
    let mut calls = Calls(HashSet::new());
    dfs_in_order(&mut calls, function, function.entry_block());
    calls.0.into_iter()
}

/// The functions of a segment of a table.
fn functions(element: &Element) -> &[FunctionId] {
    match &element.items {
        ElementItems::Functions(functions) => functions,
        ElementItems::Expressions(..) => &[],
    }
}

/// The places of a part's functions in the function table.
struct Slots {
    /// Those that pointers to functions name, and those of `called`.
    all: BTreeMap<u64, usize>,
    /// Of functions that the rest calls: after the end of the table, so nothing is there without
    /// the part.
    called: BTreeMap<usize, u64>,
}

impl Slots {
    /// Finds the places, and makes room in the table of `rest`.
    fn new(rest: &mut Module, moved: &BTreeSet<usize>) -> Result<Slots> {
        let mut all = BTreeMap::new();
        for element in rest.elements.iter() {
            let first = first_slot(element)?;
            for (slot, id) in (first..).zip(functions(element)) {
                if moved.contains(&id.index()) {
                    all.insert(slot, id.index());
                }
            }
        }
        let staying = rest
            .funcs
            .iter_local()
            .filter(|(id, _)| !moved.contains(&id.index()));
        let mut wanted: BTreeSet<_> = staying.flat_map(|(_, function)| calls(function)).collect();
        wanted.extend(rest.exports.iter().filter_map(exported));
        let wanted = wanted
            .into_iter()
            .map(|id| id.index())
            .filter(|index| moved.contains(index));
        let table = function_table(rest)?;
        let table = rest.tables.get_mut(table);
        let called: BTreeMap<_, _> = wanted.zip(table.initial..).collect();
        table.initial += called.len() as u64;
        table.maximum = table.maximum.map(|maximum| maximum.max(table.initial));
        all.extend(called.iter().map(|(&index, &slot)| (slot, index)));
        Ok(Slots { all, called })
    }
}

/// The first slot that a segment fills.
fn first_slot(element: &Element) -> Result<u64> {
    match element.kind {
        ElementKind::Active {
            offset: ConstExpr::Value(Value::I32(first)),
            ..
        } => Ok(first as u64),
        _ => bail!("a segment of the function table has no fixed place"),
    }
}

fn exported(export: &Export) -> Option<FunctionId> {
    match export.item {
        ExportItem::Function(id) => Some(id),
        _ => None,
    }
}

fn function_table(module: &Module) -> Result<TableId> {
    let table = module.tables.main_function_table()?;
    table.context("the module has no function table")
}

/// What a part imports.
enum Imported {
    Function(usize),
    Global(usize),
    Memory,
    Table,
}

/// Makes everything but the functions of `moved` and the `texts` an import of `taken`. Returns what
/// it imports, by the name of the import.
fn keep_only(
    taken: &mut Module,
    moved: &BTreeSet<usize>,
    texts: Vec<Text>,
    slots: &Slots,
    first_name: usize,
) -> Result<Vec<(String, Imported)>> {
    let exports: Vec<_> = taken.exports.iter().map(|export| export.id()).collect();
    exports.into_iter().for_each(|id| taken.exports.delete(id));
    taken.start = None;
    let data: Vec<_> = taken.data.iter().map(|data| data.id()).collect();
    data.into_iter().for_each(|id| taken.data.delete(id));
    let elements: Vec<_> = taken.elements.iter().map(|element| element.id()).collect();
    elements
        .into_iter()
        .for_each(|id| taken.elements.delete(id));

    for memory in taken.memories.iter_mut() {
        memory.data_segments.clear();
        memory.import = Some(taken.imports.add(REST, "", memory.id()));
    }
    for text in texts {
        text.put(taken)?;
    }
    for table in taken.tables.iter_mut() {
        table.elem_segments.clear();
        table.import = Some(taken.imports.add(REST, "", table.id()));
    }
    let globals: Vec<_> = taken.globals.iter().map(|global| global.id()).collect();
    for id in globals {
        let import = taken.imports.add(REST, "", id);
        taken.globals.get_mut(id).kind = GlobalKind::Import(import);
    }
    let mut ids = BTreeMap::new();
    for function in taken.funcs.iter_mut() {
        let (id, ty) = (function.id(), function.ty());
        if moved.contains(&id.index()) {
            ids.insert(id.index(), id);
        } else if matches!(function.kind, FunctionKind::Local(_)) {
            let import = taken.imports.add(REST, "", id);
            function.kind = FunctionKind::Import(ImportedFunction { import, ty });
        }
    }

    let table = function_table(taken)?;
    let size = taken.tables.get_mut(table);
    size.initial += slots.called.len() as u64;
    // The table of the rest may be larger, with slots of other parts.
    size.maximum = None;
    let mut runs: Vec<(u64, Vec<FunctionId>)> = Vec::new();
    for (&slot, index) in &slots.all {
        match runs.last_mut() {
            Some((first, run)) if *first + run.len() as u64 == slot => run.push(ids[index]),
            _ => runs.push((slot, vec![ids[index]])),
        }
    }
    for (first, run) in runs {
        let offset = ConstExpr::Value(Value::I32(first as i32));
        let id = taken.elements.add(
            ElementKind::Active { table, offset },
            ElementItems::Functions(run),
        );
        taken.tables.get_mut(table).elem_segments.insert(id);
    }
    walrus::passes::gc::run(taken);

    let mut imported = Vec::new();
    for (number, import) in (first_name..).zip(taken.imports.iter_mut()) {
        REST.clone_into(&mut import.module);
        import.name = number.to_string();
        let what = match import.kind {
            ImportKind::Function(id) => Imported::Function(id.index()),
            ImportKind::Global(id) => Imported::Global(id.index()),
            ImportKind::Memory(_) => Imported::Memory,
            ImportKind::Table(_) => Imported::Table,
            ImportKind::Tag(_) => bail!("a part cannot import a tag"),
        };
        imported.push((import.name.clone(), what));
    }
    Ok(imported)
}

/// Exports what the part imports, and replaces the functions of `moved` by calls through the
/// table.
fn leave_calls(
    rest: &mut Module,
    moved: &BTreeSet<usize>,
    slots: &Slots,
    imported: &[(String, Imported)],
) -> Result<()> {
    let table = function_table(rest)?;
    let functions: Vec<_> = rest.funcs.iter().map(|function| function.id()).collect();
    let globals: Vec<_> = rest.globals.iter().map(|global| global.id()).collect();
    let function_at = |index| {
        functions
            .iter()
            .copied()
            .find(|id| id.index() == index)
            .context("a function is missing")
    };
    let global_at = |index| {
        globals
            .iter()
            .copied()
            .find(|id| id.index() == index)
            .context("a global is missing")
    };
    for (name, imported) in imported {
        let item: ExportItem = match *imported {
            Imported::Function(index) => function_at(index)?.into(),
            Imported::Global(index) => global_at(index)?.into(),
            Imported::Memory => rest.get_memory_id()?.into(),
            Imported::Table => table.into(),
        };
        rest.exports.add(name, item);
    }
    let nothing = {
        let mut builder = FunctionBuilder::new(&mut rest.types, &[], &[]);
        builder.func_body().unreachable();
        builder.finish(Vec::new(), &mut rest.funcs)
    };
    for element in rest.elements.iter_mut() {
        if let ElementItems::Functions(functions) = &mut element.items {
            for id in functions
                .iter_mut()
                .filter(|id| moved.contains(&id.index()))
            {
                *id = nothing;
            }
        }
    }
    for (&index, &slot) in &slots.called {
        let id = function_at(index)?;
        let ty = rest.funcs.get(id).ty();
        let (params, results) = rest.types.params_results(ty);
        let (params, results) = (params.to_vec(), results.to_vec());
        let arguments: Vec<_> = params.iter().map(|&ty| rest.locals.add(ty)).collect();
        let mut builder = FunctionBuilder::new(&mut rest.types, &params, &results);
        let mut body = builder.func_body();
        for &argument in &arguments {
            body.local_get(argument);
        }
        body.i32_const(slot as i32).call_indirect(ty, table);
        rest.funcs.get_mut(id).kind = FunctionKind::Local(builder.local_func(arguments));
    }
    Ok(())
}

/// Makes the function that returns whether `part` is loaded look for one of its functions in the
/// table.
fn look_for(rest: &mut Module, part: &Part, slots: &Slots) -> Result<()> {
    let Part {
        name, is_loaded, ..
    } = part;
    let table = function_table(rest)?;
    let slot = slots.called.values().next();
    let slot = *slot.with_context(|| format!("nothing calls {name}"))?;
    let mut functions = rest.funcs.iter_mut();
    let found = functions.find(|one| {
        one.name
            .as_deref()
            .is_some_and(|name| name.starts_with(is_loaded))
    });
    let function = found.with_context(|| format!("there is no {is_loaded}"))?;
    let flag = [ValType::I32];
    ensure!(
        rest.types.params_results(function.ty()) == (&[], &flag),
        "{is_loaded} returns no flag"
    );
    let mut builder = FunctionBuilder::new(&mut rest.types, &[], &flag);
    let mut body = builder.func_body();
    body.i32_const(slot as i32)
        .table_get(table)
        .ref_is_null()
        .unop(UnaryOp::I32Eqz);
    function.kind = FunctionKind::Local(builder.local_func(Vec::new()));
    Ok(())
}

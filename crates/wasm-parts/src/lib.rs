//! Makes a wasm module smaller to download: it divides it, and orders its functions.
//!
//! What few visitors need becomes modules of their own, its parts, which a page fetches when it needs
//! them. A part imports memory, function table, globals and functions of the module that it is taken
//! from, the base, and puts its own functions into the table. The base calls them through the
//! table. A part also has texts, which it writes into the memory where cargo linked them. All
//! come from one link, so a part fits its own base and no other: the hash of a build stands in
//! each.

mod glue;
mod order;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet, HashSet};

use anyhow::{Context, Result, bail, ensure};
use walrus::ir::{Value, Visitor, dfs_in_order};
use walrus::{
    ConstExpr, DataKind, Element, ElementItems, ElementKind, Export, ExportItem, FunctionBuilder,
    FunctionId, FunctionKind, GlobalKind, ImportKind, ImportedFunction, LocalFunction, Module,
    ModuleConfig, TableId,
};

pub use glue::{Bound, Files};
use order::order;

/// What a part takes from a module, beside the texts that begin with the line `//part NAME` and end with the line
/// `//end`. Nothing reads them without the part: zeros stand there.
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// The Rust modules whose functions it takes. Functions that only these call move with them.
    pub modules: &'static [&'static str],
}

impl Part {
    /// Whether the function with this symbol, a path or `<path as trait>::method`, is of the part.
    fn has(&self, symbol: &str) -> bool {
        let path = symbol.strip_prefix('<').unwrap_or(symbol);
        self.modules.iter().any(|module| path.starts_with(module))
    }
}

/// The name of the module that a part imports from.
const BASE: &str = "base";

/// A module and a part of it, as bytes.
struct Divided {
    /// The module without the part.
    base: Vec<u8>,
    /// The part.
    taken: Vec<u8>,
}

/// Takes `part` from the module of these bytes.
///
/// # Errors
/// The module is invalid, or has neither a function nor a text of the part.
fn take(bytes: &[u8], part: &Part) -> Result<Divided> {
    let mut base = ModuleConfig::new().parse(bytes)?;
    // A function has the same index in both.
    let mut taken = ModuleConfig::new().parse(bytes)?;
    let moved = moved(&base, part);
    let texts = texts(&mut base, part.name)?;
    ensure!(
        !moved.is_empty() || !texts.is_empty(),
        "neither a function nor a text of {} is found",
        part.name
    );
    let slots = Slots::new(&mut base, &moved)?;
    // Numbers are no names of exports but those for parts.
    let names = base
        .exports
        .iter()
        .filter(|export| export.name.parse::<usize>().is_ok());
    let first_name = names.count();
    let imported = keep_only(&mut taken, &moved, texts, &slots, first_name)?;
    leave_calls(&mut base, &moved, &slots, &imported)?;
    walrus::passes::gc::run(&mut base);
    Ok(Divided {
        base: base.emit_wasm(),
        taken: taken.emit_wasm(),
    })
}

/// The functions of the part, and those that only they call.
fn moved(module: &Module, part: &Part) -> BTreeSet<usize> {
    let is_named = |id: FunctionId| {
        let function = module.funcs.get(id);
        let name = function.name.as_deref().unwrap_or_default();
        matches!(function.kind, FunctionKind::Local(_)) && part.has(name)
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

/// The texts of a part, with their addresses. Zeros take their places.
fn texts(base: &mut Module, part: &str) -> Result<Vec<(i32, Vec<u8>)>> {
    let (begin, end) = (format!("//part {part}\n"), "//end\n");
    let find = |bytes: &[u8], text: &str| {
        let mut places = bytes.windows(text.len());
        places.position(|window| window == text.as_bytes())
    };
    let mut found = Vec::new();
    let segments: Vec<_> = base.data.iter().map(|segment| segment.id()).collect();
    for id in segments {
        let segment = base.data.get_mut(id);
        let mut from = 0;
        while let Some(start) = find(&segment.value[from..], &begin).map(|at| from + at) {
            let length = find(&segment.value[start..], end).context("a text has no end")?;
            from = start + length + end.len();
            let text = segment.value[start..from].to_vec();
            segment.value[start..from].fill(0);
            let DataKind::Active {
                offset: ConstExpr::Value(Value::I32(first)),
                ..
            } = segment.kind
            else {
                bail!("a segment of the memory has no fixed place");
            };
            found.push((first + start as i32, text));
        }
    }
    Ok(found)
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
    /// Of functions that the base calls: after the end of the table, so nothing is there without
    /// the part.
    called: BTreeMap<usize, u64>,
}

impl Slots {
    /// Finds the places, and makes room in the table of `base`.
    fn new(base: &mut Module, moved: &BTreeSet<usize>) -> Result<Slots> {
        let mut all = BTreeMap::new();
        for element in base.elements.iter() {
            let first = first_slot(element)?;
            for (slot, id) in (first..).zip(functions(element)) {
                if moved.contains(&id.index()) {
                    all.insert(slot, id.index());
                }
            }
        }
        let staying = base
            .funcs
            .iter_local()
            .filter(|(id, _)| !moved.contains(&id.index()));
        let mut wanted: BTreeSet<_> = staying.flat_map(|(_, function)| calls(function)).collect();
        wanted.extend(base.exports.iter().filter_map(exported));
        let wanted = wanted
            .into_iter()
            .map(|id| id.index())
            .filter(|index| moved.contains(index));
        let table = function_table(base)?;
        let table = base.tables.get_mut(table);
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

/// Makes everything but the functions of `moved` and the texts an import of `taken`. Returns what it imports, by the
/// name of the import.
fn keep_only(
    taken: &mut Module,
    moved: &BTreeSet<usize>,
    texts: Vec<(i32, Vec<u8>)>,
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
        memory.import = Some(taken.imports.add(BASE, "", memory.id()));
    }
    let memory = taken.get_memory_id()?;
    for (address, text) in texts {
        let offset = ConstExpr::Value(Value::I32(address));
        let id = taken.data.add(DataKind::Active { memory, offset }, text);
        taken.memories.get_mut(memory).data_segments.insert(id);
    }
    for table in taken.tables.iter_mut() {
        table.elem_segments.clear();
        table.import = Some(taken.imports.add(BASE, "", table.id()));
    }
    let globals: Vec<_> = taken.globals.iter().map(|global| global.id()).collect();
    for id in globals {
        let import = taken.imports.add(BASE, "", id);
        taken.globals.get_mut(id).kind = GlobalKind::Import(import);
    }
    let mut ids = BTreeMap::new();
    for function in taken.funcs.iter_mut() {
        let (id, ty) = (function.id(), function.ty());
        if moved.contains(&id.index()) {
            ids.insert(id.index(), id);
        } else if matches!(function.kind, FunctionKind::Local(_)) {
            let import = taken.imports.add(BASE, "", id);
            function.kind = FunctionKind::Import(ImportedFunction { import, ty });
        }
    }

    let table = function_table(taken)?;
    let size = taken.tables.get_mut(table);
    size.initial += slots.called.len() as u64;
    // The table of the base may be larger, with slots of other parts.
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
        BASE.clone_into(&mut import.module);
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
    base: &mut Module,
    moved: &BTreeSet<usize>,
    slots: &Slots,
    imported: &[(String, Imported)],
) -> Result<()> {
    let table = function_table(base)?;
    let functions: Vec<_> = base.funcs.iter().map(|function| function.id()).collect();
    let globals: Vec<_> = base.globals.iter().map(|global| global.id()).collect();
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
            Imported::Memory => base.get_memory_id()?.into(),
            Imported::Table => table.into(),
        };
        base.exports.add(name, item);
    }
    let nothing = {
        let mut builder = FunctionBuilder::new(&mut base.types, &[], &[]);
        builder.func_body().unreachable();
        builder.finish(Vec::new(), &mut base.funcs)
    };
    for element in base.elements.iter_mut() {
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
        let ty = base.funcs.get(id).ty();
        let (params, results) = base.types.params_results(ty);
        let (params, results) = (params.to_vec(), results.to_vec());
        let arguments: Vec<_> = params.iter().map(|&ty| base.locals.add(ty)).collect();
        let mut builder = FunctionBuilder::new(&mut base.types, &params, &results);
        let mut body = builder.func_body();
        for &argument in &arguments {
            body.local_get(argument);
        }
        body.i32_const(slot as i32).call_indirect(ty, table);
        base.funcs.get_mut(id).kind = FunctionKind::Local(builder.local_func(arguments));
    }
    Ok(())
}

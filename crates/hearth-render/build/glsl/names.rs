//! Short names of declarations.

use std::collections::{BTreeMap, BTreeSet};

use super::Program;
use super::items::{is_member, is_of_glsl, locals, structs};
use super::pack::ARRAY;
use super::tokens::Token;

/// Shortens all declared names. Variables get lower-case names per function. Other declarations
/// get the same upper-case name in all programs, with the shortest for the most frequent. Repeated
/// text compresses well.
pub fn shorten(programs: &mut [Program]) {
    let fields: BTreeSet<String> = programs.iter().flat_map(struct_fields).collect();
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for program in programs.iter() {
        each_global(program, &fields, |name| {
            *counts.entry(name.to_owned()).or_default() += 1;
        });
    }
    let mut order: Vec<_> = counts.into_iter().collect();
    order.sort_by(|(a, often), (b, seldom)| seldom.cmp(often).then(a.cmp(b)));
    let long = order.into_iter().map(|(name, _)| name);
    let globals: BTreeMap<String, String> = long.zip(candidates('A'..='Z')).collect();
    for program in programs {
        for stage in &mut program.stages {
            let all = stage.items.clone();
            let structs = structs(all.iter().map(Vec::as_slice));
            for (long, item) in all.iter().zip(&mut stage.items) {
                let locals = locals(long, &structs);
                let mut names = BTreeMap::new();
                let mut free = candidates('a'..='z');
                for local in locals {
                    names
                        .entry(local)
                        .or_insert_with(|| free.next().unwrap_or_default());
                }
                for (at, token) in item.iter_mut().enumerate() {
                    let Token::Word(word) = token else { continue };
                    let is_member = is_member(long, at);
                    let local = names.get(word.as_str()).filter(|_| !is_member);
                    let global = globals.get(word.as_str());
                    let global = global.filter(|_| !is_member || fields.contains(word));
                    if let Some(short) = local.or(global) {
                        word.clone_from(short);
                    }
                }
            }
        }
        for (long, text) in &mut program.samplers {
            if let Some(short) = globals.get(long) {
                text.clone_from(short);
            }
        }
    }
}

/// Calls `visit` with each use of a name that is neither built in nor a variable of a function.
fn each_global(program: &Program, fields: &BTreeSet<String>, mut visit: impl FnMut(&str)) {
    for stage in &program.stages {
        let structs = structs(stage.items.iter().map(Vec::as_slice));
        for item in &stage.items {
            let locals = locals(item, &structs);
            for (at, word) in item.iter().enumerate() {
                let Some(word) = word.word() else { continue };
                let is_global = if is_member(item, at) {
                    fields.contains(word)
                } else {
                    !is_of_glsl(word) && word != ARRAY && !locals.contains(&word)
                };
                if is_global {
                    visit(word);
                }
            }
        }
    }
}

/// The fields of the structs of a program.
fn struct_fields(program: &Program) -> Vec<String> {
    let items = program.stages.iter().flat_map(|stage| &stage.items);
    let structs = items.filter(|item| item[0].word() == Some("struct"));
    let pairs = structs.flat_map(|item| item.windows(2));
    let names = pairs.filter(|pair| pair[1].is(";"));
    names
        .filter_map(|pair| pair[0].word().map(str::to_owned))
        .collect()
}

/// All names of one and then of two of these letters that GLSL does not reserve.
fn candidates(letters: std::ops::RangeInclusive<char>) -> impl Iterator<Item = String> {
    let (first, second) = (letters.clone(), letters.clone());
    let two = first.flat_map(move |a| second.clone().map(move |b| format!("{a}{b}")));
    let all = letters.map(String::from).chain(two);
    all.filter(|name| !is_of_glsl(name) && name != ARRAY)
}

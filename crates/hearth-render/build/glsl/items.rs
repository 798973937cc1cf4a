//! Declarations of a stage: constants, uniforms, varyings, structs, functions.

use std::collections::BTreeMap;

use super::files::Piece;
use super::tokens::{self, Token};

/// A global declaration.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Name of the file.
    pub file: String,
    /// Kind.
    pub kind: Kind,
    /// Declared name.
    pub name: String,
    /// All tokens.
    pub tokens: Vec<Token>,
    /// Comment on the line.
    pub comment: String,
}

/// Kinds of declarations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A uniform of that type.
    Uniform(String),
    /// A varying or an output.
    Stage,
    /// `const`.
    Constant,
    /// A struct or a function.
    Other,
    /// A constant that was replaced by its value.
    Inlined,
}

/// Built-in types.
pub const TYPES: [&str; 15] = [
    "void",
    "bool",
    "int",
    "uint",
    "float",
    "vec2",
    "vec3",
    "vec4",
    "ivec2",
    "ivec3",
    "ivec4",
    "mat2",
    "mat3",
    "mat4",
    "sampler2D",
];
const KEYWORDS: [&str; 16] = [
    "const", "uniform", "in", "out", "inout", "flat", "struct", "if", "else", "for", "while",
    "return", "discard", "true", "false", "break",
];
const BUILT_IN: [&str; 48] = [
    "abs",
    "any",
    "all",
    "acos",
    "atan",
    "ceil",
    "clamp",
    "cos",
    "cross",
    "dFdx",
    "dFdy",
    "distance",
    "dot",
    "equal",
    "exp",
    "exp2",
    "floor",
    "fract",
    "fwidth",
    "greaterThan",
    "inversesqrt",
    "length",
    "lessThan",
    "log",
    "log2",
    "max",
    "min",
    "mix",
    "mod",
    "normalize",
    "not",
    "pow",
    "reflect",
    "round",
    "sign",
    "sin",
    "smoothstep",
    "sqrt",
    "step",
    "tan",
    "texelFetch",
    "texture",
    "textureLod",
    "textureSize",
    "transpose",
    "trunc",
    "main",
    "do",
];

/// Whether GLSL reserves a word.
pub fn is_of_glsl(word: &str) -> bool {
    word.starts_with("gl_")
        || [&TYPES[..], &KEYWORDS, &BUILT_IN]
            .iter()
            .any(|words| words.contains(&word))
}

/// The declarations of a stage.
///
/// # Errors
/// Source that is no declaration, with its file.
pub fn parse(pieces: Vec<Piece<'_>>) -> Result<Vec<Item>, String> {
    let mut items = Vec::new();
    for Piece { file, lines } in pieces {
        let mut pending = Vec::new();
        for line in lines {
            tokens::read(line, &mut pending).map_err(|error| format!("{file}: {error}"))?;
            // A comment belongs to the declaration on its line.
            let comment = line.split_once("//").map_or("", |(_, comment)| comment);
            while let Some(length) = complete(&pending) {
                let rest = pending.split_off(length);
                let tokens = std::mem::replace(&mut pending, rest);
                let item = item(file, tokens, comment.trim());
                items.push(item.map_err(|error| format!("{file}: {error}"))?);
            }
        }
        if !pending.is_empty() {
            return Err(format!("{file} ends in the middle of a declaration"));
        }
    }
    Ok(items)
}

/// Length of the first declaration, once it is complete.
fn complete(tokens: &[Token]) -> Option<usize> {
    let is_struct = tokens.first()?.word() == Some("struct");
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate() {
        depth += i32::from(token.is("{")) - i32::from(token.is("}"));
        let ends = token.is(";") || token.is("}") && !is_struct;
        if depth == 0 && ends {
            return Some(at + 1);
        }
    }
    None
}

fn item(file: &str, tokens: Vec<Token>, comment: &str) -> Result<Item, String> {
    let word = |at: usize| tokens.get(at).and_then(Token::word).unwrap_or_default();
    let (kind, name) = match word(0) {
        "uniform" => (Kind::Uniform(word(1).to_owned()), word(2)),
        "const" => (Kind::Constant, word(2)),
        "flat" => (Kind::Stage, word(3)),
        "in" | "out" => (Kind::Stage, word(2)),
        _ => (Kind::Other, word(1)),
    };
    if name.is_empty() {
        return Err(format!("no declaration: {}", tokens::text(&tokens)));
    }
    Ok(Item {
        file: file.to_owned(),
        kind,
        name: name.to_owned(),
        comment: comment.to_owned(),
        tokens,
    })
}

/// Names of the structs among some declarations.
pub fn structs<'a>(items: impl Iterator<Item = &'a [Token]>) -> Vec<&'a str> {
    let structs = items.filter(|tokens| tokens[0].word() == Some("struct"));
    structs.filter_map(|tokens| tokens[1].word()).collect()
}

/// Names after a type in a declaration, including variables.
pub fn declared<'a>(tokens: &'a [Token], structs: &[&str]) -> Vec<&'a str> {
    let pairs = tokens.windows(2).filter_map(|pair| {
        let (first, second) = (pair[0].word()?, pair[1].word()?);
        let is_type = first == "struct" || TYPES.contains(&first) || structs.contains(&first);
        is_type.then_some(second)
    });
    pairs.collect()
}

/// The parameters and variables of a function; empty for other declarations.
pub fn locals<'a>(tokens: &'a [Token], structs: &[&str]) -> Vec<&'a str> {
    match tokens.get(2) {
        Some(bracket) if bracket.is("(") => declared(&tokens[2..], structs),
        _ => Vec::new(),
    }
}

/// Whether a word follows a point.
pub fn is_member(tokens: &[Token], at: usize) -> bool {
    at > 0 && tokens[at - 1].is(".")
}

/// Checks that names are declared once and before use.
///
/// # Errors
/// A name is undeclared or declared twice, or a variable has the name of a declaration.
pub fn check_names(items: &[Item], shared: &[(&str, String)]) -> Result<(), String> {
    let structs = structs(items.iter().map(|item| item.tokens.as_slice()));
    for (at, item) in items.iter().enumerate() {
        let is_named = |name: &str, items: &[Item]| items.iter().any(|item| item.name == name);
        if is_named(&item.name, &items[..at]) {
            return Err(format!("{} is declared twice", item.name));
        }
        let inside = declared(&item.tokens, &structs);
        for local in locals(&item.tokens, &structs) {
            if is_named(local, items) {
                return Err(format!("{local} is global and a variable of {}", item.name));
            }
        }
        for (at, token) in item.tokens.iter().enumerate() {
            let Some(word) = token.word() else { continue };
            if !is_member(&item.tokens, at)
                && !is_of_glsl(word)
                && !inside.contains(&word)
                && !is_named(word, items)
                && !shared.iter().any(|(name, _)| *name == word)
            {
                return Err(format!("{word} is used and not declared"));
            }
        }
    }
    Ok(())
}

/// Which declarations `main` needs directly or indirectly. Varyings count as used, because the
/// other stage declares them too.
pub fn used(items: &[Item]) -> Vec<bool> {
    let mut used: Vec<bool> = items
        .iter()
        .map(|item| item.name == "main" || item.kind == Kind::Stage)
        .collect();
    loop {
        let needed: Vec<&str> = items
            .iter()
            .zip(&used)
            .filter(|(_, used)| **used)
            .flat_map(|(item, _)| item.tokens.iter().filter_map(Token::word))
            .collect();
        let now: Vec<bool> = items
            .iter()
            .zip(&used)
            .map(|(item, used)| *used || needed.contains(&item.name.as_str()))
            .collect();
        if now == used {
            return now;
        }
        used = now;
    }
}

/// The samplers in the order of their declarations, vertex stage first.
pub fn samplers<'a>(items: impl Iterator<Item = &'a Item>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for item in items {
        if item.kind == Kind::Uniform("sampler2D".to_owned()) && !names.contains(&item.name) {
            names.push(item.name.clone());
        }
    }
    names
}

/// Inlines the shared constants and the `const` declarations.
pub fn inline(items: &mut [Item], shared: &[(&str, String)]) {
    let shared = shared.iter().map(|(name, value)| {
        let mut tokens = Vec::new();
        // The values are valid numbers.
        let _ = tokens::read(value, &mut tokens);
        ((*name).to_owned(), parenthesised(tokens))
    });
    let mut values: BTreeMap<String, Vec<Token>> = shared.collect();
    for item in items.iter_mut() {
        let mut tokens = Vec::with_capacity(item.tokens.len());
        let mut at = 0;
        while at < item.tokens.len() {
            let rest = &item.tokens[at..];
            if rest[0].word() == Some("const")
                && let Some(end) = rest.iter().position(|token| token.is(";"))
                && let [_, _, Token::Word(name), equals, value @ ..] = &rest[..end]
                && equals.is("=")
            {
                let value = value.iter().flat_map(|token| replaced(token, &values));
                let value = parenthesised(value.collect());
                values.insert(name.clone(), value);
                at += end + 1;
                continue;
            }
            if is_member(&item.tokens, at) {
                tokens.push(rest[0].clone());
            } else {
                tokens.extend(replaced(&rest[0], &values));
            }
            at += 1;
        }
        item.tokens = tokens;
        if item.tokens.is_empty() {
            item.kind = Kind::Inlined;
        }
    }
}

fn replaced(token: &Token, values: &BTreeMap<String, Vec<Token>>) -> Vec<Token> {
    let value = token.word().and_then(|word| values.get(word));
    value.cloned().unwrap_or_else(|| vec![token.clone()])
}

/// Parenthesises tokens unless they are one token or one call.
fn parenthesised(tokens: Vec<Token>) -> Vec<Token> {
    let is_call = tokens.len() > 1
        && tokens[0].word().is_some()
        && tokens[1].is("(")
        && tokens.iter().position(|token| token.is(")")) == Some(tokens.len() - 1);
    if tokens.len() == 1 || is_call {
        return tokens;
    }
    let mut all = vec![Token::Mark("(")];
    all.extend(tokens);
    all.push(Token::Mark(")"));
    all
}

//! Packs uniforms into one array of `vec4`.

use super::items::{Item, Kind};
use super::tokens::Token;

/// Name of the array in every stage.
pub const ARRAY: &str = "U";
const COMPONENTS: [&str; 3] = ["xyzw", "rgba", "stpq"];

/// A number, a vector or an array of `vec4`.
#[derive(Clone, Debug, PartialEq)]
pub struct Uniform {
    /// Name.
    pub name: String,
    /// Number of components.
    pub size: usize,
    /// Index of the first component in the array.
    pub at: usize,
    /// Comment in the shader.
    pub comment: String,
}

/// Packs the uniforms of both stages, largest first, so that none spans two vectors.
///
/// # Errors
/// A type that cannot be packed, or two types of one name.
pub fn uniforms<'a>(items: impl Iterator<Item = &'a Item>) -> Result<Vec<Uniform>, String> {
    let mut uniforms: Vec<Uniform> = Vec::new();
    for item in items {
        let Kind::Uniform(kind) = &item.kind else {
            continue;
        };
        let size = match kind.as_str() {
            "sampler2D" => continue,
            "float" => 1,
            "vec2" => 2,
            "vec3" => 3,
            "vec4" if item.tokens.get(3).is_some_and(|token| token.is("[")) => 4 * length(item)?,
            "vec4" => 4,
            other => return Err(format!("{}: a uniform cannot be a {other}", item.file)),
        };
        match uniforms.iter().find(|known| known.name == item.name) {
            Some(known) if known.size != size => {
                return Err(format!("{}: {} is of two types", item.file, item.name));
            }
            Some(_) => {}
            None => uniforms.push(Uniform {
                name: item.name.clone(),
                size,
                at: 0,
                comment: item.comment.clone(),
            }),
        }
    }
    let mut free = Vec::new();
    for uniform in uniforms.iter_mut().filter(|uniform| uniform.size > 4) {
        uniform.at = 4 * free.len();
        free.resize(free.len() + uniform.size / 4, 0);
    }
    for size in [4, 3, 2, 1] {
        for uniform in uniforms.iter_mut().filter(|uniform| uniform.size == size) {
            let vector = free.iter().position(|free| *free >= size);
            let vector = vector.unwrap_or_else(|| {
                free.push(4);
                free.len() - 1
            });
            uniform.at = 4 * vector + 4 - free[vector];
            free[vector] -= size;
        }
    }
    Ok(uniforms)
}

/// Length of a uniform that is an array.
fn length(item: &Item) -> Result<usize, String> {
    match item.tokens.get(4) {
        Some(Token::Number(number)) => number
            .parse()
            .map_err(|_| format!("{}: {number} is no length", item.file)),
        _ => Err(format!("{}: {} has no length", item.file, item.name)),
    }
}

/// Length of the array of all.
pub fn vectors(uniforms: &[Uniform]) -> usize {
    let ends = uniforms.iter().map(|uniform| uniform.at + uniform.size);
    ends.max().unwrap_or(0).div_ceil(4)
}

/// Replaces uniforms by components of the array.
///
/// # Errors
/// A uniform does not have a used component.
pub fn apply(items: &mut Vec<Item>, uniforms: &[Uniform], vectors: usize) -> Result<(), String> {
    let before = items.len();
    items.retain(|item| !uniforms.iter().any(|uniform| uniform.name == item.name));
    let reads = items.len() < before;
    for item in items.iter_mut() {
        item.tokens =
            applied(&item.tokens, uniforms).map_err(|error| format!("{}: {error}", item.file))?;
    }
    if reads {
        let mut tokens = Vec::new();
        super::tokens::read(&format!("uniform vec4 {ARRAY}[{vectors}];"), &mut tokens)?;
        let array = Item {
            file: String::new(),
            kind: Kind::Uniform("vec4".to_owned()),
            name: ARRAY.to_owned(),
            tokens,
            comment: String::new(),
        };
        items.insert(0, array);
    }
    Ok(())
}

fn applied(tokens: &[Token], uniforms: &[Uniform]) -> Result<Vec<Token>, String> {
    let mut packed = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let token = &tokens[at];
        let is_member = super::items::is_member(tokens, at);
        let uniform = uniforms
            .iter()
            .find(|uniform| !is_member && token.word() == Some(uniform.name.as_str()));
        let Some(uniform) = uniform else {
            packed.push(token.clone());
            at += 1;
            continue;
        };
        let name = &uniform.name;
        at += 1;
        packed.extend([
            Token::Word(ARRAY.to_owned()),
            Token::Mark("["),
            Token::Number((uniform.at / 4).to_string()),
        ]);
        if uniform.size > 4 {
            if !tokens.get(at).is_some_and(|token| token.is("[")) {
                return Err(format!("{name} is an array without an index"));
            }
            at += 1;
            packed.push(Token::Mark("+"));
            continue;
        }
        packed.push(Token::Mark("]"));
        let mut components: Vec<usize> = (0..uniform.size).collect();
        if let [point, Token::Word(swizzle), ..] = &tokens[at..]
            && point.is(".")
        {
            components = swizzled(swizzle, uniform.size).ok_or_else(|| {
                format!("{name}.{swizzle}: {name} has {} components", uniform.size)
            })?;
            at += 2;
        }
        let first = uniform.at % 4;
        if components != [0, 1, 2, 3] {
            let letters = components
                .iter()
                .filter_map(|component| COMPONENTS[0].chars().nth(first + component));
            packed.extend([Token::Mark("."), Token::Word(letters.collect())]);
        }
    }
    Ok(packed)
}

/// The components of a swizzle of a vector; `None` if the vector lacks one, and for a number.
fn swizzled(swizzle: &str, size: usize) -> Option<Vec<usize>> {
    let letters = COMPONENTS
        .iter()
        .find(|letters| swizzle.starts_with(|first| letters.contains(first)))?;
    swizzle
        .chars()
        .map(|letter| letters.find(letter).filter(|at| size > 1 && *at < size))
        .collect()
}

//! The texts of a part, in the memory of the module that it is taken from.

use std::cmp::Reverse;

use anyhow::{Result, ensure};
use walrus::ir::Value;
use walrus::{ConstExpr, DataKind, Module};

/// A text, and its place in the memory.
#[derive(Debug, PartialEq)]
pub(crate) struct Text {
    text: &'static str,
    place: i32,
}

/// Takes these texts from the data of a module, and leaves zeros in their places. Fails where a text
/// is missing or there twice.
pub(crate) fn take(module: &mut Module, mut texts: Vec<&'static str>) -> Result<Vec<Text>> {
    texts.retain(|text| !text.is_empty());
    // A text may be a piece of a longer one.
    texts.sort_by_key(|text| Reverse(text.len()));
    let segments: Vec<_> = module.data.iter().map(|data| data.id()).collect();
    let mut taken = Vec::new();
    for text in texts {
        let before = taken.len();
        for &segment in &segments {
            let data = module.data.get_mut(segment);
            let DataKind::Active {
                offset: ConstExpr::Value(Value::I32(start)),
                ..
            } = data.kind
            else {
                continue;
            };
            let length = text.len();
            let is_here = |&at: &usize| &data.value[at..at + length] == text.as_bytes();
            let last = (data.value.len() + 1).saturating_sub(length);
            let found: Vec<_> = (0..last).filter(is_here).collect();
            for at in found {
                data.value[at..at + length].fill(0);
                let place = start + at as i32;
                taken.push(Text { text, place });
            }
        }
        let found = taken.len() - before;
        ensure!(found == 1, "{found} places have the text {text:?}");
    }
    Ok(taken)
}

impl Text {
    /// Puts it into the memory of a module.
    pub(crate) fn put(&self, module: &mut Module) -> Result<()> {
        let memory = module.get_memory_id()?;
        let offset = ConstExpr::Value(Value::I32(self.place));
        let kind = DataKind::Active { memory, offset };
        let data = module.data.add(kind, self.text.into());
        let memory = module.memories.get_mut(memory);
        memory.data_segments.insert(data);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A module with this text at the place 100.
    fn module(text: &'static str) -> Result<Module> {
        let mut module = Module::default();
        module.memories.add_local(false, false, 1, None, None);
        Text { text, place: 100 }.put(&mut module)?;
        Ok(module)
    }

    #[test]
    fn texts_leave_zeros_and_keep_their_places() -> Result<()> {
        let mut module = module("burn, burning")?;
        let taken = take(&mut module, vec!["", "burn", "burning"])?;
        let moved = [("burning", 106), ("burn", 100)];
        assert_eq!(taken, moved.map(|(text, place)| Text { text, place }));
        let left: Vec<_> = module.data.iter().map(|data| &data.value[..]).collect();
        assert_eq!(left, [b"\0\0\0\0, \0\0\0\0\0\0\0"]);
        Ok(())
    }

    #[test]
    fn a_text_that_is_not_there_once_is_an_error() -> Result<()> {
        for text in ["ice", "fi", "fire, fire, fire"] {
            assert!(take(&mut module("fire, fire")?, vec![text]).is_err());
        }
        Ok(())
    }
}

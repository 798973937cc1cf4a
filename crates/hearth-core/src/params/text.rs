//! Small code to take texts apart.

/// A text without the blanks around it. The standard library's function knows blanks of every
/// alphabet, for half a kilobyte of download.
#[inline(never)]
pub(super) fn trimmed(text: &str) -> &str {
    text.trim_ascii()
}

/// The texts before and after the first of these ASCII characters, without it. The standard
/// library's function searches for any character, for a third of a kilobyte of download.
#[inline(never)]
pub(crate) fn split_once<'a>(text: &'a str, at: &[u8]) -> Option<(&'a str, &'a str)> {
    let length = text.bytes().position(|byte| at.contains(&byte))?;
    Some((text.get(..length)?, text.get(length + 1..)?))
}

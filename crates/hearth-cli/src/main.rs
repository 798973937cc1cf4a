//! The command `hearth`.

fn main() {}

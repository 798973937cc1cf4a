//! The command `hearth` as a process: files, standard streams, exit codes.

// `expect` is allowed in what only tests compile.
#![cfg(test)]

mod bench;
mod film;
mod harness;
mod render;
mod scene_files;
mod sheet;
mod sprites;
mod streams;
mod tres;
mod without_driver;

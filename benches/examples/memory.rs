//! The memory of a fire: `memory N` prints
//! `Hearth,where=native,N=…,bytes=…` for a block of N particles.
//!
//! `unsafe` is needed to count allocations in an allocator, which passes every call to the
//! system's.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::env;
use std::sync::atomic::{AtomicUsize, Ordering};

use hearth_benches::scenes;

struct Counting;

/// Bytes that are allocated now.
static HELD: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is passed on unchanged to the system's allocator, which
// keeps the contract; counting touches no memory of the caller's.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        HELD.fetch_add(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's contract about `layout` is passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: `pointer` came from `alloc` above, so from the system.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn main() -> Result<(), String> {
    let count = env::args().nth(1).and_then(|text| text.parse().ok());
    let count: u32 = count.ok_or("usage: memory N")?;
    let before = HELD.load(Ordering::Relaxed);
    let mut fire = scenes::block(count, scenes::NEIGHBOURS)?;
    for _ in 0..10 {
        fire.step();
    }
    let held = HELD.load(Ordering::Relaxed) - before;
    println!("Hearth,where=native,N={},bytes={held}", fire.count());
    Ok(())
}

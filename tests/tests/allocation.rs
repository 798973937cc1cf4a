//! A warm fire allocates nothing: neither a step nor the copy for the renderer.
//!
//! `unsafe` stands here because counting allocations means being the allocator;
//! every call goes straight on to the system's. The file holds one test, since
//! the count is the whole process's.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use hearth_core::{Parameters, Simulation};

struct Counting;

static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is passed on unchanged to the system's allocator, which
// keeps the contract; counting touches no memory of the caller's.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller's promise about `layout` is passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: `pointer` came from `alloc` above, so from the system.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_warm_fire_allocates_nothing() {
    let mut fire = Simulation::new(Parameters::default());
    let mut instances = Vec::new();
    let mut burn = |steps: u32| {
        for _ in 0..steps {
            fire.step();
            fire.write_instances(&mut instances);
        }
    };
    burn(2400);
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    burn(2400);
    let after = ALLOCATIONS.load(Ordering::Relaxed);
    assert!(before > 0, "the count does not count");
    assert_eq!(after - before, 0);
}

//! A warm fire allocates nothing: neither a step nor the copies for the renderer. A list whose length is that
//! of a chaotic flow may still grow once.
//!
//! `unsafe` is needed to count allocations in an allocator, which passes every call to the
//! system's. The count is that of the thread.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use hearth_core::params::{Input, Model};
use hearth_core::{Scene, Simulation, Vec2};
use hearth_tests::fires::{beside_outlines, everything, in_the_open, on_floor, set_in_model};
use hearth_tests::on_all_cores;

struct Counting;

thread_local! {
    /// Allocations of this thread: the harness allocates in its own, for instance for the message that a
    /// test takes long.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call is passed on unchanged to the system's allocator, which
// keeps the contract; counting touches no memory of the caller's.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // A thread that ends has no count any more.
        let _ = ALLOCATIONS.try_with(|count| count.set(count.get() + 1));
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

/// How often a fire allocates while it is cold, and then while it is warm.
fn allocations(scene: Scene, steps: u32) -> (usize, usize) {
    let start = ALLOCATIONS.get();
    let mut fire = Simulation::new(scene);
    let (mut instances, mut embers) = (Vec::new(), Vec::new());
    let mut burn = || {
        for _ in 0..steps {
            fire.step();
            fire.write_instances(&mut instances);
            fire.write_embers(&mut embers);
        }
    };
    // A list keeps the greatest length that it had, and grows by half where it has to.
    burn();
    burn();
    let warm = ALLOCATIONS.get();
    burn();
    (warm - start, ALLOCATIONS.get() - warm)
}

#[test]
fn a_warm_fire_allocates_nothing() {
    let open = on_floor(in_the_open(everything(), 1500));
    let mut beside = beside_outlines(open.clone());
    let swaying = [("kind", "solid"), ("motion", "sway")].map(|(id, text)| (id, Input::Text(text)));
    assert!(beside.add(&swaying).is_ok());
    let fires = [Scene::of_model(Model::Classic), everything(), open];
    let mut falling = on_floor(in_the_open(everything(), 1500));
    for height in [0.1, 0.25, 0.4, 2.0] {
        let free = [("kind", "solid"), ("motion", "free"), ("shape", "box")];
        let free = free.map(|(id, text)| (id, Input::Text(text)));
        let place = ("y", Input::Number(height));
        assert!(falling.add(&[&free[..], &[place]].concat()).is_ok());
    }
    let scenes = fires.into_iter().chain([beside, falling]);
    // Briefly where each picture takes as long as a step.
    let modes = [("fire", 800), ("vorticity", 300)];
    let cases = scenes.flat_map(|scene| modes.map(|mode| (scene.clone(), mode)));
    on_all_cores(cases.collect(), |(mut scene, (mode, steps))| {
        assert_eq!(scene.set("display_mode", mode), Ok(()));
        // As many embers at any time: the copies grow to the most that there were.
        let life = f64::from(scene.world().ember_life_max);
        set_in_model(&mut scene, "ember_life_min", life);
        let model = scene.model();
        let solids = scene.solids().count();
        let (cold, warm) = allocations(scene, steps);
        assert!(cold > 0, "the count does not count");
        // Anything that allocates in some of the steps does so hundreds of times.
        assert!(warm <= 1, "{warm}: {model:?}, {mode}, {solids} solids");
    });
}

#[test]
fn a_warm_spray_allocates_nothing() {
    let mut fire = Simulation::new(on_floor(in_the_open(everything(), 1500)));
    let mut embers = Vec::with_capacity(10_000);
    let mut burn = || {
        for step in 0..300 {
            if step % 10 == 0 {
                let place = Vec2::new(0.0, 1.0);
                assert_eq!(fire.spray(place, Vec2::new(0.0, -2.0), 0.005), Ok(()));
            }
            fire.step();
            fire.write_embers(&mut embers);
        }
    };
    // A list keeps the greatest length that it had, and grows by half where it has to.
    burn();
    burn();
    let warm = ALLOCATIONS.get();
    burn();
    assert_eq!(ALLOCATIONS.get() - warm, 0);
}

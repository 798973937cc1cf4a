//! What a step costs natively, with neighbours beside every figure.
//!
//! `cargo bench -p hearth-benches`

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use hearth_benches::Scene;

fn fires(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("fire");
    let presets = ["default", "classic", "seed"].map(|name| (name, Scene::preset(name)));
    for (name, scene) in presets {
        if let Some(scene) = scene {
            measure(&mut group, name, scene);
        }
    }
    measure(&mut group, "fine", Scene::fine());
    measure(&mut group, "bonfire", Scene::bonfire());
}

fn blocks(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("block");
    for count in [1_000, 5_000, 20_000, 50_000] {
        measure(&mut group, &count.to_string(), Scene::block(count));
    }
}

fn measure(
    group: &mut criterion::BenchmarkGroup<'_, criterion::measurement::WallTime>,
    name: &str,
    scene: Scene,
) {
    println!(
        "{name}: {} particles, {:.1} neighbours, {} substeps",
        scene.particles(),
        scene.neighbours(),
        scene.substeps()
    );
    group
        .sample_size(20)
        .throughput(Throughput::Elements(u64::from(scene.particles())))
        .bench_function(BenchmarkId::from_parameter(name), |bencher| {
            // Each measured step starts from the same state: a block without
            // gravity would drift apart in the thousands of steps of a run.
            bencher.iter_batched_ref(
                || scene.clone(),
                |scene| scene.step(1),
                BatchSize::LargeInput,
            );
        });
}

criterion_group!(benches, fires, blocks);
criterion_main!(benches);

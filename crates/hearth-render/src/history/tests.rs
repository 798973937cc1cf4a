use super::*;
use crate::bounds::Bounds;
use crate::bounds::tests::particle;
use hearth_core::params::Input;

/// A fire of the combustion model with these values, and some gas above its source.
fn fire(values: &[(&str, f64)]) -> Scene {
    let mut scene = Scene::of_model(Model::Combustion);
    for (id, value) in [("source_x", 0.0), ("source_width", 0.3)]
        .iter()
        .chain(values)
    {
        assert_eq!(scene.set(id, *value), Ok(()));
    }
    scene
}

/// Records a fire from one time to another, 100 times a second.
fn burn(history: &mut History, scene: &Scene, from: f64, to: f64) {
    let particles = [particle(0.1, 0.5, 1.0), particle(0.5, 0.5, 1.0)];
    for step in (from * 100.0) as u32..=(to * 100.0) as u32 {
        let time = f64::from(step) / 100.0;
        if history.is_due(time) {
            let poses = scene.poses(time);
            history.record(&Moment {
                time,
                scene,
                poses: &poses,
                particles: &particles,
            });
        }
    }
}

fn visible(history: &History, scene: &Scene, time: f64) -> Vec<usize> {
    let source = SourcePlace::first(scene, &[]);
    let slices = history.slices(time, 5.0, &source);
    slices.iter().map(|slice| slice.index).collect()
}

#[test]
fn a_sample_is_kept_thirty_times_a_second_and_as_long_as_a_slice_needs_it() {
    let (mut history, scene) = (History::default(), fire(&[]));
    burn(&mut history, &scene, 0.0, 0.5);
    assert_eq!(history.samples().len(), 16);
    burn(&mut history, &scene, 0.51, 9.0);
    let [first, last] = [history.samples().first(), history.samples().last()]
        .map(|sample| sample.expect("a sample").time);
    assert!((1.2..=1.5).contains(&(last - first)), "{first} {last}");
    assert!(history.around(last - 1.2).is_some() && history.around(last - 3.0).is_none());
}

#[test]
fn slices_appear_as_soon_as_the_fire_is_as_old_as_their_lag() {
    let (mut history, scene) = (History::default(), fire(&[]));
    burn(&mut history, &scene, 0.0, 0.2);
    assert_eq!(visible(&history, &scene, 0.2), [0]);
    burn(&mut history, &scene, 0.21, 0.9);
    assert_eq!(visible(&history, &scene, 0.9), [0, 1, 3]);
    burn(&mut history, &scene, 0.91, 2.0);
    assert_eq!(visible(&history, &scene, 2.0), [0, 1, 2, 3, 4]);
    // Another fire begins.
    burn(&mut history, &scene, 0.0, 0.1);
    assert_eq!(visible(&history, &scene, 0.1), [0]);
}

#[test]
fn the_last_slice_of_a_fractional_number_is_faint() {
    let (mut history, scene) = (History::default(), fire(&[]));
    burn(&mut history, &scene, 0.0, 3.0);
    let smoke = |count| {
        let source = SourcePlace::first(&scene, &[]);
        let slices = history.slices(3.0, count, &source);
        slices.iter().map(|slice| slice.smoke).collect::<Vec<_>>()
    };
    assert_eq!(smoke(1.0), [1.0]);
    let faint = smoke(2.5);
    assert!(faint.len() == 3 && (faint[2] - 0.5 * faint[1]).abs() < 1e-6);
    assert!(smoke(3.001)[3] < 1e-4);
}

#[test]
fn slices_of_another_scene_fade_out_and_return() {
    let wind = fire(&[("wind", 1.0)]);
    let far = fire(&[("source_x", 0.35)]);
    for other in [wind, far] {
        let (mut history, scene) = (History::default(), fire(&[]));
        burn(&mut history, &scene, 0.0, 2.0);
        burn(&mut history, &other, 2.01, 2.3);
        assert_eq!(visible(&history, &other, 2.3), [0]);
        burn(&mut history, &other, 2.31, 5.0);
        assert_eq!(visible(&history, &other, 5.0), [0, 1, 2, 3, 4]);
    }
}

#[test]
fn a_free_solid_hides_slices_while_it_falls_unless_it_burns() {
    for (fuel, left) in [("paper", &[0, 1, 2, 3, 4][..]), ("none", &[0])] {
        let mut scene = fire(&[]);
        let solid = [("kind", "solid"), ("motion", "free"), ("fuel", fuel)];
        let added = scene.add(&solid.map(|(field, text)| (field, Input::Text(text))));
        assert!(added.is_ok(), "{added:?}");
        let (mut history, mut poses) = (History::default(), scene.poses(0.0));
        for step in 0..=90 {
            poses[0].frame.centre.y -= 0.05;
            history.record(&Moment {
                time: f64::from(step) / RATE,
                scene: &scene,
                poses: &poses,
                particles: &[],
            });
        }
        assert_eq!(visible(&history, &scene, 3.0), left, "{fuel}");
    }
}

#[test]
fn slices_follow_a_source_and_are_not_mirrored_in_wind() {
    let source = |scene: &Scene| SourcePlace::first(scene, &[]);
    let (mut history, still, moved) = (History::default(), fire(&[]), fire(&[("source_x", 0.2)]));
    burn(&mut history, &still, 0.0, 3.0);
    burn(&mut history, &moved, 3.01, 3.05);
    for slice in history.slices(3.05, 5.0, &source(&moved)) {
        let [x, _] = slice.moved(Bounds::default()).rows[0];
        assert!(
            slice.index == 0 || (x - 0.2 - slice.shift).abs() < 1e-5,
            "{slice:?}"
        );
    }
    for (wind, mirrored) in [(0.0, 2), (0.5, 0)] {
        let (mut history, scene) = (History::default(), fire(&[("wind", wind)]));
        burn(&mut history, &scene, 0.0, 3.0);
        let slices = history.slices(3.0, 5.0, &source(&scene));
        let count = slices.iter().filter(|slice| slice.scale[0] < 0.0).count();
        assert_eq!(count, mirrored);
    }
}

#[test]
fn a_limit_leaves_fewer_slices_and_the_newest_samples() {
    let (mut history, scene) = (History::default(), fire(&[]));
    // Two particles of sixteen bytes in twenty samples.
    history.set_limit(20 * 32);
    burn(&mut history, &scene, 0.0, 3.0);
    assert!((20..=21).contains(&history.samples().len()));
    assert_eq!(visible(&history, &scene, 3.0), [0, 1, 3]);
}

#[test]
fn a_sample_keeps_places_to_a_millimetre_and_all_of_the_gas() {
    let gas: Vec<Instance> = (0..40)
        .map(|k| {
            let at = k as f32;
            [
                at * 0.05 - 1.0,
                1.9,
                0.3,
                2.0,
                900.0 + at,
                2e-6 * (1.0 + at),
                0.1,
                1.0,
            ]
        })
        .collect();
    for length in [0.001, 0.05] {
        let mut texels = Vec::new();
        pack(&gas, length, &mut texels);
        let parcels: Vec<Vec<f32>> = texels
            .chunks_exact(8)
            .map(|parcel| parcel.iter().map(|&bits| half::number(bits)).collect())
            .collect();
        let sum = |of: &dyn Fn(f32, f32) -> f32| -> f32 {
            parcels
                .iter()
                .map(|p| of(p[VOLUME] * length * length, p[4]))
                .sum()
        };
        let volume: f32 = gas.iter().map(|p| p[VOLUME]).sum();
        let heat: f32 = gas.iter().map(|p| p[VOLUME] * p[4]).sum();
        assert!((sum(&|v, _| v) / volume - 1.0).abs() < 1e-3);
        assert!((sum(&|v, t| v * t) / heat - 1.0).abs() < 1e-3);
        // Neighbours are joined, other particles are not.
        assert_eq!(parcels.len(), if length > 0.01 { 20 } else { 40 });
        assert!((parcels[0][1] - 1.9).abs() < 1e-3);
    }
}

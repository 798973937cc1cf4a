use super::*;
use crate::Simulation;

#[test]
fn every_source_burns_at_its_position() {
    for model in [Model::Combustion, Model::Classic] {
        let mut scene = few(model);
        for (id, x) in [("source_width", 0.2), ("source_x", -0.3)] {
            assert_eq!(scene.set(id, x), Ok(()));
        }
        assert!(
            scene
                .add(&[SOURCE, ("x", number(0.3)), ("width", number(0.2))])
                .is_ok()
        );
        let hot = |scene: &Scene| {
            let fire = burnt(scene, 0.3);
            let all = fire.positions().into_iter().zip(fire.temperatures());
            let hot: Vec<f32> = all
                .filter(|particle| particle.1 > 600.0)
                .map(|particle| particle.0.x)
                .collect();
            let left = hot.iter().any(|&x| x < -0.1);
            (left, hot.iter().any(|&x| x > 0.1))
        };
        assert_eq!(hot(&scene), (true, true), "{model:?}");
        assert_eq!(scene.remove(1), Ok(()));
        assert_eq!(hot(&scene), (false, true), "{model:?}");
        assert_eq!(scene.remove(2), Ok(()));
        assert_eq!(hot(&scene), (false, false), "{model:?}");
    }
}

#[test]
fn two_sources_give_the_power_of_both() {
    let mut scene = Scene::default();
    for (id, x) in [
        ("source_width", 0.3),
        ("source_x", -0.3),
        ("fuel_power", 60.0),
        ("particles", 3000.0),
    ] {
        assert_eq!(scene.set(id, x), Ok(()));
    }
    let fields = [
        SOURCE,
        ("x", number(0.3)),
        ("width", number(0.3)),
        ("power", number(90.0)),
    ];
    assert!(scene.add(&fields).is_ok());
    let mut fire = burnt(&scene, 2.0);
    let (mut heat, start) = (0.0, fire.time());
    while fire.time() < start + 2.0 {
        fire.step();
        heat += f64::from(fire.power().unwrap_or_default()) * fire.step_length();
    }
    let power = heat / (fire.time() - start);
    assert!((power / 150.0 - 1.0).abs() < 0.1, "{power} kW/m for 150");
}

#[test]
fn the_same_scene_gives_the_same_bits() {
    let mut scene = Scene::default();
    let bits = |fire: &Simulation| {
        let all = fire.positions().into_iter();
        all.flat_map(|at| at.to_array().map(f32::to_bits))
            .collect::<Vec<_>>()
    };
    let plain = Simulation::new(scene.world().clone());
    let mut plain = (plain, burnt(&scene, 0.1));
    while plain.0.time() < 0.1 {
        plain.0.step();
    }
    assert_eq!(bits(&plain.0), bits(&plain.1));
    plain.1.reset();
    assert!(scene.add(&[SOURCE, ("x", number(0.3))]).is_ok());
    assert_eq!(bits(&burnt(&scene, 0.1)), bits(&burnt(&scene, 0.1)));
    assert_ne!(bits(&burnt(&scene, 0.1)), bits(&plain.0));
}

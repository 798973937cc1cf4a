use super::*;
use crate::Vec2;
use crate::preset::Preset;

fn bytes(fire: &Simulation) -> Vec<u8> {
    let mut out = Vec::new();
    fire.save_state(&mut out);
    out
}

#[test]
fn a_fire_of_every_scene_continues_from_its_state_with_the_same_bits() {
    for preset in Preset::all() {
        let scene = preset.scene();
        let mut fire = Simulation::new(scene.clone());
        fire.record_series(true);
        for _ in 0..60 {
            fire.step();
        }
        // Water lies and flies; a classic fire has none.
        let _ = fire.spray(Vec2::new(0.0, 0.5), Vec2::new(0.1, -1.0), 0.01);
        fire.step();
        let state = bytes(&fire);
        let mut other = Simulation::new(scene);
        let mut unread = Bytes(&state);
        assert_eq!(other.load_state(&mut unread), Some(()), "{}", preset.name);
        assert!(unread.0.is_empty() && bytes(&other) == state);
        for _ in 0..20 {
            fire.step();
            other.step();
        }
        assert!(bytes(&other) == bytes(&fire), "{}", preset.name);
        let cut = other.load_state(&mut Bytes(&state[..state.len() / 2]));
        assert_eq!(cut, None);
        assert!(bytes(&other) == bytes(&fire));
    }
}

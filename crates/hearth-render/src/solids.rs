//! Solids as records of the texture from which their quads are drawn.

use hearth_core::params::{Material, Solid, Thermal};
use hearth_core::{Instance, Scene};

use crate::constants::SURFACES;

/// Minimum temperature of a surface that visibly glows \[K\].
const GLOWING: f32 = 800.0;

/// The visible solids of a scene, in the layout that `shaders/solid.glsl` reads.
pub fn records(scene: &Scene) -> Vec<Instance> {
    let visible = scene.solids().filter(|one| one.material != Material::None);
    visible.map(record).collect()
}

fn record(solid: &Solid) -> Instance {
    let shape = solid.rounded_box();
    let glows = solid.thermal == Thermal::Fixed && solid.temperature >= GLOWING;
    let kelvin = if glows { solid.temperature } else { 0.0 };
    [
        shape.centre.x,
        shape.centre.y,
        shape.axis.x,
        shape.axis.y,
        shape.half.x,
        shape.half.y,
        shape.radius,
        solid.material as u8 as f32 * SURFACES + kelvin,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::{Choice, Input};

    /// The surface of a solid of that material and temperature, and whether it is drawn.
    fn surface(material: &str, kelvin: f64, thermal: &str) -> Option<f32> {
        let mut scene = Scene::default();
        let added = scene.add(&[
            ("kind", Input::Text("solid")),
            ("material", Input::Text(material)),
            ("thermal", Input::Text(thermal)),
            ("temperature", Input::Number(kelvin)),
        ]);
        assert!(added.is_ok(), "{added:?}");
        records(&scene).first().map(|[.., surface]| *surface)
    }

    #[test]
    fn a_surface_is_its_material_and_the_temperature_at_which_it_glows() {
        for (number, name) in Material::NAMES.iter().enumerate() {
            let material = number as f32 * SURFACES;
            let drawn = (*name != "none").then_some(material);
            assert_eq!(surface(name, 1200.0, "adiabatic"), drawn);
            assert_eq!(surface(name, 500.0, "fixed"), drawn);
            let hot = drawn.map(|material| material + 2500.0);
            assert_eq!(surface(name, 2500.0, "fixed"), hot);
        }
        assert!(surface("stone", 900.0, "fixed") < Some(SURFACES));
    }
}

//! Solids as records of the texture from which their quads are drawn, and their sampled distances
//! behind them.

use std::sync::Arc;

use hearth_core::params::{Material, Shape, Solid, Thermal};
use hearth_core::scene::{Field, Pose, RoundedBox};
use hearth_core::{Charred, CharredSolid, Instance, Scene};

use crate::constants::{FUEL_OFFSET, MATERIAL_FACTOR, PARTICLES_PER_ROW, PLANE_FACTOR};
use crate::gl::Graphics;
use crate::particles::Particles;

/// Minimum temperature of a surface that visibly glows \[K\].
const MIN_GLOWING_KELVIN: f32 = 800.0;
/// Maximum temperature of a record \[K\], which `MATERIAL_FACTOR` exceeds.
const MAX_RECORD_KELVIN: f32 = 2500.0;

/// The solids on the graphics card: records in the first row of a texture, then the fields of
/// solids with a sampled distance, in the layout that `shaders/solid.glsl` reads.
pub struct Solids<G: Graphics> {
    pub texture: Particles<G>,
    /// Number of the records of bricks and hangings that come first: they clad the wall, behind all other solids.
    pub cladding: usize,
    /// The fields in the texture. They are uploaded only when they change.
    fields: Vec<Arc<Field>>,
    /// Records between the first row and the fields.
    between: usize,
}

impl<G: Graphics> Solids<G> {
    pub fn new(texture: Particles<G>) -> Solids<G> {
        Solids {
            texture,
            cladding: 0,
            fields: Vec::new(),
            between: 0,
        }
    }

    /// Uploads the visible solids of a scene where they are, with the temperatures of those that
    /// conduct heat and the cells of those that have fuel.
    pub fn upload(
        &mut self,
        gl: &G,
        scene: &Scene,
        poses: &[Pose],
        temperatures: &[(u32, f32)],
        charred: &Charred,
    ) {
        let mut fields = Vec::new();
        let (mut instances, cladding) = records(scene, poses, temperatures, charred, &mut fields);
        self.cladding = cladding;
        let count = instances.len();
        let cells = &charred.records;
        let between = cells.len();
        if between > 0 {
            instances.resize(PARTICLES_PER_ROW, [0.0; 8]);
            instances.extend_from_slice(cells);
            self.texture.upload(gl, &instances);
        }
        let same = |(new, old): (&Arc<Field>, &Arc<Field>)| Arc::ptr_eq(new, old);
        let is_known =
            fields.len() == self.fields.len() && fields.iter().zip(&self.fields).all(same);
        if !is_known || between != self.between {
            instances.resize(PARTICLES_PER_ROW + between, [0.0; 8]);
            fields
                .iter()
                .for_each(|field| append(&mut instances, field));
            self.texture.upload(gl, &instances);
            (self.fields, self.between) = (fields, between);
        }
        if count > 0 || self.texture.count() > 0 {
            self.texture.upload(gl, &instances[..count]);
        }
    }
}

/// Whether a solid clads the wall if no other comes before it.
fn clads(solid: &Solid) -> bool {
    match solid.material {
        Material::Brick => true,
        Material::Cloth => solid.shape != Shape::Line,
        _ => false,
    }
}

/// The records of the visible solids, each with those of what has broken off it, and how many of the first
/// clad the wall; appends their fields.
fn records(
    scene: &Scene,
    poses: &[Pose],
    temperatures: &[(u32, f32)],
    charred: &Charred,
    fields: &mut Vec<Arc<Field>>,
) -> (Vec<Instance>, usize) {
    let mut place = PARTICLES_PER_ROW + charred.records.len();
    let visible = scene
        .surfaces()
        .filter(|(_, solid, _)| solid.material != Material::None);
    let mut records = Vec::new();
    let (mut cladding, mut is_first) = (0, true);
    for (id, solid, surface) in visible {
        let present = temperatures.iter().find(|(solid, _)| *solid == id);
        let kelvin = present.map_or(solid.temperature, |(_, kelvin)| *kelvin);
        let pose = poses.iter().find(|pose| pose.id == id);
        // The solid comes before its parts.
        let mut known = charred.solids.iter().filter(|solid| solid.id == id);
        let mut next = known.next();
        loop {
            let part = next.and_then(|part| part.part);
            let mut frame = part.unwrap_or(pose.map_or(surface.frame, |pose| pose.frame));
            let mut field = surface.field.as_ref();
            let cells = next.map_or(0.0, |known| burnt(known, &mut frame, &mut field));
            let mut record = record(solid, if cells > 0.0 { 0.0 } else { kelvin }, &frame);
            record[7] += cells;
            if let Some(field) = field {
                record[6] = -(place as f32);
                place += 1 + field.distances.len().div_ceil(record.len());
                fields.push(field.clone());
            }
            records.push(record);
            next = known.next();
            if next.is_none() {
                break;
            }
        }
        is_first &= clads(solid);
        if is_first {
            cladding = records.len();
        }
    }
    (records, cladding)
}

/// The number to add to the surface of a solid that has fuel, whose box and field become those of
/// what is left of it.
fn burnt<'a>(
    CharredSolid { place, left, .. }: &'a CharredSolid,
    frame: &mut RoundedBox,
    field: &mut Option<&'a Arc<Field>>,
) -> f32 {
    if let Some(left) = left {
        (frame.half, frame.radius) = (left.half, 0.0);
        *field = Some(left);
    }
    let place = *place as f32;
    // The first solids of so many that there is no number for the others.
    if place < MATERIAL_FACTOR {
        FUEL_OFFSET * MATERIAL_FACTOR + place
    } else {
        0.0
    }
}

/// Appends a field: a head, then its distances. The depth of a round solid is negative.
fn append(instances: &mut Vec<Instance>, field: &Field) {
    let step = 2.0 * field.half.x / (field.columns as f32 - 1.0);
    let rise = 2.0 * field.half.y / (field.rows as f32 - 1.0);
    let depth = if field.round {
        -field.depth
    } else {
        field.depth
    };
    let mut head = [0.0; 8];
    head[..4].copy_from_slice(&[field.columns as f32, depth, step, rise]);
    instances.push(head);
    for some in field.distances.chunks(head.len()) {
        let mut record = [0.0; 8];
        record[..some.len()].copy_from_slice(some);
        instances.push(record);
    }
}

fn record(solid: &Solid, kelvin: f32, shape: &RoundedBox) -> Instance {
    let glows = solid.thermal != Thermal::Adiabatic && kelvin >= MIN_GLOWING_KELVIN;
    let kelvin = if glows {
        kelvin.min(MAX_RECORD_KELVIN)
    } else {
        0.0
    };
    [
        shape.centre.x,
        shape.centre.y,
        shape.axis.x,
        shape.axis.y,
        shape.half.x,
        shape.half.y,
        shape.radius,
        (f32::from(solid.material as u8) + PLANE_FACTOR * f32::from(solid.plane as u8))
            * MATERIAL_FACTOR
            + kelvin,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::{Choice, Input, Plane};
    use hearth_core::scene::Surface;

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
        let (records, _) = records(&scene, &[], &[], &Charred::default(), &mut Vec::new());
        records.first().map(|[.., surface]| *surface)
    }

    #[test]
    fn a_surface_is_its_material_plane_and_the_temperature_at_which_it_glows() {
        let within = f32::from(Plane::Within as u8) * PLANE_FACTOR;
        for (number, name) in Material::NAMES.iter().enumerate() {
            let material = (number as f32 + within) * MATERIAL_FACTOR;
            let drawn = (*name != "none").then_some(material);
            assert_eq!(surface(name, 1200.0, "adiabatic"), drawn);
            assert_eq!(surface(name, 500.0, "fixed"), drawn);
            let hot = drawn.map(|material| material + 2500.0);
            assert_eq!(surface(name, 2500.0, "fixed"), hot);
        }
        assert!(surface("stone", 900.0, "fixed") < Some((within + 1.0) * MATERIAL_FACTOR));
    }

    #[test]
    fn bricks_and_sheets_of_cloth_before_other_solids_clad_the_wall_in_all_their_parts() {
        let mut scene = Scene::default();
        let mut add = |shape, material| {
            let solid = [("kind", "solid"), ("shape", shape), ("material", material)];
            let added = scene.add(&solid.map(|(id, value)| (id, Input::Text(value))));
            assert!(added.is_ok(), "{added:?}");
        };
        add("box", "none");
        add("box", "brick");
        add("box", "cloth");
        add("line", "cloth");
        add("box", "brick");
        let part = CharredSolid {
            id: 4,
            place: 0,
            left: None,
            part: None,
        };
        let charred = |parts| Charred {
            records: Vec::new(),
            solids: vec![part.clone(); parts],
        };
        for (parts, expected) in [(0, 2), (1, 2), (3, 4)] {
            let (_, cladding) = records(&scene, &[], &[], &charred(parts), &mut Vec::new());
            assert_eq!(cladding, expected);
        }
    }

    #[test]
    fn a_part_is_drawn_as_its_solid_where_it_is() {
        let mut scene = Scene::default();
        let solid = |material| [("kind", Input::Text("solid")), ("material", material)];
        let ids = ["iron", "none", "wood"].map(|name| scene.add(&solid(Input::Text(name))));
        assert_eq!(ids, [Ok(2), Ok(3), Ok(4)]);
        let mut polygon = Scene::default();
        let shape = [
            ("kind", Input::Text("solid")),
            ("shape", Input::Text("polygon")),
        ];
        assert!(polygon.add(&shape).is_ok());
        let surface = polygon
            .surfaces()
            .next()
            .map(|(.., surface)| surface.clone());
        let Some(Surface {
            frame,
            field: Some(left),
        }) = surface
        else {
            panic!("a polygon without a field");
        };
        let part = |id, place| CharredSolid {
            id,
            place,
            left: Some(left.clone()),
            part: Some(frame),
        };
        let whole = |id| CharredSolid {
            left: None,
            part: None,
            ..part(id, 0)
        };
        let charred = Charred {
            records: vec![[0.0; 8]; 9],
            // The second is invisible, and the last has no solid.
            solids: vec![whole(4), part(4, 3), part(3, 5), part(4, 7), part(9, 8)],
        };
        let mut fields = Vec::new();
        let (all, _) = records(&scene, &[], &[], &charred, &mut fields);
        assert_eq!((all.len(), fields.len()), (4, 2));
        let length = 1 + left.distances.len().div_ceil(8);
        for (number, place) in [3.0, 7.0].into_iter().enumerate() {
            let drawn = all[2 + number];
            assert_eq!(drawn[..2], frame.centre.to_array());
            assert_eq!(
                drawn[6],
                -((PARTICLES_PER_ROW + 9 + number * length) as f32)
            );
            assert_eq!(drawn[7], all[1][7] + place);
        }
    }
}

use super::nearest::distance_squared;
use super::*;
use crate::params::{Input, SOLID};
use crate::random::Random;
use crate::scene::Surface;

/// Error of a distance \[m\]: an interpolated one is within a step. Beyond the field, where the
/// nearest point is found by that of the border, it is too large by up to half.
fn tolerance(surface: &Surface, exact: f32) -> f32 {
    step(surface) + if exact < 0.1 { 0.1 } else { 0.5 } * exact
}

/// A solid at the origin with these properties.
fn solid(properties: &[(&str, Input<'_>)]) -> Solid {
    let mut solid = Solid {
        y: 0.0,
        ..Solid::default()
    };
    for &(name, input) in properties {
        let entry = SOLID.iter().find(|entry| entry.id == name).expect(name);
        let value = entry.check(crate::params::Model::default(), input);
        let set = value.and_then(|value| solid.put(entry, value));
        assert_eq!(set, Ok(()), "{name}");
    }
    solid
}

fn outline(shape: &str, points: &str, height: f64) -> Surface {
    let height = ("height", Input::Number(height));
    let [shape, points] = [("shape", shape), ("points", points)].map(|(n, t)| (n, Input::Text(t)));
    solid(&[shape, points, height]).surface()
}

fn step(surface: &Surface) -> f32 {
    surface
        .field
        .as_ref()
        .map_or(0.0, |field| field.step.max_element())
}

/// The corners of a star with so many arms.
fn star(arms: u32, outer: f32, inner: f32) -> Vec<Vec2> {
    let corners = 0..2 * arms;
    corners
        .map(|corner| {
            let angle = std::f32::consts::PI * corner as f32 / arms as f32;
            let radius = if corner % 2 == 0 { outer } else { inner };
            radius * Vec2::new(libm::sinf(angle), libm::cosf(angle))
        })
        .collect()
}

fn text(points: &[Vec2]) -> String {
    let pairs = points
        .iter()
        .map(|point| format!("{},{} ", point.x, point.y));
    pairs.collect()
}

/// The distance of a point from the nearest of these lines.
fn nearest(point: Vec2, lines: &[Line]) -> f32 {
    let all = lines.iter().map(|line| distance_squared(point, line));
    all.fold(f32::MAX, f32::min).sqrt()
}

fn closed(points: &[Vec2]) -> Vec<Line> {
    let next = points.iter().cycle().skip(1);
    points
        .iter()
        .zip(next)
        .map(|(&first, &second)| [first, second])
        .collect()
}

fn places(width: f32) -> impl Iterator<Item = Vec2> {
    (0..1600).map(move |index| {
        Vec2::new((index % 40) as f32 - 19.7, (index / 40) as f32 - 19.3) * (width / 40.0)
    })
}

#[test]
fn the_distance_to_a_polygon_is_that_of_the_nearest_point_of_its_outline() {
    let points = star(5, 0.3, 0.12);
    let surface = outline("polygon", &text(&points), 0.1);
    let lines = closed(&points);
    assert!(step(&surface) < 0.005, "{}", step(&surface));
    for place in places(1.2) {
        let (distance, normal) = surface.distance(place);
        let exact = nearest(place, &lines);
        let tolerance = tolerance(&surface, exact);
        assert!(
            (distance.abs() - exact).abs() < tolerance,
            "{distance} for {exact} at {place}"
        );
        assert!(normal.is_normalized());
        if (tolerance..0.1).contains(&distance) {
            let (rest, _) = surface.distance(place - normal * distance);
            assert!(rest.abs() < 2.0 * tolerance, "{rest} at {place}");
        }
    }
    assert!(surface.distance(Vec2::ZERO).0 < -0.08);
    assert!(surface.distance(Vec2::new(0.0, 0.28)).0 < 0.0, "in an arm");
    assert!(
        surface.distance(Vec2::new(0.0, -0.28)).0 > 0.05,
        "between two"
    );
}

#[test]
fn a_polygon_that_crosses_itself_is_solid_where_its_outline_winds_around() {
    let corners: Vec<Vec2> = star(5, 0.3, 0.3).into_iter().step_by(2).collect();
    let crossed: Vec<Vec2> = (0..5).map(|corner| corners[corner * 2 % 5]).collect();
    let surface = outline("polygon", &text(&crossed), 0.1);
    // The inner corners of the same star.
    let inner = 0.3 * 0.381_966;
    let simple = outline("polygon", &text(&star(5, 0.3, inner)), 0.1);
    for place in places(0.8) {
        let [first, second] = [&surface, &simple].map(|surface| surface.distance(place).0);
        assert!(
            (first - second).abs() < 2.0 * step(&surface),
            "{first}, {second} at {place}"
        );
    }
    assert!(surface.distance(Vec2::ZERO).0 < -0.05);
}

#[test]
fn a_polygon_with_a_hole_has_no_line_between_the_two_outlines() {
    let ring = "-0.3,-0.3 0.3,-0.3 0.3,0.3 -0.3,0.3 -0.3,-0.3 -0.1,-0.1 -0.1,0.1 0.1,0.1 0.1,-0.1 -0.1,-0.1";
    let surface = outline("polygon", ring, 0.1);
    assert!(surface.distance(Vec2::ZERO).0 > 0.09, "the hole");
    let (distance, _) = surface.distance(Vec2::splat(-0.2));
    assert!(
        (distance + 0.1).abs() < step(&surface),
        "{distance} on the way to the hole"
    );
}

#[test]
fn a_thin_stroke_is_closed() {
    for (height, points) in [
        (0.02, "-0.4,-0.2 0.1,0.3 0.12,-0.1 0.4,0.33"),
        (0.002, "-0.6,0.013 0.6,0.411"),
        (0.002, "-0.5,0 0.5,0"),
    ] {
        let surface = outline("stroke", points, height);
        let all = solid(&[("points", Input::Text(points))])
            .points
            .all()
            .to_vec();
        for [from, to] in all.array_windows() {
            for part in 0..=500 {
                let place = from + (to - from) * (part as f32 / 500.0);
                assert!(
                    surface.distance(place).0 < 0.0,
                    "{height} m thick at {place}"
                );
            }
        }
        let radius = (0.5 * height as f32).max(step(&surface));
        let lines: Vec<Line> = all.array_windows().copied().collect();
        for place in places(1.6) {
            let (distance, _) = surface.distance(place);
            let exact = nearest(place, &lines) - radius;
            let tolerance = tolerance(&surface, exact);
            assert!(
                (distance - exact).abs() < tolerance,
                "{distance} for {exact} at {place}"
            );
        }
    }
}

#[test]
fn the_distance_to_a_mask_is_that_of_its_edge_between_pixels() {
    // A disc of radius 20 pixels in 64, with soft pixels at its edge.
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOP";
    let letters: String = (0..64 * 64)
        .map(|pixel| {
            let place = Vec2::new((pixel % 64) as f32 - 31.5, (pixel / 64) as f32 - 31.5);
            let cover = (20.5 - place.length()).clamp(0.0, 1.0);
            LETTERS[(cover * 15.0).round() as usize] as char
        })
        .collect();
    let mask = format!("64x64:{letters}");
    let surface = solid(&[
        ("shape", Input::Text("mask")),
        ("mask", Input::Text(&mask)),
        ("width", Input::Number(0.64)),
        ("height", Input::Number(0.64)),
    ])
    .surface();
    for place in places(1.4) {
        let (distance, normal) = surface.distance(place);
        let exact = place.length() - 0.2;
        // A tenth of a pixel, and more at the centre, where no direction is the nearest.
        let tolerance = if exact < -0.15 { 0.01 } else { 0.001 };
        assert!(
            (distance - exact).abs() < tolerance,
            "{distance} for {exact} at {place}"
        );
        assert!(
            exact < -0.15 || normal.dot(place.normalize()) > 0.98,
            "{normal} at {place}"
        );
    }
}

#[test]
fn a_mask_stands_upright_and_has_its_width_and_height() {
    let surface = solid(&[
        ("shape", Input::Text("mask")),
        // Opaque above, transparent below.
        ("mask", Input::Text("16x16:6i")),
        ("width", Input::Number(0.8)),
        ("height", Input::Number(0.4)),
        ("angle", Input::Number(90.0)),
    ])
    .surface();
    // Turned by a quarter, its upper half is on the left.
    assert!((surface.distance(Vec2::new(-0.3, 0.0)).0 - 0.1).abs() < 1e-3);
    assert!((surface.distance(Vec2::new(-0.13, 0.0)).0 + 0.07).abs() < 1e-3);
    assert!((surface.distance(Vec2::new(0.1, 0.2)).0 - 0.1).abs() < 1e-3);
    assert!((surface.distance(Vec2::new(-0.1, 0.5)).0 - 0.1).abs() < 1e-3);
}

#[test]
fn random_outlines_have_finite_distances() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let count = 2 + random.bits() % [3, 12, 255][seed as usize % 3];
        // Half of them repeat places, on a coarse lattice.
        let lattice = [1e4, 3.0][seed as usize % 2];
        let size = [0.001, 0.5, 10.0][seed as usize / 2 % 3];
        let points: Vec<Vec2> = (0..count)
            .map(|_| {
                let place = Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
                (place * lattice).round() / lattice * size
            })
            .collect();
        for shape in ["polygon", "stroke"] {
            let surface = outline(shape, &text(&points), 0.002);
            let field = surface.field.as_ref().expect("a field");
            assert!(field.distances.len() < 100_000, "{}", field.distances.len());
            for place in places(4.0 * size) {
                let (distance, normal) = surface.distance(place);
                assert!(
                    distance.is_finite() && normal.is_normalized(),
                    "{shape} {points:?}"
                );
            }
        }
    }
}

#[test]
fn a_line_between_the_arms_of_a_solid_crosses_them_and_one_within_a_hollow_does_not() {
    let surface = outline("stroke", "-0.1,0.2 -0.1,0 0.1,0 0.1,0.2", 0.02);
    let field = surface.field.as_ref().expect("a field");
    let crosses = |start: [f32; 2], end: [f32; 2]| {
        let [start, end] = [start, end].map(|place| surface.frame.local(place.into()));
        field.crosses(start, end)
    };
    assert!(crosses([-0.13, 0.1], [-0.05, 0.12]));
    assert!(crosses([-0.05, 0.1], [0.13, 0.12]), "the other arm");
    assert!(!crosses([-0.08, 0.05], [0.08, 0.15]));
    assert!(!crosses([-0.08, 0.02], [-0.08, 0.19]), "along an arm");
}

//! The panel's icons, painted with lines: the font has none.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

/// An icon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// Play.
    Play,
    /// Pause.
    Pause,
    /// Advance by one step.
    Step,
    /// Restart.
    Restart,
    /// Reset to the default.
    Reset,
    /// A random number.
    Dice,
    /// Search.
    Search,
    /// Clear a field.
    Cross,
    /// Undo.
    Undo,
    /// Redo.
    Redo,
    /// Save an image or a film.
    Camera,
    /// Full screen.
    Corners,
    /// Share.
    Share,
    /// Done.
    Tick,
    /// On.
    Eye,
    /// Off.
    ClosedEye,
}

impl Icon {
    /// Paints the icon in a square of `size` points around `centre`.
    pub fn paint(self, painter: &Painter, centre: Pos2, size: f32, colour: Color32) {
        let r = size / 2.0;
        let stroke = Stroke::new((size / 9.0).max(1.3), colour);
        let at = |x: f32, y: f32| centre + vec2(x * r, y * r);
        let bar = |x: f32| {
            painter.rect_filled(
                Rect::from_center_size(at(x, 0.0), vec2(0.36 * r, 1.5 * r)),
                1.0,
                colour,
            );
        };
        match self {
            Icon::Play => {
                painter.add(triangle(
                    [at(-0.5, -0.8), at(0.85, 0.0), at(-0.5, 0.8)],
                    colour,
                ));
            }
            Icon::Pause => {
                bar(-0.4);
                bar(0.4);
            }
            Icon::Step => {
                painter.add(triangle(
                    [at(-0.7, -0.75), at(0.4, 0.0), at(-0.7, 0.75)],
                    colour,
                ));
                bar(0.65);
            }
            Icon::Restart => {
                turn(painter, centre, 0.75 * r, false, stroke);
            }
            Icon::Reset => {
                turn(painter, centre, 0.75 * r, true, stroke);
            }
            Icon::Dice => {
                let face = Rect::from_center_size(centre, vec2(1.7 * r, 1.7 * r));
                painter.rect_stroke(face, 0.35 * r, stroke, egui::StrokeKind::Inside);
                for (x, y) in [
                    (-0.4, -0.4),
                    (0.4, -0.4),
                    (0.0, 0.0),
                    (-0.4, 0.4),
                    (0.4, 0.4),
                ] {
                    painter.circle_filled(at(x, y), 0.15 * r, colour);
                }
            }
            Icon::Search => {
                painter.circle_stroke(at(-0.15, -0.15), 0.55 * r, stroke);
                painter.line_segment([at(0.25, 0.25), at(0.8, 0.8)], stroke);
            }
            Icon::Cross => {
                painter.line_segment([at(-0.5, -0.5), at(0.5, 0.5)], stroke);
                painter.line_segment([at(0.5, -0.5), at(-0.5, 0.5)], stroke);
            }
            Icon::Undo => hook(painter, centre, r, -1.0, stroke),
            Icon::Redo => hook(painter, centre, r, 1.0, stroke),
            Icon::Camera => {
                let body = Rect::from_min_max(at(-1.0, -0.5), at(1.0, 0.8));
                painter.rect_stroke(body, 0.25 * r, stroke, egui::StrokeKind::Inside);
                let finder = [
                    at(-0.45, -0.5),
                    at(-0.25, -0.85),
                    at(0.25, -0.85),
                    at(0.45, -0.5),
                ];
                painter.line(finder.to_vec(), stroke);
                painter.circle_stroke(at(0.0, 0.15), 0.32 * r, stroke);
            }
            Icon::Corners => {
                for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                    let far = 0.8;
                    let near = 0.25;
                    let corner = [
                        at(near * x, far * y),
                        at(far * x, far * y),
                        at(far * x, near * y),
                    ];
                    painter.line(corner.to_vec(), stroke);
                }
            }
            Icon::Share => {
                let (from, upper, lower) = (at(-0.6, 0.0), at(0.6, -0.65), at(0.6, 0.65));
                painter.line(vec![upper, from, lower], stroke);
                for knot in [from, upper, lower] {
                    painter.circle_filled(knot, 0.3 * r, colour);
                }
            }
            Icon::Eye | Icon::ClosedEye => {
                let lid = |up: f32| {
                    let points = (0..=12).map(|i| {
                        let x = i as f32 / 6.0 - 1.0;
                        at(x, up * 0.6 * (1.0 - x * x))
                    });
                    painter.line(points.collect(), stroke);
                };
                lid(1.0);
                if self == Icon::Eye {
                    lid(-1.0);
                    painter.circle_filled(centre, 0.28 * r, colour);
                }
            }
            Icon::Tick => {
                painter.line(vec![at(-0.75, 0.05), at(-0.2, 0.6), at(0.8, -0.6)], stroke);
            }
        }
    }
}

/// The arrow of a heading: down if the part below is open.
pub fn chevron(painter: &Painter, centre: Pos2, open: bool, colour: Color32) {
    let points = if open {
        vec![
            pos2(centre.x - 4.0, centre.y - 2.0),
            pos2(centre.x, centre.y + 2.5),
            pos2(centre.x + 4.0, centre.y - 2.0),
        ]
    } else {
        vec![
            pos2(centre.x - 2.0, centre.y - 4.0),
            pos2(centre.x + 2.5, centre.y),
            pos2(centre.x - 2.0, centre.y + 4.0),
        ]
    };
    painter.line(points, Stroke::new(1.6, colour));
}

/// An open circle with an arrow head: anticlockwise for reset, clockwise for restart.
fn turn(painter: &Painter, centre: Pos2, radius: f32, to_the_left: bool, stroke: Stroke) {
    use std::f32::consts::TAU;
    let mirror = if to_the_left { -1.0 } else { 1.0 };
    let point = |turns: f32, radius: f32| {
        let (sin, cos) = (turns * TAU).sin_cos();
        centre + vec2(mirror * cos * radius, sin * radius)
    };
    // Clockwise from the top right to the right, open at the upper right.
    let points = (0..=20).map(|i| point(-0.12 + 0.78 - 0.78 * i as f32 / 20.0 + 0.12, radius));
    painter.line(points.collect(), stroke);
    let tip = point(0.0, radius);
    painter.add(triangle(
        [
            tip + vec2(-mirror * 0.55 * radius, 0.1 * radius),
            tip + vec2(mirror * 0.55 * radius, 0.1 * radius),
            tip + vec2(0.0, -0.65 * radius),
        ],
        stroke.color,
    ));
}

/// A bent arrow: to the left (`side` −1) for undo, to the right (1) for redo.
fn hook(painter: &Painter, centre: Pos2, r: f32, side: f32, stroke: Stroke) {
    use std::f32::consts::PI;
    let at = |x: f32, y: f32| centre + vec2(side * x * r, y * r);
    // Along the top towards the head, and around the other end to the bottom.
    let bend = (0..=12).map(|i| {
        let (sin, cos) = (PI * (0.5 - i as f32 / 12.0)).sin_cos();
        at(-0.3 - 0.55 * cos, 0.2 + 0.55 * sin)
    });
    let way = std::iter::once(at(0.3, 0.75)).chain(bend);
    painter.line(way.chain([at(0.4, -0.35)]).collect(), stroke);
    let head = [at(0.95, -0.35), at(0.3, -0.8), at(0.3, 0.1)];
    painter.add(triangle(head, stroke.color));
}

fn triangle(points: [Pos2; 3], colour: Color32) -> Shape {
    Shape::convex_polygon(points.to_vec(), colour, Stroke::NONE)
}

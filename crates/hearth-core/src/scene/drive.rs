//! How a solid moves by itself: a function of the time alone, so a fire that is saved and restored
//! or stepped elsewhere finds it at the same place.

use std::f32::consts::PI;

use glam::Vec2;

use super::distance::{RoundedBox, Surface};
use crate::direction::direction;
use crate::extremes::{fast_max, fast_min};
use crate::params::{Motion, Solid};

/// Largest speed of a surface for the gas [m/s].
pub(crate) const MAX_SPEED: f32 = 3.0;

/// The motion of a solid that moves by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Drive {
    /// What it turns about at rest \[m\].
    place: Vec2,
    /// From there to its first turning point \[m\].
    path: Vec2,
    /// Motions to and fro in a second \[1/s\].
    frequency: f64,
    /// Angular velocity \[°/s\].
    spin: f32,
}

/// Where a driven solid is at a time, and how it moves.
pub(crate) struct Driven {
    /// Its box.
    pub frame: RoundedBox,
    /// Velocity of the centre of the box [m/s].
    pub velocity: Vec2,
    /// Angular velocity [1/s].
    pub spin: f32,
}

impl Drive {
    /// The motion of a solid; `None` if it is still. No part of it is faster than [`MAX_SPEED`].
    pub fn of(solid: &Solid, surface: &Surface) -> Option<Drive> {
        let place = Vec2::new(solid.x, solid.y);
        let frame = &surface.frame;
        let (mut path, mut spin) = (Vec2::ZERO, 0.0);
        match solid.motion {
            Motion::Still | Motion::Free => return None,
            Motion::Sway => {
                let longest = MAX_SPEED * solid.period / (2.0 * PI);
                path = direction(solid.heading) * fast_min(solid.sway, longest);
            }
            Motion::Spin => {
                let reach = frame.reach() + frame.centre.distance(place);
                let fastest = (MAX_SPEED / reach).to_degrees();
                spin = fast_max(fast_min(solid.spin, fastest), -fastest);
            }
        }
        Some(Drive {
            place,
            path,
            frequency: 1.0 / f64::from(solid.period),
            spin,
        })
    }

    /// The solid at a time \[s\], whose box at rest is `rest`.
    pub fn at(&self, rest: &RoundedBox, time: f64) -> Driven {
        let swing = direction(degrees(time * self.frequency));
        let turn = direction(degrees(time * f64::from(self.spin) / 360.0));
        let from = turn.rotate(rest.centre - self.place);
        let (spin, rate) = (self.spin.to_radians(), 360.0 * self.frequency as f32);
        Driven {
            frame: RoundedBox {
                centre: self.place + self.path * swing.y + from,
                axis: turn.rotate(rest.axis),
                ..*rest
            },
            velocity: self.path * (swing.x * rate.to_radians()) + from.perp() * spin,
            spin,
        }
    }
}

impl Solid {
    /// The box of its surface at a time of the fire \[s\], moved by no force.
    pub fn frame_at(&self, surface: &Surface, time: f64) -> RoundedBox {
        let rest = &surface.frame;
        Drive::of(self, surface).map_or(*rest, |drive| drive.at(rest, time).frame)
    }
}

/// Where a solid is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// The id of the solid.
    pub id: u32,
    /// The box of its surface there.
    pub frame: RoundedBox,
}

crate::state! { Drive: place path frequency spin, Pose: id frame }

/// The angle of a number of turns \[°\], less than one.
fn degrees(turns: f64) -> f32 {
    (360.0 * (turns - turns.floor())) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECOND: f64 = 1.0;

    fn frame(solid: &Solid, time: f64) -> RoundedBox {
        solid.frame_at(&solid.surface(), time)
    }

    #[test]
    fn a_solid_sways_to_its_turning_points_and_back() {
        let solid = Solid {
            motion: Motion::Sway,
            sway: 0.4,
            heading: 90.0,
            period: 2.0,
            ..Solid::default()
        };
        let place = Vec2::new(solid.x, solid.y);
        for (time, height) in [
            (0.0, 0.0),
            (0.5, 0.4),
            (1.0, 0.0),
            (1.5, -0.4),
            (1000.0, 0.0),
        ] {
            let centre = frame(&solid, time * SECOND).centre;
            assert!(
                (centre - place - Vec2::new(0.0, height)).length() < 1e-5,
                "{time} s: {centre}"
            );
        }
    }

    #[test]
    fn a_solid_spins_about_its_place() {
        // The box of a polygon is not centred at its place.
        let mut solid = Solid {
            motion: Motion::Spin,
            spin: 90.0,
            shape: crate::params::Shape::Polygon,
            ..Solid::default()
        };
        let place = Vec2::new(solid.x, solid.y);
        let rest = frame(&solid, 0.0);
        for (time, turned) in [(1.0, Vec2::Y), (2.0, -Vec2::X), (4.0, Vec2::X)] {
            let now = frame(&solid, time * SECOND);
            assert!((now.axis - turned).length() < 1e-6);
            let from = turned.rotate(rest.centre - place);
            assert!((now.centre - place - from).length() < 1e-6, "{time} s");
        }
        solid.spin = -90.0;
        assert!((frame(&solid, 1.0).axis + Vec2::Y).length() < 1e-6);
    }

    #[test]
    fn its_velocity_is_the_change_of_its_place() {
        for motion in [Motion::Sway, Motion::Spin] {
            let solid = Solid {
                motion,
                spin: 200.0,
                heading: 30.0,
                shape: crate::params::Shape::Polygon,
                ..Solid::default()
            };
            let surface = solid.surface();
            let Some(drive) = Drive::of(&solid, &surface) else {
                panic!("it moves")
            };
            for time in [0.3, 1.7, 12.4] {
                let dt = 1e-3;
                let at = |time| drive.at(&surface.frame, time);
                let (before, now, after) = (at(time - dt), at(time), at(time + dt));
                let path = after.frame.centre - before.frame.centre;
                assert!((path / (2e-3) - now.velocity).length() < 2e-3, "{motion:?}");
                let turn = before.frame.axis.perp_dot(after.frame.axis);
                assert!((turn / 2e-3 - now.spin).abs() < 2e-3, "{motion:?}");
            }
        }
    }
}

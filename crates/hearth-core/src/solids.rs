//! The solids of a scene for the solvers: shapes that move as a caller moves them.
//!
//! A caller moves a solid by new values, so its position jumps. Gas next to it gets the velocity
//! of that motion for as long as the motion took: the time since the change before, at most
//! [`LONGEST_MOTION`]. A solid may also move by itself, as a function of the time.

pub(crate) mod free;
mod heat;
mod images;
#[cfg(test)]
mod tests;
mod thin;

use std::f32::consts::PI;
use std::sync::Arc;

use glam::Vec2;

use crate::bounds::Bounds;
use crate::extremes::{fast_max, fast_min};
use crate::params::{Fuel, Motion, Thermal};
use crate::scene::{Drive, Field, MAX_SPEED, RoundedBox, Scene, SceneSource, Surface};
use heat::{Inflow, Store};

/// Longest and shortest time of a motion \[s\].
const LONGEST_MOTION: f32 = 1.0 / 30.0;
const SHORTEST_MOTION: f32 = 1e-3;
/// Attempts to find a place outside of solids that touch.
const ATTEMPTS: u32 = 6;
/// Tolerance for rounding in the distance from a surface.
const ROUNDED_GAP: f32 = 0.9;

/// A solid, or its image beyond a periodic edge.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Body {
    id: u32,
    /// Its box in the scene and its angle \[rad\], and the path from there to this image \[m\].
    rest: RoundedBox,
    angle: f32,
    image: Vec2,
    /// How it moves by itself, and its velocity [m/s] and angular velocity [1/s] by that.
    drive: Option<Drive>,
    driven: (Vec2, f32),
    pub surface: Surface,
    /// Radius of the circle around the centre that contains it \[m\].
    pub reach: f32,
    /// Temperature of the surface \[K\]; `None` if no heat passes.
    pub temperature: Option<f32>,
    /// Whether it has fuel.
    pub burns: bool,
    /// Whether forces move it; and the force [N/m] and the torque \[N\] of the gas on it in the present
    /// step, for each metre of depth.
    pub is_free: bool,
    force: Vec2,
    torque: f32,
    /// How a body that conducts heat stores and radiates it.
    store: Option<Store>,
    /// Velocity [m/s] and angular velocity [1/s] of the last motion.
    velocity: Vec2,
    spin: f32,
    /// Time that is left of the motion, and time since its begin \[s\].
    left: f32,
    since: f32,
}

impl Body {
    /// The id of its solid.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// Lower left and upper right corner of the upright rectangle around it \[m\].
    pub fn around(&self) -> [Vec2; 2] {
        let (centre, half) = (self.surface.frame.centre, self.surface.frame.extent());
        [centre - half, centre + half]
    }

    /// Notes that gas of a temperature \[K\] exchanges heat with it at that conductance [kW/K].
    #[inline]
    pub fn exchange(&mut self, conductance: f32, temperature: f32) {
        if let Some(store) = &mut self.store {
            store.inflow.add(conductance, temperature);
        }
    }

    /// What stores its heat, and its temperature \[K\], if it conducts heat.
    fn heated(&self) -> Option<(Store, f32)> {
        Some((self.store?, self.temperature?))
    }

    /// The velocity of its surface at a position [m/s].
    #[inline]
    pub fn velocity_at(&self, position: Vec2) -> Vec2 {
        let (velocity, spin) = self.driven;
        let from = position - self.surface.frame.centre;
        let turning = from.perp() * (self.spin + spin);
        (self.velocity + velocity + turning).clamp_length_max(MAX_SPEED)
    }

    /// Whether a position may be nearer to it than this.
    #[inline]
    pub fn may_touch(&self, position: Vec2, distance: f32) -> bool {
        let reach = self.reach + distance;
        position.distance_squared(self.surface.frame.centre) < reach * reach
    }
}

/// All solids.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solids {
    pub bodies: Vec<Body>,
    /// Room for the bodies of the next step.
    spare: Vec<Body>,
    /// Those that forces move.
    pub free: Option<Box<free::FreeBodies>>,
}

crate::state! {
    Body: id rest angle image drive driven surface reach temperature burns is_free force torque store velocity
        spin left since,
    Solids: bodies free; spare
}

impl Solids {
    /// The solids of a scene at the start of the fire, those that a caller moves at rest.
    pub fn of(scene: &Scene, bounds: &Bounds, near: f32) -> Solids {
        let mut solids = Solids::default();
        solids.update(scene, 0.0, bounds, near);
        solids
    }

    /// Moves the solids to where they are in a scene at a time \[s\]. Those within `near` of a
    /// periodic edge get images beyond it.
    pub fn update(&mut self, scene: &Scene, time: f64, bounds: &Bounds, near: f32) {
        if !self.is_empty() || scene.has_solids() {
            self.gather(scene, time, bounds, near);
        }
    }

    fn gather(&mut self, scene: &Scene, time: f64, bounds: &Bounds, near: f32) {
        let old = std::mem::take(&mut self.bodies);
        for (id, solid, surface) in scene.obstacles() {
            let frame = surface.frame;
            let burns = solid.fuel != Fuel::None;
            // One that burns has a temperature in each part of it.
            let thermal = if burns {
                Thermal::Adiabatic
            } else {
                solid.thermal
            };
            let mut body = Body {
                id,
                rest: frame,
                angle: solid.angle.to_radians(),
                image: Vec2::ZERO,
                drive: Drive::of(solid, surface),
                driven: (Vec2::ZERO, 0.0),
                surface: surface.clone(),
                reach: frame.reach(),
                temperature: (thermal != Thermal::Adiabatic).then_some(solid.temperature),
                burns,
                is_free: solid.motion == Motion::Free,
                force: Vec2::ZERO,
                torque: 0.0,
                store: (thermal == Thermal::Conducting).then(|| Store::of(solid, surface)),
                velocity: Vec2::ZERO,
                spin: 0.0,
                left: 0.0,
                since: LONGEST_MOTION,
            };
            if let Some(before) = old.iter().find(|body| body.id == id) {
                body.move_from(before);
            }
            body.drive_to(time);
            self.place(body, bounds, near);
        }
        if self.free.is_some() || scene.has_free() {
            free::FreeBodies::set(self, scene, time, bounds);
        }
    }

    /// Moves the solids that move by themselves to where they are at a time \[s\]. Each body and
    /// image keeps its index.
    pub fn advance(&mut self, time: f64) {
        for body in &mut self.bodies {
            body.drive_to(time);
        }
        if self.free.is_some() {
            free::FreeBodies::advance(self, time);
        }
    }

    /// Whether a solid moves by itself.
    pub fn any_moves(&self) -> bool {
        let mut all = self.bodies.iter();
        all.any(|body| body.is_free || body.drive.is_some())
    }

    /// Updates the images beyond periodic edges of solids that move by themselves.
    pub fn renew_images(&mut self, bounds: &Bounds, near: f32) {
        if (bounds.periodic_x || bounds.periodic_y) && self.any_moves() {
            self.place_anew(bounds, near);
        }
    }

    fn place_anew(&mut self, bounds: &Bounds, near: f32) {
        let spare = std::mem::take(&mut self.spare);
        let mut old = std::mem::replace(&mut self.bodies, spare);
        for body in old.drain(..) {
            if body.image == Vec2::ZERO {
                self.place(body, bounds, near);
            }
        }
        self.spare = old;
    }

    /// Heats the bodies that conduct heat by what came in a step. Around them is air of that
    /// temperature \[K\].
    pub fn warm(&mut self, dt: f32, air: f32) {
        // A body and its images follow each other, and have one temperature.
        for parts in self.bodies.chunk_by_mut(|body, next| body.id == next.id) {
            let Some((store, temperature)) = parts[0].heated() else {
                continue;
            };
            let mut inflow = Inflow::default();
            for part in parts.iter_mut().filter_map(|body| body.store.as_mut()) {
                inflow.join(std::mem::take(&mut part.inflow));
            }
            let temperature = store.warmed(temperature, inflow, dt, air);
            for body in parts {
                body.temperature = Some(temperature);
            }
        }
    }

    /// The ids of the bodies that conduct heat, and their temperatures \[K\].
    pub fn temperatures(&self) -> impl Iterator<Item = (u32, f32)> {
        let bodies = self.bodies.chunk_by(|body, next| body.id == next.id);
        bodies.filter_map(|parts| {
            let body = parts.first()?;
            Some((body.id, body.heated()?.1))
        })
    }

    /// The body on whose surface a source is, and its images; none if the source is a line.
    pub fn parts(&self, source: &SceneSource<'_>) -> &[Body] {
        let mut bodies = self.bodies.chunk_by(|body, next| body.id == next.id);
        let id = source.solid_id();
        bodies
            .find(|parts| parts.first().map(|body| body.id) == id)
            .unwrap_or_default()
    }

    /// Sets the temperatures of the bodies that conduct heat, in their order \[K\].
    pub fn set_temperatures(&mut self, all: &[f32]) {
        let bodies = self.bodies.chunk_by_mut(|body, next| body.id == next.id);
        let conducting = bodies.filter(|parts| parts[0].heated().is_some());
        for (parts, &temperature) in conducting.zip(all) {
            for body in parts {
                body.temperature = Some(temperature);
            }
        }
    }

    /// Ends the motions by a caller whose time has passed, and lets the gas accelerate free solids.
    pub fn end_motions(&mut self, dt: f32) {
        for body in &mut self.bodies {
            body.since += dt;
            body.left -= dt;
            if body.left <= 0.0 {
                (body.velocity, body.spin) = (Vec2::ZERO, 0.0);
            }
        }
        if self.free.is_some() {
            free::FreeBodies::apply_gas_forces(self, dt);
        }
    }

    /// Boils water of a mass [kg/m] off a solid at its boiling point \[K\], which takes so much heat `each`
    /// [kJ/kg]. Returns the mass that boils. One of a fixed temperature does not cool.
    pub fn boil(&mut self, id: u32, mass: f32, each: f32, boiling: f32) -> f32 {
        let mut boiled = 0.0;
        for body in self.bodies.iter_mut().filter(|body| body.id == id) {
            let Some(kelvin) = body.temperature.filter(|kelvin| *kelvin > boiling) else {
                continue;
            };
            boiled = mass;
            if let Some(store) = &body.store {
                boiled = fast_min(mass, store.heat_above(kelvin, boiling) / each);
                body.temperature = Some(store.cooled(kelvin, boiled * each));
            }
        }
        boiled
    }

    /// The first body of a solid.
    pub fn first(&self, id: u32) -> Option<&Body> {
        self.bodies.iter().find(|body| body.id == id)
    }

    /// Gives the bodies of a solid a sampled surface around the same centre.
    pub fn reshape(&mut self, id: u32, field: &Arc<Field>) {
        for body in self.bodies.iter_mut().filter(|body| body.id == id) {
            for frame in [&mut body.rest, &mut body.surface.frame] {
                (frame.half, frame.radius) = (field.half, 0.0);
            }
            body.reach = body.rest.reach();
            body.surface.field = Some(field.clone());
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Whether a position is nearer to a solid than this, or inside.
    pub fn touch(&self, position: Vec2, distance: f32) -> bool {
        let mut near = self.bodies.iter();
        near.any(|body| {
            body.may_touch(position, distance) && body.surface.distance(position).0 < distance
        })
    }

    /// The distance of a position from the nearest solid \[m\], at most `farthest`.
    pub fn nearest(&self, position: Vec2, farthest: f32) -> f32 {
        self.bodies.iter().fold(farthest, |nearest, body| {
            if body.may_touch(position, nearest) {
                fast_min(body.surface.distance(position).0, nearest)
            } else {
                nearest
            }
        })
    }

    /// The place nearest to a position with this `gap` to every solid and, on a floor, to that;
    /// `None` for a position deeper than `depth` in a solid or, with a negative one, nearer than
    /// that, and where solids leave no place.
    pub fn outside(&self, position: Vec2, gap: f32, depth: f32, floor: bool) -> Option<Vec2> {
        let mut place = position;
        for _ in 0..ATTEMPTS {
            // Two that push against each other may return it to the same place.
            let mut pushed = false;
            for body in &self.bodies {
                if body.may_touch(place, fast_max(gap, -depth)) {
                    let (distance, normal) = body.surface.distance(place);
                    if distance < -depth {
                        return None;
                    }
                    if distance < ROUNDED_GAP * gap {
                        place += normal * (gap - distance);
                        pushed = true;
                    }
                }
            }
            if floor && place.y < ROUNDED_GAP * gap {
                place.y = gap;
                pushed = true;
            }
            if !pushed {
                return Some(place);
            }
        }
        None
    }
}

impl Body {
    /// Moves it from its box in the scene to where it is at a time \[s\] by itself.
    fn drive_to(&mut self, time: f64) {
        if let Some(drive) = &self.drive {
            let driven = drive.at(&self.rest, time);
            self.surface.frame = driven.frame;
            self.surface.frame.centre += self.image;
            self.driven = (driven.velocity, driven.spin);
        }
    }

    /// Continues from the same solid before a change.
    fn move_from(&mut self, before: &Body) {
        if let (Some((now, _)), Some((then, temperature))) = (self.heated(), before.heated())
            && now.first == then.first
        {
            self.temperature = Some(temperature);
        }
        let path = self.rest.centre - before.rest.centre;
        let turn = self.angle - before.angle;
        // The shorter way round.
        let turn = turn - 2.0 * PI * (turn / (2.0 * PI) + 0.5).floor();
        (self.velocity, self.spin) = (before.velocity, before.spin);
        (self.left, self.since) = (before.left, before.since);
        if path == Vec2::ZERO && turn == 0.0 {
            return;
        }
        if self.since > 0.0 {
            // Another motion begins.
            let span = fast_min(fast_max(self.since, SHORTEST_MOTION), LONGEST_MOTION);
            (self.velocity, self.spin) = (Vec2::ZERO, 0.0);
            (self.left, self.since) = (span, 0.0);
        }
        self.velocity += path / self.left;
        self.spin += turn / self.left;
    }
}

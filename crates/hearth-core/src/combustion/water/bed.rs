//! Water in the bed of a source.
//!
//! A source stands for what burns there, so water that lands in it wets that. The wet share gives off no
//! fuel and is not preheated. A part of what lands on the rest boils at once. The bed dries by the share of
//! its own power that a fire returns to its fuel, or by what it receives of the radiation of all gas if that is more. Less
//! water than that weakens a source, which recovers; a source that is wet throughout has no power left to dry,
//! and stays out until another flame dries it.

use std::f32::consts::{FRAC_1_PI, PI};

use glam::Vec2;

use super::around::Around;
use crate::combustion::fuels::{
    BOILING, IgnitionTarget, MAX_RECEIVED_SHARE, VAPORISATION, WATER_CAPACITY, reach,
};
use crate::combustion::reaction::burner::Burner;
use crate::combustion::reaction::chemistry::{HEAT_CAPACITY, radiative_loss};
use crate::extremes::{fast_max, fast_min};
use crate::random::Random;
use crate::scene::{Scene, SceneSource};
use crate::solids::{Body, Solids};

/// Water that wets a surface throughout [kg/m²]: a film of a quarter of a millimetre.
const FILM_MASS: f32 = 0.25;
/// Share of its power that a fire returns to its fuel: the heat of gasification of wood over its heat of
/// combustion, 1.8 of 17.5 MJ/kg (Tewarson 2002, table 3-4.7).
const RETURNED_SHARE: f32 = 0.1;
/// Places of a bed at which a solid may touch it.
const PLACES: u8 = 9;

/// Share of the water that boils at once where it lands on what is not wet: what burns there is hot.
const BOILING_SHARE: f32 = 0.4;

/// The bed of a source.
#[derive(Clone, Debug, Default)]
pub(super) struct Bed {
    /// Water in it, and water that wets it throughout [kg/m].
    pub water: f32,
    full: f32,
    /// IgnitionTarget it is; `None` on a solid.
    burner: Option<Burner>,
    /// The solid that it is on, and a place of that \[m\].
    solid: Option<u32>,
    centre: Vec2,
    /// Feeding that is due.
    due: f32,
}

crate::state! { Bed: water full burner solid centre due }

impl Bed {
    /// Follows a source. One of another size is another source. Returns the water that it does not take
    /// over [kg/m].
    pub(super) fn follow(
        &mut self,
        source: &SceneSource<'_>,
        scene: &Scene,
        solids: &Solids,
    ) -> f32 {
        let before = self.full;
        let on_solid = scene.solid_of(source);
        self.solid = source.solid_id();
        match on_solid {
            // Without power nothing burns there.
            _ if source.power <= 0.0 => {
                (self.full, self.burner, self.solid) = (0.0, None, None);
            }
            Some((_, surface)) => {
                let (_, circumference) = surface.measures();
                (self.full, self.burner) = (FILM_MASS * circumference, None);
                let body = self.solid.and_then(|solid| solids.first(solid));
                let surface = body.map_or(surface, |body| &body.surface);
                self.centre = surface.frame.centre;
            }
            None => {
                let burner = Burner::of(source);
                self.full = FILM_MASS * 2.0 * burner.half_width;
                self.centre = Vec2::new(burner.middle, burner.bottom);
                self.burner = Some(burner);
            }
        }
        if self.full == before {
            return 0.0;
        }
        std::mem::take(&mut self.water)
    }

    /// Whether it feeds in this step.
    pub(super) fn feeds(&mut self) -> bool {
        self.due += 1.0 - self.wet();
        let feeds = self.due >= 1.0;
        if feeds {
            self.due -= 1.0;
        }
        feeds
    }

    /// The share of it that is wet.
    fn wet(&self) -> f32 {
        fast_min(self.water / fast_max(self.full, 1e-6), 1.0)
    }

    /// Dries it by its own fire and by any other. Returns the steam [kg/m].
    pub(super) fn dry(&mut self, source: &SceneSource<'_>, around: &Around) -> f32 {
        if self.water <= 0.0 {
            return 0.0;
        }
        let air = around.values.ambient_temperature;
        let warming = WATER_CAPACITY * fast_max(BOILING - air, 0.0);
        let wet = self.wet();
        let own = RETURNED_SHARE * source.power * (1.0 - wet);
        let power = fast_max(own, wet * self.received(around));
        let steam = fast_min(power * around.dt / (warming + VAPORISATION), self.water);
        self.water -= steam;
        steam
    }

    /// Radiation of the gas that reaches it [kW/m], as a solid gets it: of a length l at the distance r the
    /// share l cos θ/(2πr), where a solid is as wide as its circumference over π.
    fn received(&self, around: &Around) -> f32 {
        let gas = &*around.gas;
        let length = self.full / FILM_MASS;
        let mut sum = 0.0;
        for (&place, state) in gas.position.iter().zip(&gas.state) {
            let path = place - self.centre;
            let distance = fast_max(path.length(), 1e-6);
            let seen = match &self.burner {
                Some(burner) => length * burner.axis().perp_dot(path) / distance,
                None => length * FRAC_1_PI,
            };
            let share = seen / (2.0 * PI * distance);
            let share = fast_min(fast_max(share, 0.0), MAX_RECEIVED_SHARE);
            sum += share * radiative_loss(state.x, around.values);
        }
        gas.mass * HEAT_CAPACITY * sum
    }

    /// The bodies of the solid that it is on.
    fn bodies<'a>(&self, solids: &'a Solids) -> impl Iterator<Item = &'a Body> {
        let solid = self.solid;
        let all = solids.bodies.iter();
        all.filter(move |body| Some(body.id()) == solid)
    }

    /// A mass of its steam in relation to what wets it, for pictures.
    pub(super) fn relative(&self, steam: f32) -> f32 {
        const PUFFS_PER_FILM: f32 = 200.0;
        PUFFS_PER_FILM * steam / fast_max(self.full, 1e-6)
    }

    /// A place in it.
    pub(super) fn somewhere(&self, random: &mut Random) -> Vec2 {
        match &self.burner {
            Some(burner) => {
                let across = burner.half_width * random.between(-1.0, 1.0);
                self.centre + burner.axis() * across
            }
            None => self.centre,
        }
    }

    /// Takes a mass of water [kg/m]. Returns the steam of what its hot part boils at once, and the rest.
    pub(super) fn take(&mut self, mass: f32) -> (f32, f32) {
        let steam = BOILING_SHARE * (1.0 - self.wet()) * mass;
        let taken = fast_min(fast_max(self.full - self.water, 0.0), mass - steam);
        self.water += taken;
        // Exact, so that a full bed is wet throughout.
        if self.full - self.water < 1e-4 * self.full {
            self.water = fast_max(self.water, self.full);
        }
        (steam, mass - steam - taken)
    }

    /// Whether it is on that solid or, if it is not on a solid, at that place of one.
    pub(super) fn is_at(&self, solid: u32, place: Vec2) -> bool {
        match &self.burner {
            Some(burner) => burner.is_beside(place),
            None => self.solid == Some(solid),
        }
    }

    /// Whether it is near that place, or at that solid or a solid near that place: a log that is lit in a
    /// source lights it.
    pub(super) fn is_there(&self, at: IgnitionTarget, solids: &Solids) -> bool {
        let mut bodies = solids.bodies.iter();
        match at {
            IgnitionTarget::Object(id) => bodies.any(|body| body.id() == id && self.touches(body)),
            IgnitionTarget::Place(place, radius) => {
                let radius = reach(radius);
                self.distance(place, solids) < radius
                    || bodies
                        .any(|body| body.surface.distance(place).0 < radius && self.touches(body))
            }
        }
    }

    /// Distance of a place from it \[m\].
    fn distance(&self, place: Vec2, solids: &Solids) -> f32 {
        let Some(burner) = &self.burner else {
            let distances = self
                .bodies(solids)
                .map(|body| body.surface.distance(place).0);
            return distances.fold(f32::MAX, fast_min);
        };
        let (offset, axis) = (place - self.centre, burner.axis());
        let half = burner.half_width;
        let across = fast_max(-half, fast_min(offset.dot(axis), half));
        (offset - axis * across).length()
    }

    /// Whether it is on that body, or a flame of that reaches it.
    fn touches(&self, body: &Body) -> bool {
        let Some(burner) = &self.burner else {
            return self.solid == Some(body.id());
        };
        (0..PLACES).any(|index| {
            let across = 2.0 * f32::from(index) / f32::from(PLACES - 1) - 1.0;
            let place = self.centre + burner.axis() * (across * burner.half_width);
            body.surface.distance(place).0 < reach(0.0)
        })
    }

    /// The share of a path after which it enters the bed from above; `None` if it does not.
    pub(super) fn crossing(&self, from: Vec2, to: Vec2) -> Option<f32> {
        self.burner.as_ref()?.crossing(from, to)
    }
}

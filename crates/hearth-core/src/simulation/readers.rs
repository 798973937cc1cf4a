//! Readers of the particles: copies, in the order of birth.
//!
//! A reader of a quantity that only the combustion model has returns `None` in the classic model. A
//! list holds the things that there are, so it is empty where a model makes none.

use glam::Vec2;

use super::Simulation;
use crate::combustion::{Combustion, Ember, RemovedGas};
use crate::instance::Measured;
use crate::params::DisplayMode;
use crate::particle::Particle;
use crate::solids::free::FreeSolid;

impl Simulation {
    /// Power of the combustion in the last step [kW/m]; `None` in the classic model.
    pub fn power(&self) -> Option<f32> {
        self.solver.combustion().map(Combustion::power)
    }

    /// The gas that moved solids have taken the place of since the start; `None` in the classic
    /// model, whose particles only stop at solids.
    pub fn removed(&self) -> Option<RemovedGas> {
        self.solver.combustion().map(Combustion::removed)
    }

    /// The ids of the solids that conduct heat, and their temperatures \[K\]. No solid conducts
    /// heat in the classic model.
    pub fn solid_temperatures(&self) -> impl Iterator<Item = (u32, f32)> {
        let combustion = self.solver.combustion();
        combustion
            .into_iter()
            .flat_map(Combustion::solid_temperatures)
    }

    /// The solids that forces move, in the order of the objects, then what has broken off them.
    pub fn free_solids(&self) -> Vec<FreeSolid> {
        let free = self.solver.solids().free.as_ref();
        free.map_or_else(Vec::new, |free| free.seen())
    }

    /// Eleven numbers of each of the [free solids](Simulation::free_solids), for bindings: id, x and y of its
    /// place \[m\], cosine and sine of its angle, x and y of its velocity [m/s], spin [1/s], mass [kg/m],
    /// 1 if it sleeps, and the id of its object.
    pub fn free_solid_numbers(&self) -> Vec<f32> {
        let free = self.solver.solids().free.as_ref();
        free.map_or_else(Vec::new, |free| free.numbers())
    }

    /// Lower left and upper right corner of the rectangle that the gas can reach \[m\]: the
    /// domain or, with open edges, a larger one around that and [what is seen](Simulation::set_visible_area).
    pub fn extent(&self) -> [Vec2; 2] {
        let bounds = self.solver.bounds(self.parameters());
        let half = 0.5 * bounds.width;
        let top = bounds.bottom + bounds.height;
        [Vec2::new(-half, bounds.bottom), Vec2::new(half, top)]
    }

    /// The embers. The classic model makes none.
    pub fn embers(&self) -> &[Ember] {
        self.solver.combustion().map_or(&[], Combustion::embers)
    }

    /// Copies of all particles, in the order of birth.
    pub fn particles(&self) -> Vec<Particle> {
        let solver = &self.solver;
        self.each(|i| solver.particle(i, self.time))
    }

    /// The ids of the particles, in the order of birth. An id stays the same from step to step.
    /// Ids start again at 0 for particles that are put in and for a resampled fire.
    pub fn ids(&self) -> Vec<u64> {
        self.each(|i| self.solver.id(i))
    }

    /// Positions \[m\], in the order of birth.
    pub fn positions(&self) -> Vec<Vec2> {
        self.vectors(|particle| particle.position)
    }

    /// Velocities [m/s], in the order of birth.
    pub fn velocities(&self) -> Vec<Vec2> {
        self.vectors(|particle| particle.velocity)
    }

    /// Temperatures \[K\], in the order of birth.
    pub fn temperatures(&self) -> Vec<f32> {
        self.scalars(|particle| particle.temperature)
    }

    /// Times since birth \[s\], in the order of birth; the gas of the combustion model is as old
    /// as the fire.
    pub fn ages(&self) -> Vec<f32> {
        self.scalars(|particle| particle.age)
    }

    /// Densities [kg/m³] as the last step found them, in the order of birth.
    pub fn densities(&self) -> Vec<f32> {
        self.each(|i| self.solver.density(i))
    }

    /// Pressures \[Pa\] as the last step found them, in the order of birth; in the
    /// combustion model above the mean of the domain.
    pub fn pressures(&self) -> Vec<f32> {
        self.each(|i| self.solver.pressure(i))
    }

    /// Fuel \[share of the gas\], in the order of birth; `None` in the classic model.
    pub fn fuels(&self) -> Option<Vec<f32>> {
        self.of_mixture(|particle| particle.fuel)
    }

    /// Oxygen \[share of that of air\], in the order of birth; `None` in the classic model.
    pub fn oxygens(&self) -> Option<Vec<f32>> {
        self.of_mixture(|particle| particle.oxygen)
    }

    /// Soot, in the order of birth; `None` in the classic model.
    pub fn soots(&self) -> Option<Vec<f32>> {
        self.of_mixture(|particle| particle.soot)
    }

    /// Fuel burnt in a second [1/s] in the last step, in the order of birth; `None` in the classic
    /// model.
    pub fn burn_rates(&self) -> Option<Vec<f32>> {
        let combustion = self.solver.combustion()?;
        Some(self.each(|i| combustion.gas().burn[i]))
    }

    /// Vorticities [1/s], counterclockwise above zero, in the order of birth: twice the angular
    /// velocity of the present neighbours around each particle.
    pub fn vorticities(&self) -> Vec<f32> {
        self.measured(DisplayMode::Vorticity)
    }

    /// Number of present neighbours of each particle within 2h, in the order of birth.
    pub fn neighbour_counts(&self) -> Vec<u32> {
        let counts = self.measured(DisplayMode::Neighbours).into_iter();
        counts.map(|count| count as u32).collect()
    }

    fn measured(&self, mode: DisplayMode) -> Vec<f32> {
        let mut all = Vec::new();
        self.write_measured(mode, &mut all);
        self.each(|i| Measured::from(all[i]).value)
    }

    fn of_mixture(&self, of: fn(&Particle) -> f32) -> Option<Vec<f32>> {
        self.solver.combustion()?;
        Some(self.scalars(of))
    }

    fn scalars(&self, of: fn(&Particle) -> f32) -> Vec<f32> {
        self.particles().iter().map(of).collect()
    }

    fn vectors(&self, of: fn(&Particle) -> Vec2) -> Vec<Vec2> {
        self.particles().iter().map(of).collect()
    }

    fn each<T>(&self, of: impl Fn(usize) -> T) -> Vec<T> {
        self.solver.by_id().into_iter().map(of).collect()
    }
}

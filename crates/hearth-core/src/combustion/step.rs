//! A step of the combustion model.

use glam::Vec2;

use super::gas::pair::Context;
use super::gas::{forces, number_density, seam, time_step};
use super::reaction::burner::Burner;
use super::reaction::chemistry;
use super::reaction::embers::Air;
use super::water::Water;
use super::{Combustion, sound_speed};
use crate::forces::BodyForce;
use crate::kernel::Kernel;
use crate::params::Physics;
use crate::random::Random;
use crate::report::Stage;
use crate::scene::Scene;

impl Combustion {
    /// Makes one step from `time`, with the force `user` besides the model's own. Returns its
    /// length \[s\].
    pub(super) fn make_step(
        &mut self,
        scene: &Scene,
        random: &mut Random,
        time: f64,
        user: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f32 {
        let parameters = scene.settings();
        let values: &Physics = parameters;
        let kernel = Kernel::new(parameters.smoothing_length());
        let sound = sound_speed(values, self.total_power(scene));
        let bounds = self.present_bounds(values);
        let gas = &mut self.gas;
        let mut open = self.open.as_deref_mut();

        self.solids.renew_images(&bounds, kernel.support());
        if let Some(open) = &mut open {
            open.exchange_gas(gas, scene, &self.solids, self.length);
        }
        let (walls, solids) = (&mut self.walls, &mut self.solids);
        let grid = &mut self.grid;
        let positions = gas.position.iter().copied();
        let new_indices = grid.sort(positions, &bounds, kernel.support());
        gas.reorder(new_indices);
        on_stage(Stage::Sort);
        let context = Context {
            kernel: &kernel,
            values,
            sound,
            artificial_viscosity: time_step::artificial_viscosity(gas, values, sound),
            mass: gas.mass,
        };
        let neighbours = &mut self.neighbours;
        let has_floor = open.as_ref().is_some_and(|open| open.has_floor());
        walls.find(gas, grid, solids, has_floor, &kernel);
        let number_density = &mut self.number_density;
        let mean = number_density.sum(gas, grid, neighbours, &context, (walls, solids));
        let reference = match &open {
            None => mean,
            Some(_) => values.ambient_density,
        };
        walls.add_number_density(gas, reference);
        number_density::apply(gas, reference, sound);
        if let Some(open) = &mut open {
            open.find_rim(gas);
            open.taper_pressure(gas);
        }
        on_stage(Stage::Density);
        self.interactions.sum(gas, grid, neighbours, &context);
        walls.resist(gas, solids, &context);
        if let Some(open) = &open {
            open.remove_outward_shift(gas);
        }
        let (packed, strength) = (self.interactions.packed(), values.vorticity_confinement);
        let confinement = &mut self.vorticity_confinement;
        confinement.add(gas, grid, neighbours, packed, &kernel, strength);
        forces::add_all(gas, values, time, user);
        on_stage(Stage::Forces);

        let dt = time_step::max_stable_step(gas, &context);
        let air = Air {
            gas,
            grid: &self.grid,
            bounds: &bounds,
            kernel: &kernel,
            wind: Vec2::new(values.wind, 0.0),
            solids,
        };
        self.embers.drift(&air, values, random, dt);
        self.motion = time_step::accelerate(gas, sound, dt);
        if let Some(open) = &open {
            open.relax_rim_velocity(gas, dt);
        }
        let film = match &mut self.fuels {
            Some(fuels) => {
                let around = (open.as_deref_mut(), &mut *solids);
                fuels.burn((gas, walls), around, &mut self.embers, values, random, dt)
            }
            None => 0.0,
        };
        let hottest = scene.sources().map(|source| source.source_temperature);
        self.power = film + chemistry::react(gas, values, hottest.fold(0.0, f32::max), dt);
        self.preheat = 0.0;
        for (index, source) in scene.sources().enumerate() {
            let feeds = |water: &mut Box<Water>| water.feeds(index);
            if self.water.as_mut().is_none_or(feeds)
                && let Some(burner) = Burner::new(source, parameters.spacing())
            {
                let solid = solids.parts(source);
                self.preheat +=
                    burner.feed(gas, source, (time, dt), solid, &mut self.burner_particles) / dt;
            }
        }
        if open.is_none() {
            seam::relax_to_air(gas, values, parameters.spacing(), dt);
        }
        let (h, max_speed) = (kernel.smoothing_length(), self.motion.max_speed);
        self.clamped_shifts = time_step::advance(gas, values.shifting, h, max_speed, dt);
        solids.advance(time + f64::from(dt));
        let stays = walls.hold(gas, solids, parameters.spacing(), dt);
        solids.warm(dt, values.ambient_temperature);
        solids.pass(dt);
        match &open {
            Some(open) => open.complete_volumes(gas, values.ambient_density),
            None => {
                for position in &mut gas.position {
                    *position = bounds.wrap(*position);
                }
            }
        }
        if self.water.is_some() {
            self.advance_water(scene, random, dt);
        }
        // Where it was, a solid may be now.
        if stays && self.solids.drive() {
            self.settle(values, parameters.spacing());
        }
        self.length = dt;
        on_stage(Stage::Integrate);
        dt
    }
}

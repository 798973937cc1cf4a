//! A step of the combustion model.

use glam::Vec2;

use super::gas::pair::Context;
use super::gas::time_step::{PART, PARTS};
use super::gas::{forces, number_density, time_step};
use super::reaction::embers::Air;
use super::water::Around;
use super::{Combustion, Obstacles, sound_speed};
use crate::bounds::Bounds;
use crate::forces::BodyForce;
use crate::kernel::Kernel;
use crate::params::Physics;
use crate::random::Random;
use crate::report::Stage;
use crate::scene::Scene;
use crate::time_step::fitted;

impl Combustion {
    /// Makes one step from `time`, with the force `user` besides the model's own, that ends when the time `left`
    /// has passed or before. Returns its length \[s\].
    pub(super) fn make_step(
        &mut self,
        scene: &Scene,
        random: &mut Random,
        (time, left): (f64, f64),
        user: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f32 {
        let values: &Physics = scene.world();
        let kernel = Kernel::new(values.smoothing_length());
        let sound = sound_speed(values, self.total_power(scene));
        let bounds = self.domain.bounds(values);

        self.exchange_air(scene, &bounds, &kernel);
        self.pairs.sort(&mut self.gas, &bounds, &kernel);
        on_stage(Stage::Sort);

        let context = Context::new(&self.gas, values, &kernel, sound);
        let mean = self.sum_number_density(&context);
        self.domain.find_rim(&self.gas);
        self.set_pressure(mean, &context);
        on_stage(Stage::Density);

        self.find_rolls(scene, &context);
        self.sum_interactions(&context);
        self.pairs.confine_vorticity(&mut self.gas, &context);
        forces::add_all(&mut self.gas, values, time, user);
        on_stage(Stage::Forces);

        let longest = time_step::max_stable_part(&self.gas, &context) / PART;
        let dt = fitted(longest, left);
        let part = PART * dt;
        self.drift_embers(&bounds, &context, random, dt);
        self.burn_solids(scene, random, dt);
        for number in 0..PARTS {
            if number > 0 {
                self.obstacles.keep_outside(&mut self.gas, values, dt);
                self.renew_pressure(mean, &context);
            }
            self.accelerate(sound, part);
            self.reaction.burn(&mut self.gas, scene, number, part);
            let since = number as f64 * f64::from(part);
            self.feed_sources(scene, time + since, part);
            self.move_gas(&context, part);
        }
        let stays = self.move_solids(values, time + f64::from(dt), dt);
        self.domain.close(&mut self.gas, values);
        self.advance_water(scene, &bounds, &kernel, random, dt);
        if stays && self.obstacles.solids.any_moves() {
            self.displace_gas(values);
        }
        self.motion.length = dt;
        on_stage(Stage::Integrate);
        dt
    }

    fn exchange_air(&mut self, scene: &Scene, bounds: &Bounds, kernel: &Kernel) {
        let solids = &mut self.obstacles.solids;
        solids.renew_images(bounds, kernel.support());
        let since = self.motion.length;
        self.domain
            .exchange_gas(&mut self.gas, scene, solids, since);
    }

    /// Finds the walls and the neighbours. Returns the mean number density [kg/m³].
    fn sum_number_density(&mut self, context: &Context) -> f32 {
        let Obstacles { walls, solids, .. } = &mut self.obstacles;
        let (gas, has_floor) = (&mut self.gas, self.domain.has_floor());
        walls.find(gas, self.pairs.grid(), solids, has_floor, context.kernel);
        self.pairs.find_and_sum(gas, (walls, solids), context)
    }

    fn set_pressure(&mut self, mean: f32, context: &Context) {
        let reference = self.domain.reference_density(mean, context.values);
        self.obstacles
            .walls
            .add_number_density(&mut self.gas, reference);
        number_density::set_pressure(&mut self.gas, reference, context.sound);
        self.domain.taper_pressure(&mut self.gas);
    }

    /// Renews pressure and its forces where the gas is now, beside the same neighbours and walls.
    fn renew_pressure(&mut self, mean: f32, context: &Context) {
        self.pairs.sum_number_density(&mut self.gas, context);
        self.obstacles.walls.follow(&self.gas, context.kernel);
        self.set_pressure(mean, context);
        self.pairs.press(&mut self.gas, context);
        self.complete_press(context);
    }

    /// Adds the walls and the outside to the forces of the pressure.
    fn complete_press(&mut self, context: &Context) {
        self.obstacles.press(&mut self.gas, context);
        self.domain.remove_outward_shift(&mut self.gas);
    }

    /// Finds how the rolls of the fires mix, in some of the steps.
    fn find_rolls(&mut self, scene: &Scene, context: &Context) {
        if self.pairs.rolls.is_due() {
            let solids = &self.obstacles.solids;
            self.fires.find(scene, solids, self.fuels.as_deref());
            self.pairs.find_rolls(&mut self.gas, &self.fires, context);
        }
    }

    fn sum_interactions(&mut self, context: &Context) {
        self.pairs.interact(&mut self.gas, context);
        self.obstacles.resist(&mut self.gas, context);
        self.complete_press(context);
    }

    fn drift_embers(&mut self, bounds: &Bounds, context: &Context, random: &mut Random, dt: f32) {
        let air = Air {
            gas: &self.gas,
            grid: self.pairs.grid(),
            bounds,
            kernel: context.kernel,
            wind: Vec2::new(context.values.wind, 0.0),
            solids: &self.obstacles.solids,
        };
        self.reaction.embers.drift(&air, context.values, random, dt);
    }

    fn accelerate(&mut self, sound: f32, dt: f32) {
        self.motion.accelerate(&mut self.gas, sound, dt);
        self.domain.relax_rim_velocity(&mut self.gas, dt);
    }

    /// Burns the solids that have fuel.
    fn burn_solids(&mut self, scene: &Scene, random: &mut Random, dt: f32) {
        let gas = &mut self.gas;
        let film = self.fuels.as_mut().map_or(0.0, |fuels| {
            let Obstacles { walls, solids, .. } = &mut self.obstacles;
            let around = (self.domain.open_mut(), solids);
            let embers = &mut self.reaction.embers;
            fuels.burn((gas, walls), around, embers, scene.world(), random, dt)
        });
        self.reaction.begin(film);
    }

    /// Lets the sources feed the gas, those that are wet in a share of the steps.
    fn feed_sources(&mut self, scene: &Scene, time: f64, dt: f32) {
        let mut water = self.water.as_mut();
        let feeds = |index| water.as_mut().is_none_or(|water| water.feeds(index));
        let (gas, solids) = (&mut self.gas, &self.obstacles.solids);
        self.reaction.feed(gas, scene, solids, (time, dt), feeds);
    }

    fn move_gas(&mut self, context: &Context, dt: f32) {
        let Context { values, kernel, .. } = *context;
        self.domain.relax_seam(&mut self.gas, values, dt);
        let h = kernel.smoothing_length();
        self.motion.advance(&mut self.gas, values.shifting, h, dt);
    }

    /// Moves the solids to `time`, and the gas out of them. Returns whether gas has no place between them.
    fn move_solids(&mut self, values: &Physics, time: f64, dt: f32) -> bool {
        self.obstacles.advance(&mut self.gas, values, time, dt)
    }

    fn advance_water(
        &mut self,
        scene: &Scene,
        bounds: &Bounds,
        kernel: &Kernel,
        random: &mut Random,
        dt: f32,
    ) {
        let Some(water) = self.water.as_mut() else {
            return;
        };
        let around = Around {
            gas: &mut self.gas,
            grid: self.pairs.grid(),
            kernel,
            bounds,
            solids: &mut self.obstacles.solids,
            fuels: self.fuels.as_deref_mut(),
            has_floor: self.domain.has_floor(),
            values: scene.world(),
            dt,
            near: Vec::new(),
        };
        water.advance(scene, around, random);
    }
}

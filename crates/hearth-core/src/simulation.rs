//! stub (the physics is being written; signatures are final)
use crate::params::{Input, ParamError, Parameters};
use glam::Vec2;

/// One particle as the renderer gets it: x, y [m], vx, vy [m/s], temperature
/// [K], density [kg/m³], age [s], remaining life [0–1].
pub type Instance = [f32; 8];

/// What the last step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Parts the step was divided into.
    pub substeps: u32,
    /// Neighbours of a particle within 2h, on average.
    pub mean_neighbours: f32,
    /// Most neighbours of one particle.
    pub most_neighbours: u32,
    /// Particles at the speed limit.
    pub at_speed_limit: u32,
    /// Fastest particle [m/s].
    pub fastest: f32,
}

/// A fire.
pub struct Simulation {
    parameters: Parameters,
    time: f64,
}

#[allow(missing_docs)]
impl Simulation {
    pub fn new(parameters: Parameters) -> Simulation {
        Simulation { parameters, time: 0.0 }
    }
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }
    pub fn set(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        self.parameters.set(id, input)
    }
    pub fn set_parameters(&mut self, parameters: Parameters) {
        self.parameters = parameters;
    }
    pub fn reset(&mut self) {
        self.time = 0.0;
    }
    pub fn step(&mut self) {
        self.time += f64::from(self.parameters.time_step);
    }
    pub fn time(&self) -> f64 {
        self.time
    }
    pub fn count(&self) -> usize {
        300
    }
    pub fn report(&self) -> StepReport {
        StepReport::default()
    }
    /// stub: a fake flame, so that there is something to draw
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.clear();
        let h = |n: u32| (n.wrapping_mul(2654435761) >> 8) as f32 / 16777216.0;
        for i in 0..700u32 {
            let life = 0.4 + 0.6 * h(i);
            let age = ((self.time as f32 + h(i + 9999)) / life).fract() * life;
            let y = age * (0.8 + 0.5 * h(i + 77));
            let x = (h(i + 555) - 0.5) * 0.2 * (1.0 - 0.6 * age / life);
            out.push([x, y, 0.0, 1.2, 1900.0 - 900.0 * age, 0.8, age, 1.0 - age / life]);
        }
    }
    pub fn positions(&self) -> Vec<Vec2> {
        vec![]
    }
}

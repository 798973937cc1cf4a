//! The report of a step, and the stages of a step.

/// A report of the last step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Number of substeps; two parts in the combustion model, which are as long as is stable.
    pub substeps: u32,
    /// Mean number of neighbours of a particle, within 2h.
    pub mean_neighbours: f32,
    /// Largest number of neighbours of one particle.
    pub max_neighbours: u32,
    /// Particles that the speed limit slowed down in the last substep.
    pub speed_limited: u32,
    /// Particles whose motion a limit clamped: the speed limit or, in the combustion model,
    /// the largest displacement by shifting.
    pub clamped: u32,
    /// Largest speed of a particle [m/s].
    pub max_speed: f32,
    /// Length of the step \[s\].
    pub length: f32,
    /// Power of the combustion [kW/m]; `None` in the classic model.
    pub power: Option<f32>,
    /// Power that heated the gas of the source, besides that of the combustion [kW/m]; `None` in
    /// the classic model.
    pub preheat: Option<f32>,
    /// Share of the air around the fire that is left out, because `max_particles` are reached;
    /// `None` without open edges.
    pub asleep: Option<f32>,
}

/// The stages of a step, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Births and sorting.
    Sort,
    /// Neighbour search and density.
    Density,
    /// Pair interactions and, in the combustion model, body forces.
    Forces,
    /// Motion, combustion, sources and open edges.
    Integrate,
}

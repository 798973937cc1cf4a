//! The solver of the present model. Features of one model are an `Option` here.

use std::ops::{Deref, DerefMut};

use crate::classic::Classic;
use crate::combustion::Combustion;
use crate::params::Model;
use crate::random::Random;
use crate::scene::Scene;
use crate::solver::Solver;

/// The solver of either model.
// A simulation has one, so its size does not matter.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug)]
pub(super) enum AnySolver {
    Classic(Classic),
    Combustion(Combustion),
}

impl Deref for AnySolver {
    type Target = dyn Solver;

    fn deref(&self) -> &Self::Target {
        match self {
            AnySolver::Classic(solver) => solver,
            AnySolver::Combustion(solver) => solver,
        }
    }
}

impl DerefMut for AnySolver {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            AnySolver::Classic(solver) => solver,
            AnySolver::Combustion(solver) => solver,
        }
    }
}

impl AnySolver {
    /// The solver at the start of a fire.
    pub fn new(scene: &Scene, random: &mut Random) -> AnySolver {
        match scene.world().model() {
            Model::Classic => AnySolver::Classic(Classic::new(scene)),
            Model::Combustion => AnySolver::Combustion(Combustion::new(scene, random)),
        }
    }

    pub fn model(&self) -> Model {
        match self {
            AnySolver::Classic(_) => Model::Classic,
            AnySolver::Combustion(_) => Model::Combustion,
        }
    }

    /// The solver of the combustion model, if that is the present one.
    pub fn combustion(&self) -> Option<&Combustion> {
        match self {
            AnySolver::Combustion(solver) => Some(solver),
            AnySolver::Classic(_) => None,
        }
    }

    /// The solver of the combustion model, if that is the present one.
    pub fn combustion_mut(&mut self) -> Option<&mut Combustion> {
        match self {
            AnySolver::Combustion(solver) => Some(solver),
            AnySolver::Classic(_) => None,
        }
    }
}

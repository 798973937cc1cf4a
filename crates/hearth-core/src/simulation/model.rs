//! The solver of the present model. Features of one model are an `Option` here.

use crate::classic::Classic;
use crate::combustion::Combustion;
use crate::params::Model;
use crate::random::Random;
use crate::scene::Scene;
use crate::solver::Either;

/// The solver of either model.
pub(super) type AnySolver = Either<Classic, Combustion>;

impl AnySolver {
    /// The solver at the start of a fire.
    pub fn new(scene: &Scene, random: &mut Random) -> AnySolver {
        match scene.settings().model() {
            Model::Classic => Either::Classic(Classic::new(scene)),
            Model::Combustion => Either::Combustion(Combustion::new(scene, random)),
        }
    }

    pub fn model(&self) -> Model {
        match self {
            Either::Classic(_) => Model::Classic,
            Either::Combustion(_) => Model::Combustion,
        }
    }

    /// The solver of the combustion model, if that is the present one.
    pub fn combustion(&self) -> Option<&Combustion> {
        match self {
            Either::Combustion(solver) => Some(solver),
            Either::Classic(_) => None,
        }
    }

    /// The solver of the combustion model, if that is the present one.
    pub fn combustion_mut(&mut self) -> Option<&mut Combustion> {
        match self {
            Either::Combustion(solver) => Some(solver),
            Either::Classic(_) => None,
        }
    }
}

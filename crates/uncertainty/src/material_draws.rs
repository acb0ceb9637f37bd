//! Bodies drawn anew. No scene can say yet how well its material is known, so that nothing of them is.

use rand_chacha::rand_core::Rng;
use study::models::CurveModel;
use study::scene::Scene;

use crate::group::Group;

/// What there is to draw bodies from.
#[derive(Debug)]
pub(crate) struct MaterialDraws;

/// The bodies of a draw.
pub(crate) struct DrawnMaterial;

impl MaterialDraws {
    pub fn of(_: &Scene) -> Option<Self> {
        None
    }

    /// Whether a group takes part.
    pub fn has(&self, _: Group) -> bool {
        false
    }

    pub fn draw(&self, _: &mut impl Rng, _: &mut impl Rng) -> DrawnMaterial {
        DrawnMaterial
    }
}

impl DrawnMaterial {
    pub fn of(&self, model: &CurveModel) -> CurveModel {
        *model
    }
}

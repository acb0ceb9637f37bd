//! Compliance of a specimen: how far the half-space sinks under it as a whole.

use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use units::named;

use crate::boundary::Boundary;
use crate::half_space::{Elements, HalfSpaceError};
use crate::outline::Outline;

/// Compliance of a specimen as a whole that is taken out of the stiffness of a contact with free edges.
///
/// Such a stiffness is the load per approach of two half-spaces, which sink under the nominal contact even where the surfaces are
/// smooth. A stiffness of the interface, as for a finite-element model of the bodies, is without that share.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SpecimenCompliance {
    /// Nothing is taken out.
    #[default]
    None,
    /// The approach of a rigid flat punch of the outline: the bodies behind the interface are stiff.
    Punch,
    /// The mean displacement under even pressure on the outline: the bodies behind the interface pass the load on evenly.
    Even,
}

named!(SpecimenCompliance, "compliance of the specimen", { None => "none", Punch => "punch", Even => "even" });

impl Outline {
    /// Returns the compliance of the specimen as a whole \[m/Pa\]: the approach per nominal pressure, which is the force over the
    /// area of the specimen. 0 of a periodic map, whose displacements have a mean of 0.
    ///
    /// It is computed with the elements of the contact itself, so that their errors at the edges (1 to 2 % for a punch 100 points
    /// across) are the same in both and cancel in the difference.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a modulus out of bounds, and if `progress` cancels.
    pub fn compliance_m_per_pa(
        &self,
        kind: SpecimenCompliance,
        contact_modulus_pa: f64,
        progress: &dyn Progress,
    ) -> Result<f64, HalfSpaceError> {
        if kind == SpecimenCompliance::None || self.boundary == Boundary::Periodic {
            return Ok(0.0);
        }
        let inside: Vec<u32> = (0u32..)
            .zip(self.is_inside())
            .filter_map(|(point, is_inside)| is_inside.then_some(point))
            .collect();
        let mut flat = Elements::free(self.grid, &vec![0.0; self.grid.points()])?;
        let per_mean_of_frame = match kind {
            SpecimenCompliance::Even => flat.mean_displacement_m_per_pa(&inside, contact_modulus_pa)?,
            _ => 1.0 / flat.stiffness_together(&inside, contact_modulus_pa, progress)?,
        };
        Ok(self.share() * per_mean_of_frame)
    }
}

/// Takes the compliance of a specimen \[m/Pa\] out of the stiffness of its contact \[Pa/m\], both over the area of the specimen.
/// `None` if nothing is left: if all of the specimen touches, or if the contact is stiffer than the compliance allows.
#[must_use]
pub fn stiffness_without(compliance_m_per_pa: f64, stiffness_pa_per_m: f64) -> Option<f64> {
    let rest = 1.0 - compliance_m_per_pa * stiffness_pa_per_m;
    (rest > LEAST_REST).then(|| stiffness_pa_per_m / rest)
}

/// Share of the compliance of a contact below which the rest is no more than the errors of both, each 1e-8.
const LEAST_REST: f64 = 1e-6;

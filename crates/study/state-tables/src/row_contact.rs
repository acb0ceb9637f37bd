//! The contact of a row: asperities of one curvature, or the summits of a surface.

use asperity::{AsperityError, MaterialPair};
use stat_contact::{NayakSummits, Population, StatisticalContact};
use study::models::{ModelEntry, StatisticalLaw};

/// The three numbers of a row's roughness, in the order of [`Roughness::columns`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness(pub [f64; 3]);

impl Roughness {
    /// McCool's parameters, which most models take.
    pub const ASPERITIES: [&'static str; 3] = ["radius_m", "density_per_m2", "sigma_s_m"];

    /// The moments of profiles, which a model of the summits takes instead.
    pub const MOMENTS: [&'static str; 3] = ["m0_m2", "m2", "m4_per_m2"];

    /// The roughness columns of a model.
    #[must_use]
    pub fn columns(entry: &ModelEntry) -> [&'static str; 3] {
        if entry.takes_moments() { Self::MOMENTS } else { Self::ASPERITIES }
    }
}

/// The contact of a row, if its roughness allows one.
pub(crate) enum RowContact {
    Contact(StatisticalContact),
    /// No contact: no surface has a spectrum of this alpha.
    TooNarrow {
        alpha: f64,
    },
}

impl RowContact {
    pub fn new(
        pair: &MaterialPair,
        law: &StatisticalLaw,
        roughness: Roughness,
    ) -> Result<Self, AsperityError> {
        let [first, second, third] = roughness.0;
        match law {
            StatisticalLaw::Asperities(law) => {
                let population = Population::new(first, second, third)?;
                Ok(RowContact::Contact(StatisticalContact::new(pair, &population, law)))
            }
            StatisticalLaw::Summits => match NayakSummits::new(first, second, third) {
                Ok(summits) => Ok(RowContact::Contact(StatisticalContact::from_summits(pair, &summits))),
                Err(error) if error.bound == NayakSummits::ALPHA => {
                    Ok(RowContact::TooNarrow { alpha: error.value })
                }
                Err(error) => Err(error),
            },
        }
    }
}

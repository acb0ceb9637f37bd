//! What statistical states are asked at, and of which asperities.

use asperity::{AsperityError, MaterialPair};
use ordered_float::OrderedFloat;
use spectrum::AsperityParameters;
use stat_contact::{NayakSummits, Population, StatisticalContact};

use super::ground::Roughness;
use super::{Needs, NominalPressure};
use crate::models::StatisticalLaw;

/// What a state is asked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Condition {
    /// A nominal pressure \[Pa\].
    Pressure(OrderedFloat<f64>),
    /// A separation \[m\], of either sign.
    Separation(OrderedFloat<f64>),
}

impl Needs {
    /// All loads, and behind them the separations.
    pub(super) fn conditions(&self) -> impl Iterator<Item = Condition> + Clone {
        let separation = |&separation_m: &f64| Condition::Separation(OrderedFloat(separation_m));
        self.pressures().map(Condition::from).chain(self.separations_m.iter().map(separation))
    }

    /// How many conditions there are.
    pub(super) fn condition_count(&self) -> usize {
        self.load_count() + self.separations_m.len()
    }
}

impl From<NominalPressure> for Condition {
    fn from(pressure: NominalPressure) -> Self {
        Condition::Pressure(OrderedFloat(pressure.pa()))
    }
}

/// What a state depends on of the asperities: where these are the same, so are the moments, the summits and the states.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Asperities {
    radius_m: OrderedFloat<f64>,
    density_per_m2: OrderedFloat<f64>,
    sigma_s_m: OrderedFloat<f64>,
}

impl Asperities {
    pub fn of(parameters: &AsperityParameters) -> Self {
        Asperities {
            radius_m: OrderedFloat(parameters.radius_m),
            density_per_m2: OrderedFloat(parameters.density_per_m2),
            sigma_s_m: OrderedFloat(parameters.sigma_s_m),
        }
    }
}

/// The contact of what a law makes of a roughness, where its numbers are within what the law takes.
pub(crate) fn contact_of(
    pair: &MaterialPair,
    law: &StatisticalLaw,
    roughness: &Roughness,
) -> Result<Pressed, AsperityError> {
    let Roughness { moments, asperities } = roughness;
    match law {
        StatisticalLaw::Asperities(law) => {
            let population =
                Population::new(asperities.radius_m, asperities.density_per_m2, asperities.sigma_s_m)?;
            Ok(Pressed::Contact(StatisticalContact::new(pair, &population, law)))
        }
        StatisticalLaw::Summits => match NayakSummits::new(moments.m0_m2, moments.m2, moments.m4_per_m2) {
            Ok(summits) => Ok(Pressed::Contact(StatisticalContact::from_summits(pair, &summits))),
            Err(error) if error.bound == NayakSummits::ALPHA => Ok(Pressed::TooNarrow { alpha: error.value }),
            Err(error) => Err(error),
        },
    }
}

/// What there is to press.
pub(crate) enum Pressed {
    /// Asperities, or the summits of a surface.
    Contact(StatisticalContact),
    /// A spectrum narrower than that of any surface, of this alpha: it has no summits.
    TooNarrow { alpha: f64 },
}

//! Conditions of statistical states, and the asperities that they belong to.

use asperity::AsperityError;
use ordered_float::OrderedFloat;
use spectrum::AsperityParameters;
use stat_contact::Condition;

use super::Needs;
use super::distinct::Distinct;
use super::prepared_spectrum::Roughness;
use crate::models::{Pressable, Statistical, StatisticalLaw};

impl Needs {
    /// All loads, and behind them the separations.
    pub(super) fn conditions(&self) -> impl Iterator<Item = Condition> + Clone {
        let pressures = self.pressures().map(|pressure| Condition::Pressure(pressure.pa()));
        pressures.chain(self.separations_m.iter().copied().map(Condition::Separation))
    }

    /// Returns the number of conditions.
    pub(super) fn condition_count(&self) -> usize {
        self.load_count() + self.separations_m.len()
    }
}

/// Removes the repetitions of conditions.
pub(super) fn distinct(conditions: impl IntoIterator<Item = Condition>) -> Distinct<Condition> {
    Distinct::by_key(conditions, |condition| match *condition {
        Condition::Pressure(pressure_pa) => (true, OrderedFloat(pressure_pa)),
        Condition::Separation(separation_m) => (false, OrderedFloat(separation_m)),
    })
}

/// The asperity parameters that a state depends on: if these are equal, so are the moments, the summits and the states.
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

/// Returns the asperities of a roughness as a statistical model presses them.
///
/// # Errors
/// [`AsperityError`] for numbers out of the law's bounds.
pub(crate) fn contact_of(model: &Statistical, roughness: &Roughness) -> Result<Pressable, AsperityError> {
    let Roughness { moments, asperities } = roughness;
    model.press(match model.law {
        StatisticalLaw::Asperities(_) => {
            [asperities.radius_m, asperities.density_per_m2, asperities.sigma_s_m]
        }
        StatisticalLaw::Summits => [moments.m0_m2, moments.m2, moments.m4_per_m2],
    })
}

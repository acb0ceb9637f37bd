//! Conditions of statistical states, and the asperities that they belong to.

use asperity::AsperityError;
use ordered_float::OrderedFloat;
use spectrum::AsperityParameters;

use super::prepared_spectrum::Roughness;
use super::{Needs, NominalPressure};
use crate::models::{Pressable, Statistical, StatisticalLaw};

/// The condition of a state: a nominal pressure or a separation.
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

    /// Returns the number of conditions.
    pub(super) fn condition_count(&self) -> usize {
        self.load_count() + self.separations_m.len()
    }
}

impl Condition {
    /// Returns the nominal pressure \[Pa\], or nothing for a separation.
    pub fn pressure_pa(self) -> Option<f64> {
        match self {
            Condition::Pressure(pressure_pa) => Some(pressure_pa.0),
            Condition::Separation(_) => None,
        }
    }
}

impl From<NominalPressure> for Condition {
    fn from(pressure: NominalPressure) -> Self {
        Condition::Pressure(OrderedFloat(pressure.pa()))
    }
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

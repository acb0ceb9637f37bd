//! What statistical states are asked at, and of which asperities.

use asperity::AsperityError;
use ordered_float::OrderedFloat;
use spectrum::AsperityParameters;
use stat_contact::Population;

use super::{Needs, NominalPressure};

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

/// What a state depends on of the asperities: where these are the same, so are the states.
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

    /// The population that they are, where its numbers are within what the model takes.
    pub fn population(self) -> Result<Population, AsperityError> {
        Population::new(self.radius_m.0, self.density_per_m2.0, self.sigma_s_m.0)
    }
}

//! Conditions of statistical states.

use ordered_float::OrderedFloat;
use stat_contact::Condition;

use super::Needs;
use super::distinct::Distinct;

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

//! The cost of a plan, known before it is computed.

use ordered_float::OrderedFloat;

use super::distinct::Distinct;
use super::distinct_inputs::DistinctInputs;
use super::error::MOST_ROWS;
use super::{CurveModel, Cutoffs, Plan, PlanError};

impl Plan<'_> {
    /// Returns an upper bound of the number of statistical states that the plan takes.
    #[must_use]
    pub fn statistical_states(&self) -> usize {
        let inputs = DistinctInputs::new(&self.needs);
        let of_model = |(_, cutoffs): (&CurveModel, &Cutoffs)| {
            let cutoffs = if *cutoffs == Cutoffs::Every { self.most_scales() } else { 1 };
            cutoffs * inputs.conditions.items.len()
        };
        let models = inputs.models.items.iter().zip(&inputs.cutoffs);
        let statistical = models.filter(|(model, _)| model.statistical().is_some());
        let over_cutoffs: usize = statistical.map(of_model).sum();
        let over_loads = Distinct::of(self.needs.sweeps.iter().flat_map(|sweep| {
            let place = (inputs.models.index_of[sweep.curve], OrderedFloat(sweep.cutoff_multiple));
            sweep.pressures_pa.iter().map(move |&pressure_pa| (place, OrderedFloat(pressure_pa)))
        }));
        over_cutoffs + over_loads.items.len()
    }

    /// Returns an upper bound of the number of levels of stacks that the plan takes.
    #[must_use]
    pub fn stacked_levels(&self) -> usize {
        let inputs = DistinctInputs::new(&self.needs);
        let stacks = inputs.models.items.iter().filter(|model| model.stacked().is_some());
        stacks.map(|model| self.most_scales() * inputs.conditions_of(model).len()).sum()
    }

    /// Refuses more rows than can be held: scales, loads and curves multiply.
    pub(super) fn check_size(&self) -> Result<(), PlanError> {
        let (scales, loads) = (self.most_scales(), self.needs.condition_count());
        let curves = &self.needs.curves;
        let rows_of_curve = |cutoffs| match cutoffs {
            Cutoffs::Every => scales.saturating_mul(loads),
            Cutoffs::Shortest => loads,
        };
        let over_cutoffs = curves.iter().map(|curve| rows_of_curve(curve.cutoffs));
        let over_loads = self.needs.sweeps.iter().map(|sweep| sweep.pressures_pa.len());
        let rows = over_cutoffs.chain(over_loads).fold(0usize, usize::saturating_add);
        if rows > MOST_ROWS {
            return Err(PlanError::TooManyRows { curves: curves.len(), loads, scales, rows });
        }
        Ok(())
    }
}

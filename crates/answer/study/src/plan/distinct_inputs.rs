//! The inputs of a plan, each one once.

use stat_contact::Condition;

use super::condition::distinct;
use super::distinct::Distinct;
use super::{Curve, CurveModel, CurveResult, Cutoffs, Needs};

/// The distinct models of a plan and the distinct conditions at which they are computed. Equal models under equal
/// conditions are computed once; the curves and loads of the plan then find their rows by index.
pub(super) struct DistinctInputs {
    /// The models of the curves.
    pub models: Distinct<CurveModel>,
    /// The cutoffs at which each distinct model is needed.
    pub cutoffs: Vec<Cutoffs>,
    /// The loads, and behind them the separations.
    pub conditions: Distinct<Condition>,
    /// Number of the plan's conditions that are loads.
    loads: usize,
}

impl DistinctInputs {
    pub fn new(needs: &Needs) -> Self {
        let models = Distinct::compared(needs.curves.iter().map(|curve| curve.model.clone()));
        let cutoffs =
            (0..models.items.len()).map(|model| cutoffs_of(model, &models, &needs.curves)).collect();
        DistinctInputs {
            models,
            cutoffs,
            conditions: distinct(needs.conditions()),
            loads: needs.load_count(),
        }
    }

    /// Returns the distinct conditions that a model takes: loads, and separations if it has them.
    pub fn conditions_of(&self, model: &CurveModel) -> Vec<Condition> {
        let takes_separations = model.takes_separations();
        let conditions = self.conditions.items.iter().copied();
        conditions.filter(|condition| takes_separations || condition.pressure_pa().is_some()).collect()
    }

    /// Assembles the rows of every curve from those of each distinct model.
    pub fn handed_out(&self, rows_of_models: Vec<CurveResult>, curves: &[Curve]) -> Vec<CurveResult> {
        let mut handed_out: Vec<(usize, CurveResult)> = Vec::with_capacity(curves.len());
        for (model, rows) in rows_of_models.into_iter().enumerate() {
            let of_model: Vec<usize> =
                (0..curves.len()).filter(|&curve| self.models.index_of[curve] == model).collect();
            let index_of = match self.models.items[model].takes_separations() {
                true => &self.conditions.index_of[..],
                false => &self.conditions.index_of[..self.loads],
            };
            // The last of the curves takes the rows themselves, those before it copies.
            for (&curve, rows) in of_model.iter().zip(std::iter::repeat_n(rows, of_model.len())) {
                handed_out.push((curve, rows.repeated(index_of, curves[curve].cutoffs)));
            }
        }
        handed_out.sort_by_key(|(curve, _)| *curve);
        handed_out.into_iter().map(|(_, rows)| rows).collect()
    }
}

/// Returns the cutoffs of a model: every cutoff if one of its curves needs them.
fn cutoffs_of(model: usize, models: &Distinct<CurveModel>, curves: &[Curve]) -> Cutoffs {
    let mut of_model = curves.iter().zip(&models.index_of).filter(|(_, index)| **index == model);
    let followed = of_model.any(|(curve, _)| curve.cutoffs == Cutoffs::Every);
    if followed { Cutoffs::Every } else { Cutoffs::Shortest }
}

//! `stacked`: contact area against cutoff, scale upon scale.

use super::{Context, loads, material};
use crate::args::StackedArgs;
use crate::failure::Failure;
use crate::plan::{Curve, CurveModel, CurveResult, Cutoffs, Needs, Results};
use crate::{summary, tables};

pub(super) fn run(args: &StackedArgs, context: &Context<'_>) -> Result<(), Failure> {
    let material = material(&args.material, context)?;
    let gradient = args.material.strain_gradient_length.is_some();
    let model = CurveModel::Stacked(material.stacked(args.model, gradient).map_err(Failure::input)?);
    let needs = Needs {
        amplitudes: Some(context.shared.amplitude.unwrap_or_default()),
        curves: vec![Curve { name: "stacked".to_owned(), model, cutoffs: Cutoffs::Every }],
        loads: loads(&args.pressures, &material)?,
        ..Needs::default()
    };
    let table =
        |results: &Results, needs: &Needs| tables::curve(&results.curves[0], &needs.loads, args.details);
    context.spectrum_to_table(&args.psd.psd, &args.psd.reading, needs, table, notes)
}

fn notes(results: &Results) -> Vec<String> {
    let sampling = summary::sampling(results);
    let mut notes =
        vec![format!("{sampling}; the area depends on how densely scales are sampled (--scales-per-decade)")];
    if let CurveResult::Stacked(levels) = &results.curves[0] {
        notes.extend(summary::beyond_fitted_range(levels));
    }
    notes
}

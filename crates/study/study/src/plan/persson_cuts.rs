//! Persson's theory under loads.

use asperity::MaterialPair;
use persson::Cut;

use super::run::Run;
use super::{Cutoffs, Ground, Plan, PlanError};
use crate::persson_law::{PerssonLaw, roughness};

/// Computes a block of cuts for every nominal pressure \[Pa\].
pub(super) fn blocks(
    plan: &Plan<'_>,
    pair: &MaterialPair,
    law: &PerssonLaw,
    pressures_pa: &[f64],
    ground: &Ground,
    cutoffs: Cutoffs,
    run: Run<'_>,
) -> Result<Vec<Vec<Cut>>, PlanError> {
    let moments = ground.moments.iter().map(|(moments, _)| moments);
    let normalisation = plan.needs.moments.unwrap_or_default();
    let beyond = plan.beyond(&ground.psd, law.band);
    let roughness = roughness(&ground.psd, moments, normalisation, &ground.scales, &beyond, law.band);
    let model = law.model(pair)?;
    let separation = model.separation(&roughness, law.energy_factor);
    parallel::try_map(pressures_pa, |&pressure_pa| {
        run.go_on()?;
        let mut cuts = model.along(&roughness, &separation, pressure_pa)?;
        if cutoffs == Cutoffs::Shortest {
            cuts.drain(..cuts.len().saturating_sub(1));
        }
        Ok(cuts)
    })
}

//! Persson's theory under loads.

use asperity::MaterialPair;
use persson::Cut;
use persson::variance::Band;
use spectrum::Normalisation;

use super::run::Run;
use super::{Cutoffs, Ground, PlanError};
use crate::persson_law::{PerssonLaw, roughness};

/// A block of cuts for every nominal pressure \[Pa\].
pub(super) fn blocks(
    pair: &MaterialPair,
    law: &PerssonLaw,
    pressures_pa: &[f64],
    ground: &Ground,
    normalisation: Normalisation,
    cutoffs: Cutoffs,
    run: Run<'_>,
) -> Result<Vec<Vec<Cut>>, PlanError> {
    let moments = ground.moments.iter().map(|(moments, _)| moments);
    let psd = &ground.psd;
    let roughness = roughness(psd, moments, normalisation, &ground.scales, psd, Band::Profile);
    let model = law.model(pair)?;
    let separation = model.separation(&roughness, PerssonLaw::ENERGY_FACTOR);
    parallel::try_map(pressures_pa, |&pressure_pa| {
        run.go_on()?;
        let mut cuts = model.along(&roughness, &separation, pressure_pa)?;
        if cutoffs == Cutoffs::Shortest {
            cuts.drain(..cuts.len().saturating_sub(1));
        }
        Ok(cuts)
    })
}

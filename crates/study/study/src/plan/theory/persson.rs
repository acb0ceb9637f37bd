//! Persson's theory under loads.

use std::ops::Range;

use ::persson::Cut;
use tables::Table;

use super::{CurveResult, CurveTheory, Job, Rows, pressures_pa, with_loads};
use crate::models::Persson;
use crate::persson_law::roughness;
use crate::plan::condition::Condition;
use crate::plan::{Cutoffs, PlanError, PreparedSpectrum, Work};

impl CurveTheory for Persson {
    fn rows_per_block(&self, prepared: &PreparedSpectrum, _: Cutoffs) -> usize {
        prepared.psd.len()
    }

    fn blocks(
        &self,
        job: &Job<'_>,
        conditions: &[Condition],
        _: Range<usize>,
    ) -> Result<(CurveResult, Work), PlanError> {
        let Persson { pair, law } = self;
        let Job { plan, prepared, cutoffs, run } = job;
        let moments = prepared.moments.iter().map(|(moments, _)| moments);
        let normalisation = plan.needs.moments.unwrap_or_default();
        let beyond = plan.beyond(&prepared.psd, law.band);
        let roughness = roughness(&prepared.psd, moments, normalisation, &prepared.scales, &beyond, law.band);
        let model = law.model(pair)?;
        let separation = model.separation(&roughness, law.energy_factor);
        let blocks = parallel::try_map(&pressures_pa(conditions), |&pressure_pa| {
            run.go_on()?;
            let mut cuts = model.along(&roughness, &separation, pressure_pa)?;
            if *cutoffs == Cutoffs::Shortest {
                cuts.drain(..cuts.len().saturating_sub(1));
            }
            Ok::<_, PlanError>(cuts)
        })?;
        Ok((CurveResult::Persson(blocks), Work::default()))
    }
}

impl Rows for Vec<Vec<Cut>> {
    fn count(&self) -> usize {
        self.len()
    }

    fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        self[block].iter().map(|cut| (cut.wavelength_m, cut.areas.contact())).collect()
    }

    fn highest_real_pressure_pa(&self, block: usize) -> f64 {
        self[block].iter().map(|cut| cut.real_pressure_pa).fold(0.0, f64::max)
    }

    fn table(&self, pressures_pa: &[f64], several: bool, _: bool) -> Table {
        let column = |of: fn(&Cut) -> f64| self.iter().flatten().map(of);
        let optional = |of: fn(&Cut) -> Option<f64>| self.iter().flatten().map(of);
        with_loads(self, pressures_pa, several)
            .with_numbers("wavelength_m", column(|cut| cut.wavelength_m))
            .with_numbers("area_fraction", column(|cut| cut.areas.contact()))
            .with_numbers("elastic_area_fraction", column(|cut| cut.areas.elastic))
            .with_numbers("plastic_area_fraction", column(|cut| cut.areas.plastic))
            .with_numbers("real_pressure_pa", column(|cut| cut.real_pressure_pa))
            .with_numbers("rms_gradient", column(|cut| cut.rms_gradient))
            .with_numbers("mean_gap_m", optional(|cut| cut.mean_gap_m))
            .with_numbers("stiffness_pa_per_m", optional(|cut| cut.stiffness_pa_per_m))
    }
}

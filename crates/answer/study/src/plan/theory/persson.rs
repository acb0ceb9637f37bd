//! Persson's theory under loads.

use std::ops::Range;

use ::persson::hardness_laws::HardnessError;
use ::persson::separation::SeparationLaw;
use ::persson::variance::Band;
use ::persson::{Cut, EnergyFactor, PerssonModel, Roughness};
use serde::Serialize;
use stat_contact::Condition;
use tables::Table;

use super::{CurveResult, CurveTheory, Job, Rows, pressures_pa, with_loads};
use crate::models::persson::{Persson, PerssonLaw};
use crate::plan::gap::{GapChoices, GapError, GapState, LoadedSurface};
use crate::plan::{Cutoffs, Plan, PlanError, PreparedSpectrum, Work};

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
        let Job { plan, prepared, cutoffs, run } = job;
        let PerssonLaw { band, energy_factor, .. } = self.law;
        let roughness = plan.roughness(&prepared.psd, &prepared.moments, &prepared.scales, band);
        let (model, roughness) = bodies_on(self, roughness)?;
        let separation = (!plan.needs.areas_alone).then(|| model.separation(&roughness, energy_factor));
        let blocks = numerics::parallel::try_map(&pressures_pa(conditions), |&pressure_pa| {
            run.go_on()?;
            Ok::<_, PlanError>(cuts(&model, &roughness, separation.as_ref(), *cutoffs, pressure_pa)?)
        })?;
        Ok((CurveResult::Persson(PerssonCuts { blocks, band: self.law.band }), Work::default()))
    }

    fn surface(
        &self,
        plan: &Plan<'_>,
        prepared: &PreparedSpectrum,
        choices: &GapChoices,
    ) -> Result<Option<Box<dyn LoadedSurface>>, GapError> {
        let roughness = plan.roughness(&prepared.psd, &prepared.moments, &prepared.scales, choices.band);
        let surface = PerssonSurface::of_roughness(self, roughness, choices.energy_factor)?;
        Ok(Some(Box::new(surface)))
    }
}

/// A surface by Persson's theory.
#[derive(Debug)]
pub struct PerssonSurface {
    /// The theory of the bodies in contact.
    pub model: PerssonModel,
    /// The roughness.
    pub roughness: Roughness,
    /// The law of its separations.
    pub separation: SeparationLaw,
}

impl PerssonSurface {
    /// Returns the surface that a plan has prepared.
    ///
    /// # Errors
    /// [`HardnessError`] for a hardness beyond the range of magnitudes.
    pub fn new(
        theory: &Persson,
        plan: &Plan<'_>,
        prepared: &PreparedSpectrum,
    ) -> Result<Self, HardnessError> {
        let PerssonLaw { band, energy_factor, .. } = theory.law;
        let roughness = plan.roughness(&prepared.psd, &prepared.moments, &prepared.scales, band);
        Self::of_roughness(theory, roughness, energy_factor)
    }

    fn of_roughness(
        theory: &Persson,
        roughness: Roughness,
        energy_factor: EnergyFactor,
    ) -> Result<Self, HardnessError> {
        let (model, roughness) = bodies_on(theory, roughness)?;
        let separation = model.separation(&roughness, energy_factor);
        Ok(PerssonSurface { model, roughness, separation })
    }
}

/// Returns the theory of the bodies in contact, and a roughness between them.
fn bodies_on(theory: &Persson, roughness: Roughness) -> Result<(PerssonModel, Roughness), HardnessError> {
    let model = theory.law.model(&theory.pair)?;
    let roughness = match theory.pair.layer_compliance() {
        Some(layer) => roughness.on_layer(layer),
        None => roughness,
    };
    Ok((model, roughness))
}

/// Returns the contact under a pressure at the cutoffs, with mean gap and stiffness if a law of separations is given.
fn cuts(
    model: &PerssonModel,
    roughness: &Roughness,
    separation: Option<&SeparationLaw>,
    cutoffs: Cutoffs,
    pressure_pa: f64,
) -> Result<Vec<Cut>, HardnessError> {
    let by_area = |(place, areas)| Cut::without_separation(place, areas, pressure_pa);
    let places = roughness.places();
    Ok(match (cutoffs, separation) {
        (Cutoffs::Every, Some(separation)) => model.along(roughness, separation, pressure_pa)?,
        (Cutoffs::Every, None) => {
            places.iter().zip(model.areas(roughness, pressure_pa)?).map(by_area).collect()
        }
        (Cutoffs::Shortest, Some(separation)) => {
            model.at_last(roughness, separation, pressure_pa)?.into_iter().collect()
        }
        (Cutoffs::Shortest, None) => {
            let last = places.last().zip(model.areas_at_last(roughness, pressure_pa)?);
            last.into_iter().map(by_area).collect()
        }
    })
}

impl LoadedSurface for PerssonSurface {
    fn at(&self, pressure_pa: f64) -> Result<GapState, GapError> {
        let last = self.model.at_last(&self.roughness, &self.separation, pressure_pa)?;
        let last = last.ok_or(GapError::NoRoughness)?;
        Ok(GapState {
            nominal_pressure_pa: pressure_pa,
            area_fraction: last.areas.contact(),
            mean_gap_m: last.mean_gap_m,
            stiffness_pa_per_m: last.stiffness_pa_per_m,
        })
    }

    fn persson(&self) -> Option<(&Roughness, &SeparationLaw)> {
        Some((&self.roughness, &self.separation))
    }
}

/// Cuts of Persson's theory under loads.
#[derive(Debug, Clone, Serialize)]
#[serde(transparent)]
pub struct PerssonCuts {
    /// For every load its cuts, from long to short wavelengths.
    pub blocks: Vec<Vec<Cut>>,
    /// Band that a cutoff lets through.
    #[serde(skip)]
    pub band: Band,
}

impl Rows for PerssonCuts {
    fn count(&self) -> usize {
        self.blocks.len()
    }

    fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        self.blocks[block].iter().map(|cut| (cut.wavelength_m, cut.areas.contact())).collect()
    }

    fn highest_real_pressure_pa(&self, block: usize) -> f64 {
        self.blocks[block].iter().map(|cut| cut.real_pressure_pa).fold(0.0, f64::max)
    }

    fn table(&self, pressures_pa: &[f64], several: bool, _: bool) -> Table {
        let column = |of: fn(&Cut) -> f64| self.blocks.iter().flatten().map(of);
        let optional = |of: fn(&Cut) -> Option<f64>| self.blocks.iter().flatten().map(of);
        with_loads(&self.blocks, pressures_pa, several)
            .with_numbers("wavelength_m", column(|cut| cut.wavelength_m))
            .with_numbers("area_fraction", column(|cut| cut.areas.contact()))
            .with_numbers("elastic_area_fraction", column(|cut| cut.areas.elastic))
            .with_numbers("plastic_area_fraction", column(|cut| cut.areas.plastic))
            .with_numbers("real_pressure_pa", column(|cut| cut.real_pressure_pa))
            .with_numbers("rms_gradient", column(|cut| cut.rms_gradient))
            .with_numbers("mean_gap_m", optional(|cut| cut.mean_gap_m))
            .with_numbers("stiffness_pa_per_m", optional(|cut| cut.stiffness_pa_per_m))
            .with_words("band", self.blocks.iter().flatten().map(|_| self.band.name()))
    }
}

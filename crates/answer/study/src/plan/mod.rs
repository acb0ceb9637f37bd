//! Plans: everything that is needed, computed once. Every table, figure and reported number comes from one plan.
//!
//! `needs` holds requests and `results` their answers. `prepare` computes everything that curves need from the spectrum.
//! `distinct_inputs` finds equal curves and loads. [`models`](crate::models) compute the rows of curves, and `sweeps` those
//! over loads. `compute` assembles the results; `stream` passes curves on in parts that are not kept.

mod compute;
mod condition;
mod count;
mod distinct;
mod distinct_inputs;
pub(crate) mod error;
pub(crate) mod gap;
mod needs;
mod prepare;
pub(crate) mod prepared_spectrum;
mod results;
pub(crate) mod run;
mod stream;
mod sweeps;
pub(crate) mod tolerance;
pub(crate) mod work;

pub use crate::load::{Load, LoadRange, NominalPressure};
pub use crate::models::{CurveModel, CurveResult, CutoffState, PerssonSurface};
pub use distinct::Distinct;
pub use error::PlanError;
pub use needs::{Curve, LoadSweep, Needs, Sampling};
pub use prepared_spectrum::{Cutoffs, PreparedSpectrum};
pub use results::{Results, SweepResult};
pub use stream::{Part, Stream};
pub use tolerance::Tolerance;
pub use work::Work;

use persson::Band;
use persson::Roughness;
use persson::hardness_laws::HardnessError;
use spectrum::ProfilePsd;

use crate::models::persson::roughness;

/// A spectrum, and the values to compute from it.
pub struct Plan<'p> {
    /// The spectrum as read.
    pub psd: &'p ProfilePsd,
    /// The selection of its scales.
    pub sampling: Sampling,
    /// The results to be computed.
    pub needs: Needs,
}

impl Plan<'_> {
    /// Builds the roughness that Persson's theory takes from a prepared spectrum.
    pub(crate) fn roughness(&self, prepared: &PreparedSpectrum, band: Band) -> Roughness {
        roughness(prepared, self.needs.moments.unwrap_or_default(), band)
    }

    /// Returns the surface of a model with its whole prepared spectrum, or nothing for a theory other than Persson's.
    ///
    /// # Errors
    /// [`HardnessError`] for a hardness beyond the range of magnitudes.
    pub fn persson_surface(
        &self,
        model: &CurveModel,
        prepared: &PreparedSpectrum,
    ) -> Result<Option<PerssonSurface>, HardnessError> {
        let Some(theory) = model.persson() else { return Ok(None) };
        theory.surface(self.roughness(prepared, theory.band), theory.energy_factor).map(Some)
    }
}

/// Scales per decade of a spectrum, on average; absent for a single scale.
#[must_use]
pub fn scales_per_decade(psd: &ProfilePsd) -> Option<f64> {
    let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
    (decades > 0.0).then(|| (psd.len() - 1) as f64 / decades)
}

//! Plans: everything that is needed, computed once. Every table, figure and reported number comes from one plan.
//!
//! `needs` holds requests and `results` their answers. `prepared_spectrum` computes everything that curves need from
//! the spectrum. `distinct_inputs` finds equal curves and loads. `theory` computes the rows of a model, with a module
//! per theory, and `sweeps` those over loads. `gap` presses a surface with its whole
//! spectrum. `compute` assembles the results; `stream` passes curves on in parts that
//! are not kept.

mod compute;
mod condition;
mod count;
mod distinct;
mod distinct_inputs;
mod error;
pub(crate) mod gap;
mod needs;
mod prepared_spectrum;
mod results;
mod run;
mod stream;
mod sweeps;
mod theory;
mod tolerance;
mod work;

pub use crate::load::{Load, LoadRange, NominalPressure};
pub use crate::models::CurveModel;
pub use distinct::Distinct;
pub use error::PlanError;
pub use needs::{Curve, Cutoffs, LoadSweep, Needs, Sampling};
pub use prepared_spectrum::PreparedSpectrum;
pub use results::{Results, SweepResult};
pub use stream::{Part, Stream};
pub use theory::{CurveResult, CutoffState, PerssonSurface, STATE_DETAILS};
pub use tolerance::Tolerance;
pub use work::Work;

use persson::Roughness;
use persson::variance::Band;
use spectrum::{AsperityParameters, Moments, ProfilePsd};
use stacked_contact::Scale;

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
    /// Builds the roughness that Persson's theory takes from a sampled spectrum with its moments and amplitudes, including the
    /// part that the cutoff left out.
    pub(crate) fn roughness(
        &self,
        psd: &ProfilePsd,
        moments: &[(Moments, Option<AsperityParameters>)],
        scales: &[Scale],
        band: Band,
    ) -> Roughness {
        let normalisation = self.needs.moments.unwrap_or_default();
        let moments = moments.iter().map(|(moments, _)| moments);
        roughness(psd, moments, normalisation, scales, &self.beyond(psd, band), band)
    }
}

/// Scales per decade of a spectrum, on average; absent for a single scale.
#[must_use]
pub fn scales_per_decade(psd: &ProfilePsd) -> Option<f64> {
    let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
    (decades > 0.0).then(|| (psd.len() - 1) as f64 / decades)
}

//! Plans: everything that is needed, computed once. Every table, figure and reported number comes from one plan.
//!
//! `needs` holds requests and `results` their answers. `prepared_spectrum` computes everything that curves need from
//! the spectrum. `distinct_inputs` finds equal curves and loads. `theory` computes the rows of a model, with a module
//! per theory, and `sweeps` those over loads. `compute` assembles the results; `stream` passes curves on in parts that
//! are not kept.

mod compute;
mod condition;
mod count;
mod distinct;
mod distinct_inputs;
mod error;
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
pub(crate) use condition::contact_of;
pub use error::PlanError;
pub use needs::{Curve, Cutoffs, LoadSweep, Needs, Sampling};
pub use prepared_spectrum::PreparedSpectrum;
pub(crate) use prepared_spectrum::Roughness;
pub use results::{Results, SweepResult};
pub use stream::{Part, Stream};
pub use theory::{CurveResult, CutoffState, STATE_DETAILS};
pub use tolerance::Tolerance;
pub use work::Work;

use spectrum::ProfilePsd;

/// A spectrum, and the values to compute from it.
pub struct Plan<'p> {
    /// The spectrum as read.
    pub psd: &'p ProfilePsd,
    /// The selection of its scales.
    pub sampling: Sampling,
    /// The results to be computed.
    pub needs: Needs,
}

/// Scales per decade of a spectrum, on average; absent for a single scale.
#[must_use]
pub fn scales_per_decade(psd: &ProfilePsd) -> Option<f64> {
    let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
    (decades > 0.0).then(|| (psd.len() - 1) as f64 / decades)
}

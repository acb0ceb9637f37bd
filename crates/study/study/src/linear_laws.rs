//! The areas that go with the load, for the roughness of a spectrum: yardsticks for elastic models.

use spectrum::{Normalisation, ProfilePsd, cumulative_moments};
use stat_contact::LinearLaw;

use crate::models::CurveModel;

/// The rms gradient of an isotropic surface with the spectrum of a profile, sqrt(2 m2), by the shortest wavelength \[m\] that takes
/// part: one for each but the longest. Of Parseval's moments, whatever normalisation tables are asked for in.
#[must_use]
pub fn rms_gradients(psd: &ProfilePsd) -> Vec<(f64, f64)> {
    let moments = cumulative_moments(psd, Normalisation::default());
    moments.iter().map(|moments| (moments.wavelength_m, (2.0 * moments.m2).sqrt())).collect()
}

/// The area fractions of the linear laws, the smaller first, under a nominal pressure \[Pa\] and for an rms gradient; none for
/// a model that yields, where the gradient is zero, and where the larger law leaves its range: beyond the nominal area.
#[must_use]
pub fn linear_areas(model: &CurveModel, nominal_pressure_pa: f64, rms_gradient: f64) -> Option<[f64; 2]> {
    let modulus_pa = model.pair().composite_modulus_pa();
    let areas = LinearLaw::ALL.map(|law| law.area_fraction(nominal_pressure_pa, modulus_pa, rms_gradient));
    (model.strength().is_none() && areas[1] <= 1.0).then_some(areas)
}

//! Linear laws for the roughness of a spectrum: areas proportional to the load, for comparison with elastic models.

use spectrum::{Normalisation, ProfilePsd, cumulative_moments};
use stat_contact::LinearLaw;

use crate::models::CurveModel;

/// Computes the rms gradient of an isotropic surface, sqrt(2 m2), for every cutoff \[m\] but the longest, from the
/// spectrum of a profile. The moments are Parseval's, whatever the normalisation of tables.
#[must_use]
pub fn rms_gradients(psd: &ProfilePsd) -> Vec<(f64, f64)> {
    let moments = cumulative_moments(psd, Normalisation::default());
    moments.iter().map(|moments| (moments.wavelength_m, (2.0 * moments.m2).sqrt())).collect()
}

/// Computes the area fractions of the linear laws, the smaller first, under a nominal pressure \[Pa\] and for an rms
/// gradient. `None` for a model that yields, on a layer, for a zero gradient, and if the larger area exceeds the nominal one.
#[must_use]
pub fn linear_areas(model: &CurveModel, nominal_pressure_pa: f64, rms_gradient: f64) -> Option<[f64; 2]> {
    let modulus_pa = model.pair().composite_modulus_pa();
    let areas = LinearLaw::ALL.map(|law| law.area_fraction(nominal_pressure_pa, modulus_pa, rms_gradient));
    let is_elastic_half_space = model.strength().is_none() && model.pair().layer().is_none();
    (is_elastic_half_space && areas[1] <= 1.0).then_some(areas)
}

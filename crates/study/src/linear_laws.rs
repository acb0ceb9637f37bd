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

#[cfg(test)]
mod tests {
    use asperity::{ElasticBody, MaterialPair, NixGao};
    use stacked_contact::StackedModel;

    use super::*;

    #[test]
    fn the_laws_hold_for_elastic_models_below_the_nominal_area() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.0).unwrap());
        let elastic = CurveModel::Stacked(StackedModel::Elastic { pair });
        let [persson, bgt] = linear_areas(&elastic, 1e8, 0.1).unwrap();
        assert!((persson / 0.015_957_691_216_057_3 - 1.0).abs() < 1e-14, "{persson}");
        assert!((bgt / 0.025_066_282_746_31 - 1.0).abs() < 1e-14, "{bgt}");
        assert_eq!(linear_areas(&elastic, 1e10, 0.1), None);
        assert_eq!(linear_areas(&elastic, 1e8, 0.0), None);
        let strength = NixGao::constant(1e9).unwrap();
        let yielding = CurveModel::Stacked(StackedModel::ElasticPlastic { pair, strength });
        assert_eq!(linear_areas(&yielding, 1e8, 0.1), None);
    }

    #[test]
    fn the_gradient_is_the_root_of_twice_the_mean_square_slope() {
        // C of 3 pi/q^2: m2 is 3 times the width of the band.
        let wavelengths_m: Vec<f64> = (0..=400).map(|at| 1e-6 * 10f64.powf(-f64::from(at) / 400.0)).collect();
        let c1d_m3 =
            wavelengths_m.iter().map(|l| 3.0 * std::f64::consts::PI * (l / std::f64::consts::TAU).powi(2));
        let psd = ProfilePsd::new(wavelengths_m.clone(), c1d_m3.collect()).unwrap();
        let (shortest_m, gradient) = *rms_gradients(&psd).last().unwrap();
        let band_per_m = std::f64::consts::TAU * (1e7 - 1e6);
        assert!((shortest_m / 1e-7 - 1.0).abs() < 1e-12);
        assert!((gradient / (6.0 * band_per_m).sqrt() - 1.0).abs() < 1e-9, "{gradient}");
    }
}

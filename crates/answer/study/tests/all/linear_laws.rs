//! Areas that go with the load.

use asperity::{ElasticBody, MaterialPair};

use spectrum::ProfilePsd;
use study::hardness_and_strength::HardnessAndStrength;
use study::linear_laws::{linear_areas, rms_gradients};
use study::material::{GivenMaterial, Material};
use study::models::{Framework, ModelOptions, named};

#[test]
fn the_laws_hold_for_elastic_models_below_the_nominal_area() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.0).unwrap());
    let material = Material::new(GivenMaterial {
        hardness_and_strength: HardnessAndStrength::new(None, Some("1 GPa".parse().unwrap())).unwrap(),
        ..GivenMaterial::new(pair.body())
    });
    let stacked = |name: &str| {
        let entry = named(Framework::Stacked, name).unwrap();
        entry.build(&material, &ModelOptions::default()).unwrap()
    };
    let elastic = stacked("elastic");
    let [persson, bgt] = linear_areas(&elastic, 1e8, 0.1).unwrap();
    assert!((persson / 0.015_957_691_216_057_3 - 1.0).abs() < 1e-14, "{persson}");
    assert!((bgt / 0.025_066_282_746_31 - 1.0).abs() < 1e-14, "{bgt}");
    assert_eq!(linear_areas(&elastic, 1e10, 0.1), None);
    assert_eq!(linear_areas(&elastic, 1e8, 0.0), None);
    let yielding = stacked("elastic-plastic");
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

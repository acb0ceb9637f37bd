//! A wave longer than the roughness.

use std::f64::consts::TAU;

use asperity::{ElasticBody, Layer, MaterialPair};
use persson::separation::SeparationLaw;
use persson::{EnergyFactor, Roughness, RoughnessSample};

const MODULUS_PA: f64 = 100e9;

/// Roughness from 100 um to 1 um, q^-2.6, with moments by thin rectangles.
fn roughness() -> Roughness {
    let (mut moments, mut gradient) = ([0.0; 3], 0.0);
    let mut gradients = Vec::new();
    let mut samples = Vec::new();
    let q = |at: i32| TAU / 100e-6 * 100f64.powf(f64::from(at) / 200.0);
    for at in 0..=200 {
        let c1d = 1e-18 * (q(at) / q(0)).powf(-2.6);
        if at > 0 {
            let mass = c1d * (q(at) - q(at - 1)) / std::f64::consts::PI;
            [0, 2, 4]
                .iter()
                .enumerate()
                .for_each(|(order, power)| moments[order] += mass * q(at).powi(*power));
            gradient += 2.0 * mass * q(at).powi(2);
        }
        gradients.push(gradient);
        let wavelength_m = TAU / q(at);
        samples.push(RoughnessSample { wavelength_m, c1d_m3: c1d, moments, amplitude_m: 1e-8 });
    }
    Roughness::new(&samples, Some(&gradients))
}

#[test]
fn a_wave_adds_its_variance_and_its_gradient() {
    let rough = roughness();
    let with_wave = rough.with_long_wave(2e-3, 4e-14).unwrap();
    let (last, before) = (with_wave.places().last().unwrap(), rough.places().last().unwrap());
    assert!(((last.moments[0] - before.moments[0]) / 4e-14 - 1.0).abs() < 1e-9);
    let gradient = (TAU / 2e-3).powi(2) * 4e-14;
    assert!(((last.mean_square_gradient - before.mean_square_gradient) / gradient - 1.0).abs() < 1e-6);
    // Waves of the roughness are not longer.
    assert_eq!(rough.with_long_wave(90e-6, 4e-14), None);
}

#[test]
fn a_small_wave_changes_nothing_and_a_large_one_decides() {
    let law =
        |roughness: &Roughness| SeparationLaw::from_roughness(roughness, MODULUS_PA, EnergyFactor::default());
    let rough = roughness();
    let rms_m2 = rough.places().last().unwrap().moments[0];
    let flat = law(&rough).whole(1e6);
    let small = law(&rough.with_long_wave(2e-3, 1e-8 * rms_m2).unwrap()).whole(1e6);
    assert!((small.mean_gap_m / flat.mean_gap_m - 1.0).abs() < 1e-3);
    assert!((small.stiffness_pa_per_m / flat.stiffness_pa_per_m - 1.0).abs() < 1e-3);
    // Gaps of light loads go with the height of the wave.
    let gaps: Vec<f64> = [100.0, 400.0]
        .map(|times| law(&rough.with_long_wave(2e-3, times * rms_m2).unwrap()).whole(1.0).mean_gap_m)
        .to_vec();
    assert!((gaps[1] / gaps[0] - 2.0).abs() < 0.2, "{gaps:?}");
}

#[test]
fn a_wave_on_a_layer_is_that_of_the_layer() {
    let body = ElasticBody::new(1e9, 0.3).unwrap();
    let layer = Layer::new(body, 50e-6, None).unwrap();
    let pair = MaterialPair::against_rigid(body).bonded(Some(layer));
    let (compliance, modulus_pa) = (pair.layer_compliance().unwrap(), pair.composite_modulus_pa());
    let last = |roughness: Roughness| roughness.places().last().unwrap().variance_pa2(modulus_pa);
    let [before, behind] = [
        last(roughness().with_long_wave(200e-6, 4e-14).unwrap().on_layer(compliance)),
        last(roughness().on_layer(compliance).with_long_wave(200e-6, 4e-14).unwrap()),
    ];
    let plain = last(roughness().on_layer(compliance));
    assert!(
        behind > plain && ((behind - plain) / (before - plain) - 1.0).abs() < 1e-2,
        "{plain} {before} {behind}"
    );
}

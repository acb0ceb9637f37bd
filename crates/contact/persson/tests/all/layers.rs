//! Persson's theory on layers: against a direct sum over waves, and its limits.

use std::f64::consts::{PI, TAU};

use asperity::{ElasticBody, Layer, MaterialPair};
use numerics::GaussLegendre;
use persson::separation::SeparationLaw;
use persson::{EnergyFactor, PerssonModel, Roughness, RoughnessSample};

const FIRST_RAD_PER_M: f64 = 1e5;
const DECADES: i32 = 3;
const STEPS: i32 = 40;
/// Exponent of C1D.
const EXPONENT: f64 = -2.6;
const ENERGY_FACTOR: f64 = 0.45;

/// C1D = 1e-21 m^3 (q/1e5)^-2.6 over three decades, by the waves of profiles: dh'^2 = (2/pi) q^2 C1D dq.
fn gradient_per_rad_m(q: f64) -> f64 {
    2.0 / PI * q * q * 1e-21 * (q / FIRST_RAD_PER_M).powf(EXPONENT)
}

fn roughness() -> Roughness {
    let moment = |q: f64, power: f64| {
        let exponent = power + EXPONENT + 1.0;
        let grown = ((q / FIRST_RAD_PER_M).powf(exponent) - 1.0) / exponent;
        1e-21 * FIRST_RAD_PER_M.powf(power + 1.0) * grown / PI
    };
    let sample = |i: i32| {
        let q = FIRST_RAD_PER_M * 10f64.powf(f64::from(i) / f64::from(STEPS));
        RoughnessSample {
            wavelength_m: TAU / q,
            c1d_m3: 1e-21 * (q / FIRST_RAD_PER_M).powf(EXPONENT),
            moments: [moment(q, 0.0), moment(q, 2.0), moment(q, 4.0)],
            amplitude_m: 1.0 / q,
        }
    };
    Roughness::new(&(0..=DECADES * STEPS).map(sample).collect::<Vec<_>>(), None)
}

fn pair(thickness_m: f64, base: Option<ElasticBody>) -> MaterialPair {
    let body = ElasticBody::new(1e9, 0.4).unwrap();
    MaterialPair::against_rigid(body).bonded(Some(Layer::new(body, thickness_m, base).unwrap()))
}

fn law(pair: &MaterialPair) -> (f64, SeparationLaw) {
    let roughness = match pair.layer_compliance() {
        Some(layer) => roughness().on_layer(layer),
        None => roughness(),
    };
    let modulus_pa = pair.composite_modulus_pa();
    let model = PerssonModel::Elastic { contact_modulus_pa: modulus_pa, correction: None };
    let variance_pa2 = roughness.places().last().unwrap().variance_pa2(modulus_pa);
    (variance_pa2, model.separation(&roughness, EnergyFactor::ALMQVIST))
}

/// Density [g + 3 (1 - g) erf(x)^2] exp(-x^2).
fn density(x: f64) -> f64 {
    (ENERGY_FACTOR + 3.0 * (1.0 - ENERGY_FACTOR) * libm::erf(x).powi(2)) * (-x * x).exp()
}

/// Integral of the density over dx/x from x on.
fn beyond(rule: &GaussLegendre, x: f64) -> f64 {
    let ends = [x.ln(), 8f64.ln().max(x.ln())];
    let pieces = 40;
    let end = |piece: i32| ends[0] + (ends[1] - ends[0]) * f64::from(piece) / f64::from(pieces);
    let piece =
        |piece: i32| rule.over(end(piece), end(piece + 1)).map(|(ln, w)| w * density(ln.exp())).sum::<f64>();
    (0..pieces).map(piece).sum()
}

/// Variance and mean gap by a direct sum over waves in equal steps of ln(q).
fn by_waves(pair: &MaterialPair, pressure_pa: f64) -> (f64, f64) {
    let layer = pair.layer_compliance().unwrap();
    let rule = GaussLegendre::new(10);
    let steps = 20_000;
    let step_ln = f64::from(DECADES) * 10f64.ln() / f64::from(steps);
    let (mut variance_pa2, mut gap_m) = (0.0f64, 0.0);
    for step in 0..steps {
        let q = FIRST_RAD_PER_M * ((f64::from(step) + 0.5) * step_ln).exp();
        let modulus_pa = pair.composite_modulus_pa() / layer.relative_at(q);
        let rise_pa2 = 0.25 * modulus_pa * modulus_pa * gradient_per_rad_m(q) * q * step_ln;
        let [v_pa, next_pa] = [variance_pa2, variance_pa2 + rise_pa2].map(|variance| (2.0 * variance).sqrt());
        let middle_pa = (2.0 * (variance_pa2 + 0.5 * rise_pa2)).sqrt();
        gap_m += beyond(&rule, pressure_pa / middle_pa) * (next_pa - v_pa) / (q * modulus_pa);
        variance_pa2 += rise_pa2;
    }
    (variance_pa2, 2.0 / PI.sqrt() * gap_m)
}

#[test]
fn variance_gap_and_stiffness_agree_with_a_sum_over_waves() {
    let soft = ElasticBody::new(1e8, 0.3).unwrap();
    let stiff = ElasticBody::new(2e11, 0.3).unwrap();
    for (thickness_m, base) in [(3e-6, None), (1e-6, Some(soft)), (2e-6, Some(stiff))] {
        let pair = pair(thickness_m, base);
        let (variance_pa2, law) = law(&pair);
        for share in [0.05, 0.5] {
            let pressure_pa = share * variance_pa2.sqrt();
            let (expected_pa2, expected_m) = by_waves(&pair, pressure_pa);
            let off = variance_pa2 / expected_pa2 - 1.0;
            assert!(off.abs() < 1e-5, "variance on {base:?}: {off}");
            let found = law.whole(pressure_pa);
            let off = found.mean_gap_m / expected_m - 1.0;
            assert!(off.abs() < 2e-3, "gap on {base:?} at {share}: {off}");
            // K = -dp/du.
            let nearby =
                law.whole(1.001 * pressure_pa).mean_gap_m - law.whole(0.999 * pressure_pa).mean_gap_m;
            let slope = -0.002 * pressure_pa / nearby;
            assert!(
                (found.stiffness_pa_per_m / slope - 1.0).abs() < 1e-5,
                "stiffness on {base:?} at {share}"
            );
        }
    }
}

#[test]
fn thick_and_thin_layers_are_half_spaces() {
    let base = ElasticBody::new(5e9, 0.25).unwrap();
    let body = ElasticBody::new(1e9, 0.4).unwrap();
    for (thickness_m, half_space) in [(1.0, body), (1e-18, base)] {
        let (variance_pa2, on_layer) = law(&pair(thickness_m, Some(base)));
        let (expected_pa2, plain) = law(&MaterialPair::against_rigid(half_space));
        assert!((variance_pa2 / expected_pa2 - 1.0).abs() < 1e-8, "{thickness_m}");
        let pressure_pa = 0.2 * expected_pa2.sqrt();
        let [found, expected] = [on_layer, plain].map(|law| law.whole(pressure_pa));
        assert!((found.mean_gap_m / expected.mean_gap_m - 1.0).abs() < 1e-8, "{thickness_m}");
        assert!((found.stiffness_pa_per_m / expected.stiffness_pa_per_m - 1.0).abs() < 1e-8, "{thickness_m}");
    }
}

#[test]
fn gradients_stay_those_of_the_surface() {
    let pair = pair(1e-6, None);
    let layered = roughness().on_layer(pair.layer_compliance().unwrap());
    let plain = roughness();
    for (layered, plain) in layered.places().iter().zip(plain.places()) {
        assert_eq!(layered.rms_gradient(), plain.rms_gradient());
        assert_eq!(layered.alpha, plain.alpha);
        assert!(layered.variance_pa2(1e9) >= plain.variance_pa2(1e9));
    }
}

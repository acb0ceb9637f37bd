//! A rough surface of Persson's theory.

use std::convert::Infallible;

use interface::finite_elements::{ContactLaw, LawPoint};
use persson::EnergyFactor;
use persson::separation::{SeparationKnot, SeparationLaw};

/// C1D ~ q^-2.6 from 1e4 to 1e6 rad/m, rms height 6 um, under steel against steel: E* = 115 GPa.
pub fn separation() -> SeparationLaw {
    let modulus_pa = 115e9f64;
    let knots: Vec<SeparationKnot> = (0..=16)
        .map(|at| {
            let q = 1e4 * 10f64.powf(f64::from(at) / 8.0);
            // V grows as q^0.4 from nothing to a half of (E* h')^2 at a gradient of 0.28.
            let grown = ((q / 1e4).powf(0.4) - 1.0) / (100f64.powf(0.4) - 1.0);
            let variance_pa2 = (0.14 * modulus_pa).powi(2) * grown;
            SeparationKnot { wavevector_rad_per_m: q, variance_pa2, variance_exponent: 0.4 }
        })
        .collect();
    SeparationLaw::new(&knots, modulus_pa, EnergyFactor::ALMQVIST)
}

/// Samples the law of [`separation`] over a range of pressures \[Pa\].
pub fn sampled(range_pa: [f64; 2], tolerance: f64) -> ContactLaw {
    let separation = separation();
    let at = |pressure_pa: f64| {
        let mean_gap_m = separation.whole(pressure_pa).mean_gap_m;
        Ok::<_, Infallible>(Some(LawPoint { pressure_pa, mean_gap_m, area_fraction: pressure_pa / 2e10 }))
    };
    ContactLaw::sample(range_pa, tolerance, at).unwrap()
}

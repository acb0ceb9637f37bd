//! Mean gap and stiffness of Persson's theory compared with those of boundary elements.

use elements::{ContactField, ElementsError, ImposedLoad, Pressing, RandomSurfaces, Surfaces, press};
use numerics::parallel::Unobserved;
use persson::EnergyFactor;
use persson::separation::{SeparationKnot, SeparationLaw};
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};

const HURST_EXPONENT: f64 = 0.8;
/// Four lengths of the longest wave in a box of 1 m, and eight points for the shortest one on 128 of them.
const LONGEST_M: f64 = 1.0 / 4.0;
const SHORTEST_M: f64 = 1.0 / 16.0;
const POINTS: usize = 128;
const REALISATIONS: usize = 8;

/// Surfaces of a gradient of 1, without a roll-off.
fn band() -> AreaSpectrum {
    AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: HURST_EXPONENT,
        longest_m: LONGEST_M,
        rolloff_m: LONGEST_M,
        shortest_m: SHORTEST_M,
        size: Size::RmsGradient(1.0),
    })
    .unwrap()
}

/// The theory at E* = 1 Pa, by the waves of the surface: V is a quarter of the mean square gradient up to each of them.
fn theory(band: &AreaSpectrum) -> SeparationLaw {
    let steps = 60;
    let knots: Vec<SeparationKnot> = (0..=steps)
        .map(|step| {
            let wavelength_m = LONGEST_M * (SHORTEST_M / LONGEST_M).powf(f64::from(step) / f64::from(steps));
            let gradient = if step == 0 {
                0.0
            } else {
                band.cut(LONGEST_M, wavelength_m).unwrap().mean_square_gradient()
            };
            SeparationKnot {
                wavevector_rad_per_m: std::f64::consts::TAU / wavelength_m,
                variance_pa2: 0.25 * gradient,
                variance_exponent: 2.0 - 2.0 * HURST_EXPONENT,
            }
        })
        .collect();
    SeparationLaw::new(&knots, 1.0, EnergyFactor::default())
}

#[test]
fn gap_and_stiffness_of_perssons_theory_are_those_of_surfaces_within_fifteen_per_cent() {
    let band = band();
    let law = theory(&band);
    let synthesis = Synthesis::square(POINTS, 1.0, 1, Phases::FixedModulus);
    let surfaces = Surfaces::Random(RandomSurfaces { band, synthesis, realisations: REALISATIONS });
    let loads = [0.02, 0.05, 0.12].map(ImposedLoad::PressurePa).to_vec();
    let pressing = Pressing { loads, stiffness: true, ..Pressing::elastic(1.0) };
    let unseen = |_: &ContactField<'_>| -> Result<(), ElementsError> { Ok(()) };
    let pressed = press(&surfaces, &pressing, unseen, &Unobserved).unwrap();
    for load in &pressed {
        let (mean, by_theory) = (load.mean(), law.whole(load.nominal_pressure_pa));
        assert!(mean.best_area_fraction() < 0.3, "{mean:?}");
        let stiffness = by_theory.stiffness_pa_per_m / mean.stiffness_pa_per_m.unwrap();
        let gap = by_theory.mean_gap_m / mean.mean_gap_m;
        println!("A = {:.4}: K {stiffness:.3}, u {gap:.3}", mean.best_area_fraction());
        assert!((stiffness - 1.0).abs() < 0.15, "{mean:?}: K {stiffness}");
        assert!((gap - 1.0).abs() < 0.15, "{mean:?}: u {gap}");
    }
}

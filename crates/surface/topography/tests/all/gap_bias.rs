//! Filled gaps do not change the spectrum of a surface at wavelengths above four times their size.

use crate::transform_support::holes::{HoleKind, bias, holes, surface};
use topography::GapTreatment;

const POINTS: usize = 256;
/// The bar, in decades.
const MOST_DECADES: f64 = 0.05;

#[test]
fn harmonic_filling_keeps_the_spectrum_above_four_sizes_of_a_hole() {
    for (hurst_exponent, seed) in [(0.5, 1), (0.8, 2)] {
        let heights_m = surface(POINTS, hurst_exponent, seed);
        for kind in HoleKind::ALL {
            for share in [0.05, 0.1, 0.2] {
                let (gaps, size) = holes(kind, share, &heights_m, POINTS, seed);
                let found = gaps.iter().filter(|&&gap| gap).count() as f64 / gaps.len() as f64;
                assert!(found <= share && found > share - 0.02, "{kind:?}: {found} is not {share}");
                let bias = bias(&heights_m, POINTS, &gaps, size, GapTreatment::Harmonic).expect("few gaps");
                let decades: Vec<f64> = bias
                    .spectrum
                    .iter()
                    .filter(|(ratio, _)| *ratio > 4.0)
                    .map(|(_, value)| value.log10())
                    .collect();
                assert!(decades.len() >= 2, "{kind:?}: {} bins", decades.len());
                let mean = decades.iter().sum::<f64>() / decades.len() as f64;
                assert!(mean.abs() < MOST_DECADES, "{kind:?}, {share}: {mean} decades");
                assert!(
                    (0.88..=1.0).contains(&bias.rms_slope),
                    "{kind:?}, {share}: slope {}",
                    bias.rms_slope
                );
            }
        }
    }
}

#[test]
fn lines_without_gaps_miss_the_steep_flanks_that_were_lost() {
    let heights_m = surface(POINTS, 0.8, 1);
    let (gaps, size) = holes(HoleKind::Flanks, 0.1, &heights_m, POINTS, 1);
    let slope =
        |treatment| bias(&heights_m, POINTS, &gaps, size, treatment).expect("both treat it").rms_slope;
    assert!(slope(GapTreatment::Lines) < 0.9);
    assert!(slope(GapTreatment::Harmonic) > 0.95);
}

//! The excess that window and trend add to the longest waves of scans: predicted, and in synthetic scans.

use std::f64::consts::TAU;

use trials::coverage::{AFM, Instrument, KnownSurface, Laboratory, STYLUS};

/// Number of first bins that are compared; the fourth to sixth are averaged.
const BINS: usize = 6;

/// Predicted excess of the bins 0 to 5 of scans of an instrument, and the excess found as the mean over `scans` of them.
/// All scans have the same height scale, which is off: both are those over the mean of the bins 3 to 5.
fn predicted_and_found(surface: &KnownSurface, instrument: Instrument, scans: u32) -> Vec<[f64; 2]> {
    let laboratory = Laboratory::of_surface(surface.clone(), &[instrument], 5).unwrap();
    let measured = laboratory.study(0, &[scans]).unwrap().composite().unwrap();
    // Beyond the longest wave of the surface there is nothing.
    let c1d_m3 =
        |q_rad_per_m: f64| surface.profile(&[TAU / q_rad_per_m]).map_or(0.0, |profile| profile.c1d_m3()[0]);
    let scan = &measured.scans[0];
    let predicted = scan.window_excess(&measured.in_bins[0], &measured.recipe, c1d_m3);
    let found = |bin: usize| {
        let mean_m3 = measured.in_bins.iter().map(|bins| bins[bin].c1d_m3).sum::<f64>() / f64::from(scans);
        (mean_m3 / c1d_m3(TAU / measured.in_bins[0][bin].wavelength_m)).ln()
    };
    let rows: Vec<[f64; 2]> = (0..BINS).map(|bin| [predicted[bin], found(bin)]).collect();
    let mean = |of: usize| rows[3..].iter().map(|row| row[of]).sum::<f64>() / 3.0;
    let means = [mean(0), mean(1)];
    rows.iter().map(|row| [row[0] - means[0], row[1] - means[1]]).collect()
}

#[test]
fn the_predicted_excess_is_that_of_scans() {
    let lines = Instrument { length_m: 20e-6, points: 256, shortest_m: 200e-9, ..STYLUS };
    for (hurst_exponent, least) in [(0.5, 0.2), (0.9, 0.45)] {
        let surface = KnownSurface::new(hurst_exponent, 2.0 * AFM.spacing_m()).unwrap();
        for (instrument, scans) in [(lines, 900), (AFM, 100)] {
            let rows = predicted_and_found(&surface, instrument, scans);
            assert!(rows[0][0] > least, "{rows:?}");
            // A bin holds one wave of each line; the means scatter by some 4 % for lines, and by twice that for maps.
            let tolerance = if instrument == lines { 0.12 } else { 0.25 };
            for [predicted, found] in &rows[..3] {
                assert!(
                    (predicted - found).abs() < tolerance,
                    "{hurst_exponent} {}: {rows:?}",
                    instrument.name
                );
            }
        }
    }
}

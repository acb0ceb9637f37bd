//! The reliable band, and what joins the spectra of several measurements.

use std::f64::consts::TAU;
use std::num::NonZeroU32;

use crate::transform_support::{Random, periodic_profile_m, self_affine_c1d_m3};
use approx::assert_relative_eq;
use proptest::prelude::*;
use scans::{HeightMap, NonuniformLineScan, Scan, UniformLineScan};
use spectrum::{Convention, ProfilePsd, Psd};
use topography::{
    BandLimits, BinMean, CompositeOptions, Preparation, ReliableBand, TransformError, composite,
    line_spectrum, log_binned, overlaps, tip_cutoff_m,
};

fn ten() -> NonZeroU32 {
    NonZeroU32::new(10).unwrap()
}

fn profile(samples: &[(f64, f64)]) -> ProfilePsd {
    let (wavelengths_m, values) = samples.iter().copied().unzip();
    Psd::new(wavelengths_m, values, Convention::C1D).unwrap().profile().unwrap()
}

/// A map of rows that are not periodic, cut from longer ones.
fn measurement(points: usize, spacing_m: f64, seed: u64) -> (Scan, ReliableBand, ProfilePsd) {
    let mut random = Random(seed);
    let rows =
        (0..32).flat_map(|_| periodic_profile_m(4 * points, spacing_m, &mut random)[..points].to_vec());
    let scan = Scan::Map(HeightMap::new(points, spacing_m, spacing_m, rows.collect()).unwrap());
    let band = ReliableBand::new(&scan, BandLimits::default()).unwrap();
    let psd = line_spectrum(&scan, Preparation::default()).profile(&band).unwrap();
    (scan, band, psd)
}

#[test]
fn overlapping_measurements_join_to_the_spectrum_of_the_surface() {
    let instruments =
        [(1024, 64e-9, 1), (512, 8e-9, 2), (512, 1e-9, 3)].map(|(n, a, seed)| measurement(n, a, seed).2);
    let joined = composite(&instruments, &CompositeOptions::default()).unwrap();
    let reached: Vec<usize> = joined.bins.iter().map(|bin| bin.measurements).collect();
    assert_eq!((reached[0], reached.iter().max(), reached[reached.len() - 1]), (1, Some(&3), 1));
    for bin in joined.bins.iter().skip(3) {
        assert!((bin.wavelength_m / bin.centre_m).ln().abs() <= 0.05 * 10f64.ln() + 1e-12);
        assert_eq!(bin.standard_error_m3.is_some(), bin.measurements > 1);
        let error = (bin.c1d_m3 / self_affine_c1d_m3(TAU / bin.wavelength_m)).ln();
        assert!(error.abs() < 0.6, "{:e}: {error}", bin.wavelength_m);
    }
    let profile = joined.profile();
    assert_eq!(profile.len(), joined.bins.len());
    // The last bin, a tenth of a decade wide, holds the finest sampling of 2 nm.
    assert!(
        profile.longest_wavelength_m() > 20e-6 && profile.shortest_wavelength_m() < 2e-9 * 10f64.powf(0.1)
    );
    for overlap in overlaps(&instruments, ten()) {
        // Over a dozen bins the scatter averages out; the coarsest and the finest share only a few.
        let neighbours = overlap.second == overlap.first + 1;
        assert_eq!(neighbours, overlap.bins > 10, "{overlap:?}");
        assert!((overlap.ratio - 1.0).abs() < if neighbours { 0.25 } else { 0.5 }, "{overlap:?}");
    }
}

#[test]
fn bins_begin_at_powers_of_ten_and_their_means_are_the_ones_asked_for() {
    // q = 10^(6.1/10) and 10^(6.5/10) share a bin, 10^(7.1/10) is in the next.
    let q = |exponent: f64| TAU / 10f64.powf(exponent / 10.0);
    let first = profile(&[(q(6.1), 1.0), (q(6.5), 9.0), (q(7.1), 2.0)]);
    let second = profile(&[(q(5.5), 5.0), (q(7.5), 8.0)]);
    let mut options = CompositeOptions::default();
    let joined = composite(&[first.clone(), second.clone()], &options).unwrap();
    let bins = joined.bins;
    assert_eq!(bins.iter().map(|bin| bin.measurements).collect::<Vec<_>>(), [1, 1, 2]);
    assert_relative_eq!(bins[0].centre_m, q(5.5), max_relative = 1e-14);
    assert_relative_eq!(bins[1].centre_m, q(6.5), max_relative = 1e-14);
    assert_relative_eq!(bins[1].wavelength_m, q(6.3), max_relative = 1e-14);
    assert_eq!((bins[1].c1d_m3, bins[1].standard_error_m3), (5.0, None));
    assert_relative_eq!(bins[2].c1d_m3, 4.0, max_relative = 1e-14);
    // The logarithms scatter by ln 2 about the mean.
    assert_relative_eq!(bins[2].standard_error_m3.unwrap(), 4.0 * 2f64.ln(), max_relative = 1e-14);

    options = CompositeOptions { inside: BinMean::Geometric, across: BinMean::Arithmetic, ..options };
    let joined = composite(&[first.clone(), second], &options).unwrap();
    assert_relative_eq!(joined.bins[1].c1d_m3, 3.0, max_relative = 1e-14);
    assert_relative_eq!(joined.bins[2].c1d_m3, 5.0, max_relative = 1e-14);
    assert_relative_eq!(joined.bins[2].standard_error_m3.unwrap(), 3.0, max_relative = 1e-14);
    assert_eq!(composite(&[], &options), Err(TransformError::NoMeasurements));
    assert_eq!(log_binned(&first, ten(), BinMean::Arithmetic).c1d_m3(), [5.0, 2.0]);
}

#[test]
fn the_same_data_twice_scatter_like_one_measurement() {
    let (one, other) = (profile(&[(1e-5, 1.0), (1e-6, 1.0)]), profile(&[(1e-5, 4.0), (1e-6, 4.0)]));
    let error = |measurements: &[ProfilePsd]| {
        let bin = composite(measurements, &CompositeOptions::default()).unwrap().bins[0];
        (bin.measurements, bin.standard_error_m3)
    };
    assert_eq!(error(&[one.clone(), one.clone()]), (2, None));
    let (count, of_three) = error(&[one.clone(), other.clone(), one.clone()]);
    // The repeated measurement counts once: the logarithms of 1 and 4 scatter by ln 2 about their mean.
    assert_eq!(count, 3);
    let (_, of_two) = error(&[one, other]);
    assert_relative_eq!(of_two.unwrap(), 2.0 * 2f64.ln(), max_relative = 1e-14);
    assert_eq!(of_three, of_two);
}

#[test]
fn one_bin_is_no_spectrum() {
    let narrow = profile(&[(0.99e-6, 1.0), (0.95e-6, 1.0)]);
    assert_eq!(
        composite(&[narrow], &CompositeOptions::default()).unwrap_err().to_string(),
        "averaging spectra: all samples lie in one bin near 888 nm; use more bins per decade, a longer scan, or a smaller tip \
         radius or limit"
    );
}

#[test]
fn measurements_that_share_no_bin_do_not_overlap() {
    let (coarse, fine) = (profile(&[(1e-3, 1.0), (1e-5, 1.0)]), profile(&[(1e-6, 1.0), (1e-8, 1.0)]));
    assert_eq!(overlaps(&[coarse.clone(), fine], ten()), []);
    let twice = profile(&[(1e-3, 2.0), (1e-5, 2.0)]);
    let overlap = overlaps(&[twice, coarse], ten())[0];
    assert_relative_eq!(overlap.ratio, 2.0, max_relative = 1e-14);
    assert_eq!((overlap.longest_m, overlap.shortest_m, overlap.bins), (1e-3, 1e-5, 2));
}

#[test]
fn the_band_ends_at_the_largest_of_its_limits() {
    let scan = Scan::UniformLine(UniformLineScan::new(1e-9, vec![0.0, 1.0, 0.0, 0.5]).unwrap());
    let of = |tip_radius_m, shortest_m| ReliableBand::new(&scan, BandLimits { tip_radius_m, shortest_m });
    assert_eq!(of(None, None).unwrap().shortest_m, 2e-9);
    assert_eq!(of(None, Some(5e-9)).unwrap().shortest_m, 5e-9);
    assert_eq!(of(None, Some(1e-9)).unwrap().shortest_m, 2e-9);
    assert_eq!(
        of(Some(-1.0), None).unwrap_err().to_string(),
        "the tip radius of a scan is -1 m; it must be finite and above 0"
    );
    // Twice the spacing itself belongs to the band, whatever the rounding of L/n.
    let scan = Scan::UniformLine(UniformLineScan::new(0.1, Random(1).numbers(300)).unwrap());
    let band = ReliableBand::new(&scan, BandLimits::default()).unwrap();
    assert_eq!(line_spectrum(&scan, Preparation::PERIODIC).profile(&band).unwrap().len(), 150);
    let beyond =
        ReliableBand::new(&scan, BandLimits { shortest_m: Some(31.0), ..BandLimits::default() }).unwrap();
    let refused = line_spectrum(&scan, Preparation::default()).profile(&beyond).unwrap_err();
    assert!(
        matches!(refused, TransformError::NothingReliable { shortest_m: 31.0, longest_m: 15.0 }),
        "{refused}"
    );
}

#[test]
fn a_sharp_wave_shows_the_tip_at_the_step_where_its_curvature_reaches_half_that_of_the_tip() {
    // -2 a (1 - cos(q s))/s^2 = -1/(2 R) at the crests
    let (spacing_m, amplitude_m, wavelength_m) = (0.5e-9, 1e-9, 64e-9);
    let q_rad_per_m = TAU / wavelength_m;
    let step_m = 24e-9;
    let curvature_per_m = 2.0 * amplitude_m * (1.0 - (q_rad_per_m * step_m).cos()) / (step_m * step_m);
    let radius_m = 0.5 / curvature_per_m;
    let heights = |i: usize| amplitude_m * (q_rad_per_m * spacing_m * i as f64).cos();
    let heights_m: Vec<f64> = (0..1000).map(heights).collect();
    let even = Scan::UniformLine(UniformLineScan::new(spacing_m, heights_m.clone()).unwrap());
    let positions_m = (0..1000).map(|i| spacing_m * f64::from(i)).collect();
    let uneven = Scan::NonuniformLine(NonuniformLineScan::new(positions_m, heights_m).unwrap());
    for scan in [even, uneven] {
        let cutoff_m = tip_cutoff_m(&scan, radius_m).unwrap();
        assert_relative_eq!(cutoff_m, 2.0 * step_m, max_relative = 1e-3);
        assert_eq!(tip_cutoff_m(&scan, 1e-9), None);
        assert_relative_eq!(tip_cutoff_m(&scan, 1.0).unwrap(), 500e-9, max_relative = 1e-2);
        let band = ReliableBand::new(&scan, BandLimits { tip_radius_m: Some(radius_m), shortest_m: None });
        assert_eq!(band.unwrap().shortest_m, cutoff_m);
    }
}

proptest! {
    #[test]
    fn a_composite_of_one_measurement_lies_between_its_samples(
        steps in prop::collection::vec((1e-3..0.3, -30.0..-20.0f64), 2..60),
    ) {
        let mut decade = -3.0;
        let samples: Vec<(f64, f64)> = steps.iter().map(|&(step, log_value)| {
            decade -= step;
            (10f64.powf(decade), 10f64.powf(log_value))
        }).collect();
        let index = |sample: &(f64, f64)| ((TAU / sample.0).log10() * 10.0).floor();
        let is_single = index(&samples[0]) == index(&samples[samples.len() - 1]);
        let joined = match composite(&[profile(&samples)], &CompositeOptions::default()) {
            Err(TransformError::SingleBin { .. }) if is_single => return Ok(()),
            joined => joined.unwrap(),
        };
        prop_assert!(!is_single);
        let psd = joined.profile();
        prop_assert!(psd.wavelengths_m().windows(2).all(|pair| pair[0] > pair[1]));
        let bound = |pick: fn(f64, f64) -> f64| samples.iter().map(|sample| sample.1).reduce(pick).unwrap();
        for &c1d_m3 in psd.c1d_m3() {
            prop_assert!(c1d_m3 >= bound(f64::min) * (1.0 - 1e-12) && c1d_m3 <= bound(f64::max) * (1.0 + 1e-12));
        }
    }
}

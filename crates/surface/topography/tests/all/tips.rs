//! The radius of a tip: found in comments, used on request, and bounded by the scan if it is unknown.

use crate::transform_support::Random;
use crate::transform_support::files::file_of;
use approx::assert_relative_eq;
use scans::{HeightMap, Probe, Scan, ScanFile, UniformLineScan};
use topography::{
    BandEnd, BandLimits, GapTreatment, Recipe, ScanSpectrum, TipIndication, sharpest_peak_radius_m,
    tip_cutoff_m, without_gaps,
};
use units::{Remark, RemarkCode, SceneKeys};

/// Round peaks of this radius beside each other, with dents between them as sharp as points allow.
fn peaks(radius_m: f64) -> Scan {
    let spacing_m = 1e-9;
    let height_m = |i: i32| {
        let x_m = spacing_m * f64::from(i % 41 - 20);
        -x_m * x_m / (2.0 * radius_m)
    };
    Scan::UniformLine(UniformLineScan::new(spacing_m, (0..4100).map(height_m).collect()).expect("a line"))
}

fn whole(scan: Scan, free_text: &str) -> ScanFile<Scan> {
    let mut file = without_gaps(file_of(scan.into()), GapTreatment::Refuse).expect("no gaps");
    file.free_text = free_text.to_owned();
    file
}

fn spectrum(file: ScanFile<Scan>, given_m: Option<f64>, tip_radius_auto: bool) -> ScanSpectrum {
    let recipe = Recipe {
        tip_radius_auto,
        tip_radius_m: Some(1e-12).filter(|_| tip_radius_auto),
        ..Recipe::default()
    };
    ScanSpectrum::new(file, BandLimits { tip_radius_m: given_m, shortest_m: None }, &recipe)
        .expect("a spectrum")
}

const WORDS: &str = "Initial tip radii - 17 nm. \nFinal tip radii - 60 nm (assuming, no TEM image).";

#[test]
fn a_radius_in_words_is_used_where_that_is_asked_for_and_told_where_not() {
    let used = spectrum(whole(peaks(30e-9), WORDS), None, true);
    assert_eq!(used.band.tip_m, tip_cutoff_m(&peaks(30e-9), 60e-9));
    assert!(matches!(used.band_end, BandEnd::Tip { radius_m } if (radius_m - 60e-9).abs() < 1e-20));
    assert!(
        matches!(&used.tip_remarks[..], [Remark { code: RemarkCode::TipFromText, .. }]),
        "{:?}",
        used.tip_remarks
    );

    let told = spectrum(whole(peaks(30e-9), WORDS), None, false);
    assert_eq!(told.band_end, BandEnd::PixelsWithoutTip);
    let codes: Vec<RemarkCode> = told.tip_remarks.iter().map(|remark| remark.code).collect();
    assert_eq!(codes, [RemarkCode::TipUnknown, RemarkCode::TipIndicated, RemarkCode::TipInText]);
    assert_eq!(
        told.tip_remarks[2].clone().about(["scan"]).words(&SceneKeys),
        "scan: the metadata mention a tip radius of 60 nm ('Final tip radii - 60 nm (assuming, no TEM i'); tip radius auto uses it"
    );
}

#[test]
fn what_is_given_and_what_a_field_says_count_before_words() {
    let radius_of = |found: &ScanSpectrum| found.band.tip_m;
    let given = spectrum(whole(peaks(30e-9), WORDS), Some(80e-9), true);
    assert_eq!(radius_of(&given), tip_cutoff_m(&peaks(30e-9), 80e-9));
    assert!(given.tip_remarks.is_empty());
    let mut file = whole(peaks(30e-9), WORDS);
    file.tip_radius_m = Some(90e-9);
    assert_eq!(radius_of(&spectrum(file, None, true)), tip_cutoff_m(&peaks(30e-9), 90e-9));
    // A microscope has no tip, whatever its comments say.
    let mut file = whole(peaks(30e-9), WORDS);
    file.probe = Some(Probe::Microscope);
    assert!(spectrum(file, None, false).tip_remarks.is_empty());
}

#[test]
fn the_sharpest_peak_bounds_the_tip_and_a_spike_does_not() {
    assert_relative_eq!(sharpest_peak_radius_m(&peaks(50e-9)).unwrap(), 50e-9, max_relative = 0.05);
    let Scan::UniformLine(line) = peaks(50e-9) else { panic!("a line") };
    let mut heights_m = line.heights_m().to_vec();
    heights_m[2000] += 20e-9;
    let spiked = Scan::UniformLine(UniformLineScan::new(1e-9, heights_m).unwrap());
    assert_relative_eq!(sharpest_peak_radius_m(&spiked).unwrap(), 50e-9, max_relative = 0.2);
    let flat = Scan::UniformLine(UniformLineScan::new(1e-9, vec![0.0; 50]).unwrap());
    assert_eq!(sharpest_peak_radius_m(&flat), None);
    let two = Scan::UniformLine(UniformLineScan::new(1e-9, vec![0.0; 2]).unwrap());
    assert_eq!(sharpest_peak_radius_m(&two), None);
}

#[test]
fn what_could_be_trusted_agrees_with_the_cutoff_of_a_known_tip() {
    let mut random = Random(4);
    let mut height_m = 0.0;
    let walk: Vec<f64> = (0..64 * 400)
        .map(|_| {
            height_m = 0.95 * height_m + 3e-10 * (random.next() - 0.5);
            height_m
        })
        .collect();
    let scan = Scan::Map(HeightMap::new(400, 1e-9, 1e-9, walk).unwrap());
    let indication = TipIndication::from_scan(&scan, 2e-9);
    assert_eq!(indication.trusted.len(), 3);
    for trusted in &indication.trusted {
        match (trusted.shortest_m, tip_cutoff_m(&scan, trusted.radius_m)) {
            (Some(about_m), Some(cutoff_m)) => {
                assert!((0.999..1.2).contains(&(about_m / cutoff_m)), "{about_m} is not {cutoff_m}");
            }
            (about, cutoff) => assert_eq!(about, cutoff),
        }
    }
}

//! The radius of a tip: found in comments, used on request, and bounded by the scan if it is unknown.

use crate::transform_support::Random;
use crate::transform_support::files::file_of;
use approx::assert_relative_eq;
use scans::{HeightMap, Probe, Scan, ScanFile, UniformLineScan};
use topography::{
    BandEnd, BandLimits, GapTreatment, Recipe, ScanSpectrum, TipIndication, sharpest_peak_radius_m,
    tip_cutoff_m, without_gaps,
};
use units::RemarkCode;

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

fn spectrum(file: ScanFile<Scan>, given_m: Option<f64>) -> ScanSpectrum {
    let recipe = Recipe { tip_radius_m: Some(1e-12), ..Recipe::default() };
    ScanSpectrum::new(file, BandLimits { tip_radius_m: given_m, shortest_m: None }, &recipe)
        .expect("a spectrum")
}

const WORDS: &str = "Initial tip radii - 17 nm. \nFinal tip radii - 60 nm (assuming, no TEM image).";

#[test]
fn a_radius_in_words_is_used_and_told() {
    let used = spectrum(whole(peaks(30e-9), WORDS), None);
    assert_eq!(used.band.tip_m, tip_cutoff_m(&peaks(30e-9), 60e-9));
    assert!(matches!(used.band_end, BandEnd::Tip { radius_m } if (radius_m - 60e-9).abs() < 1e-20));
    let [told] = &used.tip_remarks[..] else { panic!("{:?}", used.tip_remarks) };
    assert_eq!((told.code, told.number("radius_m")), (RemarkCode::TipFromText, Some(60e-9)));
}

#[test]
fn an_unknown_tip_states_the_wavelength_below_which_it_may_show() {
    let unknown = |scan: Scan| {
        let file = whole(scan, "");
        let limits = BandLimits { tip_radius_m: None, shortest_m: None };
        let found = ScanSpectrum::new(file, limits, &Recipe::default()).expect("a spectrum");
        let codes: Vec<RemarkCode> = found.tip_remarks.iter().map(|remark| remark.code).collect();
        assert_eq!(codes, [RemarkCode::TipUnknown, RemarkCode::TipIndicated]);
        found.tip_remarks[1].number("may_show_below_m")
    };
    let below_m = unknown(peaks(30e-9)).expect("peaks of 30 nm, and tips of 20 and 100 nm");
    let [common_m, blunt_m] = [20e-9, 100e-9].map(|radius_m| tip_cutoff_m(&peaks(30e-9), radius_m));
    assert!((0.8..1.25).contains(&(below_m / common_m.or(blunt_m).unwrap())), "{below_m}");
    assert_eq!(unknown(peaks(10e-6)), None);
}

#[test]
fn what_is_given_and_what_a_field_says_count_before_words() {
    let radius_of = |found: &ScanSpectrum| found.band.tip_m;
    let given = spectrum(whole(peaks(30e-9), WORDS), Some(80e-9));
    assert_eq!(radius_of(&given), tip_cutoff_m(&peaks(30e-9), 80e-9));
    assert!(given.tip_remarks.is_empty());
    let mut file = whole(peaks(30e-9), WORDS);
    file.tip_radius_m = Some(90e-9);
    assert_eq!(radius_of(&spectrum(file, None)), tip_cutoff_m(&peaks(30e-9), 90e-9));
    // A microscope has no tip, whatever its comments say.
    let mut file = whole(peaks(30e-9), WORDS);
    file.probe = Some(Probe::Microscope);
    assert!(spectrum(file, None).tip_remarks.is_empty());
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

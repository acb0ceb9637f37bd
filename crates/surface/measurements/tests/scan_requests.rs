//! Scans as requested by users.

use std::collections::BTreeMap;

use measurements::{CompositeOfFiles, ScanRequest, TipRadius};
use topography::Recipe;
use units::LengthUnit;

#[test]
fn a_file_carries_its_own_options() {
    let request: ScanRequest =
        "a/scan.asc:unit=nm,channel=Height Sensor,tip-radius=20nm,shortest=46 nm".parse().unwrap();
    assert_eq!(request.path, "a/scan.asc");
    assert_eq!(request.unit, Some(LengthUnit::NANOMETRE));
    assert_eq!(request.channel.as_deref(), Some("Height Sensor"));
    assert_eq!((request.tip_radius, request.shortest_m), (Some(TipRadius::Known(20e-9)), Some(46e-9)));
}

#[test]
fn colons_of_a_path_stay_in_it() {
    for path in ["C:\\scans\\a.txt", "a:b", "scan", "12:30.txt"] {
        assert_eq!(path.parse::<ScanRequest>().unwrap().path, path);
    }
    assert_eq!("a:b:unit=um".parse::<ScanRequest>().unwrap().path, "a:b");
}

#[test]
fn wrong_options_are_named_with_the_right_ones() {
    let error = |text: &str| text.parse::<ScanRequest>().unwrap_err().to_string();
    assert_eq!(
        error("s.txt:units=nm"),
        "s.txt: unknown option 'units' of a scan; use unit, channel, size, tip-radius, shortest, gaps, direction, \
         instrument, z-calibration or slope-uncertainty"
    );
    assert!(error("s.txt:unit=furlong").starts_with("s.txt: option unit: 'furlong' is not a unit of length"));
    assert!(error("s.txt:shortest=46").starts_with("s.txt: option shortest: '46' has no unit"));
}

#[test]
fn what_is_known_of_an_instrument_follows_its_scan() {
    let request: ScanRequest =
        "a.001:instrument=AFM 2,z-calibration=3 %,slope-uncertainty=0.05".parse().unwrap();
    assert_eq!(request.instrument.as_deref(), Some("AFM 2"));
    assert_eq!((request.z_calibration, request.slope_uncertainty), (Some(0.03), Some(0.05)));
    let same: ScanRequest = "a.001:z-calibration=0.03,slope-uncertainty=0".parse().unwrap();
    assert_eq!((same.instrument, same.z_calibration), (None, Some(0.03)));
    assert_eq!(same.slope_uncertainty, Some(0.0));
}

#[test]
fn what_is_no_uncertainty_of_an_instrument_is_refused_with_value_and_bound() {
    let error = |option: &str| format!("s.txt:{option}").parse::<ScanRequest>().unwrap_err().to_string();
    for option in ["z-calibration=0", "z-calibration=101 %", "z-calibration=-3 %"] {
        let told = error(option);
        assert!(told.contains("of the height scale, as a share is "), "{told}");
        assert!(told.ends_with("it must be greater than 0 and at most 1"), "{told}");
    }
    assert_eq!(
        error("z-calibration=3 nm"),
        "s.txt: option z-calibration: '3 nm' is not a fraction; write '3 %' or '0.03'"
    );
    assert_eq!(
        error("slope-uncertainty=-0.05"),
        "s.txt: option slope-uncertainty: the standard uncertainty of the spectrum's exponent is -0.05; it must be from \
         0 to 10"
    );
    assert_eq!(
        error("slope-uncertainty=5 %"),
        "s.txt: option slope-uncertainty: '5 %' is not a number; write one such as 0.05"
    );
    assert!(error("instrument= ").contains("the name of an instrument is empty"));
}

#[test]
fn scans_of_one_instrument_must_agree_on_it() {
    let heights = "0 0\n1e-6 1e-9\n2e-6 -1e-9\n3e-6 2e-9\n4e-6 0\n5e-6 1e-9\n6e-6 0\n7e-6 1e-9\n";
    let files = BTreeMap::from(["a.txt", "b.txt"].map(|name| (name.to_owned(), heights.as_bytes().to_vec())));
    let read = |options: [&str; 2]| {
        let [first, second] = [format!("a.txt:unit=m{}", options[0]), format!("b.txt:unit=m{}", options[1])]
            .map(|text| text.parse::<ScanRequest>().unwrap());
        CompositeOfFiles::read(&[first, second], &files, &Recipe::default())
    };
    for agree in [
        [",instrument=AFM,z-calibration=3 %", ",instrument=AFM,z-calibration=0.03"],
        [",instrument=AFM,z-calibration=3 %", ",instrument=AFM"],
        [",instrument=AFM,z-calibration=3 %", ",instrument=stylus,z-calibration=1 %"],
    ] {
        assert!(read(agree).is_ok(), "{agree:?}");
    }
    let error = read([",instrument=AFM,z-calibration=3 %", ",instrument=AFM,z-calibration=1 %"]).unwrap_err();
    assert_eq!(error.request, Some(1));
    assert_eq!(
        error.to_string(),
        "b.txt: the z-calibration of AFM is 0.01 here but 0.03 for a.txt; give all scans of an instrument the same"
    );
    // Without names they are guessed to be of one instrument, their format.
    let error = read([",z-calibration=3 %", ",z-calibration=1 %"]).unwrap_err();
    assert!(error.to_string().contains("the z-calibration of text is 0.01 here"), "{error}");
    let error = read([",instrument=AFM,slope-uncertainty=0", ",instrument=AFM,slope-uncertainty=0.1"]);
    assert!(error.unwrap_err().to_string().contains("slope uncertainty of AFM is 0.1 here but 0 for a.txt"));
}

//! Scans as requested by users.

use std::collections::BTreeMap;

use measurements::{CompositeOfFiles, RequestError, ScanProblem, ScanRequest, TipRadius};
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
    let error = |text: &str| text.parse::<ScanRequest>().unwrap_err();
    assert!(
        matches!(error("s.txt:units=nm"), RequestError::UnknownKey { file, key } if file == "s.txt" && key == "units")
    );
    for option in ["unit=furlong", "shortest=46"] {
        let RequestError::BadValue { file, key, .. } = error(&format!("s.txt:{option}")) else {
            panic!("{option}")
        };
        assert_eq!((file.as_str(), Some(key.as_str())), ("s.txt", option.split('=').next()));
    }
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
    for option in [
        "z-calibration=0",
        "z-calibration=101 %",
        "z-calibration=-3 %",
        "z-calibration=3 nm",
        "slope-uncertainty=-0.05",
        "slope-uncertainty=5 %",
        "instrument= ",
    ] {
        let error = format!("s.txt:{option}").parse::<ScanRequest>().unwrap_err();
        let RequestError::BadValue { key, .. } = error else { panic!("{error}") };
        assert_eq!(Some(key.as_str()), option.split('=').next());
    }
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
    // Without names they are guessed to be of one instrument, their format.
    for (options, instrument, values) in [
        ([",instrument=AFM,z-calibration=3 %", ",instrument=AFM,z-calibration=1 %"], "AFM", [0.01, 0.03]),
        ([",z-calibration=3 %", ",z-calibration=1 %"], "text", [0.01, 0.03]),
        ([",instrument=AFM,slope-uncertainty=0", ",instrument=AFM,slope-uncertainty=0.1"], "AFM", [0.1, 0.0]),
    ] {
        let error = read(options).unwrap_err();
        assert_eq!((error.file.as_deref(), error.request), (Some("b.txt"), Some(1)));
        let ScanProblem::InstrumentDisagrees { instrument: name, here, there, other, .. } = error.problem
        else {
            panic!("{error}")
        };
        assert_eq!((name.as_str(), [here, there], other.as_str()), (instrument, values, "a.txt"));
    }
}

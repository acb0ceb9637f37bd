//! Scans as requested by users.

use std::collections::BTreeMap;

use measurements::{
    CompositeOfFiles, RequestError, ScanProblem, ScanRequest, ScansInFolders, TipRadius, heights_in,
    holds_heights,
};
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
    for path in ["C:\\scans\\a.txt", "C:\\q=1\\a.txt", "D:/a=b", "a:b", "scan", "12:30.txt"] {
        assert_eq!(path.parse::<ScanRequest>().unwrap().path, path);
    }
    let on_drive: ScanRequest = "C:\\scans\\a.txt:unit=um".parse().unwrap();
    assert_eq!((on_drive.path.as_str(), on_drive.unit), ("C:\\scans\\a.txt", Some(LengthUnit::MICROMETRE)));
    assert_eq!("a:b:unit=um".parse::<ScanRequest>().unwrap().path, "a:b");
}

#[test]
fn a_unit_without_its_option_is_refused_and_keys_of_scenes_are_accepted() {
    for text in ["a.txt:um", "a.txt:unit:um"] {
        let error = text.parse::<ScanRequest>().unwrap_err();
        assert!(
            matches!(&error, RequestError::BareUnit { file, unit } if file == "a.txt" && unit == "um"),
            "{error}"
        );
    }
    let request: ScanRequest = "a.txt:tip_radius=2um,shortest_wavelength=5um".parse().unwrap();
    assert_eq!((request.tip_radius, request.shortest_m), (Some(TipRadius::Known(2e-6)), Some(5e-6)));
}

#[test]
fn a_file_is_known_by_what_it_holds() {
    let trace = b"X (mm),Z (um)\n0,0.5\n0.1,0.25\n0.2,0.75\n";
    assert!(holds_heights("a.txt", trace) && heights_in("a.txt", b"1 2\n2 1\n").is_some());
    for other in
        [&b"# Nothing\nto see\n"[..], b"wavelength_m,C1D_m3\n1e-5,1\n1e-6,2\n", b"\x89PNG\r\n\x1a\n", b""]
    {
        assert!(!holds_heights("a.txt", other), "{}", other.escape_ascii());
    }
    let read = |name: &str, text: &[u8]| {
        let files = BTreeMap::from([(name.to_owned(), text.to_vec())]);
        let request: ScanRequest = name.parse().unwrap();
        CompositeOfFiles::read(&[request], &files, &Recipe::default()).unwrap_err().problem
    };
    assert!(matches!(read("a.toml", b"[surface]\npsd = \"a.csv\"\n"), ScanProblem::IsAScene));
}

#[test]
fn a_folder_is_all_scans_in_it() {
    let trace = |spacing: f64| {
        (0..64).map(|at| format!("{} {}\n", spacing * f64::from(at), (at * 7) % 31)).collect::<String>()
    };
    let files = BTreeMap::from([
        ("day/a.txt".to_owned(), trace(1.0).into_bytes()),
        ("day/b.txt".to_owned(), trace(2.0).into_bytes()),
        ("day/readme.md".to_owned(), b"# Nothing\n".to_vec()),
        ("other/readme.md".to_owned(), b"# Nothing\n".to_vec()),
    ]);
    let find =
        |typed: &str| ScansInFolders::find(&["c.txt".parse().unwrap(), typed.parse().unwrap()], &files);
    let found = find("day:unit=nm").unwrap();
    let paths: Vec<&str> = found.requests.iter().map(|request| request.path.as_str()).collect();
    assert_eq!((paths, found.origins), (vec!["c.txt", "day/a.txt", "day/b.txt"], vec![0, 1, 1]));
    assert_eq!(
        (found.requests[2].unit, found.skipped),
        (Some(LengthUnit::NANOMETRE), vec!["day/readme.md".to_owned()])
    );
    let error = find("other").unwrap_err();
    assert!(matches!((error.problem, error.request), (ScanProblem::NoScanInFolder, Some(1))));
}

#[test]
#[cfg(feature = "formats")]
fn an_optical_map_has_no_tip() {
    let metadata = "surfaces:\n- topographies:\n  - {name: m, datafile: {original: map.txt}, unit: nm, \
                    instrument: {type: microscope-based}}\n";
    let trace = (0..64).map(|at| format!("{at} {}\n", (at * 7) % 31)).collect::<String>();
    let files = BTreeMap::from([
        ("map.txt".to_owned(), trace.into_bytes()),
        ("meta.yml".to_owned(), metadata.as_bytes().to_vec()),
    ]);
    let read = |typed: &str| CompositeOfFiles::read(&[typed.parse().unwrap()], &files, &Recipe::default());
    assert!(read("map.txt").is_ok());
    let error = read("map.txt:tip-radius=2um").unwrap_err();
    assert!(matches!(error.problem, ScanProblem::NoTip), "{error}");
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
        // Text files of two calibrations are not of one instrument.
        [",z-calibration=3 %", ",z-calibration=1 %"],
    ] {
        assert!(read(agree).is_ok(), "{agree:?}");
    }
    for (options, instrument, values) in [
        ([",instrument=AFM,z-calibration=3 %", ",instrument=AFM,z-calibration=1 %"], "AFM", [0.01, 0.03]),
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

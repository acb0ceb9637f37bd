//! Scans as they are asked for.

use measurements::{ScanRequest, TipRadius};
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
        "s.txt: there is no option 'units' of a scan; there are unit, channel, size, tip-radius, shortest, gaps and direction"
    );
    assert!(error("s.txt:unit=furlong").starts_with("s.txt: option unit: 'furlong' is no unit of length"));
    assert!(error("s.txt:shortest=46").starts_with("s.txt: option shortest: '46' has no unit"));
}

//! Images of Nanonis controllers; files of this layout were compared with Gwyddion.

use super::{Sample, assert_holds, channels, refusal};
use scans::{Measure, Probe, ScanAxis, ScanOptions, read_scans};

/// Two channels of 3 x 2 points in both directions, the second line of the first never measured.
fn sxm(direction: &str, header: impl Fn(String) -> String) -> Vec<u8> {
    let text = format!(
        ":NANONIS_VERSION:\n2\n:SCANIT_TYPE:\n              FLOAT            MSBFIRST\n:SCAN_PIXELS:\n       3       2\n\
         :SCAN_RANGE:\n           3.000000E-8           1.000000E-8\n:SCAN_DIR:\n{direction}\n:COMMENT:\nW tip\n\
         :DATA_INFO:\n\tChannel\tName\tUnit\tDirection\tCalibration\tOffset\n\t14\tZ\tm\tboth\t-3.480E-9\t-4.8E-7\n\
         \t0\tBias_spare\tA\tforward\t1.000E-9\t1.0E-12\n\n:SCANIT_END:\n\n\n\u{1a}\u{4}"
    );
    let mut bytes = header(text).into_bytes();
    let images = [[1f32, 2.0, 3.0, f32::NAN, f32::NAN, f32::NAN], [3.0, 2.0, 1.0, 6.0, 5.0, 4.0], [7.0; 6]];
    bytes.extend(images.as_flattened().iter().flat_map(|number| number.to_be_bytes()));
    bytes
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "two channels", bytes: sxm("down", |text| text) }]
}

#[test]
fn images_lie_as_they_were_scanned() {
    let (gap, metres) = ([None; 3], |numbers: [f64; 3]| numbers.map(Some));
    let (first, second) = (metres([1.0, 2.0, 3.0]), metres([4.0, 5.0, 6.0]));
    for (direction, forward, backward) in
        [("down", [first, gap], [first, second]), ("up", [gap, first], [second, first])]
    {
        let all: Vec<_> =
            channels(&sxm(direction, |text| text), true).into_iter().map(Result::unwrap).collect();
        let names: Vec<_> = all.iter().map(|file| file.channel.as_deref().unwrap()).collect();
        assert_eq!(names, ["Z (Forward)", "Z (Backward)", "Bias spare (Forward)"]);
        let size = (3e-8, Some(1e-8));
        assert_holds(&all[0].scan, size, forward.as_flattened(), 0.0);
        assert_holds(&all[1].scan, size, backward.as_flattened(), 0.0);
        assert_eq!(all[2].measure, Measure::Other("A".to_owned()));
        assert_eq!((all[0].probe, all[0].fast_axis), (Some(Probe::Tip), Some(ScanAxis::X)));
        assert_eq!(all[0].free_text, "W tip");
    }
}

#[test]
fn damage_is_told() {
    let with = |from: &'static str, to: &'static str| refusal(&sxm("down", |text| text.replace(from, to)));
    refused!(with("MSBFIRST", "LSBFIRST"), BadField { bound: "FLOAT MSBFIRST" });
    refused!(with("3       2", "3"), BadField { value: "'3'" });
    refused!(with("\tboth\t", "\tnone\t"), BadField { value: "'none'" });
    refused!(with(":SCAN_DIR:", ":SCAN_WAY:"), MissingField { field: "tag SCAN_DIR" });
    refused!(with(":SCANIT_END:", ""), MissingField { field: "tag SCANIT_END" });
    // The image that is cut off is refused, those before it are read.
    let whole = sxm("down", |text| text);
    let cut = &whole[..whole.len() - 25];
    let backward = ScanOptions { channel: Some("Z (Backward)".to_owned()), ..ScanOptions::default() };
    refused!(read_scans(cut, "scan", &backward).unwrap_err(), Truncated { needed: 24, available: 23 });
    assert_eq!(read_scans(cut, "scan", &ScanOptions::default()).unwrap()[0].scan.missing_points().count(), 3);
}

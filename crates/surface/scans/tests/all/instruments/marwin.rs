//! MarWin: traced profiles in a ZIP file, evenly spaced or not.

use crate::instruments::refusal;
use scans::{MeasuredScan, Probe, Scan};

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, heights};
use crate::support::zip_file;

const EVEN_MM: [f64; 4] = [1.0, 1.5, 2.0, 2.5];
const UNEVEN_MM: [f64; 4] = [1.0, 1.5, 2.5, 2.75];

/// Heights in mm of four points, the third of which was not measured.
fn profile(positions_mm: [f64; 4]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put("[p3dlin]").pad_to(0x14).put(4u32.to_le_bytes()).pad_to(0xc4);
    let texts = [">MachineName=MarSurf", ">ProbeRadius=0.002", ">Comment=bearing seat"];
    file.put((texts.len() as u32).to_le_bytes());
    for text in texts {
        file.put((text.len() as u32).to_le_bytes()).put(text);
    }
    file.zeros(5).put("[sellsg]").zeros(3).put("[Trajec]").zeros(41);
    for array in [positions_mm, [0.0; 4], [0.25, -0.5, 99.0, 0.125]] {
        array.iter().for_each(|number| {
            file.put(number.to_le_bytes());
        });
    }
    for flag in [0f32, 0.0, 1.0, 0.0] {
        file.put(flag.to_le_bytes());
    }
    file.0
}

fn zipped(files: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let files = files.iter().map(|(path, bytes)| (*path, bytes.as_slice()));
    zip_file::zipped(&files.collect::<Vec<_>>())
}

fn even() -> Vec<u8> {
    let reference = "qe_contour_reference_profil_001.tmp";
    zipped(&[(reference, profile(EVEN_MM)), ("Kontur1.prf", profile(EVEN_MM))])
}

fn of(positions_mm: [f64; 4]) -> Vec<u8> {
    zipped(&[("Kontur1.prf", profile(positions_mm))])
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "even", bytes: even() }, Sample { name: "uneven", bytes: of(UNEVEN_MM) }]
}

#[test]
fn even_profiles_keep_their_missing_points() {
    let [measured, reference] = heights(&even()).try_into().unwrap();
    assert_holds(&measured.scan, (2e-3, None), &[Some(0.25e-3), Some(-0.5e-3), None, Some(0.125e-3)], 1e-18);
    assert_eq!(
        (measured.channel.as_deref(), reference.channel.as_deref()),
        (Some("measured"), Some("reference"))
    );
    assert_eq!((measured.probe, measured.tip_radius_m), (Some(Probe::Tip), Some(2e-6)));
    assert_eq!(measured.free_text, "bearing seat");
}

#[test]
fn uneven_profiles_leave_them_out() {
    let positions_m = |scan: MeasuredScan| match scan.complete().unwrap() {
        Scan::NonuniformLine(line) => (line.positions_m().to_vec(), line.heights_m().to_vec()),
        other => panic!("{other:?}"),
    };
    let [scan] = heights(&of(UNEVEN_MM)).try_into().unwrap();
    assert_eq!(
        scan.notes[1..],
        ["1 of 4 points have no height and are left out of the unevenly spaced line"]
    );
    assert_eq!(positions_m(scan.scan), (vec![1e-3, 1.5e-3, 2.75e-3], vec![0.25e-3, -0.5e-3, 0.125e-3]));
    let falling = UNEVEN_MM.map(|position| -position);
    let [scan] = heights(&of(falling)).try_into().unwrap();
    assert_eq!(positions_m(scan.scan), (vec![-2.75e-3, -1.5e-3, -1e-3], vec![0.125e-3, -0.5e-3, 0.25e-3]));
}

#[test]
fn damage_is_told() {
    let refusal_of = |profile: Vec<u8>| refusal(&zipped(&[("Kontur1.prf", profile)]));
    refused!(refusal_of(b"PK".to_vec()), BadField { field: "the beginning of a profile", value: "'PK'" });
    let whole = profile(EVEN_MM);
    refused!(refusal_of(whole[..whole.len() - 1].to_vec()), Truncated { needed: 16, available: 15 });
    let mut marks = whole.clone();
    marks.iter_mut().filter(|byte| **byte == b'T').for_each(|byte| *byte = b't');
    refused!(refusal_of(marks), MissingField { field: "section '[Trajec]'" });
    let mut count = whole;
    count[0x14..0x18].fill(0x7f);
    refused!(refusal_of(count), Truncated { needed: 17112497144, available: 112 });
    refused!(
        refusal(&of([0.0, f64::NAN, 2.0, 3.0])),
        BadField { field: "a position", value: "no number at point 2" }
    );
    refused!(refusal(&of([0.0, -1.0, 2.0, 3.0])), Scan(PositionsDoNotRise {}));
}

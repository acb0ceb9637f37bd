//! The sample exports of the shared folder beside the checkout, of all generations.

use std::path::PathBuf;

use spectrum::{Convention, PsdFile, ReadOptions, SeriesName, read_psd, series_names};

fn export(name: &str) -> Vec<u8> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../../shared/data/exports").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

const X: &str = "1D PSD along x";
const Y: &str = "1D PSD along y";
const AREA: &str = "q/π × 2D PSD";

/// Every export, whether it names the subject `sample 1`, and whether it has its units.
fn exports() -> impl Iterator<Item = (&'static str, bool, Vec<u8>)> {
    [
        ("genA_psd.txt", false),
        ("genA_psd.xlsx", true),
        ("genB_psd.txt", true),
        ("genB_psd.csv", true),
        ("genB_psd.xlsx", true),
        ("genC_psd.csv", true),
        ("genC_psd.txt", true),
    ]
    .into_iter()
    .map(|(name, has_subject)| (name, has_subject, export(name)))
    .filter(|(name, ..)| cfg!(feature = "xlsx") || !name.ends_with("xlsx"))
}

fn series(name: &str) -> ReadOptions {
    ReadOptions { series: Some(name.to_owned()), ..ReadOptions::default() }
}

fn assert_close(file: &PsdFile, first: [f64; 2], last: [f64; 2], len: usize) {
    let close = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-14;
    let q = |i: usize| std::f64::consts::TAU / file.psd.wavelengths_m()[i];
    assert_eq!(file.psd.len(), len);
    assert_eq!(file.psd.convention(), Convention::C1D);
    for (i, [q_rad_per_m, c1d_m3]) in [(0, first), (len - 1, last)] {
        assert!(close(q(i), q_rad_per_m), "{}", q(i));
        assert!(close(file.psd.values()[i], c1d_m3), "{}", file.psd.values()[i]);
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn every_export_holds_the_same_series_in_the_same_unit() {
    for (name, has_subject, bytes) in exports() {
        println!("{name}");
        let found = series_names(&bytes[..]).unwrap();
        let reliable: Vec<&SeriesName> = found.iter().filter(|name| name.is_reliable()).collect();
        assert_eq!(
            reliable.iter().filter_map(|name| name.series.as_deref()).collect::<Vec<_>>(),
            [X, Y, AREA]
        );
        assert!(found.iter().all(|name| name.subject.as_deref() == has_subject.then_some("sample 1")));

        let usual = read_psd(&bytes[..], &ReadOptions::default()).unwrap();
        let first = [6.283185307179586e5, 6.610473859781669e-21];
        assert_close(&usual, first, [3.769911184307752e7, 2.80212622418777e-53], 21);
        assert!(usual.notes[0].contains("1D PSD along x' is read; choose another by its series or subject"));
        assert_eq!(read_psd(&bytes[..], &series(X)).unwrap().psd, usual.psd);

        let y = read_psd(&bytes[..], &series("1d psd along Y")).unwrap();
        let first = [6.283185307179586e5, 5.484001342718478e-21];
        assert_close(&y, first, [3.769911184307752e7, 1.831948584745788e-53], 21);

        let area = read_psd(&bytes[..], &series("q/pi x 2D PSD")).unwrap();
        let first = [6.283185307179586e5, 4.045443589989427e-22];
        assert_close(&area, first, [3.828234950756415e7, 2.5353986020646135e-53], 25);
        assert!(area.notes.iter().any(|note| note.contains("which is C1D only for a Hurst exponent of 1/2")));

        let refusal = read_psd(&bytes[..], &series("1D PSD")).unwrap_err().to_string();
        assert!(
            refusal.contains("there is no series '1D PSD'") && refusal.contains("'q/π × 2D PSD'"),
            "{refusal}"
        );
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn the_series_of_json_takes_the_units_given() {
    let bytes = export("series-0.json");
    let units =
        ReadOptions { x_unit: Some("1/um".into()), psd_unit: Some("um^3".into()), ..ReadOptions::default() };
    let file = read_psd(&bytes[..], &units).unwrap();
    let first = [6.283185307179586e5, 6.610473859781669e-21];
    assert_close(&file, first, [3.769911184307752e7, 2.80212622418777e-53], 21);
    let refusal = read_psd(&bytes[..], &ReadOptions::default()).unwrap_err().to_string();
    assert!(refusal.contains("states no units, and both are needed"), "{refusal}");
}

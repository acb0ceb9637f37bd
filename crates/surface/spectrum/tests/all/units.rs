//! Files without units, with units given by the caller; series of JSON among them.

use std::f64::consts::TAU;

use spectrum::{Abscissa, Convention, PsdFile, ReadOptions, is_psd, read_psd, series_names};

fn units(x: &str, psd: &str) -> ReadOptions {
    ReadOptions {
        x_unit: (!x.is_empty()).then(|| x.to_owned()),
        psd_unit: (!psd.is_empty()).then(|| psd.to_owned()),
        ..ReadOptions::default()
    }
}

fn read(text: &str, options: &ReadOptions) -> PsdFile {
    read_psd(text.as_bytes(), options).unwrap_or_else(|error| panic!("{error}"))
}

const BARE: &str = "1 2\n2 3\n4 5\n";
const JSON: &str = "{\"name\": \"1D PSD along x\", \"x\": [1, 2, 4],\n \"y\": [6.1e-3, null, 4e-3],\n \
                    \"std_err_y\": [1e-4, null, null]}\n";

#[test]
fn the_units_of_bare_columns_tell_what_they_hold() {
    let file = read(BARE, &units("nm", "um^3"));
    assert_eq!(file.psd.wavelengths_m(), [4e-9, 2e-9, 1e-9]);
    assert_eq!(file.psd.values(), [5e-18, 3e-18, 2e-18]);
    assert_eq!(file.psd.convention(), Convention::C1D);
    assert_eq!(
        file.notes,
        [
            "the first column, in nm, is read as the wavelength",
            "the second column, in um^3, is read as C1D, sigma^2 = (1/pi) Int C dq"
        ]
    );
    let file = read(BARE, &units("1/µm", "m^4"));
    assert_eq!(file.psd.wavelengths_m(), [TAU / 1e6, TAU / 2e6, TAU / 4e6]);
    assert_eq!(file.psd.convention(), Convention::Ciso);
    assert_eq!(
        file.notes[..2],
        [
            "the first column, in 1/µm, is read as the wavevector",
            "the second column, in m^4, is read as Ciso, sigma^2 = (1/2 pi) Int q C dq"
        ]
    );
    let frequency = ReadOptions { x: Some(Abscissa::Frequency), ..units("1/mm", "um^3") };
    assert_eq!(read(BARE, &frequency).psd.convention(), Convention::Frequency);
    let stated = ReadOptions { convention: Some(Convention::Persson), ..units("m", "nm^4") };
    let file = read(BARE, &stated);
    assert_eq!(file.psd.convention(), Convention::Persson);
    assert_eq!(file.psd.values(), [5e-36, 3e-36, 2e-36]);
}

#[test]
fn what_is_not_given_is_in_si_and_noted() {
    let stated = ReadOptions {
        x: Some(Abscissa::Wavevector),
        convention: Some(Convention::W1),
        ..ReadOptions::default()
    };
    assert_eq!(read(BARE, &stated).notes, ["the file states no units; its columns are read in SI units"]);
    let with_x = ReadOptions { x_unit: Some("1/um".into()), ..stated.clone() };
    assert_eq!(
        read(BARE, &with_x).notes,
        ["the file states no unit of the spectrum, which is read in SI units"]
    );
    let with_psd = ReadOptions { psd_unit: Some("nm^3".into()), ..stated };
    assert_eq!(
        read(BARE, &with_psd).notes,
        ["the file states no unit of the wavevector, which is read in SI units"]
    );
}

#[test]
fn headers_without_units_take_those_given() {
    let file = read("q,psd,psd_se\n1,2,0.5\n2,3,\n", &units("1/um", "um^3"));
    assert_eq!(file.psd.wavelengths_m(), [TAU / 1e6, TAU / 2e6]);
    assert_eq!(file.psd.values(), [2e-18, 3e-18]);
    assert_eq!(file.psd.standard_errors(), Some(&[Some(5e-19), None][..]));
    assert_eq!(
        file.notes,
        ["column 'psd' states no convention and is read as C1D, sigma^2 = (1/pi) Int C dq"]
    );
}

#[test]
fn units_of_a_header_are_not_overruled() {
    let text = "Wavevector (µm⁻¹),PSD (µm³)\n1,2\n2,3\n";
    assert_eq!(read(text, &units("1/um", "um^3")), read(text, &ReadOptions::default()));
}

#[test]
fn a_json_series_needs_both_units() {
    let file = read(JSON, &units("1/um", "um^3"));
    assert_eq!(file.psd.wavelengths_m(), [TAU / 1e6, TAU / 4e6]);
    assert_eq!(file.psd.values(), [6.1e-21, 4e-21]);
    assert_eq!(file.psd.standard_errors(), Some(&[Some(1e-22), None][..]));
    assert_eq!(
        file.notes,
        [
            "the first column, in 1/um, is read as the wavevector",
            "the second column, in um^3, is read as C1D, sigma^2 = (1/pi) Int C dq",
            "1 row without a value is left out"
        ]
    );
}

#[test]
fn json_holds_one_series_or_several() {
    let both = format!("[{JSON}, {}]", JSON.replace("along x", "along y").replace("6.1e-3", "7e-3"));
    let names: Vec<_> = series_names(both.as_bytes()).unwrap().into_iter().map(|name| name.series).collect();
    assert_eq!(names, [Some("1D PSD along x".to_owned()), Some("1D PSD along y".to_owned())]);
    assert_eq!(read(&both, &units("1/um", "um^3")).psd.values(), [6.1e-21, 4e-21]);
    let y = ReadOptions { series: Some("1D PSD along y".into()), ..units("1/um", "um^3") };
    assert_eq!(read(&both, &y).psd.values(), [7e-21, 4e-21]);
    let analysis = format!(
        "{{\"name\": \"PSD\", \"xlabel\": \"Wavevector\", \"ylabel\": \"PSD\", \"xunit\": \"µm⁻¹\", \"yunit\": \
         \"µm³\", \"series\": {both}}}"
    );
    let file = read(&analysis, &ReadOptions::default());
    assert_eq!(file.psd, read(&both, &units("1/um", "um^3")).psd);
}

const ROWS: &str = "[{\"lambda_nm\": 4, \"C1D_m3\": 5e-28, \"C1D_se_m3\": 1e-29},\n {\"lambda_nm\": 2, \"C1D_m3\": 3e-28},\n \
                    {\"C1D_m3\": \"2e-28\", \"lambda_nm\": 1, \"C1D_se_m3\": null, \"remark\": \"last\"}]";

#[test]
fn json_holds_rows_as_well() {
    let file = read(ROWS, &ReadOptions::default());
    assert_eq!(file.psd.wavelengths_m(), [4e-9, 2e-9, 1e-9]);
    assert_eq!(file.psd.values(), [5e-28, 3e-28, 2e-28]);
    assert_eq!(file.psd.standard_errors(), Some(&[Some(1e-29), None, None][..]));
    let usual = ReadOptions::default();
    assert!(
        read_psd(ROWS.replace("lambda_nm", "width").as_bytes(), &usual)
            .unwrap_err()
            .to_string()
            .contains("'width'")
    );
}

#[test]
fn a_spectrum_is_told_from_other_files() {
    let is_spectrum = |text: &str| is_psd(text.as_bytes());
    assert!(is_spectrum(ROWS));
    assert!(is_spectrum(JSON));
    assert!(is_spectrum("lambda_m,C1D_m3\n1,-2\n"));
    for text in [
        BARE,
        "",
        "x [mm];h [um]\n0;1\n1;2\n",
        "[{\"x\": 1, \"y\": 2}]",
        "[1, 2]",
        "{\"a\": 1}",
        "CDF\u{2}\0",
    ] {
        assert!(!is_spectrum(text), "{text}");
    }
}

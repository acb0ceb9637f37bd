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

#[track_caller]
fn assert_refused(text: &str, options: &ReadOptions, line: Option<usize>, message: &str) {
    let error = read_psd(text.as_bytes(), options).unwrap_err();
    assert_eq!(error.to_string(), message);
    assert_eq!(error.line(), line);
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
    assert_refused(
        BARE,
        &units("1/um", ""),
        Some(1),
        "line 1: the file has no header that names its two columns",
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
    assert_refused(
        "q,psd\n1,2\n2,3\n",
        &units("nm", ""),
        Some(1),
        "line 1: column 'q' is in 'nm', but the wavevector is read in rad/m or 1/m, and the same with cm, mm, um, nm, \
         angstrom, pm, km, inch, uin; rename the column",
    );
}

#[test]
fn units_of_a_header_are_not_overruled() {
    let text = "Wavevector (µm⁻¹),PSD (µm³)\n1,2\n2,3\n";
    assert_eq!(read(text, &units("1/um", "um^3")), read(text, &ReadOptions::default()));
    assert_refused(
        text,
        &units("1/nm", ""),
        Some(1),
        "line 1: column 'Wavevector (µm⁻¹)' is in '1/um', but '1/nm' is given for it; correct the file",
    );
    assert_refused(
        text,
        &units("1/um", "m^3"),
        Some(1),
        "line 1: column 'PSD (µm³)' is in 'um^3', but 'm^3' is given for it; correct the file",
    );
}

#[test]
fn units_that_are_none_are_refused_whatever_the_file() {
    for text in [BARE, JSON, "lambda_m,C1D_m3\n1,2\n2,3\n"] {
        assert_refused(
            text,
            &units("furlong", "um^3"),
            None,
            "'furlong' is not a unit of the abscissa; give one such as m, um or nm for a wavelength, 1/m, 1/um or \
             1/nm for a wavevector",
        );
        assert_refused(
            text,
            &units("1/um", "um^2"),
            None,
            "'um^2' is not a unit of the spectrum; give one such as m^3, um^3 or nm^3 for a profile, m^4, um^4 or \
             nm^4 for an area",
        );
    }
    assert_refused(
        BARE,
        &ReadOptions { x: Some(Abscissa::Wavelength), ..units("1/um", "um^3") },
        None,
        "'1/um' is not a unit of the wavelength; give one such as m, um or nm",
    );
    assert_refused(
        BARE,
        &ReadOptions { convention: Some(Convention::Ciso), ..units("1/um", "um^3") },
        None,
        "'um^3' is not a unit of the spectrum (ciso); give one such as m^4, um^4 or nm^4",
    );
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
    for options in [units("", ""), units("1/um", ""), units("", "um^3")] {
        assert_refused(
            JSON,
            &options,
            Some(2),
            "line 2: the JSON series states no units, and both are needed",
        );
    }
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

#[test]
fn json_that_is_no_series_is_refused() {
    let given = units("1/um", "um^3");
    assert_refused(
        &JSON.replace("[1, 2, 4]", "[1, 2]"),
        &given,
        None,
        "reading a series from JSON: the series '1D PSD along x' has 2 numbers in 'x' and 3 in 'y'; give one for each",
    );
    assert_refused(
        &JSON.replace("1e-4, null, null", "1e-4"),
        &given,
        None,
        "reading a series from JSON: the series '1D PSD along x' has 3 numbers in 'x' and 1 in 'std_err_y'; give one for \
         each",
    );
    assert_refused(
        "{\"x\": [1, 2]}",
        &given,
        None,
        "reading a series from JSON: the object has no array 'y'; a series is {\"name\": ..., \"x\": [...], \"y\": \
         [...], \"std_err_y\": [...]}, the last of which may be missing",
    );
    assert_refused(
        "[]",
        &given,
        None,
        "reading a series from JSON: the array of series is empty; give at least 1",
    );
    assert_refused(
        &JSON.replace("null, 4e-3", "NaN, 4e-3"),
        &given,
        Some(2),
        "line 2, column 16: reading a series from JSON: expected value; a missing number is null, not NaN",
    );
    assert_refused(
        "{\"x\": 1}",
        &given,
        Some(1),
        "line 1, column 7: reading a series from JSON: invalid type: integer `1`, expected a sequence",
    );
    assert_refused(
        &JSON.replace("null, 4e-3", "0, 4e-3"),
        &given,
        Some(2),
        "line 2: column 'y[1]' is '0'; it must be finite and above 0: correct it or remove the row",
    );
    assert_refused(
        &JSON.replace("[1, 2, 4]", "[1, 2, \"b\"]"),
        &given,
        Some(2),
        "line 2: column 'x[2]' is 'b', not a number; write it like 1.5e-9, with a point, or remove the row",
    );
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
    assert_refused(
        &ROWS.replace("\"lambda_nm\": 1,", "\"lambda_nm\": null,"),
        &usual,
        Some(3),
        "line 3: column 'lambda_nm' is empty; enter a number above 0 or remove the row",
    );
    assert_refused(
        &ROWS.replace("3e-28", "-3e-28"),
        &usual,
        Some(2),
        "line 2: column 'C1D_m3' is '-3e-28'; it must be finite and above 0: correct it or remove the row",
    );
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

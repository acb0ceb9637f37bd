//! Files of several series: exports of contact.engineering as text, and graphs of Gwyddion.

use std::f64::consts::TAU;

use spectrum::{Convention, PsdFile, ReadError, ReadOptions, SeriesName, read_psd, series_names};

fn read(text: &str, options: &ReadOptions) -> PsdFile {
    read_psd(text.as_bytes(), options).unwrap_or_else(|error| panic!("{error}"))
}

fn default(text: &str) -> PsdFile {
    read(text, &ReadOptions::default())
}

fn refusal(text: &str, options: &ReadOptions) -> String {
    read_psd(text.as_bytes(), options).unwrap_err().to_string()
}

fn series(name: &str) -> ReadOptions {
    ReadOptions { series: Some(name.to_owned()), ..ReadOptions::default() }
}

fn of(subject: &str, name: &str) -> ReadOptions {
    ReadOptions { subject: Some(subject.to_owned()), ..series(name) }
}

fn names(text: &str) -> Vec<String> {
    series_names(text.as_bytes()).unwrap().iter().map(SeriesName::to_string).collect()
}

/// Until mid 2023: the measurement's own unit, a missing value is `nan`.
const GENERATION_A: &str = "\
# Power Spectrum
# ==============
# 
# 1D PSD along x
# --------------
# Columns: Wavevector (µm⁻¹), PSD (µm³)
1.0e+00 5.0e-03
2.0e+00 nan
4.0e+00 3.0e-04

# q/π × 2D PSD
# ------------
# Columns: Wavevector (µm⁻¹), PSD (µm³)
1.0e+00 4.0e-03
2.0e+00 4.0e-04
";

/// 2023 to 2026: SI, with subjects.
const GENERATION_B: &str = "\
# Power spectral density
# ======================
# IF YOU USE THIS DATA IN A PUBLICATION, PLEASE CITE THE FOLLOWING PAPERS:
# - 10.1088/2051-672X/aa51f8
#
# topography: scan 1
# ==================
# Creator: A. User
# 
# 1D PSD along x
# --------------
# Columns: Wavevector (1/m), PSD (m³)
1e6 6e-21
2e6 4e-21

# 1D PSD along x (incl. unreliable data)
# --------------------------------------
# Columns: Wavevector (1/m), PSD (m³)
1e6 6e-21
2e6 4e-21
4e6 1e-21

# surface: the dataset
# ====================
# 
# 1D PSD along x
# --------------
# Columns: Wavevector (1/m), PSD (m³), standard error of PSD (m³)
1e6 7e-21 1e-22
2e6 5e-21 nan
";

const GENERATION_B_CSV: &str = "\
Subject type;Subject name;Creator;Data series;Wavevector (1/m);PSD (m³);standard error of PSD (m³);comment
measurement;scan 1;A. User;1D PSD along x;1e6;6e-21;;
measurement;scan 1;A. User;1D PSD along x;2e6;4e-21;;
measurement;scan 1;A. User;q/π × 2D PSD;1e6;5e-21;;
measurement;scan 1;A. User;q/π × 2D PSD;2e6;3e-21;;
measurement;scan 2;A. User;1D PSD along x;1e6;8e-21;;
measurement;scan 2;A. User;1D PSD along x;2e6;6e-21;;
surface;the dataset;A. User;1D PSD along x;1e6;7e-21;1e-21;
surface;the dataset;A. User;1D PSD along x;2e6;5e-21;;
surface;the dataset;A. User;1D PSD along x;4e6;;;unreliable
";

/// 2026: commas, the first unit.
const GENERATION_C_CSV: &str = "\
Subject,Series,Wavevector (µm⁻¹),PSD (µm³)
scan 1,1D PSD along x,1,0.006
scan 1,1D PSD along x,2,0.004
scan 1,1D PSD along x,4,
scan 1,1D PSD along y,1,0.005
scan 1,1D PSD along y,2,0.003
";

#[test]
fn the_first_generation_is_read_in_its_own_unit() {
    let file = default(GENERATION_A);
    assert_eq!(file.psd.wavelengths_m(), [TAU / 1e6, TAU / 4e6]);
    assert_eq!(file.psd.values(), [5e-21, 3e-22]);
    assert_eq!(file.psd.convention(), Convention::C1D);
    assert_eq!(
        file.notes,
        [
            "the file holds 2 series; '1D PSD along x' is read; choose another by its series or subject",
            "column 'PSD (µm³)' states no convention and is read as C1D, sigma^2 = (1/pi) Int C dq",
            "1 row without a value is left out",
        ]
    );
    assert_eq!(names(GENERATION_A), ["1D PSD along x", "q/π × 2D PSD"]);
}

#[test]
fn names_are_matched_in_any_case_and_without_greek() {
    for name in ["q/π × 2D PSD", "q/pi x 2D PSD", "Q/PI X 2d psd"] {
        let file = read(GENERATION_A, &series(name));
        assert_eq!(file.psd.values(), [4e-21, 4e-22]);
        assert!(
            file.notes[2].starts_with("the series 'q/π × 2D PSD' is q/pi times a two-dimensional spectrum")
        );
    }
}

#[test]
fn the_second_generation_names_subjects_and_prefers_the_average_of_the_dataset() {
    assert_eq!(
        names(GENERATION_B),
        [
            "scan 1 - 1D PSD along x",
            "scan 1 - 1D PSD along x (incl. unreliable data)",
            "the dataset - 1D PSD along x"
        ]
    );
    let found = series_names(GENERATION_B.as_bytes()).unwrap();
    assert_eq!(found[0].subject_type.as_deref(), Some("topography"));
    assert_eq!(found.iter().map(SeriesName::is_reliable).collect::<Vec<_>>(), [true, false, true]);
    for text in [GENERATION_B, GENERATION_B_CSV] {
        let average = default(text);
        assert_eq!(average.psd.values(), [7e-21, 5e-21]);
        assert!(
            average.notes[0].contains("'the dataset - 1D PSD along x', the average over a dataset, is read")
        );
        let one = ReadOptions { subject: Some("Scan 1".into()), ..ReadOptions::default() };
        assert_eq!(read(text, &one).psd.values(), [6e-21, 4e-21]);
        assert_eq!(read(text, &of("scan 1", "1D PSD along x")).psd.values(), [6e-21, 4e-21]);
        assert_eq!(read(text, &series("scan 1 - 1D PSD along x")).psd.values(), [6e-21, 4e-21]);
    }
    let unreliable = read(GENERATION_B, &series("1D PSD along x (incl. unreliable data)"));
    assert_eq!(unreliable.psd.values(), [6e-21, 4e-21, 1e-21]);
}

#[test]
fn standard_errors_are_kept_where_there_are_any() {
    let text = default(GENERATION_B);
    assert_eq!(text.psd.standard_errors(), Some(&[Some(1e-22), None][..]));
    let csv = default(GENERATION_B_CSV);
    assert_eq!(csv.psd.standard_errors(), Some(&[Some(1e-21), None][..]));
    assert_eq!(csv.notes[2], "1 row without a value is left out");
    assert_eq!(default(GENERATION_C_CSV).psd.standard_errors(), None);
    let own = default("lambda_m,C1D_m3,C1D_se_m3\n1,5,0.5\n2,6,0\n");
    assert_eq!(own.psd.standard_errors(), Some(&[Some(0.0), Some(0.5)][..]));
    let scaled = default("lambda_m,C1D_m3,C1D_se_nm3\n1,5,0.5\n2,6,\n");
    assert_eq!(scaled.psd.standard_errors(), Some(&[None, Some(0.5e-27)][..]));
    let bare = default("lambda_m,C1D_nm3,C1D_se\n1,5,0.5\n2,6,\n");
    assert_eq!(bare.psd.standard_errors(), Some(&[None, Some(0.5e-27)][..]));
    let other = default("lambda_m,C1D_m3,C1D_se_m4\n1,5,0.5\n2,6,\n");
    assert_eq!(other.psd.standard_errors(), None);
    assert_eq!(other.notes, ["column 'C1D_se_m4' is ignored: its unit does not fit its quantity"]);
}

#[test]
fn the_third_generation_is_read_and_its_text_names_subjects_in_the_titles() {
    let file = default(GENERATION_C_CSV);
    assert_eq!(file.psd.wavelengths_m(), [TAU / 1e6, TAU / 2e6]);
    assert_eq!(file.psd.values(), [6e-21, 4e-21]);
    assert_eq!(read(GENERATION_C_CSV, &series("1d psd ALONG y")).psd.values(), [5e-21, 3e-21]);
    let text = "# Power spectral density\n# ====\n#\n# a - b - 1D PSD along x\n# ----\n# Columns: Wavevector \
                (µm⁻¹), PSD (µm³)\n1 2\n2 3\n\n#\n# a - b - 1D PSD along y\n# ----\n# Columns: Wavevector (µm⁻¹), \
                PSD (µm³)\n1 4\n2 5\n";
    let found = series_names(text.as_bytes()).unwrap();
    assert_eq!(found[1].subject.as_deref(), Some("a - b"));
    assert_eq!(found[1].series.as_deref(), Some("1D PSD along y"));
    assert_eq!(default(text).psd.values(), [2e-18, 3e-18]);
}

#[test]
fn names_that_are_not_there_are_refused_with_those_that_are() {
    assert_eq!(
        refusal(GENERATION_B_CSV, &of("scan 3", "1D PSD along x")),
        "there is no subject 'scan 3'; the subjects are 'scan 1' (measurement), 'scan 2' \
         (measurement), 'the dataset' (surface); the series are '1D PSD along x', 'q/π × 2D PSD'"
    );
    let error = read_psd(GENERATION_A.as_bytes(), &series("x")).unwrap_err();
    assert!(matches!(error, ReadError::Series(_)));
}

#[test]
fn several_subjects_without_an_average_are_refused() {
    let text = GENERATION_B_CSV.replace("surface;", "measurement;");
    let offer = "the subjects are 'scan 1' (measurement), 'scan 2' (measurement), 'the dataset' (measurement); the \
                 series are '1D PSD along x'";
    assert_eq!(
        refusal(&text, &ReadOptions::default()),
        format!("the file holds 4 series to choose from; {offer}, 'q/π × 2D PSD'")
    );
    assert_eq!(
        refusal(&text, &series("1D PSD along x")),
        format!("the file holds 3 series to choose from; {offer}")
    );
    let twice = format!("{GENERATION_A}\n{GENERATION_A}");
    assert_eq!(
        refusal(&twice, &ReadOptions::default()),
        "2 series of the file are called '1D PSD along x'; keep the rows of one, or rename them"
    );
}

#[test]
fn graphs_of_gwyddion_are_w1_in_the_unit_of_their_second_line() {
    let plain = "PSDF             Fit             \nk       W<sub>1</sub>           k       W<sub>1</sub>           \n\
                 [1/µm]     [µm<sup>3</sup>]         [1/µm]     [µm<sup>3</sup>]         \n\
                 0  5e-3            1  6e-3            \n2  4e-3            2  4.5e-3            \n\
                 3  1e-3            -          -              \n";
    assert_eq!(names(plain), ["PSDF", "Fit"]);
    let file = read(plain, &series("psdf"));
    assert_eq!(file.psd.wavelengths_m(), [TAU / 2e6, TAU / 3e6]);
    assert_eq!(file.psd.values(), [4e-21, 1e-21]);
    assert_eq!(file.psd.convention(), Convention::W1);
    assert_eq!(
        file.notes,
        [
            "the file holds 2 series; 'PSDF' is read; choose another by its series or subject",
            "line 4, the wavevector 0, is left out"
        ]
    );
    assert_eq!(read(plain, &series("fit")).psd.values(), [6e-21, 4.5e-21]);

    let single = "k       W<sub>1</sub>           \n[m^-1]     [m^3]         \n1e6  4e-21            \n2e6  1e-21            \n";
    let semicolons = "k;W<sub>1</sub>;\n[m^-1];[m^3];\n1e6;4e-21;\n2e6;1e-21;\n";
    let gnuplot = "# PSDF\n# k      W<sub>1</sub>\n# [m^-1]    [m^3]\n1e6   4e-21\n2e6   1e-21\n\n\n";
    for text in [single, semicolons, gnuplot] {
        let file = default(text);
        assert_eq!(file.psd.wavelengths_m(), [TAU / 1e6, TAU / 2e6], "{text}");
        assert_eq!(file.psd.values(), [4e-21, 1e-21]);
        assert_eq!(file.psd.convention(), Convention::W1);
        assert!(file.notes.is_empty(), "{:?}", file.notes);
    }
    let uneven =
        "A;B;\nk;W1;k;W1;\n[1/m];[m^3];[1/m];[m^3];\n1;2;1;3;\n2;1;2;4;\n;;3;5;\n;;4;6;\n;;5;7;\n;;6;8;\n";
    assert_eq!(read(uneven, &series("A")).psd.len(), 2);
    assert_eq!(read(uneven, &series("B")).psd.len(), 6);
    let curves = format!("{gnuplot}{}", gnuplot.replace("PSDF", "Fit").replace("4e-21", "5e-21"));
    assert_eq!(read(&curves, &series("Fit")).psd.values(), [5e-21, 1e-21]);

    let merged = "k  PSDF  Fit\n[m^-1]  [m^3]  [m^3]\n1e6  4e-21  -\n2e6  1e-21  3e-21\n3e6  1e-22  2e-21\n";
    assert_eq!(names(merged), ["PSDF", "Fit"]);
    assert_eq!(read(merged, &series("PSDF")).psd.values(), [4e-21, 1e-21, 1e-22]);
    let fit =
        ReadOptions { column: Some("Fit [m^3]".into()), convention: Some(Convention::W1), ..series("Fit") };
    assert_eq!(read(merged, &fit).psd.values(), [3e-21, 2e-21]);
    assert_eq!(
        default(&single.replace("W<sub>1</sub>", "PSDF")).notes,
        ["column 'PSDF [m^3]' is named as by Gwyddion and read as W1, sigma^2 = Int W dq"]
    );
}

#[test]
fn tables_of_persson_tell_their_convention() {
    for text in [
        "q (1/m)  C (m^4)\n1 2\n2 3\n4 5\n",
        "# q (1/m)  C (m^4)\n1 2\n2 3\n4 5\n",
        "# q (1/m), C (m^4)\n1 2\n2 3\n4 5\n",
    ] {
        let file = default(text);
        assert_eq!(file.psd.wavelengths_m(), [TAU, TAU / 2.0, TAU / 4.0]);
        assert_eq!(file.psd.values(), [2.0, 3.0, 5.0]);
        assert_eq!(file.psd.convention(), Convention::Persson);
        assert_eq!(
            file.notes,
            [
                "column 'C (m^4)' is read as Persson's C, sigma^2 = 2 pi Int q C dq",
                "the spectrum is that of an area (persson): the waves of a surface are taken from it as it is. Moments, stacks \
                 and asperities take C1D, by the Abel integral over its samples for an isotropic surface without roughness \
                 beyond them"
            ]
        );
        assert_eq!(file.psd.profile().unwrap().len(), 3);
    }
    let with_errors = default("q_per_m,Ciso_m4,Ciso_se_m4\n1,2,1\n2,3,1\n4,5,1\n");
    assert_eq!(with_errors.psd.standard_errors(), Some(&[Some(1.0); 3][..]));
    let of_area = with_errors.notes.last().unwrap();
    assert!(of_area.ends_with("without roughness beyond them; standard errors are lost"), "{of_area}");
    assert_eq!(with_errors.psd.profile().unwrap().standard_errors_m3(), None);
}

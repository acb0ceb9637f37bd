//! Files as they are found: layouts, names, units, assumptions.

use std::f64::consts::TAU;

use spectrum::{Abscissa, Convention, PsdFile, ReadOptions, read_psd};

fn read(text: &str) -> PsdFile {
    read_with(text, &ReadOptions::default())
}

fn read_with(text: &str, options: &ReadOptions) -> PsdFile {
    read_psd(text.as_bytes(), options).unwrap_or_else(|error| panic!("{error}"))
}

fn assert_samples(file: &PsdFile, wavelengths_m: &[f64], values: &[f64], convention: Convention) {
    assert_eq!(file.psd.wavelengths_m(), wavelengths_m);
    assert_eq!(file.psd.values(), values);
    assert_eq!(file.psd.convention(), convention);
}

#[test]
fn a_csv_table_with_more_columns_than_needed_is_read_by_its_names() {
    let file = read(
        "# first comment\n#second\n\nlambda_m,q_rad_per_m,C1D_m3,Ciso_approx_m4,basis\n\
         8.954647e-03,7.016676e+02,1.215386e-22,5.441678e-25,\"plateau, extrapolated\"\n\
         # a comment between rows\n7.112929e-03,8.833472e+02,1.215385e-22,4.322478e-25,plateau\n",
    );
    assert_samples(&file, &[8.954647e-03, 7.112929e-03], &[1.215386e-22, 1.215385e-22], Convention::C1D);
    assert_eq!(file.comments, ["first comment", "second"]);
    assert!(file.notes.is_empty());
}

#[test]
fn separators_byte_order_mark_and_line_ends_do_not_matter() {
    let expected = read("lambda_m,C1D_m3\n2e-6,3e-22\n1e-6,1e-22\n");
    for text in [
        "lambda_m;C1D_m3\n2e-6;3e-22\n1e-6;1e-22",
        "lambda_m\tC1D_m3\r\n2e-6\t3e-22\r\n\r\n1e-6\t1e-22\r\n",
        "\u{feff}lambda_m,C1D_m3\n2e-6,3e-22\n1e-6,1e-22\n",
        "\"lambda_m\",\"C1D_m3\"\n\"2e-6\", 3e-22\n1e-6 ,\"1e-22\"\n",
        "   \n lambda_m   C1D_m3\n  2e-6\t 3e-22  \n 1e-6 1e-22\n   \n",
        "  # indented comment\nC1D_m3,lambda_m\n  # another\n1e-22,1e-6\n3e-22,2e-6\n",
    ] {
        assert_eq!(read(text).psd, expected.psd, "{text:?}");
    }
}

#[test]
fn numbers_are_scaled_by_their_unit_without_a_second_rounding() {
    let file = read("λ / nm,C1D (µm³)\n5.65,5.799607e-10\n1.1,7\n");
    assert_samples(&file, &[5.65e-9, 1.1e-9], &[5.799607e-28, 7e-18], Convention::C1D);
}

#[test]
fn wavevectors_and_frequencies_become_wavelengths() {
    let by_wavevector = read("Q [rad/µm],C1D_nm3\n1,5e3\n2,4e3\n");
    assert_samples(&by_wavevector, &[TAU / 1e6, TAU / 2e6], &[5e-24, 4e-24], Convention::C1D);
    let by_frequency = read("f_1/mm;c1d_m3\n4;5\n8;4\n");
    assert_samples(&by_frequency, &[1.0 / 4e3, 1.0 / 8e3], &[5.0, 4.0], Convention::C1D);
}

#[test]
fn exports_of_contact_engineering_are_read_series_by_series() {
    let text = "# Power spectral density\n# ====\n#\n# sample 1 - 1D PSD along x\n# ----\n\
                # Columns: Wavevector (µm⁻¹), PSD (µm³)\n\
                6.283185307179586e-01 6.610473859781669e-03\n1.256637061435917e+00 3.956676139303139e-03\n";
    let from_text = read(text);
    let from_csv = read(
        "Subject,Series,Wavevector (µm⁻¹),PSD (µm³)\n\
         sample 1,1D PSD along x,6.283185307179586e-01,6.610473859781669e-03\n\
         sample 1,1D PSD along x,1.256637061435917e+00,3.956676139303139e-03\n",
    );
    let area_csv = "Series,q,C1D\nq/π × 2D PSD,1,2\nq/π × 2D PSD,2,3\n";
    assert_eq!(
        read(area_csv).notes[2],
        "the series 'q/π × 2D PSD' is q/pi times a two-dimensional spectrum, which is C1D only for a Hurst exponent of \
         1/2"
    );
    let from_si = read(
        "Subject name;Data series;Wavevector (1/m);PSD (m³);standard error of PSD (m³);comment\n\
         sample 1;1D PSD along x;6.283185307179586e+05;6.610473859781669e-21;;\n\
         sample 1;1D PSD along x;1.256637061435917e+06;3.956676139303139e-21;;\n",
    );
    assert_eq!(from_text.psd, from_csv.psd);
    assert_eq!(from_text.psd, from_si.psd);
    assert_eq!(from_text.comments[3], "sample 1 - 1D PSD along x");
    let note = "column 'PSD (µm³)' states no convention and is read as C1D, sigma^2 = (1/pi) Int C dq";
    assert_eq!(from_text.notes, [note]);
    assert_eq!(
        read(&text.replace("1D PSD along x", "q/π × 2D PSD")).notes,
        [
            note,
            "the series 'sample 1 - q/π × 2D PSD' is q/pi times a two-dimensional spectrum, which is C1D only for a \
             Hurst exponent of 1/2"
        ]
    );
}

#[test]
fn c1d_counts_before_other_spectra() {
    for header in ["psd_m3,C1D_m3,lambda_m", "Ciso_m4,c1d,lambda_m", "C1D_error,C1D_m3,lambda_m"] {
        let file = read(&format!("{header}\n9,1,2\n9,3,1\n"));
        assert_samples(&file, &[2.0, 1.0], &[1.0, 3.0], Convention::C1D);
    }
}

#[test]
fn a_unit_that_is_none_is_passed_over_where_another_column_does() {
    let file = read("wavelength_furlong,q_rad_per_m,C1D_m3,C1D_m4\n7,1,2,9\n7,3,4,9\n");
    assert_samples(&file, &[TAU, TAU / 3.0], &[2.0, 4.0], Convention::C1D);
}

#[test]
fn the_caller_may_name_the_column_and_its_convention() {
    let text = "lambda_m,C1D_m3,Ciso_m4,Ciso_approx_m4,C (nm^4)\n2,1,5,7,1\n1,3,6,8,2\n";
    let options = |column: &str, convention| ReadOptions {
        column: Some(column.to_owned()),
        convention,
        ..ReadOptions::default()
    };
    let values = |column: &str, convention| read_with(text, &options(column, convention)).psd;
    assert_eq!(values("Ciso_m4", None).convention(), Convention::Ciso);
    assert_eq!(values("ciso_M4", None).values(), [5.0, 6.0]);
    assert_eq!(values("Ciso_approx_m4", Some(Convention::Ciso)).values(), [7.0, 8.0]);
    assert_eq!(values("C (nm^4)", Some(Convention::Persson)).values(), [1e-36, 2e-36]);
    assert_eq!(values("C1D_m3", Some(Convention::W1)).convention(), Convention::W1);
}

#[test]
fn a_stated_convention_overrides_names_and_chooses_the_column_it_fits() {
    let options = |convention| ReadOptions { convention: Some(convention), ..ReadOptions::default() };
    let text = "lambda_m,C1D_m3,Ciso_m4\n2,1,5\n1,3,6\n";
    assert_samples(&read_with(text, &options(Convention::W1)), &[2.0, 1.0], &[1.0, 3.0], Convention::W1);
    assert_samples(
        &read_with(text, &options(Convention::Persson)),
        &[2.0, 1.0],
        &[5.0, 6.0],
        Convention::Persson,
    );
    let bare = text.replace("_m3", "").replace("_m4", "");
    assert_samples(&read_with(&bare, &options(Convention::Ciso)), &[2.0, 1.0], &[5.0, 6.0], Convention::Ciso);
    let file = read_with("q,psd_m4\n1,2\n2,3\n", &options(Convention::Persson));
    assert_samples(&file, &[TAU, TAU / 2.0], &[2.0, 3.0], Convention::Persson);
}

#[test]
fn assumptions_are_noted() {
    assert_eq!(
        read("frequency,psd\n1,2\n2,3\n").notes,
        [
            "column 'frequency' states no unit and is read in SI units",
            "column 'psd' states no unit and is read in SI units",
            "column 'psd' is given against frequency and is read as the one-sided spectrum S of frequency, sigma^2 = Int \
             S df"
        ]
    );
    assert_eq!(read("frequency,psd\n1,2\n2,3\n").psd.convention(), Convention::Frequency);
    assert_eq!(read("f_per_m,C1D_m3\n1,2\n2,3\n").psd.convention(), Convention::C1D);
}

#[test]
fn where_several_abscissae_stand_the_wavelength_counts() {
    let text = "q_rad_per_m,f_per_m,lambda_m,C1D_m3\n6.284,1.0001,1,2\n12.57,2,0.5,3\n";
    assert_eq!(read(text).psd.wavelengths_m(), [1.0, 0.5]);
    let by_wavevector = ReadOptions { x: Some(Abscissa::Wavevector), ..ReadOptions::default() };
    assert_eq!(read_with(text, &by_wavevector).psd.wavelengths_m(), [TAU / 6.284, TAU / 12.57]);
}

#[test]
fn two_columns_without_a_header_are_read_as_the_caller_says() {
    let options =
        |x, convention| ReadOptions { convention: Some(convention), x: Some(x), ..ReadOptions::default() };
    let text = "# measured\n1 2e-30\n2 1e-30\n";
    let file = read_with(text, &options(Abscissa::Wavevector, Convention::Persson));
    assert_samples(&file, &[TAU, TAU / 2.0], &[2e-30, 1e-30], Convention::Persson);
    let file = read_with("1,2\n2,3\n", &options(Abscissa::Wavelength, Convention::C1D));
    assert_samples(&file, &[2.0, 1.0], &[3.0, 2.0], Convention::C1D);
}

#[test]
fn names_separated_by_blanks_keep_their_units() {
    let options = ReadOptions {
        column: Some("C (m^4)".into()),
        convention: Some(Convention::Persson),
        ..ReadOptions::default()
    };
    let file = read_with("q (1/m)  C (m^4)\n1 2\n2 3\n", &options);
    assert_samples(&file, &[TAU, TAU / 2.0], &[2.0, 3.0], Convention::Persson);
    assert_eq!(read("lambda / nm  C1D [ nm^3 ]\n2 2\n1 3\n").psd.wavelengths_m(), [2e-9, 1e-9]);
}

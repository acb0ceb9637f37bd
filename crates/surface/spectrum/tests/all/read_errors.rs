//! Refused inputs, and the wording of their errors.

use spectrum::{Abscissa, Convention, ReadError, ReadOptions, read_psd};

fn error_of(bytes: impl AsRef<[u8]>, options: &ReadOptions) -> ReadError {
    read_psd(bytes.as_ref(), options).unwrap_err()
}

#[track_caller]
fn assert_refused(bytes: impl AsRef<[u8]>, line: usize, message: &str) {
    assert_refused_with(&ReadOptions::default(), bytes, line, message);
}

#[track_caller]
fn assert_refused_with(options: &ReadOptions, bytes: impl AsRef<[u8]>, line: usize, message: &str) {
    let error = error_of(bytes, options);
    assert_eq!(error.to_string(), message);
    assert_eq!(error.line(), Some(line));
}

fn column(name: &str) -> ReadOptions {
    ReadOptions { column: Some(name.to_owned()), ..ReadOptions::default() }
}

#[test]
fn files_without_rows_are_refused() {
    for text in ["", "\n \n", "# only a comment\n", "\u{feff}"] {
        let error = error_of(text, &ReadOptions::default());
        assert_eq!(error.to_string(), "reading the spectrum: the file holds no rows; give at least 2");
        assert_eq!(error.line(), None);
    }
    assert_refused(
        "# comment\nlambda_m,C1D_m3\n1e-6,1e-22\n",
        3,
        "line 3: the file holds 1 row; give at least 2",
    );
    assert_refused("lambda_m,C1D_m3\n", 1, "line 1: the file holds 0 rows; give at least 2");
}

#[test]
fn files_that_are_no_utf8_text_are_refused() {
    assert_refused(
        b"lambda_m,C1D_m3\n1e-6,1\xb5\n",
        2,
        "line 2: byte 23 of the file is 0xb5, which is not UTF-8 text; save the spectrum as CSV or text in UTF-8",
    );
    assert_refused(
        b"\xff\xfel\0a\0m\0",
        1,
        "line 1: byte 1 of the file is 0xff, which is the start of UTF-16, not UTF-8; save the spectrum as CSV or text \
         in UTF-8",
    );
    assert_refused(
        b"CDF\x02\0\0",
        1,
        "line 1: byte 5 of the file is 0x00, which is binary data, perhaps a scan; save the spectrum as \
         CSV or text in UTF-8",
    );
}

#[test]
fn a_failing_input_is_reported() {
    struct Failing;
    impl std::io::Read for Failing {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("the disk is gone"))
        }
    }
    let error = read_psd(Failing, &ReadOptions::default()).unwrap_err();
    assert_eq!(error.to_string(), "reading the spectrum: the disk is gone");
    assert_eq!(error.line(), None);
}

#[test]
fn missing_columns_are_refused_with_those_found() {
    assert_refused(
        "# x\ndepth,C1D_m3\n1,2\n2,3\n",
        2,
        "line 2: no column holds the wavelength (wavelength or lambda, wavevector or q, frequency or f); the columns \
         are 'depth', 'C1D_m3'",
    );
    assert_refused(
        "lambda_m,PSD_error_m3,Ciso_approx_m4\n1,2,3\n2,3,4\n",
        1,
        "line 1: no column holds the spectrum (c1d, psd or ciso); the columns are \
         'lambda_m', 'PSD_error_m3', 'Ciso_approx_m4'",
    );
    assert_refused_with(
        &ReadOptions { x: Some(Abscissa::Frequency), ..ReadOptions::default() },
        "lambda_m,C1D_m3\n1,2\n2,3\n",
        1,
        "line 1: no column holds the frequency (frequency, f); the columns are 'lambda_m', 'C1D_m3'",
    );
    assert_refused_with(
        &column("C2D"),
        "lambda_m,C1D_m3\n1,2\n2,3\n",
        1,
        "line 1: there is no column 'C2D'; the columns are 'lambda_m', 'C1D_m3'",
    );
}

#[test]
fn duplicate_columns_are_refused() {
    assert_refused(
        "lambda_m,wavelength_nm,C1D_m3\n1,2,3\n2,3,4\n",
        1,
        "line 1: duplicate column: 'lambda_m' and 'wavelength_nm' both hold the wavelength; keep one",
    );
    assert_refused(
        "lambda_m,C1D_m3,C1D_nm3\n1,2,3\n2,3,4\n",
        1,
        "line 1: duplicate column: 'C1D_m3' and 'C1D_nm3' both hold the spectrum; keep one",
    );
    assert_refused_with(
        &column("x"),
        "lambda_m,X,X\n1,2,3\n2,3,4\n",
        1,
        "line 1: duplicate column: 'X' and 'X' both hold the spectrum; keep one",
    );
}

#[test]
fn several_spectra_without_precedence_are_refused() {
    assert_refused(
        "lambda_m,psd_m3,Ciso_m4\n1,2,3\n2,3,4\n",
        1,
        "line 1: several columns hold a spectrum: 'psd_m3', 'Ciso_m4'",
    );
}

#[test]
fn units_that_are_unknown_or_of_another_dimension_are_refused() {
    assert_refused(
        "wavelength_furlong,C1D_m3\n1,2\n2,3\n",
        1,
        "line 1: column 'wavelength_furlong' is in 'furlong', but the wavelength is read in m, cm, mm, um, nm, angstrom, \
         pm, km, inch, uin; rename the column",
    );
    assert_refused(
        "wavelength_m3,C1D_m3\n1,2\n2,3\n",
        1,
        "line 1: column 'wavelength_m3' is in 'm3', but the wavelength is read in m, cm, mm, um, nm, angstrom, pm, km, inch, uin; \
         rename the column",
    );
    assert_refused(
        "q_m,C1D_m3\n1,2\n2,3\n",
        1,
        "line 1: column 'q_m' is in 'm', but the wavevector is read in rad/m or 1/m, and the same with cm, mm, um, nm, \
         angstrom, pm, km, inch, uin; rename the column",
    );
    assert_refused(
        "lambda_nm^2147483647,C1D_m3\n1,2\n2,3\n",
        1,
        "line 1: column 'lambda_nm^2147483647' is in 'nm^2147483647', but the wavelength is read in m, cm, mm, um, nm, \
         angstrom, pm, km, inch, uin; rename the column",
    );
    for power in ["2147483648", "-2147483648", "-99999999999"] {
        let text = format!("lambda_m,C1D_1/nm^{power}\n1,2\n2,3\n");
        assert!(error_of(text, &ReadOptions::default()).to_string().contains("column"), "{power}");
    }
    assert_refused(
        "Frequency (rad/m),C1D_m3\n1,2\n2,3\n",
        1,
        "line 1: column 'Frequency (rad/m)' is in 'rad/m', but the frequency is read in 1/m, 1/cm, 1/mm, 1/um, 1/nm, \
         1/angstrom, 1/pm, 1/km, 1/inch, 1/uin; rename the column",
    );
    assert_refused(
        "lambda_m,C1D_m4\n1,2\n2,3\n",
        1,
        "line 1: column 'C1D_m4' is in 'm4', but the spectrum (c1d) is read in m^3, cm^3, mm^3, um^3, nm^3, \
         angstrom^3, pm^3, km^3, inch^3, uin^3; rename the column",
    );
    assert_refused_with(
        &ReadOptions { convention: Some(Convention::Persson), ..column("power_m3") },
        "lambda_m,power_m3\n1,2\n2,3\n",
        1,
        "line 1: column 'power_m3' is in 'm^3', but the spectrum (persson) is read in m^4, cm^4, mm^4, um^4, nm^4, \
         angstrom^4, pm^4, km^4, inch^4, uin^4; rename the column",
    );
}

#[test]
fn spectra_of_unknown_convention_are_refused() {
    assert_refused(
        "lambda_m,psd_m4\n1,2\n2,3\n",
        1,
        "line 1: column 'psd_m4' is a spectrum in m^4, which two conventions share",
    );
    assert_refused_with(
        &column("Ciso_approx_m4"),
        "lambda_m,Ciso_approx_m4\n1,2\n2,3\n",
        1,
        "line 1: column 'Ciso_approx_m4' does not state its convention",
    );
}

#[test]
fn numbers_without_a_header_are_refused_unless_the_caller_knows_them() {
    let message = "line 2: the file has no header that names its two columns";
    assert_refused("# comment\n1e-6 1e-22\n2e-6 1e-22\n", 2, message);
    let only_x = ReadOptions { x: Some(Abscissa::Wavelength), ..ReadOptions::default() };
    assert_refused_with(&only_x, "# comment\n1e-6 1e-22\n2e-6 1e-22\n", 2, message);
    let both = ReadOptions { convention: Some(Convention::C1D), ..only_x };
    assert_refused_with(
        &both,
        "1e-6 1e-22 1e-24\n2e-6 1e-22 1e-24\n",
        1,
        "line 1: a file without a header needs 2 columns but has 3; name them in a first row",
    );
    assert_refused_with(
        &ReadOptions { column: Some("C1D".into()), ..both },
        "1e-6 1e-22\n2e-6 1e-22\n",
        1,
        "line 1: there is no column 'C1D'; the columns are '1', '2'",
    );
}

#[test]
fn fields_that_are_no_positive_finite_numbers_are_refused() {
    let refuse = |field: &str, complaint: &str| {
        let text = format!("# comment\n\nlambda_nm;C1D_m3\n1;2\r\n# comment\n\n2;{field}\n3;4\n");
        assert_refused(text, 7, &format!("line 7: column 'C1D_m3' {complaint}"));
    };
    refuse("", "is empty; enter a number above 0 or remove the row");
    refuse("two", "is 'two', not a number; write it like 1.5e-9, with a point, or remove the row");
    refuse("1,5", "is '1,5', not a number; write it like 1.5e-9, with a point, or remove the row");
    for field in ["NaN", "nan", "inf", "-inf", "1e400", "0", "-0", "-1e-22", "1e-400"] {
        refuse(field, &format!("is '{field}'; it must be finite and above 0: correct it or remove the row"));
    }
    for field in ["0", "-5", "1e-400", "inf"] {
        assert_refused(
            format!("lambda_nm,C1D_m3\n1,2\n{field},3\n"),
            3,
            &format!(
                "line 3: column 'lambda_nm' is '{field}'; it must be finite and above 0: correct it or remove the row"
            ),
        );
    }
    assert_refused(
        "q,C1D\n1,2\n1e-310,3\n",
        3,
        "line 3: column 'q' is '1e-310'; it must be finite and above 0: correct it or remove the row",
    );
}

#[test]
fn ragged_rows_are_refused() {
    assert_refused(
        "lambda_m,C1D_m3\n1,2\n2,3,4\n",
        3,
        "line 3: 3 fields, but 2 in line 1; give every row the same columns",
    );
    assert_refused(
        "# c\nlambda_m  C1D_m3\n2 2\n1\n",
        4,
        "line 4: 1 field, but 2 in line 2; give every row the same columns",
    );
    assert_refused(
        "# Columns: Wavevector (1/m), PSD (m³)\n\n1 2 3\n2 3 4\n",
        3,
        "line 3: 3 fields, but 2 in line 1; give every row the same columns",
    );
}

#[test]
fn repeated_wavelengths_are_refused_with_both_lines() {
    assert_refused(
        "lambda_nm,C1D_m3\n5,2\n2,3\n# comment\n5.0,4\n2,3\n",
        5,
        "line 5: the wavelength 5 nm is already in line 2; keep one row for each wavelength, and one series (such \
         as '1D PSD along x') in a file",
    );
}

#[test]
fn abscissae_that_contradict_each_other_are_refused() {
    assert_refused(
        "lambda_m,q_rad_per_m,C1D_m3\n1,6.2832,1\n0.5,12.6,1\n",
        3,
        "line 3: column 'lambda_m' is '0.5' and column 'q_rad_per_m' is '12.6', wavelengths in the ratio 1.00268, which \
         must be 1 within 0.001; correct the row or remove a column",
    );
    assert_refused(
        "lambda_m,q_rad_per_m,C1D_m3\n1,1,1\n0.5,2,1\n",
        2,
        "line 2: column 'lambda_m' is '1' and column 'q_rad_per_m' is '1', wavelengths in the ratio 0.159155, which must \
         be 1 within 0.001: a factor of 2 pi, so the second holds the frequency 1/lambda, not the wavevector 2 \
         pi/lambda; correct the row or remove a column",
    );
    assert_refused(
        "lambda_m,f_per_m,C1D_m3\n1,6.2832,1\n0.5,12.5664,1\n",
        2,
        "line 2: column 'lambda_m' is '1' and column 'f_per_m' is '6.2832', wavelengths in the ratio 6.2832, which must \
         be 1 within 0.001: a factor of 2 pi, so the second holds the wavevector 2 pi/lambda, not the frequency \
         1/lambda; correct the row or remove a column",
    );
    assert_refused(
        "lambda_m,q_rad_per_m,C1D_m3\n1,39.478,1\n0.5,78.957,1\n",
        2,
        "line 2: column 'lambda_m' is '1' and column 'q_rad_per_m' is '39.478', wavelengths in the ratio 6.28312, which \
         must be 1 within 0.001: a factor of 2 pi, as between wavevector and frequency; correct the row or remove a \
         column",
    );
}

#[test]
fn lines_are_the_physical_ones_whatever_stands_between() {
    let text = "\u{feff}# a\r\n\r\n   \r\nlambda_m,C1D_m3,remark\r\n1,2,\"two\r\nlines\"\r\n#\r\n   # b, c\r\n\t\r\n2,x,\r\n";
    assert_eq!(error_of(text, &ReadOptions::default()).line(), Some(10));
    let tabbed = "lambda_m\tC1D_m3\n1\t2\n \t \n\n2\tx\n";
    assert_eq!(error_of(tabbed, &ReadOptions::default()).line(), Some(5));
}

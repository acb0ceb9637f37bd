//! Refused spectra: their files, with `\n` for the end of a line, the options they are read with, and the line and the words of the
//! error in a table; beside it what a table cannot hold.

use spectrum::{ReadError, ReadOptions, read_psd};

fn error_of(bytes: impl AsRef<[u8]>) -> ReadError {
    read_psd(bytes.as_ref(), &ReadOptions::default()).unwrap_err()
}

/// Reads options such as `column=C2D;x=frequency`.
fn options(cell: &str) -> ReadOptions {
    let mut options = ReadOptions::default();
    for (name, value) in cell.split(';').filter_map(|option| option.split_once('=')) {
        match name {
            "column" => options.column = Some(value.to_owned()),
            "convention" => options.convention = Some(value.parse().unwrap()),
            "x" => options.x = Some(value.parse().unwrap()),
            "series" => options.series = Some(value.to_owned()),
            "subject" => options.subject = Some(value.to_owned()),
            "x_unit" => options.x_unit = Some(value.to_owned()),
            "psd_unit" => options.psd_unit = Some(value.to_owned()),
            other => panic!("there is no option '{other}'"),
        }
    }
    options
}

#[test]
fn every_file_of_the_table_is_refused_with_its_line_and_words() {
    let table = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/all/refused.tsv");
    let mut rows = csv::ReaderBuilder::new().delimiter(b'\t').quoting(false).from_path(table).unwrap();
    for row in rows.records() {
        let row = row.unwrap();
        let [_, text, given, line, message] = [0, 1, 2, 3, 4].map(|column| &row[column]);
        let bytes = text.replace("\\n", "\n").replace("\\r", "\r").replace("\\u{feff}", "\u{feff}");
        let error = read_psd(bytes.as_bytes(), &options(given)).expect_err(text);
        assert_eq!(error.to_string(), message, "{text}");
        assert_eq!(error.line(), line.parse().ok(), "{text}");
    }
}

#[test]
fn files_that_are_no_utf8_text_are_refused() {
    for (bytes, line, message) in [
        (
            &b"lambda_m,C1D_m3\n1e-6,1\xb5\n"[..],
            2,
            "line 2: byte 23 of the file is 0xb5, which is not UTF-8 text",
        ),
        (
            b"\xff\xfel\0a\0m\0",
            1,
            "line 1: byte 1 of the file is 0xff, which is the start of UTF-16, not UTF-8",
        ),
        (b"CDF\x02\0\0", 1, "line 1: byte 5 of the file is 0x00, which is binary data, perhaps a scan"),
    ] {
        let error = error_of(bytes);
        let advice = "save the spectrum as CSV or text in UTF-8";
        assert_eq!((error.to_string(), error.line()), (format!("{message}; {advice}"), Some(line)));
    }
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
fn fields_that_are_no_positive_finite_numbers_are_refused() {
    for field in ["NaN", "nan", "inf", "-inf", "1e400", "0", "-0", "-1e-22", "1e-400"] {
        let complaint = format!("is '{field}'; it must be finite and above 0: correct it or remove the row");
        for (column, row) in [("C1D_m3", format!("2;{field}")), ("lambda_nm", format!("{field};3"))] {
            let error = error_of(format!("# comment\n\nlambda_nm;C1D_m3\n1;2\r\n# comment\n\n{row}\n3;4\n"));
            assert_eq!(error.to_string(), format!("line 7: column '{column}' {complaint}"));
            assert_eq!(error.line(), Some(7));
        }
    }
}

#[test]
fn powers_of_units_beyond_all_bounds_are_no_units() {
    for power in ["2147483648", "-2147483648", "-99999999999"] {
        let text = format!("lambda_m,C1D_1/nm^{power}\n1,2\n2,3\n");
        assert!(error_of(text).to_string().contains("column"), "{power}");
    }
}

#[test]
fn lines_are_the_physical_ones_whatever_stands_between() {
    let text = "\u{feff}# a\r\n\r\n   \r\nlambda_m,C1D_m3,remark\r\n1,2,\"two\r\nlines\"\r\n#\r\n   # b, c\r\n\t\r\n2,x,\r\n";
    assert_eq!(error_of(text).line(), Some(10));
    let tabbed = "lambda_m\tC1D_m3\n1\t2\n \t \n\n2\tx\n";
    assert_eq!(error_of(tabbed).line(), Some(5));
}

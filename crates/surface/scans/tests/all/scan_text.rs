//! Scans as text: layouts, separators, decimal commas, headers, and what is refused.

use crate::support::{heights_m, in_unit, measured, missing_points, read_one, refusal, spacings_m};
use scans::{Mend, Scan, ScanOption, ScanOptions, ScanReadError, ScanSize, Unitless};

fn sized(x_m: f64, y_m: Option<f64>) -> ScanOptions {
    ScanOptions { size: Some(ScanSize { x_m, y_m }), ..in_unit("nm") }
}

#[test]
fn decimal_commas_are_read_where_they_are_no_separators() {
    for text in [
        "0,0;1,5\n0,5;2,5\n",
        "0,0\t1,5\n0,5\t2,5\n",
        "0,0 1,5\n0,5 2,5\n",
        "0.0,1.5\n0.5,2.5\n",
        "0.0, 1.5,\n0.5, 2.5,\n",
    ] {
        let scan = read_one(text.as_bytes(), &in_unit("m")).unwrap().scan;
        assert_eq!((spacings_m(&scan).0, heights_m(&scan)), (0.5, [1.5, 2.5].as_slice()), "{text}");
    }
    refused!(refusal(b"0,1\n0,2\n", &in_unit("nm")), AmbiguousComma { line: 1 });
}

#[test]
fn one_column_needs_its_length() {
    let scan = read_one(b"1\n2\n3\n4\n", &sized(2e-6, None)).unwrap().scan;
    assert_eq!((spacings_m(&scan).0, heights_m(&scan).len()), (0.5e-6, 4));
    let stated = read_one(b"# Spacing: 0.5 um\n# Unit: nm\n1\n2\n", &ScanOptions::default()).unwrap().scan;
    assert_eq!(spacings_m(&stated).0, 0.5e-6);
    refused!(refusal(b"1\n2\n3\n", &in_unit("nm")), NoSize { what: "how long the line of heights is" });
}

#[test]
fn a_matrix_takes_its_size_from_the_options_before_its_header() {
    let text = "# Width: 10,0 \u{b5}m\n# Height: 4 \u{3bc}m\n# Value units: nm\n1 2 3 4\n5 6 7 8\n";
    let scan = read_one(text.as_bytes(), &ScanOptions::default()).unwrap();
    assert_eq!((spacings_m(&scan.scan), scan.notes.len()), ((2.5e-6, 2e-6), 0));
    assert_eq!(heights_m(&scan.scan)[4], 5e-9);
    let options = ScanOptions { unit: None, ..sized(1e-6, None) };
    let scan = read_one(text.as_bytes(), &options).unwrap();
    assert_eq!(spacings_m(&scan.scan), (0.25e-6, 0.25e-6));
    assert_eq!(
        scan.notes,
        [
            "the size 1 µm asked for replaces that of the file, 10 µm x 4 µm",
            "only the size along x is given: rows are as far apart as columns",
        ]
    );
    // Latin-1, as older instruments write it.
    let latin1: Vec<u8> = text.replace('\u{3bc}', "\u{b5}").chars().map(|c| c as u8).collect();
    assert_eq!(spacings_m(&read_one(&latin1, &ScanOptions::default()).unwrap().scan), (2.5e-6, 2e-6));
    // A bare number may count pixels.
    let bare = "# Width: 4\n# Height: 2\n1 2 3 4\n5 6 7 8\n";
    refused!(refusal(bare.as_bytes(), &in_unit("nm")), NoSize { what: "how large the map is" });
}

#[test]
fn units_come_from_the_header_or_the_options() {
    let scan = read_one(b"x [mm];h [um]\n0;1\n1;2\n", &ScanOptions::default()).unwrap().scan;
    assert_eq!((spacings_m(&scan).0, heights_m(&scan)[1]), (1e-3, 2e-6));
    refused!(refusal(b"0 1\n1 2\n", &ScanOptions::default()), NoUnit { what: Unitless::LengthsAndHeights });
    for (header, column) in [("x (mm) h (V)", 2), ("t (s) h (um)", 1)] {
        match refusal(format!("{header}\n0 1\n1 2\n").as_bytes(), &in_unit("um")) {
            ScanReadError::NoLength { line: 1, column: found, .. } => assert_eq!(found, column),
            other => panic!("{header}: {other}"),
        }
    }
    let scan = read_one(b"mm\tum\n0\t1\n1\t2\n", &ScanOptions::default()).unwrap().scan;
    assert_eq!((spacings_m(&scan).0, heights_m(&scan)[1]), (1e-3, 2e-6));
    let scan = read_one(b"Z (um)\n1\n2\n", &ScanOptions { unit: None, ..sized(2e-6, None) }).unwrap().scan;
    assert_eq!(heights_m(&scan), [1e-6, 2e-6]);
    let options = ScanOptions { height_unit: "nm".parse().ok(), ..in_unit("um") };
    let scan = read_one(b"# Unit: mm\n0 1\n1 2\n", &options).unwrap();
    assert_eq!((spacings_m(&scan.scan).0, heights_m(&scan.scan)[1]), (1e-6, 2e-9));
    assert_eq!(scan.notes[0], "the unit µm of lengths asked for replaces that of the file, mm");
    assert_eq!(scan.notes.len(), 2);
}

#[test]
fn a_unit_in_the_name_of_the_lengths_is_theirs_alone() {
    let options = ScanOptions { fallback_unit: "nm".parse().ok(), ..ScanOptions::default() };
    let scan = read_one(b"X_(microns),y1\n0.5,2.25\n1.0,2.5\n", &options).unwrap();
    assert_eq!((spacings_m(&scan.scan).0, heights_m(&scan.scan)[0]), (0.5e-6, 2.25e-9));
    assert_eq!(scan.notes, ["ignoring the unit nm of lengths: they are known to be in µm"]);
}

#[test]
fn empty_columns_at_the_end_hold_no_numbers() {
    let dektak = b"Scan Parameters\nStylus,Radius: 2.5 \xb5m\nLength,1500.0 um\n\nScan Data\nLateral um,Raw Micrometer,\n\
        0.0,-0.00933,,\n0.2,-0.00760,,\n0.4,-0.00644,,\n";
    let scan = read_one(dektak, &ScanOptions::default()).unwrap().scan;
    assert_eq!(heights_m(&scan), [-9.33e-9, -7.6e-9, -6.44e-9]);
    assert!((spacings_m(&scan).0 - 0.2e-6).abs() < 1e-20);
}

#[test]
fn missing_points_and_broken_rows_are_named_by_their_line() {
    let refused = |text: &str| refusal(text.as_bytes(), &in_unit("nm"));
    let told = |text: &str| missing_points(text.as_bytes(), &in_unit("nm"));
    assert_eq!(told("# a profile\n0 1\n1 NaN\n2 1\n"), [1]);
    refused!(
        read_one(b"# a profile\n0 1\n1 NaN\n2 1\n", &in_unit("nm")).unwrap_err(),
        Scan(MissingPoints { missing: 1, points: 3 })
    );
    assert_eq!(told("0;1\n1;\n2;1\n"), [1]);
    refused!(refused("0;1\n1\n2;1\n"), Ragged { line: 2, found: 1, expected: 2 });
    refused!(refused("0;1;0\n1;;2\n"), NotANumber { line: 2, column: 2, text: "no position" });
    refused!(refused("0 1\n1 2x\n"), NotANumber { line: 2, column: 2, text: "2x" });
    // Rows of missing points on top are rows of the scan, whatever they are separated by.
    // Points without position and height say nothing.
    let points = measured(b"NaN NaN NaN\nnan nan nan\n1 2 3\n4 5 6\n", &in_unit("nm")).unwrap().scan;
    assert_eq!((points.points(), points.missing_points().count()), ((2, Some(2)), 2));
    let profile = read_one(b"nan;nan\n0,5;1\n1,5;2\n", &in_unit("nm")).unwrap().scan;
    assert_eq!((spacings_m(&profile).0, heights_m(&profile)), (1e-9, [1e-9, 2e-9].as_slice()));
    let map = "NaN NaN NaN NaN\nnan nan nan nan\n1 2 3 4\n4 5 bad 6\n";
    assert_eq!(missing_points(map.as_bytes(), &sized(1e-6, None)), [0, 1, 2, 3, 4, 5, 6, 7, 14]);
    assert_eq!(missing_points(b"# h\nbad\n1.5\n2\n", &sized(1e-6, None)), [0]);
    // Underlined headers, and those with other words or as many as no row has, are none.
    for text in ["x h\n--- ---\n0 1\n1 2\n", "nan\n0 1\n1 2\n", "nan nan\nx h\n0 1\n1 2\n"] {
        assert_eq!(
            heights_m(&read_one(text.as_bytes(), &in_unit("nm")).unwrap().scan),
            [1e-9, 2e-9],
            "{text}"
        );
    }
    refused!(refused("0 1\n1 2 3\n"), Ragged { line: 2, found: 3, expected: 2 });
    refused!(refused("# nothing\n"), NoRows {});
    refused!(refused("0 1\n"), Scan(TooFew { what: "points", found: 1 }));
    let late = "0 1
1 2
"
    .repeat(100)
        + "\0";
    refused!(refused(&late), NotText { line: 201, offset: 800 });
}

#[test]
fn fillers_and_words_are_points_without_a_height() {
    for filler in ["***", "#N/A", "-----", "missing", "1.#QNAN"] {
        let profile = format!("0 1\n1 2\n2 {filler}\n3 1\n");
        assert_eq!(missing_points(profile.as_bytes(), &in_unit("nm")), [2], "{filler}");
        let column = format!("1\n{filler}\n3\n4\n");
        assert_eq!(missing_points(column.as_bytes(), &sized(2e-6, None)), [1], "{filler}");
    }
}

#[test]
fn a_profile_with_its_columns_swapped_is_not_to_be_sorted() {
    let swapped = refusal(b"1 0\n3 1\n2 2\n5 3\n", &in_unit("nm"));
    assert!(matches!(swapped, ScanReadError::AmbiguousColumns { line: 1, columns } if columns == [2]));
}

#[test]
fn profiles_must_not_turn_back() {
    refused!(
        refusal(b"# traced\n0 1\n2 1\n1.5 2\n3 1\n", &in_unit("nm")),
        PositionsDoNotRise { line: 4, position: 1.5, before: 2.0 }
    );
    let fallen = read_one(b"2.5 1\n1.5 3\n0.5 2\n", &in_unit("nm")).unwrap();
    assert_eq!((heights_m(&fallen.scan), fallen.notes.len()), ([2e-9, 3e-9, 1e-9].as_slice(), 1));
}

#[test]
fn points_must_fill_a_grid() {
    let refused = |text: &str| refusal(text.as_bytes(), &in_unit("nm"));
    let hole = measured(b"0 0 1\n1 0 1\n0 1 1\n", &in_unit("nm")).unwrap().scan;
    assert_eq!((hole.points(), hole.missing_points().indices().collect::<Vec<_>>()), ((2, Some(2)), vec![3]));
    refused!(refused("0 0 1\n1 0 1\n0 1 1\n1 1 1\n1 0 2\n"), RepeatedPoint { line: 5, first_line: 2 });
    refused!(
        refused("0 0 1\n1.0 0 1\n3.5 0 1\n0 1 1\n1 1 1\n3.5 1 1\n"),
        NotAGrid { line: 2, axis: 'x', position: 1.0, count: 3 }
    );
    // Whole numbers are not rounded multiples of 1.5.
    refused!(
        refused("0 0 1\n1 0 1\n3 0 1\n0 1 1\n1 1 1\n3 1 1\n"),
        NotAGrid { line: 2, axis: 'x', position: 1.0, count: 3 }
    );
    // Positions with a last digit that varies.
    let map = read_one(b"0.000 0 1\n0.334 0 2\n0.667 0 3\n0 1 4\n0.333 1.001 5\n0.666 1 6\n", &in_unit("nm"))
        .unwrap();
    let Scan::Map(map) = map.scan else { panic!("a map") };
    assert_eq!((map.columns(), map.rows(), map.heights_m()[4]), (3, 2, 5e-9));
}

#[test]
fn positions_without_trailing_zeros_are_no_coarser() {
    let scan = read_one(b"0 1\n1.2 1\n2 1\n2.8 1\n4 1\n", &in_unit("nm")).unwrap().scan;
    assert!(matches!(scan, Scan::NonuniformLine(_)));
    let scan = read_one(b"0 1\n.5 1\n1 1\n1.5 1\n2 1\n", &in_unit("nm")).unwrap().scan;
    assert!(matches!(scan, Scan::UniformLine(_)));
}

#[test]
fn constant_heights_are_read() {
    let scan = read_one(b"0 1\n1 1\n2 1\n", &in_unit("nm")).unwrap().scan;
    assert_eq!(heights_m(&scan), [1e-9; 3]);
}

#[test]
fn errors_tell_which_option_mends_them() {
    let mend = |text: &str, options: &ScanOptions| read_one(text.as_bytes(), options).unwrap_err().mend();
    assert_eq!(mend("0 1\n1 2\n", &ScanOptions::default()), Some(Mend::Give(ScanOption::Units)));
    assert_eq!(
        mend("x (mm);z\n0;1\n1;2\n", &ScanOptions::default()),
        Some(Mend::Give(ScanOption::HeightUnit))
    );
    assert_eq!(mend("1\n2\n", &in_unit("nm")), Some(Mend::Give(ScanOption::Size)));
    let channel = ScanOptions { channel: Some("Phase".to_owned()), ..in_unit("nm") };
    assert_eq!(mend("# Channel: Height\n0 1\n1 2\n", &channel), Some(Mend::Give(ScanOption::Channel)));
    assert_eq!(mend("0 1\n1 2\n", &channel), Some(Mend::Give(ScanOption::Channel)));
    let unnamed = ScanOptions { channel: Some("unnamed".to_owned()), ..in_unit("nm") };
    assert!(read_one(b"0 1\n1 2\n", &unnamed).is_ok());
    let sized = ScanOptions { size: Some(ScanSize { x_m: 1e-6, y_m: None }), ..in_unit("nm") };
    assert_eq!(mend("0 1\n1 2\n4 1\n", &sized), Some(Mend::LeaveOut(ScanOption::Size)));
    assert_eq!(mend("0 1\n0 2\n", &in_unit("nm")), None);
}

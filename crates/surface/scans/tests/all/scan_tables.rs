//! Texts whose columns, headers and preambles have to be told apart.

use crate::support::{heights_m, in_unit, measured, read_one, refusal, spacings_m};
use scans::{Mend, Scan, ScanFile, ScanOption, ScanOptions, ScanReadError, ScanSize};

fn rough(at: usize) -> f64 {
    ((at * 7919) % 101) as f64 / 10.0
}

/// A table of so many rows.
fn rows(count: usize, row: impl Fn(usize) -> String) -> String {
    (0..count).map(|at| row(at) + "\n").collect()
}

fn read(text: &str, options: &ScanOptions) -> ScanFile {
    measured(text.as_bytes(), options).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn of_channel(channel: &str, unit: &str) -> ScanOptions {
    ScanOptions { channel: Some(channel.to_owned()), ..in_unit(unit) }
}

#[test]
fn names_decide_before_places() {
    let none = ScanOptions::default();
    for text in [
        "z (um),x (mm)\n1,0.0\n2,0.5\n4,1.0\n",
        "height [um];flag note;position [mm]\n1;7;0.0\n2;7;0.5\n4;7;1.0\n",
        "n,x_mm,time (s),z_um\n0,0.0,5,1\n1,0.5,6,2\n2,1.0,7,4\n",
        "# x (mm)  z (um)\n0.0 1\n0.5 2\n1.0 4\n",
        "No.\tx\tz\n\tmm\tum\n1\t0.0\t1\n2\t0.5\t2\n3\t1.0\t4\n",
        "Distance\tDepth\nmm\tum\n0.0\t1\n0.5\t2\n1.0\t4\n",
        "\"x, mm\",\"z, um\"\n\"0.0\",\"1\"\n\"0.5\",\"2\"\n\"1.0\",\"4\"\n",
    ] {
        let found = read(text, &none);
        assert_eq!(spacings_m(&found.scan.clone().complete().unwrap()).0, 0.5e-3, "{text}");
        assert_eq!(found.scan.complete_heights_m().unwrap(), [1e-6, 2e-6, 4e-6], "{text}");
    }
}

#[test]
fn a_table_of_profiles_is_no_map() {
    let table =
        rows(12, |at| format!("{:.1} {} {} {}", at as f64 / 2.0, rough(at), rough(at + 5), rough(at + 9)));
    let of = |channel: &str| read(&table, &of_channel(channel, "um"));
    assert_eq!(read(&table, &in_unit("um")).channels, ["column 2", "column 3", "column 4"]);
    for (channel, shift) in [("2", 0), ("column 3", 5), ("4", 9)] {
        let found = of(channel);
        assert_eq!(found.scan.points(), (12, None));
        let height_m = found.scan.height_m(3).unwrap();
        assert!((height_m / rough(3 + shift) / 1e-6 - 1.0).abs() < 1e-12, "{channel}");
    }
    // Heights of a map rise in no column, or in all where it is tilted.
    let sized = ScanOptions { size: Some(ScanSize { x_m: 4e-6, y_m: Some(12e-6) }), ..in_unit("um") };
    let map = rows(12, |at| format!("{} {} {} {}", rough(at), rough(at + 3), rough(at + 5), rough(at + 9)));
    assert_eq!(read(&map, &sized).scan.points(), (4, Some(12)));
    let tilted = rows(12, |at| format!("{0} {0} {0} {0}", at * 20));
    assert_eq!(read(&tilted, &in_unit_of_size()).scan.points(), (4, Some(12)));
}

fn in_unit_of_size() -> ScanOptions {
    ScanOptions { fallback_size: Some(ScanSize { x_m: 4e-6, y_m: None }), ..in_unit("um") }
}

#[test]
fn columns_without_names_are_asked_for_where_two_may_hold_positions() {
    let asked = |text: &str| match refusal(text.as_bytes(), &in_unit("um")) {
        ScanReadError::AmbiguousColumns { columns, .. } => columns,
        other => panic!("{text}: {other}"),
    };
    assert_eq!(asked("0 1\n1 2\n2 5\n"), [1, 2]);
    assert_eq!(asked("3 0\n1 1\n5 2\n"), [2]);
    assert_eq!(asked("0 0 1\n0.5 2 3\n1 3 2\n1.5 5 7\n2 8 1\n"), [1, 2]);
    let swapped = rows(9, |at| format!("{} {} {} {}", rough(at), rough(at + 3), rough(at + 5), at * at));
    assert_eq!(asked(&swapped), [4]);
    for (channel, expected) in [("1", [3e-6, 1e-6, 5e-6]), ("column 1", [3e-6, 1e-6, 5e-6])] {
        let found = read("3 0\n1 1\n5 2\n", &of_channel(channel, "um"));
        assert_eq!(found.scan.complete_heights_m().unwrap(), expected);
    }
    // Of two columns that rise, even steps over many rows are those of positions.
    let wedge = rows(9, |at| format!("{:.1} {}", at as f64 / 2.0, at * at));
    assert_eq!(spacings_m(&read_one(wedge.as_bytes(), &in_unit("um")).unwrap().scan).0, 0.5e-6);
}

#[test]
fn positions_of_points_along_a_line_make_a_profile() {
    let along = |text: &str| read(text, &in_unit("um")).scan;
    let heights = |text: &str| along(text).complete_heights_m().unwrap().to_vec();
    assert_eq!(heights("x y z\n0.5 3 1\n1.0 3 4\n1.5 3 2\n"), [1e-6, 4e-6, 2e-6]);
    assert_eq!(heights("x y z\n3 0.5 1\n3 1.0 4\n3 1.5 2\n"), [1e-6, 4e-6, 2e-6]);
    assert_eq!(along("y,x,z\n0,0.0,1\n0,0.5,2\n1,0.0,3\n1,0.5,4\n").points(), (2, Some(2)));
}

#[test]
fn numbers_above_a_scan_are_no_heights() {
    let heights = rows(40, |at| format!("{:.3}", rough(at)));
    let sized = ScanOptions { size: Some(ScanSize { x_m: 40e-6, y_m: None }), ..in_unit("um") };
    for preamble in ["40\n", "2.5\n40\n", "40\n0.25\n", "0.5 40\n", "40 1\nHeights\n", "Trace 1\n40\n"] {
        let found = read(&format!("{preamble}{heights}"), &sized);
        assert_eq!(
            (found.scan.points().0, found.scan.height_m(1)),
            (40, Some(rough(1) * 1e-6)),
            "{preamble}"
        );
        assert!(!found.notes.is_empty(), "{preamble}");
    }
    let tester = read(&format!("8.0\n40\n{heights}"), &in_unit("um"));
    assert_eq!(tester.scan.size_m().0, 8e-3);
    let map =
        rows(6, |at| format!("{} {} {} {} {}", rough(at), rough(at + 3), rough(at + 5), rough(at + 9), at));
    let sized = ScanOptions { size: Some(ScanSize { x_m: 5e-6, y_m: Some(6e-6) }), ..in_unit("um") };
    for preamble in ["5 6\n", "6 5\n", "30\n", "6\n5\n", "0.5 0.5\n"] {
        let found = read(&format!("{preamble}{map}"), &sized);
        assert_eq!(found.scan.points(), (5, Some(6)), "{preamble}");
    }
    // More than there are: the file is cut off.
    for preamble in ["5 7\n", "7 5\n", "31\n"] {
        refused!(refusal(format!("{preamble}{map}").as_bytes(), &sized), BadField {});
    }
    // A count that is not that of the heights is written unlike them.
    refused!(refusal(format!("8.0\n41\n{heights}").as_bytes(), &in_unit("um")), BadField {});
}

#[test]
fn headers_tell_factors_spacings_and_marks() {
    let map = |header: &str| read(&format!("{header}1 2 3 4\n5 6 -9999 8\n"), &ScanOptions::default()).scan;
    let esri = ScanOptions { fallback_unit: "m".parse().ok(), ..ScanOptions::default() };
    let grid = read(
        "ncols 4\nnrows 2\nxllcorner 0.0\nyllcorner 0.0\ncellsize 0.5\nNODATA_value -9999\n1 2 3 4\n5 6 -9999 8\n",
        &esri,
    );
    assert_eq!((grid.scan.size_m(), grid.scan.height_m(6)), ((2.0, Some(1.0)), None));
    assert!(grid.notes.iter().any(|note| note.contains("xllcorner 0.0")), "{:?}", grid.notes);
    let found = map("Pixel size: 0.5 um\nUnit: nm\nMultiplier 2\nNo data value = -9999\n");
    assert_eq!((found.size_m().0, found.height_m(1), found.height_m(6)), (2e-6, Some(4e-9), None));
    let found = map("x spacing\t500 nm/pixel\nz scale\t0.25 nm\n");
    assert_eq!((found.size_m().0, found.height_m(1)), (2e-6, Some(0.5e-9)));
}

#[test]
fn blocks_and_line_ends_are_told() {
    let heights = rows(10, |at| format!("{:.3}", rough(at)));
    let sized = ScanOptions { size: Some(ScanSize { x_m: 1e-6, y_m: None }), ..in_unit("nm") };
    refused!(refusal(format!("{heights}\n{heights}").as_bytes(), &sized), Unsupported {});
    // An empty line behind each, or at the ends, separates nothing.
    for text in [heights.replace('\n', "\n\n"), format!("\n\n{heights}\n\n"), heights.replace('\n', "\r")] {
        assert_eq!(read(&text, &sized).scan.points(), (10, None));
    }
    refused!(refusal(b"0;1,234\n1;567\n2;12,345\n", &in_unit("nm")), BadField {});
    let marked = read("0.0 3\n0.5 -9999\n1.0 2\n", &in_unit("nm"));
    assert!(marked.notes[0].contains("'no data = -9999'"), "{:?}", marked.notes);
    let declared = read("# no data = -9999\n0.0 1\n0.5 3\n1.0 -9999\n1.5 2\n", &in_unit("nm"));
    assert_eq!((declared.scan.missing_points().count(), declared.notes.len()), (1, 0));
}

#[test]
fn height_maps_of_keyence_are_read() {
    let text = "\"Model\",\"VK-X\"\n\"XY Calibration\",\"138.5\",\"nm\"\n\"Output image data\",\"Height\"\n\"Horizontal\",\"4\"\n\
                \"Vertical\",\"2\"\n\"Unit\",\"um\"\n\"\"\n\"Height\"\n\"1.5\",\"2\",\"\",\"4\"\n\"5\",\"6\",\"7\",\"8\"\n";
    let scan = read(text, &ScanOptions::default()).scan;
    let (x_m, y_m) = scan.spacing_m();
    assert!((x_m / 138.5e-9 - 1.0).abs() < 1e-12 && (y_m.unwrap() / 138.5e-9 - 1.0).abs() < 1e-12);
    assert_eq!((scan.points(), scan.height_m(0), scan.height_m(2)), ((4, Some(2)), Some(1.5e-6), None));
    let cut_off = text.replace("\"Vertical\",\"2\"", "\"Vertical\",\"3\"");
    refused!(refusal(cut_off.as_bytes(), &ScanOptions::default()), BadField {});
}

#[test]
fn a_unit_of_heights_may_be_given_alone() {
    let text = "x (mm);z\n0;1\n1;3\n2;2\n";
    let error = refusal(text.as_bytes(), &ScanOptions::default());
    assert_eq!(error.mend(), Some(Mend::Give(ScanOption::HeightUnit)));
    let options = ScanOptions { fallback_height_unit: "nm".parse().ok(), ..ScanOptions::default() };
    let scan = read_one(text.as_bytes(), &options).unwrap().scan;
    assert_eq!((spacings_m(&scan).0, heights_m(&scan)), (1e-3, [1e-9, 3e-9, 2e-9].as_slice()));
    assert!(matches!(scan, Scan::UniformLine(_)));
}

#[test]
fn each_profile_of_a_table_has_its_own_positions() {
    let named =
        rows(9, |at| format!("{0:.1};{1};{2:.1};{3}", at as f64 / 2.0, rough(at), at as f64, rough(at + 4)));
    for (heads, unit) in
        [("x1 (um);z1 (um);x2 (um);z2 (um)\n", None), ("x;y;x;y\n", Some("um")), ("", Some("um"))]
    {
        let text = format!("{heads}{named}");
        let options = |channel: &str| ScanOptions {
            channel: Some(channel.to_owned()),
            fallback_unit: unit.and_then(|unit: &str| unit.parse().ok()),
            ..ScanOptions::default()
        };
        let all = ScanOptions { channel: None, ..options("") };
        let channels = read(&text, &all).channels;
        assert_eq!(channels.len(), 2, "{heads}: {channels:?}");
        for (channel, length_m) in channels.iter().zip([4.5e-6, 9e-6]) {
            let found_m = read(&text, &options(channel)).scan.size_m().0;
            assert!((found_m / length_m - 1.0).abs() < 1e-12, "{heads} {channel}: {found_m}");
        }
    }
}

#[test]
fn masks_tell_what_does_not_count() {
    let gaps = |head: &str, is_marked: u8, is_not: u8| {
        let table =
            rows(10, |at| format!("{at}.5;{};{}", rough(at), if at == 3 { is_marked } else { is_not }));
        let found = read(&format!("x (um);z (um);{head}\n{table}"), &ScanOptions::default());
        found.scan.missing_points().indices().collect::<Vec<_>>()
    };
    assert_eq!(gaps("valid", 0, 1), [3]);
    assert_eq!((gaps("mask", 1, 0), gaps("flag", 0, 1), gaps("bad", 1, 0)), (vec![3], vec![3], vec![3]));
}

#[test]
fn counted_points_take_their_distance_from_the_header_or_the_caller() {
    let counted = rows(10, |at| format!("{at}\t{}", rough(at)));
    let length_m = |text: &str, options: &ScanOptions| read(text, options).scan.size_m().0;
    let stated = length_m(&format!("Spacing: 0.5 um\nUnit: um\n{counted}"), &ScanOptions::default());
    let named = length_m(&format!("Spacing (um): 0.5\nNo.\tHeight (nm)\n{counted}"), &ScanOptions::default());
    let sized = ScanOptions { fallback_size: Some(ScanSize { x_m: 5e-6, y_m: None }), ..in_unit("nm") };
    for found_m in [stated, named, length_m(&counted, &sized)] {
        assert!((found_m / 5e-6 - 1.0).abs() < 1e-12, "{found_m}");
    }
    let points = rows(12, |at| format!("{} {} {}", at % 4, at / 4, rough(at)));
    let map = read(&format!("Pixel size: 0.5 um\nUnit: um\n{points}"), &ScanOptions::default());
    assert_eq!(map.scan.size_m(), (2e-6, Some(1.5e-6)));
}

#[test]
fn labels_of_a_map_are_no_heights() {
    let cells =
        |row: usize| (0..6).map(|column| rough(6 * row + column).to_string()).collect::<Vec<_>>().join(",");
    let numbers = (0..6).map(|at| at.to_string()).collect::<Vec<_>>().join(",");
    let places = (0..6).map(|at| format!("{:.1}", 0.5 * f64::from(at))).collect::<Vec<_>>().join(",");
    let sized = ScanOptions { fallback_size: Some(ScanSize { x_m: 3e-6, y_m: None }), ..in_unit("um") };
    let with_rows = |corner: &str, above: &str, step: f64| {
        format!("{corner},{above}\n{}", rows(8, |row| format!("{:.2},{}", step * row as f64, cells(row))))
    };
    let without = format!("{numbers}\n{}", rows(8, cells));
    for text in [
        &without,
        &with_rows("", &numbers, 1.0),
        &with_rows("0", &places, 0.25),
        &with_rows("y", &places, 0.25),
    ] {
        let found = read(text, &sized);
        assert_eq!(
            (found.scan.points(), found.scan.height_m(7)),
            ((6, Some(8)), Some(rough(7) * 1e-6)),
            "{text}"
        );
        assert!((found.scan.size_m().0 / 3e-6 - 1.0).abs() < 1e-12 && !found.notes.is_empty(), "{text}");
    }
    let placed = read(&with_rows("0", &places, 0.25), &in_unit("um"));
    assert_eq!(placed.scan.size_m(), (3e-6, Some(2e-6)));
}

#[test]
fn points_may_have_more_columns() {
    let table = rows(12, |at| format!("{} {} {} {}", at % 4, at / 4, rough(at), 100 + at % 5));
    let found = read(&table, &in_unit("um"));
    assert_eq!((found.scan.points(), found.channels.len()), ((4, Some(3)), 2));
}

#[test]
fn rows_at_the_edge_of_a_scan_belong_to_it() {
    let sized = ScanOptions { size: Some(ScanSize { x_m: 4e-6, y_m: Some(4e-6) }), ..in_unit("um") };
    for gap in ["***,***,***,***", "---,---,---,---", ",,,", "Bad,Bad,Bad,Bad"] {
        let found = read(&format!("{gap}\n1.5,2,3,4\n5,6,7,8\n9,7,5,1\n"), &sized);
        assert_eq!((found.scan.points(), found.scan.missing_points().count()), ((4, Some(4)), 4), "{gap}");
    }
    for row in ["0,OVER", "0.5,1.5,start"] {
        let rest = if row.matches(',').count() == 1 { "0.5,2\n1.0,1\n" } else { "0.5,2,\n1.0,1,end\n" };
        refused!(refusal(format!("{row}\n{rest}").as_bytes(), &in_unit("um")), NotANumber {});
    }
    let empty = read(",,1.5,2,3,4,5\n,,5,6,7,8,9\n,,9,7,5,1,2\n", &sized);
    assert!(empty.notes.iter().any(|note| note.starts_with("2 empty columns")), "{:?}", empty.notes);
}

#[test]
fn bare_widths_count_points_and_lengths_state_units() {
    let map = rows(3, |at| format!("{} {} {} {}", rough(at), rough(at + 3), rough(at + 5), rough(at + 9)));
    let size = |header: &str| read(&format!("{header}{map}"), &ScanOptions::default()).scan.size_m();
    assert_eq!(size("Width: 4\nHeight: 3\nPixel size: 0.5 um\nUnit: um\n"), (2e-6, Some(1.5e-6)));
    assert_eq!(size("Length: 4 um\nWidth: 3 um\nZ unit: nm\n"), (4e-6, Some(3e-6)));
    // Two sizes along the rows make none across.
    assert_eq!(size("X Size: 4 um\nScan Length: 4 um\nZ unit: nm\n").1, Some(3e-6));
    let tester = format!(
        "Scan Length (um): 5\nUnits: Angstroms\nX\tZ\n{}",
        rows(10, |at| format!("{:.1}\t{}", at as f64 / 2.0, rough(at)))
    );
    let found = read(&tester, &ScanOptions::default());
    assert!((found.scan.size_m().0 / 5e-6 - 1.0).abs() < 1e-12);
    assert_eq!(found.scan.height_m(1), Some(rough(1) * 1e-10));
}

#[test]
fn words_below_the_numbers_are_named_and_not_read() {
    let profile = rows(10, |at| format!("{:.1},{}", at as f64 / 2.0, rough(at)));
    for footer in ["Ra,0.83,um\n", "\nRa = 0.83\nRz = 4.1\n", "Mean,0.1\n", "EOR\n"] {
        let found = read(&format!("x (um),z (um)\n{profile}{footer}"), &ScanOptions::default());
        assert_eq!(found.scan.points(), (10, None), "{footer}");
        assert!(
            found.notes.iter().any(|note| note.starts_with("not read below")),
            "{footer} {:?}",
            found.notes
        );
    }
    let row = "1.5,2,3,4\n5,6,7,8\nOVER,1,2,3\n";
    let sized = ScanOptions { size: Some(ScanSize { x_m: 4e-6, y_m: Some(4e-6) }), ..in_unit("um") };
    refused!(refusal(row.as_bytes(), &sized), NotANumber { line: 3, column: 1, text: "OVER" });
    refused!(refusal(format!("{profile}Profile 2\n{profile}").as_bytes(), &in_unit("um")), Ragged {});
}

#[test]
fn headers_that_contradict_the_columns_are_told() {
    let heights = rows(10, |at| format!("{:.3}", rough(at)));
    let found =
        read(&format!("Length: 4 mm\nSpacing: 0.5 um\nZ unit: nm\n{heights}"), &ScanOptions::default());
    assert!(found.notes.iter().any(|note| note.contains("do not agree")), "{:?}", found.notes);
    let wrapped =
        rows(5, |row| (0..8).map(|at| rough(8 * row + at).to_string()).collect::<Vec<_>>().join(" "));
    let line =
        read(&format!("Number of points: 40\nSpacing: 0.5 um\nUnit: um\n{wrapped}"), &ScanOptions::default());
    assert_eq!((line.scan.points(), line.scan.height_m(9)), ((40, None), Some(rough(9) * 1e-6)));
    let profile = rows(10, |at| format!("{:.1} {}", at as f64 / 2.0, rough(at)));
    let specimen = read(&format!("Width: 10 mm\nHeight: 5 mm\n{profile}"), &in_unit("um"));
    assert_eq!(specimen.scan.points(), (10, None));
    let commas = rows(4, |at| format!("2{at},490\t31,220\t12,345\t10,00{at}"));
    let sized = ScanOptions { size: Some(ScanSize { x_m: 4e-6, y_m: Some(4e-6) }), ..in_unit("nm") };
    assert!(read(&commas, &sized).notes.iter().any(|note| note.contains("decimal comma")));
}

#[test]
fn counted_points_keep_their_mask_and_take_the_size_that_is_given() {
    let masked = rows(10, |at| format!("{at};{};{}", rough(at), u8::from(at == 4)));
    let profile = read(&format!("Spacing: 0.5 um\nZ unit: nm\nx;z;mask\n{masked}"), &ScanOptions::default());
    assert_eq!(profile.scan.missing_points().indices().collect::<Vec<_>>(), [4]);
    let points = rows(12, |at| format!("{} {} {}", at % 4, at / 4, rough(at)));
    let sized = ScanOptions { fallback_size: Some(ScanSize { x_m: 8e-6, y_m: None }), ..in_unit("nm") };
    let map = read(&points, &ScanOptions { unit: None, fallback_unit: "nm".parse().ok(), ..sized });
    assert_eq!(map.scan.size_m(), (8e-6, Some(6e-6)));
}

#[test]
fn labels_above_a_row_of_gaps_stay_labels() {
    let text = format!("y,0,1,2,3\n0,,,,\n{}", rows(6, |at| format!("{},1.5,{},2,3", at + 1, rough(at))));
    let sized = ScanOptions { fallback_size: Some(ScanSize { x_m: 4e-6, y_m: None }), ..in_unit("um") };
    let found = read(&text, &sized);
    assert_eq!((found.scan.points(), found.scan.missing_points().count()), ((4, Some(7)), 4));
}

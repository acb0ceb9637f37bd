//! Binary files that lie about themselves: refused with the place, the value and the bound.

use crate::support::nanoscope::{Image, NanoscopeFile};
use crate::support::netcdf::{Attribute, Kind, NetCdf, Variable};
use crate::support::x3p::X3p;
use crate::support::zip_file::zipped;
use crate::support::{
    heights_m, in_unit, measured, missing_points, read_one, refusal, self_affine_map, spacings_m,
};
use scans::ScanError::AbsurdHeight;
use scans::{ForeignFile, Measure, Mend, ScanOption, ScanOptions, ScanReadError, read_scans, visit_channels};

fn none() -> ScanOptions {
    ScanOptions::default()
}

/// A file with one text in its header replaced by another of the same length.
fn replaced(bytes: &[u8], from: &str, to: &str) -> Vec<u8> {
    assert_eq!(from.len(), to.len());
    let at = bytes.windows(from.len()).position(|window| window == from.as_bytes()).expect(from);
    let mut bytes = bytes.to_vec();
    bytes[at..at + to.len()].copy_from_slice(to.as_bytes());
    bytes
}

#[test]
fn unknown_formats_are_named_by_their_first_bytes_with_advice() {
    let of = |bytes: &[u8]| refusal(bytes, &none());
    assert!(matches!(of(b"\x89PNG\r\n\x1a\n"), ScanReadError::Foreign(ForeignFile::Picture("PNG"))));
    assert!(matches!(of(b"%PDF-1.7\n1 2\n"), ScanReadError::Foreign(ForeignFile::Pdf)));
    assert!(matches!(of(b"<!DOCTYPE html>\n"), ScanReadError::Foreign(ForeignFile::WebPage)));
    refused!(of(b"\x01\x02\x03"), UnknownFormat { start: "'\\x01\\x02\\x03'" });
    refused!(of(b""), NoRows {});
    refused!(of(b"\x89HDF\r\n\x1a\n...."), Syntax { file: "HDF5" });
    assert!(matches!(of(&zipped(&[("a.bin", b"\0\x01")])), ScanReadError::Foreign(ForeignFile::Zip)));
}

#[test]
fn nanoscope_headers_that_lie() {
    let map = self_affine_map(6, 4);
    let bytes = NanoscopeFile::new(6, 4, &map).to_bytes();
    let refused = |from: &str, to: &str| refusal(&replaced(&bytes, from, to), &none());
    refused!(
        refused("Data length: 48", "Data length: 47"),
        BadField { field: "'Data length'", value: "'47'", place: scans::FilePlace::Byte(192) }
    );
    refused!(
        refused("Data offset: 2048", "Data offset: 2049"),
        Truncated { needed: 48, available: 47, offset: 2049 }
    );
    refused!(
        refused("Data offset: 2048", "Data offset: 0000"),
        BadField { field: "'Data offset'", value: "'0000'" }
    );
    refused!(refused("Samps/line: 6", "Samps/line: 0"), BadField { field: "'Samps/line'", value: "'0'" });
    let three = refused("Bytes/pixel: 2", "Bytes/pixel: 3");
    refused!(three, BadField { field: "'Bytes/pixel'", value: "'3'" });
    refused!(refused("500 250 nm", "500 -50 nm"), BadField { field: "'Scan size'", value: "'500 -50 nm'" });
    refused!(refused("500 250 nm", "500 250 mV"), BadField { field: "'Scan size'", value: "'500 250 mV'" });
    refused!(refusal(&bytes[..400], &none()), MissingField { field: "line '\\*File list end' before it" });
    refused!(
        refused("\\*File list end", "?*File list end"),
        BadField { field: "the line", value: "'?*File list end'" }
    );
    refused!(
        refused("\\@Sens. Zsens", "\\@Sens. Ysens"),
        BadField { field: "'@2:Z scale'", value: "'V [Sens. Zsens] (0.0001 V/LSB) 8 V'" }
    );
    refused!(refused("OL2BIG", "FOL   "), Unsupported { found: "a force curve" });
    let unit = refusal(&bytes, &in_unit("nm"));
    refused!(unit, UnitIsFixed {});
    let lies = replaced(&bytes, "lines: 4\r\n\\Scan", "lines: 9\r\n\\Scan");
    refused!(refusal(&lies, &none()), BadField { field: "'Data length'", value: "'48'" });
}

#[test]
fn nanoscope_channels_go_by_name() {
    let map = self_affine_map(6, 4);
    let mut file = NanoscopeFile::new(6, 4, &map);
    file.images = vec![
        Image { name: "Phase", direction: "Trace", heights_m: &map },
        Image { name: "Height Sensor", direction: "Retrace", heights_m: &map },
    ];
    let scan = read_one(&file.to_bytes(), &none()).unwrap();
    assert_eq!(scan.channel.as_deref(), Some("Height Sensor (Retrace)"));
    let wanted = |name: &str| ScanOptions { channel: Some(name.to_owned()), ..none() };
    assert!(read_one(&file.to_bytes(), &wanted("Height Sensor")).is_ok());
    refused!(
        refusal(&file.to_bytes(), &wanted("Amplitude")),
        NoChannel { wanted: "channel 'Amplitude'", channels: ["Phase (Trace)", "Height Sensor (Retrace)"] }
    );
    let phase = read_scans(&file.to_bytes(), "scan", &wanted("Phase")).unwrap_err();
    refused!(phase, NoHeights { channel: "Phase (Trace)", unit: "V", channels: ["Height Sensor (Retrace)"] });
    assert_eq!(phase.mend(), Some(Mend::Give(ScanOption::Channel)));
    file.images.remove(1);
    let alone = read_scans(&file.to_bytes(), "scan", &wanted("Phase")).unwrap_err();
    assert!(alone.to_string().ends_with("there are none with heights") && alone.mend().is_none(), "{alone}");
}

#[test]
fn channels_that_hold_no_lengths_can_be_looked_at() {
    let map = self_affine_map(6, 4);
    let mut file = NanoscopeFile::new(6, 4, &map);
    let height = Image { name: "Height", direction: "Trace", heights_m: &map };
    file.images = vec![Image { name: "Phase", direction: "Trace", heights_m: &map }, height];
    let wanted = ScanOptions { channel: Some("Phase".to_owned()), ..none() };
    for (options, all) in [(&wanted, false), (&none(), true)] {
        let mut found = Vec::new();
        visit_channels(&file.to_bytes(), "scan", options, all, |channel| found.push(channel)).unwrap();
        let phase = found.remove(0).unwrap();
        assert_eq!(phase.channel.as_deref(), Some("Phase (Trace)"));
        assert_eq!(phase.measure, Measure::Other("V".to_owned()));
        assert_eq!(phase.channels, ["Height (Trace)"]);
    }
}

#[test]
fn nanoscope_scans_of_other_size_than_their_images() {
    let map = self_affine_map(6, 4);
    let slow = NanoscopeFile {
        extra: "\\Scan Size: 500 nm\r\n\\Slow Axis Size: 0.3 ~m\r\n",
        ..NanoscopeFile::new(6, 4, &map)
    };
    assert_eq!(spacings_m(&read_one(&slow.to_bytes(), &none()).unwrap().scan).1 * 4.0, 300e-9);
    // The image's section says 6 x 2, its data and the scan have 6 x 4.
    let scan = NanoscopeFile { extra: "\\Samps/line: 6\r\n\\Lines: 4\r\n", ..NanoscopeFile::new(6, 4, &map) };
    let halved = replaced(&scan.to_bytes(), "of lines: 4", "of lines: 2");
    let read = read_one(&halved, &none()).unwrap();
    assert_eq!((heights_m(&read.scan).len(), read.notes.len()), (24, 1));
}

#[test]
fn nanoscope_scans_that_are_no_squares() {
    let map = self_affine_map(8, 4);
    let size_m = |scan_size, extra| {
        let mut file = NanoscopeFile { scan_size, extra, ..NanoscopeFile::new(8, 4, &map) };
        file.images[0].direction = "Trace\r\n\\Aspect Ratio: 2:1";
        let file = read_one(&file.to_bytes(), &none()).unwrap();
        let (x_m, y_m) = spacings_m(&file.scan);
        ((x_m * 8.0 * 1e9).round(), (y_m * 4.0 * 1e9).round(), file.notes)
    };
    let note = "the file gives one size for both axes and an aspect ratio of 2:1: points are taken to be as far apart along \
                both"
        .to_owned();
    assert_eq!(size_m("500 250 nm", ""), (500.0, 250.0, vec![]));
    assert_eq!(size_m("500 nm", ""), (500.0, 250.0, vec![note.clone()]));
    assert_eq!(size_m("500 500 nm", "\\Lines: 4\r\n"), (500.0, 250.0, vec![note.clone()]));
    // The scan was stopped at half of its lines.
    assert_eq!(size_m("500 500 nm", "\\Lines: 8\r\n"), (500.0, 250.0, vec![note]));
    let slow = "\\Lines: 8\r\n\\Scan Size: 500 nm\r\n\\Slow Axis Size: 250 nm\r\n";
    assert_eq!(size_m("500 500 nm", slow), (500.0, 125.0, vec![]));
}

#[test]
fn netcdf_headers_that_lie() {
    let map = self_affine_map(6, 4);
    let file = || NetCdf::map(2, Kind::F64, 6, &map);
    let with = |change: &dyn Fn(&mut NetCdf)| {
        let mut file = file();
        change(&mut file);
        refusal(&file.to_bytes(), &none())
    };
    refused!(
        with(&|file| file.dimensions[0].1 = 0xffff_fff0),
        Truncated { needed: 137438952960, available: 272, offset: 356 }
    );
    refused!(
        with(&|file| file.dimensions[1].1 = 0),
        BadField { field: "the list of dimensions of 'heights'", value: "x: 6, y: 0" }
    );
    refused!(
        with(&|file| file.variables[0].dimensions = vec![0, 9]),
        BadField { field: "a dimension of 'heights'", value: "9" }
    );
    refused!(
        with(&|file| file.variables[0].name = "z"),
        NoChannel { wanted: "variable 'heights'", channels: ["z", "x", "y"] }
    );
    refused!(with(&|file| file.version = 3), BadField { field: "the version", value: "3" });
    let unit = |file: &mut NetCdf| file.variables[0].attributes[0].1 = Attribute::Text("V");
    refused!(with(&unit), BadField { field: "attribute 'unit'", value: "'V'" });
    let length = |file: &mut NetCdf| file.variables[1].attributes[0].1 = Attribute::Number(-1.0);
    refused!(with(&length), BadField { field: "attribute 'length'", value: "-1" });
    let mixed = |file: &mut NetCdf| file.variables[2].attributes[2].1 = Attribute::Text("nm");
    refused!(with(&mixed), BadField { field: "the unit of 'y'", value: "nm" });
    // A list that claims more entries than the file has bytes.
    let mut bytes = file().to_bytes();
    bytes[12..16].copy_from_slice(&[0xff; 4]);
    refused!(refusal(&bytes, &none()), BadField { field: "the number of dimensions", value: "4294967295" });
}

#[test]
fn netcdf_missing_points_scales_and_records() {
    let map = self_affine_map(6, 4);
    let mut masked = NetCdf::map(2, Kind::F64, 6, &map);
    let mut mask = vec![0.0; 24];
    mask[5] = 1.0;
    let dimensions = vec![0, 1];
    masked.variables.push(Variable {
        name: "mask",
        dimensions,
        attributes: Vec::new(),
        kind: Kind::I8,
        values: mask,
    });
    // Values run along y first: the sixth is the second point of the second column.
    assert_eq!(missing_points(&masked.to_bytes(), &none()), [7]);
    refused!(
        read_one(&masked.to_bytes(), &none()).unwrap_err(),
        Scan(MissingPoints { missing: 1, points: 24 })
    );
    let kept = measured(&masked.to_bytes(), &none()).unwrap().scan;
    for (index, (found, written)) in kept.heights_m().zip(&map).enumerate() {
        assert!(found.map_or(index == 7, |found_m| (found_m - written).abs() < 1e-22), "{index}");
    }
    masked.variables.last_mut().unwrap().dimensions = vec![1, 0];
    refused!(
        refusal(&masked.to_bytes(), &none()),
        BadField { field: "the list of dimensions of 'mask'", value: "y: 4, x: 6" }
    );

    // The fill value of the library marks a missing point, unless an attribute names another fill value.
    for kind in [Kind::F32, Kind::F64] {
        let mut unwritten = NetCdf::map(2, kind, 6, &map);
        unwritten.variables[0].values[5] = 9.969_209_968_386_869e36;
        assert_eq!(missing_points(&unwritten.to_bytes(), &none()), [7]);
        unwritten.variables[0].attributes.push(("_FillValue", Attribute::Number(-1.0)));
        let read = read_one(&unwritten.to_bytes(), &none());
        assert!(
            matches!(read, Err(ScanReadError::Scan(AbsurdHeight { height_m, .. })) if height_m > 1e30),
            "{read:?}"
        );
    }

    let mut filled = NetCdf::map(2, Kind::I16, 6, &map);
    filled.variables[0].values = (0..24).map(f64::from).collect();
    filled.variables[0].attributes.push(("scale_factor", Attribute::Number(0.5)));
    filled.variables[0].attributes.push(("add_offset", Attribute::Number(-1.0)));
    assert_eq!(heights_m(&read_one(&filled.to_bytes(), &none()).unwrap().scan)[1], 1e-6);
    filled.variables[0].attributes.push(("_FillValue", Attribute::Number(23.0)));
    assert_eq!(missing_points(&filled.to_bytes(), &none()), [23]);

    // Records of x and heights take turns.
    let values = [[0.0, 1.0], [1.0, 2.0], [2.5, 4.0]];
    let mut records = NetCdf::line("n", vec![0.0; 1], &[0.0; 1]);
    (records.records, records.dimensions) = (3, vec![("n", 0)]);
    let mut bytes = records.to_bytes();
    bytes.truncate(bytes.len() - 16);
    bytes.extend(values.iter().flatten().flat_map(|value: &f64| value.to_be_bytes()));
    assert_eq!(heights_m(&read_one(&bytes, &none()).unwrap().scan), [1e-6, 2e-6, 4e-6]);
}

#[test]
#[cfg(feature = "x3p")]
fn x3p_descriptions_that_lie() {
    let map = self_affine_map(6, 4);
    let file = X3p::surface('D', 6, &map);
    let with = |from: &str, to: &str| {
        let index = file.main_xml();
        assert!(index.contains(from), "{from}");
        let index = index.replacen(from, to, 1);
        refusal(&zipped(&[("main.xml", index.as_bytes()), ("bindata/data.bin", &file.data())]), &none())
    };
    refused!(with("<SizeX>6<", "<SizeX>7<"), Truncated { needed: 224, available: 192, offset: 0 });
    refused!(
        with("<SizeX>6<", "<SizeX>18446744073709551615<"),
        Truncated { needed: 18446744073709551615, available: 192 }
    );
    refused!(with("<SizeX>6<", "<SizeX>0<"), BadField { field: "the text", value: "'0'" });
    refused!(with("<SizeZ>1<", "<SizeZ>2<"), BadField { field: "the text", value: "'2'" });
    refused!(with("SUR", "PCL"), MissingField { field: "element 'ListDimension'" });
    refused!(with("<Increment>0.00000025<", "<Increment>0<"), BadField { field: "the text", value: "'0'" });
    refused!(with("SUR", "VOL"), Unsupported { found: "the feature type 'VOL'" });
    refused!(with("<DataType>D<", "<DataType>X<"), BadField { field: "the text", value: "'X'" });
    refused!(with("bindata/data.bin", "../data.bin"), PathOutside { path: "../data.bin" });
    refused!(with("</Record3>", ""), Syntax { file: "main.xml" });
    let attributes: String = (0..300_000).map(|at| format!(" a{at}=\"\"")).collect();
    refused!(with("<Record3>", &format!("<Record3{attributes}>")), Syntax { file: "main.xml" });
    refused!(with("<DataLink>", "<DataList>"), Syntax { file: "main.xml" });
    let invalid = X3p { valid: Some(&[0xff, 0xbf, 0xff]), ..X3p::surface('I', 6, &map) };
    assert_eq!(missing_points(&invalid.to_bytes(), &none()), [14]);
    let mut holed = map.clone();
    holed[7] = f64::NAN;
    let missing = X3p::surface('F', 6, &holed).to_bytes();
    assert_eq!(missing_points(&missing, &none()), [7]);
}

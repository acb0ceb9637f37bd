//! The inputs that fuzzing starts from, of formats whose writers the tests of scans share; those of others stand in
//! `instruments`.

use crate::support::corpus::keep;
use crate::support::nanoscope::{Image, NanoscopeFile};
use crate::support::netcdf::{Kind, NetCdf};
use crate::support::x3p::X3p;
use crate::support::zip_file::zipped;
use crate::support::{gwyddion_matrix, in_unit, self_affine_line, self_affine_map, text_rows};
use scans::{ScanOptions, read_scans};

/// Name of the target, name of the input, its bytes.
fn inputs() -> Vec<(&'static str, &'static str, Vec<u8>)> {
    let (line, map) = (self_affine_line(12), self_affine_map(6, 4));
    let nm = |height: &f64| height * 1e9;
    let even = text_rows(line.iter().enumerate().map(|(index, height)| [index as f64, nm(height)]));
    let uneven =
        text_rows(line.iter().enumerate().map(|(index, height)| [(index * index) as f64, nm(height)]));
    let points =
        text_rows(map.iter().enumerate().map(|(i, height)| [(i % 6) as f64, (i / 6) as f64, nm(height)]));
    let retrace = Image { name: "Height", direction: "Retrace", heights_m: &map };
    let mut nanoscope = NanoscopeFile::new(6, 4, &map);
    nanoscope.images.push(retrace);
    let wide = NanoscopeFile { version: 0x0920_0000, bytes_per_count: 4, ..NanoscopeFile::new(6, 4, &map) };
    let netcdf = |version| NetCdf::map(version, Kind::F64, 6, &map).to_bytes();
    let netcdf_line = NetCdf::line("n", (0..12).map(f64::from).collect(), &line).to_bytes();
    let surface = X3p::surface('I', 6, &map);
    let masked = X3p { valid: Some(&[0xff; 3]), ..X3p::surface('D', 6, &map) };
    let json = r#"{"surfaces": [{"topographies": [{"name": "a", "datafile": {"original": "data"}, "size": [2.5, 1],
        "unit": "um", "height_scale": 2.0, "is_periodic": true, "instrument": {"parameters": {"tip_radius":
        {"value": 10, "unit": "nm"}}}}]}]}"#;
    let yaml = "surfaces:\n- topographies:\n  - name: b\n    datafile: {original: data, squeezed-netcdf: data}\n    \
                size: !!python/tuple\n    - 1.5\n    unit: nm\n";
    let joined = |text: &str, data: &[u8]| [text.as_bytes(), b"\0", data].concat();
    let archive = zipped(&[("meta.yml", yaml.as_bytes()), ("data", even.as_bytes())]);
    vec![
        ("text", "even", even.clone().into_bytes()),
        ("text", "uneven", uneven.into_bytes()),
        ("text", "points", points.into_bytes()),
        ("text", "matrix", gwyddion_matrix(6, [2.5, 1.5], &map).into_bytes()),
        ("text", "decimal-commas", b"x [mm];h [um];\n0,0;1,5;\n0,5;-2e-1;\n1,0;3;\n".to_vec()),
        ("text", "one-column", b"# Spacing: 0.5 nm\n# Unit: nm\n1.5\n2\nnan\n".to_vec()),
        ("nanoscope", "two-bytes", nanoscope.to_bytes()),
        ("nanoscope", "four-bytes", wide.to_bytes()),
        ("netcdf", "cdf1", netcdf(1)),
        ("netcdf", "cdf2", netcdf(2)),
        ("netcdf", "cdf5", netcdf(5)),
        ("netcdf", "line", netcdf_line.clone()),
        ("x3p", "integers", joined(&surface.main_xml(), &surface.data())),
        ("x3p", "masked", joined(&masked.main_xml(), &masked.data())),
        ("container", "json-text", joined(json, even.as_bytes())),
        ("container", "yaml-netcdf", joined(yaml, &netcdf_line)),
        ("archive", "container", archive),
        ("archive", "x3p", surface.to_bytes()),
    ]
}

#[test]
fn the_corpus_is_small_and_read_by_the_readers_it_is_for() {
    for (target, name, bytes) in inputs() {
        keep(target, name, &bytes);
        let missing = usize::from(name == "one-column");
        if ["nanoscope", "netcdf", "archive"].contains(&target) {
            read_scans(&bytes, name, &ScanOptions::default()).unwrap();
        } else if target == "text" && name != "matrix" && name != "decimal-commas" {
            assert_eq!(
                read_scans(&bytes, name, &in_unit("nm")).unwrap()[0].scan.missing_points().count(),
                missing,
                "{name}"
            );
        }
    }
}

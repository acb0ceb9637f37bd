//! Containers of contact.engineering: which data count, whose scale and size, and archives that mean harm.
use crate::support::nanoscope::NanoscopeFile;
use crate::support::netcdf::{Kind, NetCdf};
use crate::support::x3p::X3p;
use crate::support::zip_file::zipped;
use crate::support::{assert_close, heights_m, read_one, refusal, self_affine_map, spacings_m};
use scans::{Probe, Scan, ScanFile, ScanFormat, ScanOptions, ScanReadError, read_metadata, read_scans};

const YAML: &str = "\
versions: {topobank: 0.13.0}
surfaces:
- name: diamond
  topographies:
  - name: afm
    datafile: {original: afm.001, squeezed-netcdf: afm-squeezed.nc}
    data_source: 0
    height_scale: 0.112
    is_periodic: false
    measurement_date: 2018-04-05
    size: !!python/tuple
    - 500.0
    - 250.0
    unit: nm
    instrument:
      name: scope
      type: contact-based
      parameters:
        tip_radius: {value: 26.0, unit: nm}
        resolution: {value: 0.01, unit: µm}
  - name: stylus
    datafile: {original: stylus.txt}
    height_scale: 2.0
    is_periodic: true
    size: !!python/tuple
    - 4.0
    unit: mm
";

fn scans(options: &ScanOptions) -> Result<Vec<ScanFile<Scan>>, ScanReadError> {
    let map = self_affine_map(6, 4);
    let afm = NanoscopeFile::new(6, 4, &map).to_bytes();
    let archive = zipped(&[
        ("meta.yml", YAML.as_bytes()),
        ("afm.001", &afm),
        ("stylus.txt", b"0.0 1.5\n1.0 2.5\n2.0 0.5\n3.0 1.0\n"),
    ]);
    complete_scans(&archive, options)
}

/// The scans of a container, none of which has missing points.
fn complete_scans(archive: &[u8], options: &ScanOptions) -> Result<Vec<ScanFile<Scan>>, ScanReadError> {
    read_scans(archive, "container.zip", options)?.into_iter().map(ScanFile::complete).collect()
}

#[test]
fn height_scale_is_for_files_without_a_scale_of_their_own() {
    let scans = scans(&ScanOptions::default()).unwrap();
    let [afm, stylus] = scans.as_slice() else { panic!("two measurements") };
    let map = self_affine_map(6, 4);
    assert_eq!((afm.name.as_str(), afm.format, afm.is_periodic), ("afm", ScanFormat::Nanoscope, false));
    assert_close(heights_m(&afm.scan), &map, 0.51 * NanoscopeFile::new(6, 4, &map).resolution_m());
    assert_eq!(
        afm.notes,
        ["height_scale 0.112 of the metadata is not applied: the file carries its own scale"]
    );
    assert_eq!((afm.tip_radius_m, afm.resolution_m), (Some(26e-9), Some(10e-9)));

    assert_eq!((stylus.name.as_str(), stylus.is_periodic), ("stylus", true));
    assert_eq!(heights_m(&stylus.scan), [3e-3, 5e-3, 1e-3, 2e-3]);
    assert_eq!((spacings_m(&stylus.scan).0, stylus.notes.len()), (1e-3, 0));
}

#[test]
fn one_measurement_can_be_chosen() {
    let chosen = |name: &str| ScanOptions { measurement: Some(name.to_owned()), ..ScanOptions::default() };
    assert_eq!(scans(&chosen("stylus")).unwrap().len(), 1);
    assert_eq!(scans(&chosen("afm.001")).unwrap()[0].name, "afm");
    refused!(
        scans(&chosen("tem")).unwrap_err(),
        NoChannel { wanted: "measurement 'tem'", channels: ["afm", "stylus"] }
    );
}

#[test]
fn an_index_beside_a_file_says_what_the_file_does_not() {
    let entries = read_metadata(YAML, "meta.yml").unwrap();
    let entry = entries.iter().find(|entry| entry.names_file("somewhere/stylus.txt")).unwrap();
    assert_eq!((entry.surface.as_deref(), entry.height_scale), (Some("diamond"), Some(2.0)));
    let options = ScanOptions { metadata: Some(entry.clone()), ..ScanOptions::default() };
    assert_eq!(heights_m(&read_one(b"1\n2\n", &options).unwrap().scan), [2e-3, 4e-3]);
    assert_eq!(spacings_m(&read_one(b"1\n2\n", &options).unwrap().scan).0, 2e-3);
    // The unit in the header counts, and leaves nothing to scale.
    let scan = read_one(b"# Unit: um\n0 1\n1 2\n", &options).unwrap();
    assert_eq!(heights_m(&scan.scan), [1e-6, 2e-6]);
    assert_eq!(
        scan.notes,
        [
            "height_scale 2 of the metadata is not applied: the heights have their unit",
            "the metadata give the size as 4 mm, the file as 2 µm: the file counts"
        ]
    );
}

#[test]
fn processed_copies_stand_in_for_originals_that_cannot_be_read() {
    let map = self_affine_map(6, 4);
    let copy = NetCdf::map(2, Kind::F64, 6, &map).to_bytes();
    let json = r#"{"surfaces": [{"name": "s", "topographies": [{"name": "a", "datafile": {"original": "a.opd",
        "squeezed-netcdf": "a-squeezed.nc"}, "size": [2.5, 1.5], "unit": "um", "height_scale": 3.0}]}]}"#;
    let archive = zipped(&[
        ("folder/index.json", json.as_bytes()),
        ("folder/a.opd", b"\x01\x00Directory"),
        ("folder/a-squeezed.nc", &copy),
    ]);
    let scans = complete_scans(&archive, &ScanOptions::default()).unwrap();
    assert!(scans[0].is_periodic);
    assert_close(heights_m(&scans[0].scan), &map, 1e-22);
    assert!(scans[0].notes[0].starts_with("the instrument's file cannot be read ("), "{:?}", scans[0].notes);
    let gone = zipped(&[("index.json", json.as_bytes())]);
    refused!(
        refusal(&gone, &ScanOptions::default()),
        Measurement { measurement: "a", source: Zip { what: "'a-squeezed.nc'" } }
    );
}

#[test]
fn metadata_that_make_no_sense_are_refused_with_their_path() {
    let message = |text: &str| read_metadata(text, "x/meta.yml").unwrap_err();
    refused!(message("a: 1"), MissingField { field: "list 'surfaces'" });
    refused!(
        message("surfaces:\n- topographies:\n  - size: [-1]\n"),
        BadField { field: "'size'", value: "[-1]" }
    );
    refused!(
        message("surfaces:\n- topographies:\n  - unit: V\n"),
        BadField { field: "'unit'", value: "\"V\"" }
    );
    refused!(message("surfaces: ["), Syntax { file: "meta.yml" });
    refused!(message("{\"surfaces\": }"), Syntax { file: "meta.yml" });
    let mut aliases = "a0: &a0 [x,x,x,x,x,x,x,x,x,x]\n".to_owned();
    for level in 1..9 {
        let ten = vec![format!("*a{}", level - 1); 10].join(",");
        aliases += &format!("a{level}: &a{level} [{ten}]\n");
    }
    refused!(message(&aliases), Syntax { file: "meta.yml" });
    refused!(message(&"[".repeat(100_000)), Syntax { file: "meta.yml" });
}

#[test]
fn archives_that_unpack_without_bound_are_refused() {
    let zeros = vec![b'0'; 1 << 20];
    let archive = zipped(&[("meta.yml", YAML.as_bytes()), ("afm.001", &zeros), ("stylus.txt", &zeros)]);
    assert!(archive.len() < 10_000);
    let options = ScanOptions { max_unpacked_bytes: Some(100_000), ..ScanOptions::default() };
    let stylus = ScanOptions { measurement: Some("stylus".to_owned()), ..options };
    let message = |bytes: &[u8]| read_scans(bytes, "bomb.zip", &stylus).unwrap_err();
    refused!(
        message(&archive),
        Measurement {
            measurement: "stylus",
            source: ArchiveTooLarge { what: "'stylus.txt'", bound: 100000 }
        }
    );
    // The sizes in the directory may lie: here a megabyte is called ten bytes, wherever it is said.
    let size = (1u32 << 20).to_le_bytes();
    let mut lying = archive.clone();
    while let Some(at) = lying.windows(4).position(|window| window == size) {
        lying[at..at + 4].copy_from_slice(&10u32.to_le_bytes());
    }
    refused!(message(&lying), Measurement { measurement: "stylus", source: Zip { what: "'stylus.txt'" } });
}

#[test]
fn paths_that_lead_outside_are_refused() {
    for outside in ["../meta.yml", "a/../../b", "/etc/passwd", "c:\\b", "a\\..\\b"] {
        let archive = zipped(&[("meta.yml", YAML.as_bytes()), (outside, b"1")]);
        refused!(refusal(&archive, &ScanOptions::default()), PathOutside { path: outside });
    }
    // No processed copy stands in for a file that is not where it should be.
    let index = YAML.replace("stylus.txt", "../stylus.txt, squeezed-netcdf: afm.nc");
    let archive = zipped(&[("meta.yml", index.as_bytes())]);
    let options = ScanOptions { measurement: Some("stylus".to_owned()), ..ScanOptions::default() };
    let message = read_scans(&archive, "container.zip", &options).unwrap_err();
    refused!(message, Measurement { measurement: "stylus", source: PathOutside { path: "../stylus.txt" } });
}

#[test]
fn instruments_tell_whether_they_have_a_tip() {
    let of = |kind: &str| {
        let yaml = format!("surfaces:\n- topographies:\n  - name: a\n    instrument: {kind}\n");
        read_metadata(&yaml, "meta.yml").unwrap()[0].probe
    };
    assert_eq!(of("{type: microscope-based}"), Some(Probe::Microscope));
    assert_eq!(of("{type: contact-based}"), Some(Probe::Tip));
    assert_eq!(of("{type: undefined}"), None);
    assert_eq!(of("{name: scope}"), None);
    let map = self_affine_map(6, 4);
    let probe = |bytes: &[u8]| read_one(bytes, &ScanOptions::default()).unwrap().probe;
    assert_eq!(probe(&NanoscopeFile::new(6, 4, &map).to_bytes()), Some(Probe::Tip));
    assert_eq!(probe(&NetCdf::map(2, Kind::F64, 6, &map).to_bytes()), None);
    let x3p = X3p::surface('D', 6, &map);
    assert_eq!(probe(&x3p.to_bytes()), None);
    let optical = x3p.main_xml().replace(
        "<Record3>",
        "<Record2><ProbingSystem><Type>NonContacting</Type></ProbingSystem></Record2><Record3>",
    );
    let files = [("main.xml", optical.as_bytes()), ("bindata/data.bin", &x3p.data())];
    assert_eq!(probe(&zipped(&files)), Some(Probe::Microscope));
}

//! Files packed with gzip, and ZIP files of one scan.

use std::io::Write;

use flate2::Compression;
use flate2::write::GzEncoder;
use scans::{Mend, ScanFormat, ScanOption, ScanOptions, read_scans};

use crate::support::zip_file::zipped;

const PROFILE: &[u8] = b"# Unit: um\n0 1\n1 4\n2 2\n";

fn gzipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// A binary file that no profile in text is taken for: a line of NumPy's in m.
fn array() -> Vec<u8> {
    let header = format!("{:<117}\n", "{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }");
    [b"\x93NUMPY\x01\x00\x76\x00".as_slice(), header.as_bytes(), &[0; 16]].concat()
}

fn heights_m(bytes: &[u8], options: &ScanOptions) -> Vec<Option<f64>> {
    read_scans(bytes, "scan", options).unwrap()[0].scan.heights_m().collect()
}

#[test]
fn what_is_packed_is_read() {
    let none = ScanOptions::default();
    let expected = [Some(1e-6), Some(4e-6), Some(2e-6)];
    assert_eq!(heights_m(&gzipped(PROFILE), &none), expected);
    // Several streams follow each other.
    assert_eq!(heights_m(&[gzipped(&PROFILE[..15]), gzipped(&PROFILE[15..])].concat(), &none), expected);
    assert_eq!(
        heights_m(&zipped(&[("folder/", b""), ("folder/a.txt", PROFILE), (".DS_Store", b"x")]), &none),
        expected
    );
}

#[test]
fn the_format_is_told_by_what_is_packed() {
    assert_eq!(ScanFormat::recognise(&gzipped(&array())), Some(ScanFormat::Numpy));
    assert_eq!(
        ScanFormat::recognise(&zipped(&[("readme.txt", b"a note"), ("a.npy", &array())])),
        Some(ScanFormat::Numpy)
    );
    assert_eq!(ScanFormat::recognise(&gzipped(PROFILE)), None);
    assert_eq!(ScanFormat::recognise(&gzipped(&array())[..20]), None);
}

#[test]
fn one_of_several_scans_is_asked_for() {
    let several = zipped(&[("a.txt", PROFILE), ("b.txt", b"# Unit: um\n0 3\n1 3\n")]);
    let refused = read_scans(&several, "scans.zip", &ScanOptions::default()).unwrap_err();
    refused!(refused, NoChannel { wanted: "single scan in the ZIP file", channels: ["a.txt", "b.txt"] });
    assert_eq!(refused.mend(), Some(Mend::Give(ScanOption::Measurement)));
    let wanted = |name: &str| ScanOptions { measurement: Some(name.to_owned()), ..ScanOptions::default() };
    assert_eq!(heights_m(&several, &wanted("b.txt")), [Some(3e-6); 2]);
    let gone = read_scans(&several, "scans.zip", &wanted("c.txt")).unwrap_err();
    refused!(gone, NoChannel { wanted: "measurement 'c.txt'", channels: ["a.txt", "b.txt"] });
}

#[test]
fn bounds_and_damage_are_told() {
    let bounded = ScanOptions { max_unpacked_bytes: Some(1000), ..ScanOptions::default() };
    let refused = |bytes: &[u8]| read_scans(bytes, "scan", &bounded).unwrap_err();
    let bomb = gzipped(&[b'1'; 1 << 20]);
    refused!(refused(&bomb), ArchiveTooLarge { what: "the gzip file", bound: 1000 });
    refused!(refused(&zipped(&[("a", &[b'1'; 1 << 20])])), ArchiveTooLarge { what: "'a'", bound: 1000 });
    refused!(refused(&gzipped(PROFILE)[..15]), Zip { what: "the gzip file" });
    // One level is unpacked, no more.
    refused!(
        refused(&gzipped(&gzipped(PROFILE))),
        UnknownFormat { start: "'\\x1f\\x8b\\x08\\x00\\x00\\x00\\x00\\x00\\x00\\xffSV\\x08\\xcd\\xcb,'" }
    );
}

//! Files cut off at every length and with every bit flipped: an answer or an error, never a panic.

use crate::support::nanoscope::NanoscopeFile;
use crate::support::netcdf::{Kind, NetCdf};
use crate::support::x3p::X3p;
use crate::support::zip_file::zipped;
use crate::support::{gwyddion_matrix, in_unit, self_affine_line, self_affine_map};
use scans::{ScanOptions, read_scans};

fn corrupt(bytes: &[u8], options: &ScanOptions) {
    assert!(read_scans(bytes, "whole", options).is_ok());
    for end in 0..bytes.len() {
        let _ = read_scans(&bytes[..end], "cut off", options);
    }
    let mut flipped = bytes.to_vec();
    for bit in 0..bytes.len() * 8 {
        flipped[bit / 8] ^= 1 << (bit % 8);
        let _ = read_scans(&flipped, "flipped", options);
        flipped[bit / 8] ^= 1 << (bit % 8);
    }
}

#[test]
fn nanoscope() {
    let map = self_affine_map(3, 2);
    let bytes = NanoscopeFile::new(3, 2, &map).to_bytes();
    corrupt(&bytes, &ScanOptions::default());
    // No prefix of a binary file passes for the whole.
    assert!((0..bytes.len()).all(|end| read_scans(&bytes[..end], "cut", &ScanOptions::default()).is_err()));
}

#[test]
fn netcdf() {
    let map = self_affine_map(3, 2);
    for version in [1, 2, 5] {
        corrupt(&NetCdf::map(version, Kind::F32, 3, &map).to_bytes(), &ScanOptions::default());
    }
    let line = NetCdf::line("n", vec![0.0, 1.0, 3.0], &self_affine_line(3)).to_bytes();
    corrupt(&line, &ScanOptions::default());
}

#[test]
#[cfg(feature = "x3p")]
fn x3p() {
    let map = self_affine_map(3, 2);
    corrupt(&X3p { valid: Some(&[0xff]), ..X3p::surface('D', 3, &map) }.to_bytes(), &ScanOptions::default());
    corrupt(&X3p::surface('I', 3, &map).to_bytes(), &ScanOptions::default());
}

#[test]
#[cfg(feature = "container")]
fn container() {
    let index =
        "surfaces:\n- topographies:\n  - datafile: {original: a.txt}\n    unit: nm\n    height_scale: 2\n";
    let bytes = zipped(&[("meta.yml", index.as_bytes()), ("a.txt", b"0 1\n1 2\n")]);
    corrupt(&bytes, &ScanOptions { max_unpacked_bytes: Some(1 << 20), ..ScanOptions::default() });
}

#[test]
fn text() {
    corrupt(gwyddion_matrix(3, [1.0, 2.0], &self_affine_map(3, 2)).as_bytes(), &ScanOptions::default());
    corrupt(b"0,0;1,5\n0,5;2e1\n1,0;-1\n", &in_unit("nm"));
    corrupt(b"0 0 1\n1 0 2\n0 1 3\n1 1 4\n", &in_unit("nm"));
}

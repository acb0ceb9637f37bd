//! Headers that claim more than any instrument writes are refused before they cost memory or time.

use crate::instruments::refusal;

use crate::support::zip_file::stored;

#[test]
fn channels_without_number_are_refused() {
    let image = |number: u32| format!("/{number}/data\0oGwyDataField\0\0\0\0\0").into_bytes();
    let images: Vec<u8> = (0..2000).flat_map(image).collect();
    let size = u32::try_from(images.len()).unwrap().to_le_bytes();
    refused!(
        refusal(&[b"GWYPGwyContainer\0".as_slice(), &size, &images].concat()),
        BadField { field: "the number of channels", value: "at least 1025" }
    );
    let images = "\\*AFM image list\r\n".repeat(2000);
    let header = format!("\\*File list\r\n\\Version: 0x09200000\r\n{images}\\*File list end\r\n");
    refused!(
        refusal(header.as_bytes()),
        BadField { field: "the number of channels", value: "at least 2000" }
    );
}

#[test]
fn names_that_would_stand_in_every_path_are_refused() {
    let name = [600u32.to_le_bytes().as_slice(), &[b'a'; 600]].concat();
    let file = [b"VCA DATA\x01\x00\x00\x55".as_slice(), &name, &[0x7d, 1, 0]].concat();
    refused!(
        refusal(&file),
        BadField { field: "the length of a name", value: "600", place: scans::FilePlace::Byte(12) }
    );
}

#[test]
fn an_archive_of_more_files_than_any_has_is_refused_before_it_is_opened() {
    let paths: Vec<String> = (0..10_001).map(|index| index.to_string()).collect();
    let files: Vec<(&str, &[u8])> = paths.iter().map(|path| (path.as_str(), b"".as_slice())).collect();
    refused!(refusal(&stored(&files)), ArchiveTooLarge { what: "the archive", bound: 10000 });
}

#[test]
fn a_header_longer_than_that_of_any_array_is_refused() {
    let header = [b"\x93NUMPY\x02\x00".as_slice(), &100_000u32.to_le_bytes(), &[b' '; 100_000]].concat();
    refused!(refusal(&header), BadField { field: "the length of the header", value: "100000" });
}

/// Rows of no columns, more than anyone could walk through.
#[test]
fn a_map_without_columns_ends_at_once() {
    let counts = |counts: &[u64]| counts.iter().flat_map(|count| count.to_be_bytes()).collect::<Vec<_>>();
    let [tag, none] = [|tag: u32| tag.to_be_bytes().to_vec(), |_: u32| vec![0; 12]];
    let file = [
        b"CDF\x05".to_vec(),
        counts(&[0]),
        [tag(10), counts(&[2, 1]), b"x\0\0\0".to_vec(), counts(&[0, 1])].concat(),
        [b"y\0\0\0".to_vec(), counts(&[u64::MAX >> 1])].concat(),
        none(0),
        [tag(11), counts(&[1, 7]), b"heights\0".to_vec(), counts(&[2, 0, 1])].concat(),
        [none(0), tag(6), counts(&[0, 0])].concat(),
    ]
    .concat();
    refused!(
        crate::instruments::heights_if_told(&file).unwrap_err(),
        Scan(TooFew { what: "points", found: 0 })
    );
}

/// Every channel of a file has a copy of its comment.
#[test]
fn long_comments_are_kept_in_part() {
    let comment = b"a comment ".repeat(10_000);
    let length = u32::try_from(comment.len()).unwrap().to_le_bytes();
    let spacings = [1.0f64, 1.0, 0.0, 0.0].map(f64::to_le_bytes).concat();
    let heights = [1.0f32, 2.0, 3.0, 4.0].map(f32::to_le_bytes).concat();
    let grid = [2u32, 2].map(u32::to_le_bytes).concat();
    let file =
        [b"OmniSurf3D".as_slice(), &[0; 8], &length, &comment, &[0; 4], &grid, &spacings, &heights].concat();
    let scan = &crate::instruments::heights(&file)[0];
    assert_eq!(scan.free_text.len(), 1 << 14);
    assert_eq!(scan.scan.height_m(3), Some(4e-6));
}

//! BCR-STM and BCRF: text headers in three encodings before counts or floating-point numbers.

use crate::instruments::refusal;

use crate::instruments::{Sample, assert_holds, channels, heights};

const LINES: [&str; 7] = [
    "xpixels = 3",
    "ypixels = 2",
    "xlength = 1500",
    "ylength = 0.5",
    "yunit = um",
    "bit2nm = 0.5",
    "voidpixels = 1",
];
const COUNTS: [i16; 6] = [2, -4, 6, 8, 32767, -32768];
const NUMBERS: [f32; 6] = [1.0, -2.0, 3.0, 4.0, 3e38, -16384.0];
const HEIGHTS_NM: [Option<f64>; 6] = [Some(1.0), Some(-2.0), Some(3.0), Some(4.0), None, Some(-16384.0)];

fn heights_m(unit_m: f64) -> Vec<Option<f64>> {
    HEIGHTS_NM.iter().map(|height| height.map(|height| height * unit_m)).collect()
}

/// A header of the format and lines, filled up with blanks.
fn header(format: &str, lines: &[&str], characters: usize) -> String {
    let text = format!("fileformat = {format}\r\n% made here = by hand\r\n{}\r\n", lines.join("\r\n"));
    format!("{text:characters$}")
}

fn counts(lines: &[&str]) -> Vec<u8> {
    let mut file = header("bcrstm", lines, 2048).into_bytes();
    COUNTS.iter().for_each(|count| file.extend(count.to_le_bytes()));
    file
}

fn numbers(lines: &[&str]) -> Vec<u8> {
    let mut file = header("bcrf", lines, 2048).into_bytes();
    NUMBERS.iter().for_each(|number| file.extend(number.to_le_bytes()));
    file
}

/// The lines and one more.
fn with(line: &str) -> Vec<&str> {
    let key = line.split(' ').next().unwrap();
    let others = LINES.iter().copied().filter(|own| !own.starts_with(key));
    others.chain([line]).collect()
}

fn unicode(is_big: bool, has_mark: bool) -> Vec<u8> {
    let mark = if has_mark { "\u{feff}" } else { "" };
    let characters = 2048 - mark.len() / 3;
    let text = format!("{mark}{}", header("bcrstm_unicode", &LINES, characters));
    let units =
        text.encode_utf16().flat_map(|unit| if is_big { unit.to_be_bytes() } else { unit.to_le_bytes() });
    let mut file: Vec<u8> = units.collect();
    COUNTS.iter().for_each(|count| file.extend(count.to_le_bytes()));
    file
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "counts", bytes: counts(&LINES) }, Sample { name: "numbers", bytes: numbers(&LINES) }]
}

const SIZE_M: (f64, Option<f64>) = (1.5e-6, Some(0.5e-6));

#[test]
fn counts_and_numbers_are_read() {
    for bytes in [counts(&LINES), numbers(&LINES)] {
        let [scan] = heights(&bytes).try_into().unwrap();
        assert_holds(&scan.scan, SIZE_M, &heights_m(1e-9), 1e-20);
        assert!(scan.notes.is_empty(), "{:?}", scan.notes);
    }
    let [scan] = heights(&numbers(&with("zunit = um"))).try_into().unwrap();
    assert_holds(&scan.scan, SIZE_M, &heights_m(1e-6), 1e-17);
}

#[test]
fn headers_in_utf_16_are_read() {
    for (is_big, has_mark) in [(false, false), (false, true), (true, true)] {
        let [scan] = heights(&unicode(is_big, has_mark)).try_into().unwrap();
        assert_holds(&scan.scan, SIZE_M, &heights_m(1e-9), 1e-20);
    }
}

#[test]
fn long_headers_and_the_other_byte_order_are_read() {
    let mut file =
        header("bcrf", &[&LINES[..], &["headersize = 4096", "intelmode = 0"]].concat(), 4096).into_bytes();
    NUMBERS.iter().for_each(|number| file.extend(number.to_be_bytes()));
    let [scan] = heights(&file).try_into().unwrap();
    assert_holds(&scan.scan, SIZE_M, &heights_m(1e-9), 1e-20);
}

#[test]
fn what_is_left_out_is_assumed_or_asked_for() {
    let [scan] = heights(&counts(&with("voidpixels = 0"))).try_into().unwrap();
    assert!(scan.scan.missing_points().is_empty());
    let [scan] = heights(&counts(&with("bit2nm = "))).try_into().unwrap();
    assert_eq!(scan.notes, ["the file does not say the height of a count; it is taken to be 1"]);
    assert_holds(&scan.scan, SIZE_M, &heights_m(2e-9), 1e-20);
    let no_size = counts(&with("xlength = 0"));
    refused!(refusal(&no_size), NoSize { what: "how large the map is" });
    let current = counts(&with("zunit = nA"));
    assert!(heights(&current).is_empty());
    assert_eq!(channels(&current, true).remove(0).unwrap().measure.to_string(), "nA");
}

#[test]
fn damage_is_told() {
    refused!(
        refusal(&counts(&with("xpixels = many"))),
        BadField { field: "'xpixels' in the header", value: "'many'" }
    );
    refused!(refusal(&counts(&LINES[1..])), MissingField { field: "'xpixels' in the header" });
    refused!(refusal(&counts(&with("ypixels = 4"))), Truncated { needed: 24, available: 12 });
    let mut other = header("bcrx", &LINES, 2048).into_bytes();
    other.extend([0; 12]);
    refused!(refusal(&other), BadField { field: "'fileformat' in the header", value: "'bcrx'" });
}

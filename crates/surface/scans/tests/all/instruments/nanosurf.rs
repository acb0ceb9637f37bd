//! Files of Nanosurf.

use crate::instruments::refusal;
use scans::{Measure, Probe, ScanAxis};

use super::{Sample, assert_holds, channels, heights};

/// A channel of 2 x 2 points in its section.
fn section(name: &str, frame: &str, signal: &str, unit: &str, save: &str) -> String {
    format!(
        "[{name}]\r\nVersion=2\r\nPoints=2\r\nLines=2\r\nFrame={frame}\r\nDim0Name=X*\r\nDim0Unit=\u{b5}m\r\nDim0Range=20\r\n\
         Dim0Min=0\r\nDim1Unit=m\r\nDim1Range=1e-05\r\nDim2Name={signal}\r\nDim2Unit={unit}\r\nDim2Range=65.536\r\n\
         Dim2Min=-32.768\r\n{save}\r\n\r\n"
    )
}

fn file(first: &str, sections: &[String], numbers: &[u8]) -> Vec<u8> {
    let header = format!(
        "[DataSet]\r\nVersion=2\r\n{first}\r\n[DataSet-Info]\r\n-- Scan --=--------\r\nImage size=20\u{b5}m\r\nComment=sharp\r\n\r\n{}\r\n#!",
        sections.concat()
    );
    let mut bytes: Vec<u8> = header.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap()).collect();
    bytes.extend(numbers);
    bytes
}

const SIGNED_16: &str = "SaveMode=Binary\r\nSaveBits=16\r\nSaveSign=Signed\r\nSaveOrder=Intel";
const UNSIGNED_8: &str = "SaveMode=Binary\r\nSaveBits=8\r\nSaveSign=Unsigned\r\nSaveOrder=Intel";
const SIGNED_32: &str = "SaveMode=Binary\r\nSaveBits=32\r\nSaveSign=Signed\r\nSaveOrder=Motorola";

/// A place without a channel, a signal that is not a height, and heights of either direction.
fn scan() -> Vec<u8> {
    let mut numbers: Vec<u8> = [1i16, 2, 3, -4].iter().flat_map(|value| value.to_le_bytes()).collect();
    numbers.extend([0, 64, 128, 255]);
    numbers.extend([1i32 << 16, 0, 0, -1 << 16].iter().flat_map(|value| value.to_be_bytes()));
    let first = "GroupCount=2\r\nGr0-Count=4\r\nGr0-Ch0=DataSet-0:0\r\nGr0-Ch1=DataSet-0:1\r\nGr0-Ch3=DataSet-0:3\r\nGr1-Count=1\r\n\
                 Gr1-Ch0=DataSet-1:0\r\nGr1-Ch1=DataSet-1:1\r\n";
    let sections = [
        section("DataSet-0:1", "Scan forward", "Z-Axis", "nm", SIGNED_16),
        section("DataSet-0:3", "Scan forward", "Deflection", "m", UNSIGNED_8),
        section("DataSet-1:0", "Scan backward", "Z-AxisSensor", "nm", SIGNED_32),
        section("DataSet-1:1", "Scan backward", "Z-Axis", "nm", SIGNED_32),
    ];
    file(first, &sections, &numbers)
}

/// One channel of volts.
fn volts() -> Vec<u8> {
    let first = "GroupCount=1\r\nGr0-Count=1\r\nGr0-Ch0=DataSet-0:0\r\n";
    file(first, &[section("DataSet-0:0", "Scan forward", "Friction", "V", UNSIGNED_8)], &[0; 4])
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "both directions", bytes: scan() }]
}

#[test]
fn both_directions_are_read_from_their_bottom() {
    let all: Vec<_> = channels(&scan(), true).into_iter().map(Result::unwrap).collect();
    let names: Vec<_> = all.iter().map(|file| file.channel.as_deref().unwrap()).collect();
    assert_eq!(names, ["Scan forward (Z-Axis)", "Scan forward (Deflection)", "Scan backward (Z-AxisSensor)"]);
    let size = (20e-6, Some(10e-6));
    assert_holds(&all[0].scan, size, &[3e-12, -4e-12, 1e-12, 2e-12].map(Some), 1e-24);
    assert_holds(&all[1].scan, size, &[0.0, 32.512, -32.768, -16.384].map(Some), 1e-12);
    assert_holds(&all[2].scan, size, &[0.0, -1e-12, 1e-12, 0.0].map(Some), 1e-24);
    assert_eq!((&all[0].measure, &all[1].measure), (&Measure::Height, &Measure::Length));
    assert_eq!((all[0].probe, all[0].fast_axis), (Some(Probe::Tip), Some(ScanAxis::X)));
    assert_eq!(all[0].free_text, "Comment: sharp\n");
    assert_eq!(heights(&scan()).len(), 2);
}

#[test]
fn what_cannot_be_read_is_told() {
    refused!(refusal(&volts()), NoHeightChannel { channels: ["Scan forward (Friction)"] });
    let changed = |from: &str, to: &str| {
        let text: String = scan().iter().map(|byte| char::from(*byte)).collect();
        text.replace(from, to)
            .chars()
            .map(|letter| u8::try_from(u32::from(letter)).unwrap())
            .collect::<Vec<u8>>()
    };
    refused!(
        refusal(&changed("GroupCount=2", "GroupCount=none")),
        BadField { field: "'GroupCount'", value: "'none'" }
    );
    // A channel of unknown size hides those behind it.
    let hidden = changed("SaveBits=16", "SaveBits=24");
    let all = channels(&hidden, true);
    refused!(all[0].as_ref().unwrap_err(), BadField { field: "'SaveBits'", value: "'24'" });
    refused!(all[2].as_ref().unwrap_err(), Unsupported { found: "a channel behind one of unknown size" });
    refused!(refusal(&changed("#!", "??")), MissingField { field: "'#!' before it, which ends the header" });
    let mut cut = scan();
    cut.truncate(cut.len() - 25);
    refused!(refusal(&cut), Truncated { needed: 8, available: 3 });
}

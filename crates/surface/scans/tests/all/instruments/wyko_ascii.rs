//! Wyko's text: blocks above arrays, in nm or in wavelengths.

use crate::instruments::{Sample, assert_holds, channels, heights, refusal};
use scans::{Measure, Probe};

fn text(flags: &str, facts: &str, rows: &str) -> Vec<u8> {
    format!(
        "Wyko ASCII Data File Format {flags}\r\nX Size\t3\r\nY Size\t2\r\n{facts}RAW_DATA\t3\t24\r\n{rows}"
    )
    .into()
}

const FACTS: &str = "Wavelength\t7\t4\t500\r\nMult\t7\t4\t2\r\nPixel_size\t7\t4\t0.001\r\nAspect\t7\t4\t0.5\r\n\
                     Title\t5\t20\tlapped steel\r\n";
const ROWS: &str = "1\t2\r\n3\tBad\r\n5\t6\r\n";

pub fn samples() -> Vec<Sample> {
    let second =
        [&text("0\t0\t1", FACTS, ROWS), &b"Intensity\t6\t6\r\n1\t2\r\n3\t4\r\n5\t6\r\n"[..]].concat();
    vec![
        Sample { name: "text-in-nm", bytes: text("0\t1\t1", FACTS, ROWS) },
        Sample { name: "text-in-waves", bytes: second },
    ]
}

#[test]
fn heights_are_in_nm_or_in_wavelengths() {
    for (sample, unit_m) in samples().iter().zip([1e-9, 250e-9]) {
        let file = &heights(&sample.bytes)[0];
        let expected =
            [1.0, 2.0, 3.0, 0.0, 5.0, 6.0].map(|height| Some(height * unit_m).filter(|m| *m > 0.0));
        assert_holds(&file.scan, (1e-6, Some(3e-6)), &expected, 1e-20);
        assert_eq!((file.channel.as_deref(), file.probe), (Some("RAW_DATA"), Some(Probe::Microscope)));
        assert_eq!(file.free_text, "lapped steel");
    }
    let all = channels(&samples()[1].bytes, true);
    assert_eq!(all[1].as_ref().unwrap().measure, Measure::Other(String::new()));
}

#[test]
fn damaged_texts_are_refused() {
    refused!(refusal(&text("0\t0\t1", "Pixel_size\t7\t4\t0.001\r\n", ROWS)), MissingField {});
    refused!(refusal(&text("0\t1\t1", FACTS, "1\t2\r\n3\t4\r\n")), BadField {});
    refused!(refusal(&text("0\t1\t1", FACTS, "1\t2\r\n3\r\n5\t6\r\n")), BadField {});
    refused!(
        refusal(&text("0\t1\t1", FACTS, "1\t2\r\n3\tx\r\n5\t6\r\n")),
        NotANumber { line: 11, column: 2 }
    );
    refused!(refusal(&text("0\t1\t1", "", ROWS)), NoSize {});
}

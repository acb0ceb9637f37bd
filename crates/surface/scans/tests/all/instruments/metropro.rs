//! MetroPro: phases behind a header of one of three formats and intensities.

use crate::instruments::refusal;
use scans::Probe;

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, heights};

#[derive(Clone)]
struct Phases {
    format: u8,
    header_bytes: usize,
    buckets: u16,
    resolution: u16,
    sign: u16,
    spacing_m: f32,
    obliquity: f32,
    columns: u16,
    phases: Vec<i32>,
}

/// A fringe of 4096 phases is 512 nm times a half times two high.
fn map() -> Phases {
    Phases {
        format: 1,
        header_bytes: 834,
        buckets: 1,
        resolution: 0,
        sign: 0,
        spacing_m: 0.5,
        obliquity: 2.0,
        columns: 3,
        phases: vec![4096, -8192, 2_147_483_640, 0, i32::MAX, 12288],
    }
}

impl Phases {
    fn bytes(&self) -> Vec<u8> {
        let rows = (self.phases.len() / usize::from(self.columns.max(1))) as u16;
        let mut file = Bytes::default();
        file.put([0x88, 0x1b, 0x03, 0x6e + self.format]).put(u16::from(self.format).to_be_bytes());
        file.put((self.header_bytes as u32).to_be_bytes()).pad_to(52);
        let points = u32::from(self.columns) * u32::from(rows);
        let intensities = 2 * points * u32::from(self.buckets);
        file.put(self.columns.to_be_bytes()).put(rows.to_be_bytes()).put(self.buckets.to_be_bytes()).zeros(2);
        file.put(intensities.to_be_bytes()).zeros(4);
        file.put(self.columns.to_be_bytes())
            .put(rows.to_be_bytes())
            .put((4 * points).to_be_bytes())
            .pad_to(80);
        file.text("diamond turned", 82).pad_to(164);
        for number in [0.5, 512e-9, 0.0, self.obliquity, 20.0, self.spacing_m] {
            file.put(number.to_be_bytes());
        }
        file.pad_to(218)
            .put(self.resolution.to_be_bytes())
            .pad_to(232)
            .put(self.sign.to_be_bytes())
            .pad_to(258);
        file.text("mirror", 40).pad_to(self.header_bytes).zeros(intensities as usize);
        self.phases.iter().for_each(|phase| {
            file.put(phase.to_be_bytes());
        });
        file.0
    }
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "format 1", bytes: map().bytes() },
        Sample { name: "format 2", bytes: Phases { format: 2, buckets: 0, ..map() }.bytes() },
        Sample { name: "without a size", bytes: Phases { spacing_m: 0.0, ..map() }.bytes() },
    ]
}

fn heights_m(factor: f64) -> Vec<Option<f64>> {
    let fringes = [Some(1.0), Some(-2.0), None, Some(0.0), None, Some(3.0)];
    fringes.map(|fringes| fringes.map(|fringes| fringes * 512e-9 * factor)).to_vec()
}

#[test]
fn phases_are_heights_in_every_format_and_resolution() {
    let long = Phases { format: 3, header_bytes: 4096, ..map() };
    let resolutions = [(0, 1.0), (1, 0.125), (2, 0.03125)];
    for (resolution, factor) in resolutions {
        for phases in [map(), Phases { format: 2, buckets: 3, ..map() }, long.clone()] {
            let [scan] = heights(&Phases { resolution, ..phases }.bytes()).try_into().unwrap();
            assert_holds(&scan.scan, (1.5, Some(1.0)), &heights_m(factor), 1e-13);
            assert_eq!(
                (scan.probe, scan.free_text.as_str()),
                (Some(Probe::Microscope), "diamond turned\nmirror")
            );
        }
    }
}

#[test]
fn the_sign_turns_heights() {
    let [scan] = heights(&Phases { sign: 1, ..map() }.bytes()).try_into().unwrap();
    assert_holds(&scan.scan, (1.5, Some(1.0)), &heights_m(-1.0), 1e-13);
}

#[test]
fn damage_is_told() {
    let no_size = Phases { spacing_m: 0.0, ..map() }.bytes();
    refused!(refusal(&no_size), NoSize { what: "how large the map is" });
    refused!(
        refusal(&Phases { resolution: 3, ..map() }.bytes()),
        BadField { field: "the resolution of phases", value: "3", place: scans::FilePlace::Byte(218) }
    );
    let none = Phases { columns: 0, phases: vec![], ..map() }.bytes();
    refused!(refusal(&none), MissingField { field: "phase data (0 x 0 points)" });
    refused!(
        refusal(&Phases { obliquity: 0.0, ..map() }.bytes()),
        BadField {
            field: "the scale factor times wavelength times obliquity",
            value: "0.5 x 0.000000512 x 0"
        }
    );
    let cut = map().bytes();
    refused!(refusal(&cut[..cut.len() - 4]), Truncated { needed: 24, available: 20 });
    let mut short = map().bytes();
    short[8] = 0;
    refused!(refusal(&short), BadField { field: "the length of the header", value: "66" });
}

//! The two instruments of the studies.

/// Shape of a scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// One line.
    Line,
    /// A square map.
    Map,
}

units::named!(Shape, "shape", { Line => "line", Map => "map" });

/// Instrument without noise, whose only uncertainty is its height scale. It shows no waves shorter than two of its
/// points, so that nothing is aliased.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instrument {
    /// Name of the instrument.
    pub name: &'static str,
    /// Shape of its scans.
    pub shape: Shape,
    /// Number of points along a side, even.
    pub points: usize,
    /// Length of a side \[m\].
    pub length_m: f64,
    /// Shortest wavelength used \[m\].
    pub shortest_m: f64,
}

/// Stylus: long lines.
pub const STYLUS: Instrument =
    Instrument { name: "stylus", shape: Shape::Line, points: 1024, length_m: 512e-6, shortest_m: 1.2e-6 };

/// Atomic force microscope: small maps. They share with the lines the wavelengths from 5 to 1.2 µm, six tenths of a
/// decade.
pub const AFM: Instrument =
    Instrument { name: "AFM", shape: Shape::Map, points: 128, length_m: 10e-6, shortest_m: 200e-9 };

/// Atomic force microscope of which only single lines are kept, twice as long.
pub const AFM_LINES: Instrument =
    Instrument { name: "AFM", shape: Shape::Line, points: 256, length_m: 20e-6, shortest_m: 200e-9 };

/// Both instruments.
pub const INSTRUMENTS: [Instrument; 2] = [STYLUS, AFM];

/// Standard uncertainty of a height scale, as a share.
pub const GAIN_SD: f64 = 0.03;

impl Instrument {
    /// Distance between points \[m\].
    #[must_use]
    pub fn spacing_m(&self) -> f64 {
        self.length_m / self.points as f64
    }
}

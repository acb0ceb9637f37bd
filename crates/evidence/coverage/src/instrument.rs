//! The two instruments of the studies.

/// What an instrument measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// One line.
    Line,
    /// A square map.
    Map,
}

/// An instrument without noise, whose height scale alone is not known exactly. It shows no waves shorter than two of its points,
/// so that none of them pass for longer ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instrument {
    /// Its name.
    pub name: &'static str,
    /// What it measures.
    pub shape: Shape,
    /// Points along a side, an even number.
    pub points: usize,
    /// Length of a side \[m\].
    pub length_m: f64,
    /// The shortest wavelength \[m\] that is used.
    pub shortest_m: f64,
}

/// Long lines.
pub const STYLUS: Instrument =
    Instrument { name: "stylus", shape: Shape::Line, points: 1024, length_m: 512e-6, shortest_m: 1.2e-6 };

/// Small maps. They share with the lines the wavelengths from 5 to 1.2 µm, six tenths of a decade.
pub const AFM: Instrument =
    Instrument { name: "AFM", shape: Shape::Map, points: 128, length_m: 10e-6, shortest_m: 200e-9 };

/// Both.
pub const INSTRUMENTS: [Instrument; 2] = [STYLUS, AFM];

/// One standard uncertainty of a height scale, as a share.
pub const GAIN_SD: f64 = 0.03;

impl Instrument {
    /// Distance of its points \[m\].
    #[must_use]
    pub fn spacing_m(&self) -> f64 {
        self.length_m / self.points as f64
    }
}

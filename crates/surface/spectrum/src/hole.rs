//! Holes in a spectrum: wavelengths that were not measured.

use serde::Serialize;
use units::display::length;
use units::{Remark, RemarkCode};

use crate::ProfilePsd;

/// Smallest ratio of neighbouring wavelengths that leaves a hole in the spectrum between them.
pub const HOLE_FACTOR: f64 = 2.5;

/// A hole in a spectrum: the wavelengths between two neighbouring samples that lie far apart.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Hole {
    /// Wavelength of the sample at the long end \[m\].
    pub longest_m: f64,
    /// Wavelength of the sample at the short end \[m\].
    pub shortest_m: f64,
}

impl ProfilePsd {
    /// Lists the holes of the spectrum, from long to short wavelengths: neighbours a factor of [`HOLE_FACTOR`] or more
    /// apart.
    #[must_use]
    pub fn holes(&self) -> Vec<Hole> {
        let pairs = self.wavelengths_m().windows(2);
        pairs
            .map(|pair| Hole { longest_m: pair[0], shortest_m: pair[1] })
            .filter(|hole| hole.longest_m >= HOLE_FACTOR * hole.shortest_m)
            .collect()
    }
}

/// The most holes that a remark names; the others are counted.
const MAX_HOLES_NAMED: usize = 3;

impl Hole {
    /// Makes the remark on holes, from long to short wavelengths; `None` without holes.
    #[must_use]
    pub fn remark(code: RemarkCode, holes: &[Hole]) -> Option<Remark> {
        let ends =
            |hole: &Hole| format!("between {} and {}", length(hole.longest_m), length(hole.shortest_m));
        let named: Vec<String> = holes.iter().take(MAX_HOLES_NAMED).map(ends).collect();
        let more = match holes.len() - named.len() {
            0 => String::new(),
            more => format!(", and in {more} more such holes"),
        };
        let holes = named.join(" and ") + &more;
        (!named.is_empty()).then(|| Remark::new(code).with("holes", holes))
    }

    /// Fraction of a band \[m\] that lies in the hole, on a logarithmic scale; 0 to 1.
    #[must_use]
    pub fn share_of(&self, longest_m: f64, shortest_m: f64) -> f64 {
        let within = self.longest_m.min(longest_m) / self.shortest_m.max(shortest_m);
        (within.ln() / (longest_m / shortest_m).ln()).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wavelengths_far_apart_leave_a_hole() {
        let psd = |wavelengths_m: &[f64]| {
            ProfilePsd::new(wavelengths_m.to_vec(), vec![1.0; wavelengths_m.len()]).unwrap()
        };
        assert_eq!(psd(&[8.0, 4.0, 2.0, 1.0]).holes(), []);
        let hole = Hole { longest_m: 5.0, shortest_m: 2.0 };
        assert_eq!(psd(&[8.0, 5.0, 2.0, 1.0]).holes(), [hole]);
    }

    #[test]
    fn a_hole_covers_a_part_of_a_decade() {
        let hole = Hole { longest_m: 100.0, shortest_m: 1.0 };
        assert_eq!(hole.share_of(10.0, 1.0), 1.0);
        assert!((hole.share_of(1000.0, 10.0) - 0.5).abs() < 1e-15);
        assert_eq!(hole.share_of(1e5, 1e4), 0.0);
    }
}

#[cfg(test)]
mod remarks {
    use units::SceneKeys;

    use super::*;

    #[test]
    fn many_holes_are_counted() {
        let hole = |longest_m: f64| Hole { longest_m, shortest_m: longest_m / 4.0 };
        let words = |holes: &[Hole]| Some(Hole::remark(RemarkCode::Holes, holes)?.words(&SceneKeys));
        assert_eq!(
            words(&[hole(1e-6)]).unwrap(),
            "nothing was measured between 1 µm and 250 nm: the spectrum there is a straight line in logarithms from end to end"
        );
        assert!(words(&[hole(1e-3); 5]).unwrap().contains(", and in 2 more such holes: "));
        assert_eq!(words(&[]), None);
    }
}

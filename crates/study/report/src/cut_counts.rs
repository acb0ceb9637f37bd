//! What there is to count of a curve of Persson's theory.

use persson::Cut;
use units::display::{counted, length, three_digits};

/// From this rms gradient on the pressure that flattens the roughness, s = E* h'/2, exceeds E*/10.
const STEEP: f64 = 0.2;

/// Cutoffs at which small slopes are assumed of a surface that has none, and those at which all that touches flows.
#[derive(Debug, Default)]
pub(crate) struct CutCounts {
    all: usize,
    steep: usize,
    longest_steep_m: f64,
    steepest: f64,
    /// Blocks in which the nominal pressure itself is not below the hardness.
    flowing: usize,
}

impl CutCounts {
    pub fn add(&mut self, blocks: &[Vec<Cut>]) {
        for block in blocks {
            self.flowing += usize::from(block.first().is_some_and(|cut| cut.areas.plastic == 1.0));
            self.all += block.len();
            for cut in block.iter().filter(|cut| cut.rms_gradient > STEEP) {
                self.steep += 1;
                self.longest_steep_m = self.longest_steep_m.max(cut.wavelength_m);
                self.steepest = self.steepest.max(cut.rms_gradient);
            }
        }
    }

    pub fn notes(&self) -> impl Iterator<Item = String> {
        let CutCounts { all, steep, longest_steep_m, steepest, flowing } = self;
        let of_slopes = (*steep > 0).then(|| {
            format!(
                "{steep} of {}, from {} down: the rms gradient h' exceeds {STEEP} (up to {}) and with it s = E* h'/2 exceeds \
                 E*/10; the theory assumes small slopes",
                counted(*all, "cutoff"),
                length(*longest_steep_m),
                three_digits(*steepest)
            )
        });
        let of_flow = (*flowing > 0).then(|| {
            format!(
                "{}: the nominal pressure is not below the hardness; everything touches and flows, at every cutoff",
                counted(*flowing, "load")
            )
        });
        of_flow.into_iter().chain(of_slopes)
    }
}

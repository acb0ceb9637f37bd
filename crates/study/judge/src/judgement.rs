//! The judgement of a scene: every curve on every window, every curve on the whole band, and what stands.

use serde::Serialize;

use crate::headline::Headline;
use crate::layout::Extent;
use crate::phases::OfMap;
use crate::verdicts::{OfCurve, OnWindow};
use crate::yielding::Yielding;

/// What the judge found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Judgement {
    /// What was pressed; `None` where nothing could be.
    pub extent: Option<Extent>,
    /// Every curve under every load on every window.
    pub windows: Vec<OnWindow>,
    /// Every curve under every load on the whole band.
    pub curves: Vec<OfCurve>,
    /// For every load, what may be said first.
    pub headlines: Vec<Headline>,
    /// Measured maps beside Gaussian surfaces of their waves: what the spectrum leaves out.
    pub maps: Vec<OfMap>,
    /// For every load, where an elastic contact would be pressed beyond the hardness.
    pub yielding: Vec<Yielding>,
    /// The wavelength \[m\] down to which slopes are small enough for a half-space: there the rms pressure of full contact
    /// reaches a tenth of E*; `None` where it never does.
    pub steep_from_m: Option<f64>,
    /// Root mean square of the surface's gradient over the whole band.
    pub rms_gradient: f64,
}

impl Judgement {
    /// What may be said first of a load; `None` where no curve has an area under it.
    #[must_use]
    pub fn headline(&self, load: usize) -> Option<&Headline> {
        self.headlines.iter().find(|headline| headline.load == load)
    }
}

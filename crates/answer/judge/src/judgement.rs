//! The judgement of a scene: every curve on every window and on the whole band, and a headline for every load.

use serde::Serialize;

use crate::headline::Headline;
use crate::layout::Extent;
use crate::maps::MapVerdict;
use crate::pressed_surface::PressedSurface;
use crate::verdicts::{CurveVerdict, ReferenceArea, WindowOutcome};
use crate::yielding::Yielding;

/// The verdicts of the judge on a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Judgement {
    /// The surfaces and pressures that were solved; `None` if there are none.
    pub extent: Option<Extent>,
    /// Every curve under every load on every window.
    pub windows: Vec<WindowOutcome>,
    /// Every curve under every load on the whole band.
    pub curves: Vec<CurveVerdict>,
    /// The areas of the elements themselves, on the whole band.
    pub references: Vec<ReferenceArea>,
    /// The headline of every load.
    pub headlines: Vec<Headline>,
    /// Measured maps beside Gaussian surfaces of their waves.
    pub maps: Vec<MapVerdict>,
    /// For every load, the scales at which an elastic contact would exceed the hardness.
    pub yielding: Vec<Yielding>,
    /// The wavelength \[m\] below which slopes are too steep for a half-space: the rms pressure of full contact exceeds E*/10.
    /// `None` if it never does.
    pub steep_from_m: Option<f64>,
    /// Root mean square of the surface's gradient over the whole band.
    pub rms_gradient: f64,
    /// The relative standard error of areas of Gaussian surfaces from waves beyond the end of the spectrum, which its last values hold
    /// too.
    pub error_of_spectrum_end: f64,
    /// The pressed surface to look at; no part of tables.
    #[serde(skip)]
    pub surface: Option<PressedSurface>,
}

impl Judgement {
    /// The headline of a load; `None` if no curve has an area under it.
    #[must_use]
    pub fn headline(&self, load: usize) -> Option<&Headline> {
        self.headlines.iter().find(|headline| headline.load == load)
    }
}

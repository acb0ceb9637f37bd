//! Verdicts on curves: under a load on a window, and under a load on the whole band.

use serde::Serialize;
use units::Remark;

use crate::assumptions::CurveAtLoad;
use crate::body::Reference;
use crate::seam::Seam;
use crate::verdict::{ERRORS_GIVEN, Verdict, WorstWindow};

/// A curve under a load on a window, held against boundary elements.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WindowOutcome {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The longest wave of the window \[m\].
    pub longest_m: f64,
    /// The shortest wave of the window \[m\].
    pub shortest_m: f64,
    /// True for the whole band, whose area is that of the last window carried over by the closed form; false for a window.
    pub is_whole_band: bool,
    /// The mean pressure on the window \[Pa\]: the real pressure with the longer waves alone.
    pub pressure_pa: f64,
    /// The mean pressure on the window over twice the rms pressure of full contact: on half-spaces over E* times its rms gradient.
    pub pressure_over_gradient: f64,
    /// The curve's area, as a fraction of the window.
    pub area_fraction: Option<f64>,
    /// The area of boundary elements.
    pub elements: Option<ElementArea>,
    /// Their area for the whole surface, down to the end of the window.
    pub elements_of_whole: Option<ElementArea>,
    /// The verdict on the curve.
    pub verdict: Verdict,
    /// The reason for the verdict.
    pub reason: Remark,
}

/// The area of boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ElementArea {
    /// The area fraction.
    pub area_fraction: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// The area that cannot be less: the nominal pressure over that at which elements flow; 0 of elastic elements.
    #[serde(skip)]
    pub(crate) least: f64,
}

/// A range of areas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AreaRange {
    /// The least area fraction.
    pub low: f64,
    /// The largest area fraction.
    pub high: f64,
}

impl ElementArea {
    /// Takes an area fraction and its standard error.
    pub(crate) fn new(area_fraction: f64, standard_error: f64) -> Self {
        ElementArea { area_fraction, standard_error, least: 0.0 }
    }

    /// Bounds the area from below.
    pub(crate) fn at_least(self, least: f64) -> Self {
        ElementArea { area_fraction: self.area_fraction.max(least), least, ..self }
    }

    /// Adds an independent relative standard error.
    pub(crate) fn with_error(self, relative_error: f64) -> Self {
        let standard_error = self.standard_error.hypot(relative_error * self.area_fraction);
        ElementArea { standard_error, ..self }
    }

    /// The area less two standard errors; at least a tenth of the area, since an area is positive, and at least what a contact
    /// that flows has.
    #[must_use]
    pub fn low(self) -> f64 {
        (self.area_fraction - ERRORS_GIVEN * self.standard_error)
            .max(0.1 * self.area_fraction)
            .max(self.least)
    }

    /// The area with two standard errors, at most 1.
    #[must_use]
    pub fn high(self) -> f64 {
        (self.area_fraction + ERRORS_GIVEN * self.standard_error).min(1.0)
    }

    /// The range from [`low`](Self::low) to [`high`](Self::high).
    #[must_use]
    pub fn range(self) -> AreaRange {
        AreaRange { low: self.low(), high: self.high() }
    }

    /// The area of the surface, from that on a window.
    pub(crate) fn carried_over(self, seam: Seam) -> Self {
        let area_fraction = (seam.factor * self.area_fraction).min(1.0);
        let relative_error = self.relative_error().hypot(seam.relative_error);
        ElementArea::new(area_fraction, relative_error * area_fraction)
    }

    /// The standard error over the area.
    #[must_use]
    pub fn relative_error(self) -> f64 {
        self.standard_error / self.area_fraction
    }
}

impl WindowOutcome {
    /// The curve's area over that of the elements.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        Some(self.area_fraction? / self.elements?.area_fraction)
    }

    /// True for the outcomes of this curve under this load.
    pub(crate) fn is_of(&self, at: CurveAtLoad) -> bool {
        (self.curve, self.load) == (at.curve, at.load)
    }

    /// The ratio and its relative error, if it counts for the verdict on the curve.
    pub(crate) fn ratio_and_error(&self) -> Option<(f64, f64)> {
        self.verdict.compares().then_some(())?;
        Some((self.ratio()?, self.elements?.relative_error()))
    }
}

/// A curve under a load, on the whole band.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveVerdict {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The area fraction at the shortest wavelength, if the curve has one.
    pub area_fraction: Option<f64>,
    /// The bodies of the elements that the curve is compared with.
    pub reference: Reference,
    /// The area of these elements with the whole band, if it is known; that of bodies whose hardness grows has a range alone.
    pub elements: Option<ElementArea>,
    /// The range of that area.
    pub range: Option<AreaRange>,
    /// The verdict on the area at the shortest wavelength.
    pub verdict: Verdict,
    /// The reason for the verdict.
    pub reason: Remark,
    /// The window on which the curve is farthest from the elements; `None` if no window was compared.
    pub worst_window: Option<WorstWindow>,
    /// The number of windows on which the curve agrees.
    pub agreeing: usize,
    /// The number of windows on which it was compared.
    pub windows: usize,
}

impl CurveVerdict {
    /// The curve's area over that of the elements, both with the whole band.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        Some(self.area_fraction? / self.elements?.area_fraction)
    }

    /// True if the curve agrees with the elements on the whole band and on more than half of the windows.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.verdict == Verdict::Agrees && 2 * self.agreeing > self.windows
    }
}

/// The measured maps that stand for the surface. Their gap and stiffness are known where they bear the whole load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PressedMaps {
    /// The mean gap \[m\].
    pub mean_gap_m: Option<f64>,
    /// The stiffness \[Pa/m\], in a scene that asks for the interface.
    pub stiffness_pa_per_m: Option<f64>,
    /// The share of the contact that has flowed, of bodies that yield.
    pub plastic_share: Option<f64>,
}

/// The area of boundary elements with the whole band under a load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ReferenceArea {
    /// The load, by index.
    pub load: usize,
    /// The bodies that were pressed.
    pub reference: Reference,
    /// The area, if it was found; that of bodies whose hardness grows has a range alone.
    pub elements: Option<ElementArea>,
    /// Its range, if it was found.
    pub range: Option<AreaRange>,
    /// The measured maps that were pressed; `None` for Gaussian surfaces of the spectrum.
    pub maps: Option<PressedMaps>,
    /// The area of Gaussian surfaces of the spectrum, where maps were pressed in their place.
    pub of_spectrum: Option<ElementArea>,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: f64, expected: f64) -> bool {
        (found / expected - 1.0).abs() < 1e-12
    }

    #[test]
    fn an_area_lies_within_two_standard_errors_of_itself_and_between_what_flows_and_all() {
        // An area of 0.4 with an error of 5 %, and what becomes of it: area, error, low, high.
        let area = ElementArea::new(0.4, 0.02);
        let seam = |factor, relative_error| Seam { factor, relative_error };
        let cases = [
            (area, [0.4, 0.02, 0.36, 0.44]),
            (area.with_error(0.12), [0.4, 0.4 * 0.13, 0.4 * 0.74, 0.4 * 1.26]),
            (area.with_error(0.9), [0.4, 0.4 * (0.05f64.powi(2) + 0.81).sqrt(), 0.04, 1.0]),
            (area.at_least(0.39), [0.4, 0.02, 0.39, 0.44]),
            (area.at_least(0.5), [0.5, 0.02, 0.5, 0.54]),
            (area.carried_over(seam(0.5, 0.12)), [0.2, 0.2 * 0.13, 0.2 * 0.74, 0.2 * 1.26]),
            (area.carried_over(seam(3.0, 0.0)), [1.0, 0.05, 0.9, 1.0]),
            (area.carried_over(Seam::NONE), [0.4, 0.02, 0.36, 0.44]),
        ];
        for (area, expected) in cases {
            let AreaRange { low, high } = area.range();
            let found = [area.area_fraction, area.standard_error, low, high];
            assert!(found.iter().zip(expected).all(|(found, expected)| near(*found, expected)), "{area:?}");
            assert!(near(area.relative_error(), expected[1] / expected[0]));
        }
    }
}

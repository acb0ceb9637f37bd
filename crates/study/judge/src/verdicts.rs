//! What is said of a curve: under a load on a window, and under a load on the whole band.

use serde::Serialize;

use crate::assumptions::Broken;
use crate::reason::Reason;
use crate::verdict::Verdict;

/// A curve under a load on a window.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OnWindow {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The longest wave of the window \[m\].
    pub longest_m: f64,
    /// The shortest wave of the window \[m\].
    pub shortest_m: f64,
    /// Whether this is no window but the whole band, of which the last window was pressed on what Persson's theory says the
    /// longer waves leave.
    pub is_whole_band: bool,
    /// The mean pressure on the window \[Pa\]: the real pressure that the longer waves leave.
    pub pressure_pa: f64,
    /// The same over E* times the rms gradient of the window.
    pub pressure_over_gradient: f64,
    /// The curve's area over that of the window.
    pub area_fraction: Option<f64>,
    /// That of boundary elements.
    pub judged: Option<Judged>,
    /// What is said of the curve there.
    pub verdict: Verdict,
    /// Why.
    pub reason: Reason,
}

/// An area by boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Judged {
    /// The area fraction.
    pub area_fraction: f64,
    /// Its standard error.
    pub standard_error: f64,
}

impl Judged {
    /// The standard error over the area.
    #[must_use]
    pub fn relative_error(self) -> f64 {
        self.standard_error / self.area_fraction
    }
}

impl OnWindow {
    /// The curve's area over that of the elements.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        Some(self.area_fraction? / self.judged?.area_fraction)
    }

    /// The ratio where it counts for the curve's verdict, with its relative error.
    pub(crate) fn counted(&self) -> Option<(f64, f64)> {
        self.verdict.compares().then_some(())?;
        Some((self.ratio()?, self.judged?.relative_error()))
    }
}

/// A curve under a load, on the whole band.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OfCurve {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// Its area fraction at the shortest wavelength; none where it has none.
    pub area_fraction: Option<f64>,
    /// The area of boundary elements and its standard error, where the whole band was solved.
    pub judged: Option<Judged>,
    /// The ratio to boundary elements on the worst window.
    pub ratio: Option<f64>,
    /// What is said of it.
    pub verdict: Verdict,
    /// Why.
    pub reason: Reason,
    /// The assumption of its own that breaks first.
    pub broken: Option<Broken>,
}

impl OnWindow {
    /// What the whole surface down to the end of the window would have in contact, with its error: the elements' area of the
    /// window, times what Persson's theory leaves to it of a nominal pressure \[Pa\] by the longer waves.
    #[must_use]
    pub fn judged_of_whole(&self, nominal_pressure_pa: f64) -> Option<Judged> {
        let left = nominal_pressure_pa / self.pressure_pa;
        let Judged { area_fraction, standard_error } = self.judged?;
        Some(Judged { area_fraction: left * area_fraction, standard_error: left * standard_error })
    }
}

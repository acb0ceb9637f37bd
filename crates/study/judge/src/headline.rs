//! The headline of a load: one number with a bracket, or the range of the models.

use serde::Serialize;

use crate::verdict::{ERRORS_GIVEN, Verdict};
use crate::verdicts::{CurveVerdict, ElementArea, WindowOutcome};

/// The area of a load, to be said first.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Headline {
    /// The load, by index.
    pub load: usize,
    /// The source of the number.
    pub basis: Basis,
    /// The least area fraction that the judge cannot exclude.
    pub low: f64,
    /// The largest area fraction that the judge cannot exclude.
    pub high: f64,
}

/// The source of a headline.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// A curve whose assumptions hold and which agrees with the elements in most windows.
    Curve {
        /// The curve, by index.
        curve: usize,
        /// Its area fraction.
        area_fraction: f64,
        /// The number of windows on which it agrees.
        agreeing: usize,
        /// The number of windows on which it was compared.
        windows: usize,
        /// True if the elements were pressed with the whole band.
        whole_band: bool,
    },
    /// No curve is valid: the range of the models.
    RangeOfModels {
        /// The curve of the least area.
        least: usize,
        /// The curve of the largest.
        most: usize,
        /// The area of boundary elements on the whole band, if they were pressed for a curve whose assumptions hold.
        elements: Option<ElementArea>,
    },
}

impl Headline {
    /// The headline of a load; `None` if no curve has an area under it.
    pub(crate) fn new(load: usize, windows: &[WindowOutcome], curves: &[CurveVerdict]) -> Option<Self> {
        let of_load = || curves.iter().filter(move |curve| curve.load == load);
        let is_valid = |curve: &&CurveVerdict| {
            let whole = widest(windows, curve);
            curve.broken.is_none() && whole.is_some_and(|on| on.verdict == Verdict::Agrees)
        };
        let candidates = of_load().filter(is_valid);
        let with_agreement = candidates.map(|curve| {
            let own = || windows.iter().filter(|on| on.is_of(curve.curve, load));
            (curve, own().filter(|on| on.verdict == Verdict::Agrees).count())
        });
        // Of several that agree as often the first is kept.
        let best = with_agreement.reduce(|best, other| if other.1 > best.1 { other } else { best });
        match best {
            Some((curve, agreeing)) => Self::from_curve(curve, agreeing, windows),
            None => {
                let sound = of_load().filter(|curve| curve.broken.is_none());
                let elements = sound.filter_map(|curve| widest(windows, curve)?.elements).next();
                Self::from_range(load, of_load(), elements)
            }
        }
    }

    fn from_curve(curve: &CurveVerdict, agreeing: usize, windows: &[WindowOutcome]) -> Option<Self> {
        let area_fraction = curve.area_fraction?;
        let own = windows.iter().filter(|on| on.is_of(curve.curve, curve.load));
        let judged_windows = own.filter_map(WindowOutcome::ratio_and_error).count();
        let elements = widest(windows, curve)?.elements?;
        let given = ERRORS_GIVEN * elements.standard_error;
        // The bracket holds the curve's own area.
        let low = area_fraction.min(elements.area_fraction - given);
        let high = area_fraction.max(elements.area_fraction + given);
        let basis = Basis::Curve {
            curve: curve.curve,
            area_fraction,
            agreeing,
            windows: judged_windows,
            whole_band: curve.elements.is_some(),
        };
        Some(Headline { load: curve.load, basis, low, high: high.min(1.0) })
    }

    fn from_range<'c>(
        load: usize,
        curves: impl Iterator<Item = &'c CurveVerdict>,
        elements: Option<ElementArea>,
    ) -> Option<Self> {
        let areas: Vec<(usize, f64)> =
            curves.filter_map(|curve| Some((curve.curve, curve.area_fraction?))).collect();
        let least = areas.iter().copied().reduce(|a, b| if b.1 < a.1 { b } else { a })?;
        let most = areas.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        let basis = Basis::RangeOfModels { least: least.0, most: most.0, elements };
        Some(Headline { load, basis, low: least.1, high: most.1 })
    }
}

/// The outcome of a curve on its widest band: the whole band, which follows the windows.
fn widest<'w>(windows: &'w [WindowOutcome], curve: &CurveVerdict) -> Option<&'w WindowOutcome> {
    windows.iter().rev().find(|on| on.is_of(curve.curve, curve.load))
}

//! What may be said first of a load: one number with a bracket, or the range of the models.

use serde::Serialize;

use crate::verdict::{ERRORS_GIVEN, Verdict};
use crate::verdicts::{Judged, OfCurve, OnWindow};

/// The number of a load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Headline {
    /// The load, by index.
    pub load: usize,
    /// What it rests on.
    pub rests_on: RestsOn,
    /// The least area fraction that the judge leaves open.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

/// What a number rests on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RestsOn {
    /// A curve whose assumptions hold and which agrees with the elements in most windows.
    Curve {
        /// The curve, by index.
        curve: usize,
        /// Its area fraction.
        area_fraction: f64,
        /// On how many windows it agrees.
        agreeing: usize,
        /// Of how many.
        windows: usize,
        /// Whether the elements were pressed with the whole band.
        whole_band: bool,
    },
    /// No curve is left: the range of the models.
    RangeOfModels {
        /// The curve of the least area.
        least: usize,
        /// The curve of the largest.
        most: usize,
        /// What boundary elements say of the whole band, where they were pressed for a curve whose assumptions hold.
        elements: Option<Judged>,
    },
}

impl Headline {
    /// That of a load; `None` where no curve has an area under it.
    pub(crate) fn of(load: usize, windows: &[OnWindow], curves: &[OfCurve]) -> Option<Self> {
        let of_load = || curves.iter().filter(move |curve| curve.load == load);
        let stands = |curve: &&OfCurve| {
            let whole = widest(windows, curve);
            curve.broken.is_none() && whole.is_some_and(|on| on.verdict == Verdict::Agrees)
        };
        let candidates = of_load().filter(stands);
        let standing = candidates.map(|curve| {
            let own = || windows.iter().filter(|on| (on.curve, on.load) == (curve.curve, load));
            (curve, own().filter(|on| on.verdict == Verdict::Agrees).count())
        });
        // Of several that agree as often the first stays.
        let best = standing.reduce(|best, other| if other.1 > best.1 { other } else { best });
        match best {
            Some((curve, agreeing)) => Self::of_curve(curve, agreeing, windows),
            None => {
                let sound = of_load().filter(|curve| curve.broken.is_none());
                let elements = sound.filter_map(|curve| widest(windows, curve)?.judged).next();
                Self::of_range(load, of_load(), elements)
            }
        }
    }

    fn of_curve(curve: &OfCurve, agreeing: usize, windows: &[OnWindow]) -> Option<Self> {
        let area_fraction = curve.area_fraction?;
        let own = windows.iter().filter(|on| (on.curve, on.load) == (curve.curve, curve.load));
        let judged_windows = own.filter_map(OnWindow::counted).count();
        let judged = widest(windows, curve)?.judged?;
        let given = ERRORS_GIVEN * judged.standard_error;
        // The curve's own area belongs to what is left open.
        let low = area_fraction.min(judged.area_fraction - given);
        let high = area_fraction.max(judged.area_fraction + given);
        let rests_on = RestsOn::Curve {
            curve: curve.curve,
            area_fraction,
            agreeing,
            windows: judged_windows,
            whole_band: curve.judged.is_some(),
        };
        Some(Headline { load: curve.load, rests_on, low, high: high.min(1.0) })
    }

    fn of_range<'c>(
        load: usize,
        curves: impl Iterator<Item = &'c OfCurve>,
        elements: Option<Judged>,
    ) -> Option<Self> {
        let areas: Vec<(usize, f64)> =
            curves.filter_map(|curve| Some((curve.curve, curve.area_fraction?))).collect();
        let least = areas.iter().copied().reduce(|a, b| if b.1 < a.1 { b } else { a })?;
        let most = areas.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        let rests_on = RestsOn::RangeOfModels { least: least.0, most: most.0, elements };
        Some(Headline { load, rests_on, low: least.1, high: most.1 })
    }
}

/// What is known of a curve on the widest band: the whole one, which stands behind the windows.
fn widest<'w>(windows: &'w [OnWindow], curve: &OfCurve) -> Option<&'w OnWindow> {
    windows.iter().rev().find(|on| (on.curve, on.load) == (curve.curve, curve.load))
}

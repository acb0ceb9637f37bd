//! Curves against boundary elements: on each window, on the whole band, and the verdict on each curve.

use study::plan::PlanError;

use crate::JudgeError;
use crate::assumptions::CurveAtLoad;
use crate::case::Case;
use crate::headline::Headline;
use crate::judgement::Judgement;
use crate::layout::{Cell, Extent, Layout, PlannedPress};
use crate::model_areas;
use crate::reason::Reason;
use crate::solve::{Solutions, Solved};
use crate::verdict::{ERRORS_GIVEN, Verdict};
use crate::verdicts::{CurveVerdict, ElementArea, WindowOutcome};
use crate::window::{Band, Window};

/// One standard error, as a share of the area, of an area of the whole band: it joins Persson's theory for the longer waves
/// to elements under a uniform pressure on the last window.
const SEAM_ERROR: f64 = 0.1;

/// A solved layout, to hold the curves of a case against.
pub(crate) struct Comparisons<'c> {
    pub case: &'c Case<'c>,
    pub layout: &'c Layout,
    pub solutions: &'c Solutions,
}

impl Comparisons<'_> {
    /// Compares every curve under every load on every window.
    pub fn on_windows(&self) -> Result<Vec<WindowOutcome>, JudgeError> {
        let Comparisons { case, layout, .. } = self;
        let mut outcomes = Vec::new();
        for (index, window) in layout.windows.iter().enumerate() {
            let pressures = Pressures::on(case, window);
            let areas = areas(case, window, &pressures)?;
            for at in case.all() {
                let bound = case.bound(at.curve);
                let planned = layout.planned(Cell { bound, window: index, load: at.load });
                let comparison = Comparison {
                    at,
                    band: window.band,
                    pressure_pa: pressures.pa[bound][at.load],
                    gradient_pa: case.composite_modulus_pa * window.rms_gradient,
                    area_fraction: areas[at.curve][at.load],
                    elements: element_area(planned, self.solutions),
                };
                outcomes.push(comparison.outcome(case));
            }
        }
        Ok(outcomes)
    }

    /// Compares every curve on the whole band with the elements' area on the last window, times the share of the area that
    /// the longer waves leave by Persson's theory. Empty if the elements were pressed with the whole band.
    pub fn on_whole_band(&self, windows: &[WindowOutcome]) -> Vec<WindowOutcome> {
        if self.layout.is_whole_band() {
            return Vec::new();
        }
        let case = self.case;
        let band = case.band();
        let gradient_pa = 2.0 * case.rms_pressure_pa(band.shortest_m);
        let outcome = |at: CurveAtLoad| {
            let last = windows.iter().rev().find(|on| on.is_of(at.curve, at.load))?;
            let pressure_pa = case.nominal_pressure_pa(at.load);
            let elements = last.elements_of_whole(pressure_pa).map(|elements| ElementArea {
                standard_error: elements.standard_error.hypot(SEAM_ERROR * elements.area_fraction),
                ..elements
            });
            let comparison = Comparison {
                at,
                band,
                pressure_pa,
                gradient_pa,
                area_fraction: case.final_area(at),
                elements: elements.ok_or(last.reason),
            };
            Some(WindowOutcome { is_whole_band: true, ..comparison.outcome(case) })
        };
        case.all().filter_map(outcome).collect()
    }

    /// Combines the outcomes of every curve under every load into its verdict.
    pub fn verdicts(&self, windows: &[WindowOutcome]) -> Vec<CurveVerdict> {
        let verdict = |at| curve_verdict(self.case, at, windows, self.layout.is_whole_band());
        self.case.all().map(verdict).collect()
    }
}

/// The mean pressures \[Pa\] on a window, for every bound and load.
struct Pressures {
    pa: Vec<Vec<f64>>,
}

impl Pressures {
    fn on(case: &Case<'_>, window: &Window) -> Self {
        let longest_m = window.band.longest_m;
        let of_bound =
            |bound| (0..case.loads()).map(|load| case.pressure_pa(bound, load, longest_m)).collect();
        Pressures { pa: (0..case.bounds_pa.len()).map(of_bound).collect() }
    }
}

/// The area fractions of all curves on a window, curve by curve and load by load.
fn areas(
    case: &Case<'_>,
    window: &Window,
    pressures: &Pressures,
) -> Result<Vec<Vec<Option<f64>>>, JudgeError> {
    let model_areas = |curves: &[usize], pressures_pa: &[f64]| {
        model_areas::area_fractions(case.scene, &case.results.psd, window, curves, pressures_pa)
    };
    let mut areas = vec![vec![None; case.loads()]; case.curves()];
    for (bound, pressures_pa) in pressures.pa.iter().enumerate() {
        let (growing, steady): (Vec<usize>, Vec<usize>) = (0..case.curves())
            .filter(|curve| case.bound(*curve) == bound)
            .partition(|curve| case.strength_grows(*curve));
        for (curve, found) in steady.iter().zip(model_areas(&steady, pressures_pa)?) {
            areas[*curve] = found;
        }
        for curve in growing {
            for (load, pressure_pa) in pressures_pa.iter().enumerate() {
                if case.yields_while_growing(CurveAtLoad { curve, load }).is_none() {
                    areas[curve][load] = match model_areas(&[curve], &[*pressure_pa]) {
                        Ok(areas) => areas[0][0],
                        // The window begins with more than the strength bears.
                        Err(JudgeError::Plan(PlanError::Hardness(_))) => None,
                        Err(error) => return Err(error),
                    };
                }
            }
        }
    }
    Ok(areas)
}

/// The area that elements give for a cell of the layout, or the reason why there is none.
fn element_area(planned: PlannedPress, solutions: &Solutions) -> Result<ElementArea, Reason> {
    let solved = match planned {
        PlannedPress::Solve(press) => solutions.of_presses[press]?,
        PlannedPress::Flows { share } => Solved::between(share),
        PlannedPress::TooLight => return Err(Reason::TooLight),
        PlannedPress::LoadNotChosen => return Err(Reason::LoadNotChosen),
    };
    Ok(ElementArea { area_fraction: solved.area_fraction, standard_error: solved.standard_error })
}

/// A curve under a load on a band, with the inputs of its verdict.
struct Comparison {
    at: CurveAtLoad,
    band: Band,
    /// Mean pressure on the band.
    pressure_pa: f64,
    /// E* times the rms gradient of the band.
    gradient_pa: f64,
    /// Area fraction of the curve.
    area_fraction: Option<f64>,
    /// Area fraction of the elements, or the reason why there is none.
    elements: Result<ElementArea, Reason>,
}

impl Comparison {
    fn outcome(&self, case: &Case<'_>) -> WindowOutcome {
        let Comparison { at: CurveAtLoad { curve, load }, band, pressure_pa, area_fraction, .. } = *self;
        let (elements, reason) = self.elements_and_reason(case);
        // An assumption that breaks at some scale is broken at all shorter ones.
        let broken = case
            .broken_assumption(self.at)
            .filter(|broken| broken.wavelength_m() >= band.shortest_m * (1.0 - 1e-9));
        let (verdict, reason) = match (broken, area_fraction.zip(elements)) {
            (Some(broken), _) => (Verdict::OutOfRange, Reason::Broken(broken)),
            (None, Some((area_fraction, elements))) => self.compared(area_fraction, elements),
            (None, None) => (Verdict::NotJudged, reason),
        };
        WindowOutcome {
            curve,
            load,
            longest_m: band.longest_m,
            shortest_m: band.shortest_m,
            is_whole_band: false,
            pressure_pa,
            pressure_over_gradient: pressure_pa / self.gradient_pa,
            area_fraction,
            elements,
            verdict,
            reason,
        }
    }

    /// The area of the elements, and the reason for no verdict if it is missing or the curve has no area.
    fn elements_and_reason(&self, case: &Case<'_>) -> (Option<ElementArea>, Reason) {
        let grows = case.strength_grows(self.at.curve);
        match (self.elements, grows.then(|| case.yields_while_growing(self.at)).flatten()) {
            (_, Some(above)) => (None, Reason::StrengthGrows { wavelength_m: above.wavelength_m }),
            (Ok(elements), None) => (Some(elements), Reason::NoArea),
            (Err(reason), None) => (None, reason),
        }
    }

    fn compared(&self, area_fraction: f64, elements: ElementArea) -> (Verdict, Reason) {
        let ratio = area_fraction / elements.area_fraction;
        let verdict = Verdict::from_ratio(ratio, elements.relative_error());
        let reason = Reason::Compared {
            longest_m: self.band.longest_m,
            shortest_m: self.band.shortest_m,
            ratio,
            pressure_over_gradient: self.pressure_pa / self.gradient_pa,
            agreeing: usize::from(verdict == Verdict::Agrees),
            windows: 1,
        };
        (verdict, reason)
    }
}

/// The verdict on a curve from its outcomes: that of its worst window, unless one of its assumptions is broken.
fn curve_verdict(
    case: &Case<'_>,
    at: CurveAtLoad,
    windows: &[WindowOutcome],
    whole_band: bool,
) -> CurveVerdict {
    let own = || windows.iter().filter(move |on| on.is_of(at.curve, at.load));
    let compared = || own().filter(|on| on.ratio_and_error().is_some());
    let worst = compared().max_by(|a, b| badness(a).total_cmp(&badness(b)));
    let agreeing = own().filter(|on| on.verdict == Verdict::Agrees).count();
    let broken = case.broken_assumption(at);
    let (verdict, reason) = match (broken, worst) {
        (Some(broken), _) => (Verdict::OutOfRange, Reason::Broken(broken)),
        (None, Some(worst)) => (worst.verdict, worst.reason.over_windows(agreeing, compared().count())),
        (None, None) => (Verdict::NotJudged, own().next_back().map_or(Reason::NoSurface, |on| on.reason)),
    };
    CurveVerdict {
        curve: at.curve,
        load: at.load,
        area_fraction: case.final_area(at),
        elements: own().next().and_then(|on| on.elements).filter(|_| whole_band),
        ratio: worst.and_then(WindowOutcome::ratio),
        verdict,
        reason,
        broken,
    }
}

/// The distance of the logarithm of a ratio from 0, less the errors that it is given.
fn badness(on: &WindowOutcome) -> f64 {
    on.ratio_and_error()
        .map_or(f64::NEG_INFINITY, |(ratio, error)| ratio.ln().abs() - (1.0 + ERRORS_GIVEN * error).ln())
}

/// The judgement of a case for which nothing can be pressed.
pub(crate) fn without_elements(case: &Case<'_>, reason: Reason) -> Judgement {
    let verdict = |at: CurveAtLoad| {
        let broken = case.broken_assumption(at);
        CurveVerdict {
            curve: at.curve,
            load: at.load,
            area_fraction: case.final_area(at),
            elements: None,
            ratio: None,
            verdict: if broken.is_some() { Verdict::OutOfRange } else { Verdict::NotJudged },
            reason: broken.map_or(reason, Reason::Broken),
            broken,
        }
    };
    conclude(case, None, Vec::new(), case.all().map(verdict).collect())
}

/// Adds to the verdicts what follows from them and from the case; the maps are left empty.
pub(crate) fn conclude(
    case: &Case<'_>,
    extent: Option<Extent>,
    windows: Vec<WindowOutcome>,
    curves: Vec<CurveVerdict>,
) -> Judgement {
    let headlines = (0..case.loads()).filter_map(|load| Headline::new(load, &windows, &curves)).collect();
    Judgement {
        extent,
        windows,
        curves,
        headlines,
        maps: Vec::new(),
        yielding: (0..case.loads()).map(|load| case.yielding(load)).collect(),
        steep_from_m: case.steep_from_m(),
        rms_gradient: case.rms_gradient(),
    }
}

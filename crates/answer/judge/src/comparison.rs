//! Curves against boundary elements: on each window, on the whole band, and the verdict on each curve.

use study::plan::PlanError;
use units::{Remark, RemarkCode};

use crate::JudgeError;
use crate::assumptions::CurveAtLoad;
use crate::body::Reference;
use crate::case::Case;
use crate::headline::{Basis, Headline};
use crate::judgement::Judgement;
use crate::layout::{Cell, Extent, Layout, PlannedPress};
use crate::maps::MapVerdict;
use crate::model_areas::{self, WindowProfiles};
use crate::seam::Seam;
use crate::solve::{Solutions, Solved};
use crate::standing_maps::{StandingArea, StandingMaps};
use crate::verdict::{ERRORS_GIVEN, Verdict, WorstWindow};
use crate::verdicts::{AreaRange, CurveVerdict, ElementArea, ReferenceArea, WindowOutcome};
use crate::window::{Band, Window};
use crate::yielding::Yielding;

/// A solved layout, to hold the curves of a case against.
pub(crate) struct Comparisons<'c> {
    pub case: &'c Case<'c>,
    pub layout: &'c Layout,
    pub solutions: &'c Solutions,
    /// The areas of maps that stand for the surface.
    pub maps: &'c [StandingArea],
}

impl Comparisons<'_> {
    /// Compares every curve under every load on every window.
    pub fn on_windows(&self) -> Result<Vec<WindowOutcome>, JudgeError> {
        let Comparisons { case, layout, .. } = self;
        let mut outcomes = Vec::new();
        for (index, window) in layout.windows.iter().enumerate() {
            let forms = &layout.forms[index];
            let pressures_pa =
                of_bodies_and_loads(case, |reference, load| case.pressure_pa(forms, reference, load));
            let seams = of_bodies_and_loads(case, |reference, load| case.seam(forms, reference, load));
            let areas = areas(case, window, &pressures_pa)?;
            for at in case.all() {
                let body = case.body(at);
                let comparison = Comparison {
                    at,
                    band: window.band,
                    seam: seams[body][at.load],
                    pressure_pa: pressures_pa[body][at.load],
                    gradient_pa: case.composite_modulus_pa * window.flattening_gradient,
                    area_fraction: areas[at.curve][at.load],
                    elements: comparable(case, at).and_then(|()| {
                        let cell = Cell { body, window: index, load: at.load };
                        self.area_on_window(cell).map_err(Remark::new)
                    }),
                    range: None,
                };
                outcomes.push(comparison.outcome(case));
            }
        }
        Ok(outcomes)
    }

    /// Compares every curve with the elements on the whole band.
    pub fn on_whole_band(&self) -> Vec<WindowOutcome> {
        let case = self.case;
        let band = case.band();
        let gradient_pa = 2.0 * case.rms_pressure_pa(band.shortest_m);
        let outcome = |at: CurveAtLoad| {
            let comparison = Comparison {
                at,
                band,
                seam: Seam::NONE,
                pressure_pa: case.nominal_pressure_pa(at.load),
                gradient_pa,
                area_fraction: case.final_area(at),
                elements: comparable(case, at)
                    .and_then(|()| self.area_of_whole_band(case.body(at), at.load).map_err(Remark::new)),
                range: self.range_of_growing(case.body(at), at.load),
            };
            WindowOutcome { is_whole_band: true, ..comparison.outcome(case) }
        };
        case.all().map(outcome).collect()
    }

    /// The areas of all elements on the whole band, under every load.
    pub fn references(&self) -> Vec<ReferenceArea> {
        let loads = 0..self.case.loads();
        let of_load = |load: usize| {
            self.case.references.iter().enumerate().map(move |(body, reference)| ReferenceArea {
                load,
                reference: *reference,
                elements: self.area_of_whole_band(body, load).ok(),
                maps: self.of_maps(body, load).map(|found| found.maps),
                range: self.range_of_whole_band(body, load),
                of_spectrum: self.of_maps(body, load).and_then(|_| self.area_of_spectrum(body, load).ok()),
            })
        };
        loads.flat_map(of_load).collect()
    }

    /// The range of the area of elements on the whole band.
    fn range_of_whole_band(&self, body: usize, load: usize) -> Option<AreaRange> {
        let of_elements = || self.area_of_whole_band(body, load).ok().map(ElementArea::range);
        self.range_of_growing(body, load).or_else(of_elements)
    }

    /// The range of the area of bodies whose hardness grows: from the load over the hardness at the shortest wave, or the area of elastic
    /// bodies if that is larger, to the area with the constant hardness. A limit on pressures has no scale, so elements do not say which
    /// hardness of this range to take.
    fn range_of_growing(&self, body: usize, load: usize) -> Option<AreaRange> {
        let constant = self.case.constant_body(body)?;
        let high = self.area_of_whole_band(constant, load).ok()?.high();
        let elastic = self.case.references.iter().position(|other| *other == Reference::Elastic);
        let elastic = elastic.and_then(|elastic| self.area_of_whole_band(elastic, load).ok());
        let least = self.case.least_area(self.case.references[body], load);
        let low = elastic.map_or(least, |elastic| elastic.low().max(least));
        Some(AreaRange { low: low.min(high), high })
    }

    /// The area of the maps that stand for the surface, if there are any.
    fn of_maps(&self, body: usize, load: usize) -> Option<&StandingArea> {
        self.maps.iter().find(|area| (area.body, area.load) == (body, load))
    }

    /// The area of elements on the whole band: that of maps, or of Gaussian surfaces.
    fn area_of_whole_band(&self, body: usize, load: usize) -> Result<ElementArea, RemarkCode> {
        match self.of_maps(body, load) {
            Some(area) => Ok(area.elements.at_least(self.case.least_area(self.case.references[body], load))),
            None => self.area_of_spectrum(body, load),
        }
    }

    /// The area of Gaussian surfaces on the whole band: as pressed, or that of the last window carried over by the closed form.
    fn area_of_spectrum(&self, body: usize, load: usize) -> Result<ElementArea, RemarkCode> {
        let Comparisons { case, layout, .. } = self;
        let Some(window) = layout.windows.len().checked_sub(1) else { return Err(RemarkCode::NoSurface) };
        let area = self.area_on_window(Cell { body, window, load })?;
        let reference = case.references[body];
        let seam = if layout.is_whole_band() {
            Seam::NONE
        } else {
            case.seam(&layout.forms[window], reference, load)
        };
        let carried_over = area.carried_over(seam).with_error(case.error_of_spectrum_end());
        Ok(carried_over.at_least(case.least_area(reference, load)))
    }

    /// The area that elements give for a cell of the layout, or the reason why there is none.
    fn area_on_window(&self, cell: Cell) -> Result<ElementArea, RemarkCode> {
        let Comparisons { case, layout, solutions, .. } = self;
        let (reference, forms) = (case.references[cell.body], &layout.forms[cell.window]);
        let (solved, down) = match layout.planned(cell) {
            PlannedPress::Solve(press) => (solutions.of_presses[press]?, Seam::NONE),
            PlannedPress::CarryDown(press) => {
                let down = case.down_to_load(forms, reference, cell.load, layout.presses[press].pressure_pa);
                (solutions.of_presses[press]?, down)
            }
            PlannedPress::Flows { share } => (Solved::between(share), Seam::NONE),
            PlannedPress::TooLight => return Err(RemarkCode::TooLight),
            PlannedPress::LoadNotChosen => return Err(RemarkCode::LoadNotChosen),
            PlannedPress::HasRange => return Err(RemarkCode::BetweenHardnesses),
        };
        Ok(ElementArea::new(solved.area_fraction, solved.standard_error).carried_over(down))
    }

    /// Combines the outcomes of every curve under every load into its verdict.
    pub fn verdicts(&self, windows: &[WindowOutcome], whole_band: &[WindowOutcome]) -> Vec<CurveVerdict> {
        let verdict = |whole: &WindowOutcome| {
            let body = self.case.body(CurveAtLoad { curve: whole.curve, load: whole.load });
            let range = self.range_of_growing(body, whole.load).or(whole.elements.map(ElementArea::range));
            let is_map = self.of_maps(body, whole.load).is_some();
            CurveVerdict { range, ..curve_verdict(self.case, whole, windows, is_map) }
        };
        whole_band.iter().map(verdict).collect()
    }
}

/// Refuses a curve that yields by a hardness law that no elements have.
fn comparable(case: &Case<'_>, at: CurveAtLoad) -> Result<(), Remark> {
    let own_law = Remark::new(RemarkCode::OwnHardnessLaw);
    let above = case.yields_by_own_law(at);
    above.map_or(Ok(()), |above| Err(own_law.with("wavelength_m", above.wavelength_m)))
}

/// A value for every body that is pressed and every load.
fn of_bodies_and_loads<T>(case: &Case<'_>, value: impl Fn(Reference, usize) -> T) -> Vec<Vec<T>> {
    let of_body = |&reference: &Reference| (0..case.loads()).map(|load| value(reference, load)).collect();
    case.references.iter().map(of_body).collect()
}

/// The area fractions of all curves on a window, curve by curve and load by load.
fn areas(
    case: &Case<'_>,
    window: &Window,
    pressures_pa: &[Vec<f64>],
) -> Result<Vec<Vec<Option<f64>>>, JudgeError> {
    let profiles = WindowProfiles::new(window, &case.results.psd);
    let model_areas = |curves: &[usize], pressures_pa: &[f64]| {
        model_areas::area_fractions(case.scene, &profiles, curves, pressures_pa)
    };
    let mut areas = vec![vec![None; case.loads()]; case.curves()];
    let (growing, steady): (Vec<usize>, Vec<usize>) =
        (0..case.curves()).partition(|curve| case.strength_grows(*curve));
    for (body, pressures_pa) in pressures_pa.iter().enumerate() {
        let of_body = |curve: &&usize| case.body(CurveAtLoad { curve: **curve, load: 0 }) == body;
        let of_body: Vec<usize> = steady.iter().filter(of_body).copied().collect();
        for (curve, found) in of_body.iter().zip(model_areas(&of_body, pressures_pa)?) {
            areas[*curve] = found;
        }
    }
    // The elements of a strength that grows depend on the load.
    for at in case.all().filter(|at| growing.contains(&at.curve) && comparable(case, *at).is_ok()) {
        let pressure_pa = pressures_pa[case.body(at)][at.load];
        areas[at.curve][at.load] = match model_areas(&[at.curve], &[pressure_pa]) {
            Ok(areas) => areas[0][0],
            // The window begins with more than the strength bears.
            Err(JudgeError::Plan(PlanError::Hardness(_))) => None,
            Err(error) => return Err(error),
        };
    }
    Ok(areas)
}

/// A curve under a load on a band, with the inputs of its verdict.
struct Comparison {
    at: CurveAtLoad,
    band: Band,
    /// Step from an area on the band to that of the surface.
    seam: Seam,
    /// Mean pressure on the band.
    pressure_pa: f64,
    /// Twice the rms pressure of full contact on the band: on half-spaces E* times its rms gradient.
    gradient_pa: f64,
    /// Area fraction of the curve.
    area_fraction: Option<f64>,
    /// Area fraction of the elements, or the reason why there is none.
    elements: Result<ElementArea, Remark>,
    /// Range of the area of bodies whose hardness grows.
    range: Option<AreaRange>,
}

impl Comparison {
    fn outcome(&self, case: &Case<'_>) -> WindowOutcome {
        let Comparison { at: CurveAtLoad { curve, load }, band, pressure_pa, area_fraction, .. } = *self;
        let reference = case.reference(self.at);
        // An assumption that breaks at some scale is broken at all shorter ones.
        let broken = case
            .broken_assumption(self.at)
            .filter(|(begins_m, _)| *begins_m >= band.shortest_m * (1.0 - 1e-9));
        let (verdict, reason) = match (broken, area_fraction, self.range, &self.elements) {
            (Some((_, broken)), ..) => (Verdict::OutOfRange, broken.clone()),
            (None, Some(area_fraction), Some(range), _) => Self::held_against(area_fraction, range),
            (None, _, _, Err(reason)) => (Verdict::NotJudged, reason.clone()),
            (None, None, _, Ok(_)) => (Verdict::NotJudged, Remark::new(RemarkCode::NoArea)),
            (None, Some(area_fraction), None, Ok(elements)) => Self::compared(area_fraction, *elements),
        };
        let elements = self.elements.as_ref().ok().copied();
        WindowOutcome {
            curve,
            load,
            longest_m: band.longest_m,
            shortest_m: band.shortest_m,
            is_whole_band: false,
            elements_of_whole: elements
                .map(|elements| elements.carried_over(self.seam).at_least(case.least_area(reference, load))),
            pressure_pa,
            pressure_over_gradient: pressure_pa / self.gradient_pa,
            area_fraction,
            elements,
            verdict,
            reason,
        }
    }

    /// Nothing is judged within a range, and outside it what lies beyond its ends by more than agreement allows.
    fn held_against(area_fraction: f64, AreaRange { low, high }: AreaRange) -> (Verdict, Remark) {
        let ratio = area_fraction / area_fraction.clamp(low, high);
        match Verdict::from_ratio(ratio, 0.0) {
            Verdict::Agrees => (Verdict::NotJudged, Remark::new(RemarkCode::BetweenHardnesses)),
            verdict => (verdict, Remark::new(RemarkCode::BeyondHardnesses).with("ratio", ratio)),
        }
    }

    fn compared(area_fraction: f64, elements: ElementArea) -> (Verdict, Remark) {
        let ratio = area_fraction / elements.area_fraction;
        let verdict = Verdict::from_ratio(ratio, elements.relative_error());
        (verdict, Remark::new(RemarkCode::ComparedAreas).with("ratio", ratio))
    }
}

/// The verdict on a curve: that of the whole band, with its worst window beside it. A model of Gaussian surfaces that agrees with a map
/// and not with them agrees by accident.
fn curve_verdict(
    case: &Case<'_>,
    whole: &WindowOutcome,
    windows: &[WindowOutcome],
    is_map: bool,
) -> CurveVerdict {
    let at = CurveAtLoad { curve: whole.curve, load: whole.load };
    let compared = || windows.iter().filter(|on| on.is_of(at) && on.ratio_and_error().is_some());
    let worst = compared().max_by(|a, b| badness(a).total_cmp(&badness(b)));
    let worst_window = worst.and_then(|on| {
        let WindowOutcome { longest_m, shortest_m, verdict, .. } = *on;
        Some(WorstWindow { longest_m, shortest_m, ratio: on.ratio()?, verdict })
    });
    let agreeing = compared().filter(|on| on.verdict == Verdict::Agrees).count();
    let windows = compared().count();
    let found = CurveVerdict {
        curve: at.curve,
        load: at.load,
        area_fraction: whole.area_fraction,
        reference: case.reference(at),
        elements: whole.elements,
        range: None,
        verdict: whole.verdict,
        reason: whole.reason.clone(),
        worst_window,
        agreeing,
        windows,
    };
    let reason = match (worst_window, found.reason.clone()) {
        (Some(worst), reason) if reason.code == RemarkCode::ComparedAreas => reason
            .with("agreeing", agreeing)
            .with("windows", windows)
            .with("longest_m", worst.longest_m)
            .with("shortest_m", worst.shortest_m)
            .with("worst_ratio", worst.ratio),
        (_, reason) => reason,
    };
    let is_accident = is_map && windows > 0 && found.verdict == Verdict::Agrees && !found.holds();
    match is_accident {
        true => CurveVerdict {
            verdict: Verdict::OutOfRange,
            reason: Remark { code: RemarkCode::AgreesByAccident, ..reason },
            ..found
        },
        false => CurveVerdict { reason, ..found },
    }
}

/// The distance of the logarithm of a ratio from 0, less the errors that it is given.
fn badness(on: &WindowOutcome) -> f64 {
    on.ratio_and_error()
        .map_or(f64::NEG_INFINITY, |(ratio, error)| ratio.ln().abs() - (1.0 + ERRORS_GIVEN * error).ln())
}

/// The judgement of a case for which nothing can be pressed.
pub(crate) fn without_elements(case: &Case<'_>, reason: RemarkCode) -> Judgement {
    let verdict = |at: CurveAtLoad| {
        let broken = case.broken_assumption(at);
        CurveVerdict {
            curve: at.curve,
            load: at.load,
            area_fraction: case.final_area(at),
            reference: case.reference(at),
            elements: None,
            range: None,
            verdict: if broken.is_some() { Verdict::OutOfRange } else { Verdict::NotJudged },
            reason: broken.map(|(_, remark)| remark.clone()).unwrap_or_else(|| Remark::new(reason)),
            worst_window: None,
            agreeing: 0,
            windows: 0,
        }
    };
    conclude(
        case,
        None,
        Vec::new(),
        case.all().map(verdict).collect(),
        Vec::new(),
        Vec::new(),
        &StandingMaps::default(),
    )
}

/// Holds the maps that are the answer against Gaussian surfaces of their spectrum, under each load.
fn standing_verdicts(
    case: &Case<'_>,
    headlines: &[Headline],
    references: &[ReferenceArea],
    standing: &StandingMaps,
) -> Vec<MapVerdict> {
    let gradient_pa = standing.gradient_over_spectrum * case.composite_modulus_pa * case.rms_gradient();
    let verdict = |headline: &Headline| {
        let is_own = |area: &&ReferenceArea| {
            area.load == headline.load && headline.basis == Basis::Elements(area.reference)
        };
        let area = references.iter().find(is_own)?;
        Some(MapVerdict {
            map: standing.names.join(", "),
            load: area.load,
            pressure_over_gradient: case.nominal_pressure_pa(area.load) / gradient_pa,
            gradient_over_spectrum: standing.gradient_over_spectrum,
            area_fraction: area.elements?.area_fraction,
            twins: area.of_spectrum?,
        })
    };
    headlines.iter().filter_map(verdict).collect()
}

/// Adds to the verdicts what follows from them and from the case.
pub(crate) fn conclude(
    case: &Case<'_>,
    extent: Option<Extent>,
    windows: Vec<WindowOutcome>,
    curves: Vec<CurveVerdict>,
    references: Vec<ReferenceArea>,
    maps: Vec<MapVerdict>,
    standing: &StandingMaps,
) -> Judgement {
    let yielding: Vec<Yielding> = (0..case.loads()).map(|load| case.yielding(load)).collect();
    let headlines: Vec<Headline> =
        yielding.iter().filter_map(|yielding| Headline::new(yielding, &references, &curves, &maps)).collect();
    let mut maps: Vec<MapVerdict> =
        standing_verdicts(case, &headlines, &references, standing).into_iter().chain(maps).collect();
    maps.sort_by_key(|map| map.load);
    Judgement {
        extent,
        windows,
        curves,
        references,
        headlines,
        maps,
        yielding,
        steep_from_m: case.steep_from_m(),
        rms_gradient: case.rms_gradient(),
        error_of_spectrum_end: case.error_of_spectrum_end(),
        surface: None,
    }
}

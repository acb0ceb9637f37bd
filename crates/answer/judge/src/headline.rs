//! The headline of a load: the area that the scene supports, its range, and the assumption that decides it.

use serde::Serialize;

use crate::body::Reference;
use crate::maps::MapVerdict;
use crate::verdicts::{AreaRange, CurveVerdict, ElementArea, PressedMaps, ReferenceArea};
use crate::yielding::Yielding;

/// The area of a load, to be said first.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Headline {
    /// The load, by index.
    pub load: usize,
    /// The source of the number.
    pub basis: Basis,
    /// The best estimate of the area fraction; `None` if only models give it, or the hardness grows.
    pub area_fraction: Option<f64>,
    /// The least area fraction that the judge cannot exclude.
    pub low: f64,
    /// The largest area fraction that the judge cannot exclude.
    pub high: f64,
    /// The area under another assumption on the hardness, if that moves it beyond the range.
    pub otherwise: Option<Otherwise>,
    /// The measured maps that were pressed; `None` for Gaussian surfaces of the spectrum.
    pub maps: Option<PressedMaps>,
    /// The curve nearest to the elements of the headline, among those that agree on the whole band and on most windows.
    pub best_curve: Option<usize>,
}

/// The source of a headline.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// Boundary elements that match the material.
    Elements(Reference),
    /// The range of the models, since no elements were pressed.
    RangeOfModels {
        /// The curve of the least area.
        least: usize,
        /// The curve of the largest.
        most: usize,
    },
}

/// The area if the hardness is the same at every scale.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Otherwise {
    /// The constant hardness \[Pa\].
    pub hardness_pa: f64,
    /// The area of elements that flow at it.
    pub elements: ElementArea,
}

impl Headline {
    /// The headline of a load; `None` if there are no elements and no curve has an area under it.
    pub(crate) fn new(
        yielding: &Yielding,
        areas: &[ReferenceArea],
        curves: &[CurveVerdict],
        maps: &[MapVerdict],
    ) -> Option<Self> {
        let load = yielding.load;
        let area = |is_wanted: fn(Reference) -> bool| {
            areas.iter().find(|area| area.load == load && is_wanted(area.reference) && area.range.is_some())
        };
        let elastic = area(|reference| reference == Reference::Elastic);
        let flowing = area(|reference| matches!(reference, Reference::Yielding { .. }));
        let growing = area(|reference| reference == Reference::Growing);
        let own = match (yielding.above_constant, yielding.hardness_grows, yielding.above_growing) {
            (None, _, _) | (Some(_), true, None) => elastic,
            (Some(_), false, _) => flowing,
            (Some(_), true, Some(_)) => growing,
        };
        let Some(own) = own else { return Self::from_range(load, curves) };
        let is_elastic = yielding.above_constant.is_none();
        let own = flowing.filter(|flowing| is_elastic && has_peaks_that_flow(own, flowing)).unwrap_or(own);
        let headline = Self::from_elements(own, curves)?.with_peaks_that_flow(yielding).with_maps(maps);
        // Maps that touch less are elastic: what flows touches as much as the load over the hardness, whatever its peaks.
        let least = own.elements.map_or(0.0, |elements| elements.least.min(headline.high));
        let headline = Headline { low: headline.low.max(least), ..headline };
        let may_be_softer = own.reference == Reference::Elastic && yielding.above_constant.is_some();
        let otherwise = flowing.filter(|_| may_be_softer).and_then(Otherwise::new);
        let moves =
            |other: &Otherwise| !(headline.low..=headline.high).contains(&other.elements.area_fraction);
        Some(Headline { otherwise: otherwise.filter(moves), ..headline })
    }

    fn from_elements(area: &ReferenceArea, curves: &[CurveVerdict]) -> Option<Self> {
        let AreaRange { low, high } = area.range?;
        let off = |curve: &CurveVerdict| curve.ratio().map_or(f64::INFINITY, |ratio| ratio.ln().abs());
        let candidates = curves
            .iter()
            .filter(|curve| curve.load == area.load && curve.reference == area.reference && curve.holds());
        Some(Headline {
            load: area.load,
            basis: Basis::Elements(area.reference),
            area_fraction: area.elements.map(|elements| elements.area_fraction),
            low,
            high,
            otherwise: None,
            maps: area.maps,
            best_curve: candidates.min_by(|a, b| off(a).total_cmp(&off(b))).map(|curve| curve.curve),
        })
    }

    /// Extends the range by what peaks of the pressure add that flow though no scale yields on average.
    fn with_peaks_that_flow(self, yielding: &Yielding) -> Self {
        let is_elastic =
            self.basis == Basis::Elements(Reference::Elastic) && yielding.above_constant.is_none();
        let factor = yielding.flowing_over_elastic.filter(|_| is_elastic).unwrap_or(1.0);
        Headline { high: (self.high * factor.max(1.0)).min(1.0), ..self }
    }

    /// Extends the range of Gaussian surfaces by the ratios of maps that touch otherwise, under this load or, if none was pressed
    /// under it, under any.
    fn with_maps(self, maps: &[MapVerdict]) -> Self {
        let is_own = |map: &&MapVerdict| map.load == self.load;
        let all = !maps.iter().any(|map| is_own(&map));
        let ratios = maps.iter().filter(|map| map.differs() && (all || is_own(map))).map(MapVerdict::ratio);
        let ratios = ratios.filter(|_| self.maps.is_none());
        let (least, most) =
            ratios.fold((1.0f64, 1.0f64), |(least, most), ratio| (least.min(ratio), most.max(ratio)));
        Headline { low: self.low * least, high: (self.high * most).min(1.0), ..self }
    }

    fn from_range(load: usize, curves: &[CurveVerdict]) -> Option<Self> {
        let areas = || {
            let of_load = curves.iter().filter(|curve| curve.load == load);
            of_load.filter_map(|curve| Some((curve.curve, curve.area_fraction?)))
        };
        let least = areas().reduce(|a, b| if b.1 < a.1 { b } else { a })?;
        let most = areas().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        Some(Headline {
            load,
            basis: Basis::RangeOfModels { least: least.0, most: most.0 },
            area_fraction: None,
            low: least.1,
            high: most.1,
            otherwise: None,
            maps: None,
            best_curve: None,
        })
    }
}

/// Tells whether maps have peaks that flow, though no Gaussian surface of their spectrum has: their area with the hardness lies above
/// the range of the elastic one.
fn has_peaks_that_flow(elastic: &ReferenceArea, flowing: &ReferenceArea) -> bool {
    let areas = flowing.elements.zip(elastic.range).filter(|_| flowing.maps.is_some());
    areas.is_some_and(|(flowing, elastic)| flowing.area_fraction > elastic.high)
}

impl Otherwise {
    fn new(area: &ReferenceArea) -> Option<Self> {
        match area.reference {
            Reference::Elastic | Reference::Growing => None,
            Reference::Yielding { hardness_pa } => Some(Otherwise { hardness_pa, elements: area.elements? }),
        }
    }
}

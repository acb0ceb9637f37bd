//! The estimate of an area beside all that it was compared with.

use judge::{AGREEMENT, ElementArea, Headline, Reference};
use serde::Serialize;

use super::area::{AreaEstimate, Source};
use super::compared_models::{ModelCell, ReferenceGroup};

/// The area if the hardness is the same at every scale.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OtherHardness {
    /// The hardness \[Pa\].
    pub hardness_pa: f64,
    /// The area fraction.
    pub area_fraction: f64,
    /// The lower end of its range.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The area over the best estimate.
    pub ratio: f64,
}

/// An estimate under a load, the area under the other assumption on the hardness, and the models.
#[derive(Clone, Copy)]
pub(crate) struct Estimate<'a> {
    pub nominal_pressure_pa: f64,
    pub area: AreaEstimate,
    pub otherwise: Option<OtherHardness>,
    pub best_model: Option<ModelCell>,
    pub references: &'a [ReferenceGroup],
}

impl Estimate<'_> {
    /// Returns the factor between the areas with a constant hardness and with one that grows at small scales, if it decides: if it
    /// leaves the range, or if only a range is known that is wider than what counts as agreement.
    pub fn factor_of_hardness(&self) -> Option<f64> {
        let of_range = || {
            let ratio = self.area.high / self.area.low;
            (self.area.source == Source::Elements(Reference::Growing) && ratio > AGREEMENT).then_some(ratio)
        };
        self.otherwise.map(|other| other.ratio).or_else(of_range)
    }

    /// Returns the curve whose area stands for the elements where these have none, as along the cutoff: the best model, or
    /// else the one nearest to the elements of the estimate.
    pub fn nearest_curve(&self) -> Option<usize> {
        let nearest = || self.references.first()?.models.first();
        match self.area.source {
            Source::Model { curve } => Some(curve),
            _ => self.best_model.as_ref().or_else(nearest).map(|cell| cell.curve),
        }
    }
}

impl OtherHardness {
    pub(crate) fn new(headline: &Headline, area: &AreaEstimate) -> Option<Self> {
        let (hardness_pa, elements) = match (headline.otherwise, headline.basis) {
            (Some(other), _) => (other.hardness_pa, other.elements),
            _ => return None,
        };
        let area_fraction = elements.area_fraction;
        let is_outside = !(area.low..=area.high).contains(&area_fraction);
        is_outside.then(|| OtherHardness {
            hardness_pa,
            area_fraction,
            low: ElementArea::low(elements),
            high: ElementArea::high(elements),
            ratio: area_fraction / area.area_fraction.unwrap_or(area.low),
        })
    }
}

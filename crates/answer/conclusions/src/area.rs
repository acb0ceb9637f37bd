//! The area that touches under a load, with its one range.

use judge::{Basis, Headline, PressedMaps, Reference};
use serde::Serialize;
use study::models::Choice;

use super::evidence::Evidence;

/// The area that touches, as a share of the nominal area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AreaEstimate {
    /// The best estimate; `None` if only its range is known.
    pub area_fraction: Option<f64>,
    /// The lower end of its range: two standard errors of the elements and the interval of the inputs.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The source.
    pub source: Source,
    /// The measured maps that were pressed; `None` for Gaussian surfaces of the spectrum.
    pub maps: Option<PressedMaps>,
    /// The factor between the ends that the elements, or the models, leave.
    pub factor_of_elements: f64,
    /// The part of uncertain scans, instruments and materials; `None` without draws.
    pub of_inputs: Option<OfInputs>,
}

/// The part of a range that uncertain inputs make.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OfInputs {
    /// The curve whose interval it is, by index.
    pub curve: usize,
    /// The high end of that interval over its low end.
    pub factor: f64,
}

/// The source of an area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// Boundary elements of bodies like these.
    Elements(Reference),
    /// One model, which nothing was compared with.
    Model {
        /// The curve, by index.
        curve: usize,
    },
    /// The range of the models, which nothing was compared with.
    Models,
}

impl Source {
    /// Returns true if no elements were pressed, so that models alone give the area.
    #[must_use]
    pub fn is_of_models(self) -> bool {
        matches!(self, Source::Model { .. } | Source::Models)
    }
}

impl AreaEstimate {
    pub(crate) fn from_headline(evidence: &Evidence<'_>, headline: &Headline) -> Self {
        let source = match headline.basis {
            Basis::Elements(reference) => Source::Elements(reference),
            Basis::RangeOfModels { least, most } if least == most => Source::Model { curve: least },
            Basis::RangeOfModels { .. } => Source::Models,
        };
        let single = match source {
            Source::Model { .. } => Some(headline.low),
            _ => headline.area_fraction,
        };
        let plain = AreaEstimate {
            area_fraction: single,
            low: headline.low,
            high: headline.high,
            source,
            maps: headline.maps,
            factor_of_elements: headline.high / headline.low,
            of_inputs: None,
        };
        plain.widened(evidence, headline.load, headline.best_curve)
    }

    pub(crate) fn from_models(evidence: &Evidence<'_>, load: usize) -> Option<Self> {
        let areas = || {
            let of_load = evidence.answer.curves.iter().map(|loads| loads[load].as_ref());
            of_load.enumerate().filter_map(|(curve, answer)| Some((curve, answer?.area_fraction)))
        };
        let low = areas().map(|(_, area)| area).reduce(f64::min)?;
        let high = areas().map(|(_, area)| area).reduce(f64::max)?;
        let mut curves = areas().map(|(curve, _)| curve);
        let (source, area_fraction) = match (curves.next(), curves.next()) {
            (Some(curve), None) => (Source::Model { curve }, Some(low)),
            _ => (Source::Models, None),
        };
        let factor_of_elements = high / low;
        let plain = AreaEstimate {
            area_fraction,
            low,
            high,
            source,
            maps: None,
            factor_of_elements,
            of_inputs: None,
        };
        Some(plain.widened(evidence, load, None))
    }

    /// Widens the range by the interval that uncertain inputs give a curve: that of the best model, or else of any curve
    /// with an interval. Errors of elements and of inputs are independent, so their logarithms add as squares.
    fn widened(self, evidence: &Evidence<'_>, load: usize, best: Option<usize>) -> Self {
        let Some(uncertainty) = evidence.uncertainty else { return self };
        let own = match self.source {
            Source::Model { curve } => Some(curve),
            _ => best,
        };
        let curves = &evidence.scene.needs.curves;
        // The interval of a model that does not yield says nothing of bodies that do, nor that of one that yields of bodies that do not.
        let is_alike = |curve: &usize| {
            let yields = curves[*curve].model.entry.has(Choice::Strength);
            match self.source {
                Source::Elements(Reference::Yielding { .. }) => yields,
                Source::Elements(Reference::Elastic) => !yields,
                _ => true,
            }
        };
        let alike = own.into_iter().chain((0..curves.len()).filter(is_alike));
        let Some(interval) = alike.filter_map(|curve| uncertainty.interval(curve, load)).next() else {
            return self;
        };
        let wider = |end: f64, of_inputs: f64| -> f64 {
            let centre = self.area_fraction.unwrap_or(end);
            let ln = (end / centre).ln().hypot((of_inputs / interval.area_fraction).ln());
            if of_inputs < interval.area_fraction { centre * (-ln).exp() } else { centre * ln.exp() }
        };
        // An interval that begins above the area widens nothing downwards.
        let low =
            if interval.low < interval.area_fraction { wider(self.low, interval.low) } else { self.low };
        let high =
            if interval.high > interval.area_fraction { wider(self.high, interval.high) } else { self.high };
        AreaEstimate {
            low: low.min(self.low),
            high: high.clamp(self.high, 1.0),
            of_inputs: Some(OfInputs { curve: interval.curve, factor: interval.high / interval.low }),
            ..self
        }
    }
}

//! The area that touches under a load, with its one range.

use judge::{Basis, Headline, PressedMaps, Reference};
use serde::Serialize;
use study::models::Choice;
use study::student::normal_half_width;
use uncertainty::{AreaInterval, Group};

use super::evidence::Evidence;

/// The largest share of scans that is taken out of an interval.
const MOST_OF_SCANS: f64 = 0.999;

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
    /// The part of that factor that waves beyond the end of the spectrum leave; 1 if they matter to no elements.
    pub factor_of_spectrum_end: f64,
    /// The part of uncertain scans, instruments and materials; `None` without draws.
    pub of_inputs: Option<OfInputs>,
}

/// The part of a range that uncertain inputs make.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OfInputs {
    /// The curve whose interval it is, by index; `None` for that of the hardness alone, where no curve yields as the bodies do.
    pub curve: Option<usize>,
    /// The high end of that interval over its low end.
    pub factor: f64,
    /// The share of the scatter of scans in the variance of the drawn areas, which is not in the interval if maps were pressed: 0 if none
    /// were.
    pub share_of_scans: f64,
}

/// The interval of uncertain inputs over the best estimate.
struct IntervalOfInputs {
    curve: Option<usize>,
    low: f64,
    high: f64,
    share_of_scans: f64,
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
        let is_of_spectrum = headline.maps.is_none() && !source.is_of_models();
        let judgement = evidence.judgement.filter(|_| is_of_spectrum);
        let end_error = judgement.map_or(0.0, |judgement| judgement.error_of_spectrum_end);
        let plain = AreaEstimate {
            area_fraction: single,
            low: headline.low,
            high: headline.high,
            source,
            maps: headline.maps,
            factor_of_elements: headline.high / headline.low,
            // Both ends lie two standard errors from the middle.
            factor_of_spectrum_end: (4.0 * end_error).exp(),
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
            factor_of_spectrum_end: 1.0,
            of_inputs: None,
        };
        Some(plain.widened(evidence, load, None))
    }

    /// Returns the width of the range, as a share of that now, if the interval of uncertain inputs becomes so many times as wide.
    pub(crate) fn width_ratio(&self, of_inputs: f64) -> f64 {
        let Some(inputs) = self.of_inputs else { return 1.0 };
        let share = inputs.share_of_scans;
        let (elements, inputs) = (self.factor_of_elements.ln(), inputs.factor.ln());
        let of_inputs = ((of_inputs * of_inputs - share) / (1.0 - share)).max(0.0).sqrt();
        elements.hypot(of_inputs * inputs) / elements.hypot(inputs)
    }

    /// Widens the range by the interval that uncertain inputs give the area. Errors of elements and of inputs are independent, so their
    /// logarithms add as squares.
    fn widened(self, evidence: &Evidence<'_>, load: usize, best: Option<usize>) -> Self {
        let Some(inputs) = self.interval_of_inputs(evidence, load, best) else { return self };
        let centre = |end: f64| self.area_fraction.unwrap_or(end);
        let wider = |end: f64, of_inputs: f64| (end / centre(end)).ln().hypot(of_inputs.ln()).exp();
        // An interval that begins above the area widens nothing downwards.
        let low = centre(self.low) / wider(self.low, inputs.low.min(1.0));
        let high = centre(self.high) * wider(self.high, inputs.high.max(1.0));
        AreaEstimate {
            low: low.min(self.low),
            high: high.clamp(self.high, 1.0),
            of_inputs: Some(OfInputs {
                curve: inputs.curve,
                factor: inputs.high / inputs.low,
                share_of_scans: inputs.share_of_scans,
            }),
            ..self
        }
    }

    /// Finds the interval of the best model, or else of any curve that yields as the bodies do; if there is none, bodies that flow have
    /// that of the load over their hardness. A map that is pressed does not scatter as other places do.
    fn interval_of_inputs(
        &self,
        evidence: &Evidence<'_>,
        load: usize,
        best: Option<usize>,
    ) -> Option<IntervalOfInputs> {
        let uncertainty = evidence.uncertainty?;
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
        let of_curve = alike.filter_map(|curve| uncertainty.interval(curve, load)).next();
        let over_area = |found: &AreaInterval| {
            let of_scans = self.maps.and_then(|_| match uncertainty.groups[..] {
                [Group::Scans] => Some(1.0),
                _ => uncertainty.share(found, Group::Scans),
            });
            let share_of_scans = of_scans.unwrap_or(0.0).clamp(0.0, MOST_OF_SCANS);
            let end = |area: f64| (area / found.area_fraction).powf((1.0 - share_of_scans).sqrt());
            IntervalOfInputs {
                curve: Some(found.curve),
                low: end(found.low),
                high: end(found.high),
                share_of_scans,
            }
        };
        let of_hardness = || {
            let flows = matches!(self.source, Source::Elements(Reference::Yielding { .. }));
            let strength = evidence.scene.spreads.strength.as_ref().filter(|_| flows)?;
            let half = normal_half_width(uncertainty.settings.level) * strength.standard_uncertainty();
            Some(IntervalOfInputs { curve: None, low: (-half).exp(), high: half.exp(), share_of_scans: 0.0 })
        };
        of_curve.map(over_area).or_else(of_hardness)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scans_leave_the_share_of_an_interval_that_a_pressed_map_has_not() {
        let width_ratio = |share_of_scans: f64, of_inputs: f64| {
            let of_inputs_now = OfInputs { curve: None, factor: 2.0, share_of_scans };
            let area = AreaEstimate {
                area_fraction: Some(0.1),
                low: 0.05,
                high: 0.2,
                source: Source::Models,
                maps: None,
                factor_of_elements: 1.0,
                factor_of_spectrum_end: 1.0,
                of_inputs: Some(of_inputs_now),
            };
            area.width_ratio(of_inputs)
        };
        // Of a variance of 1, 0.64 is that of scans and 0.36 is left; an interval 0.73 as large in variance keeps 0.09 of that.
        for (share, of_inputs, expected) in
            [(0.0, 0.5, 0.5), (0.64, 1.0, 1.0), (0.64, 0.73f64.sqrt(), 0.5), (0.64, 0.1, 0.0)]
        {
            assert!((width_ratio(share, of_inputs) - expected).abs() < 1e-12, "{share} {of_inputs}");
        }
    }
}

//! The assessment of the results of a scene: by boundary elements and by draws.

use judge::{Basis, Headline, Judgement};
use uncertainty::{Advice, Uncertainty};

/// The judgement and the uncertainty of the results of a scene, as far as they were computed.
#[derive(Debug, Clone, Copy, Default)]
pub struct Assessment<'a> {
    /// The verdicts of boundary elements on the curves.
    pub judgement: Option<&'a Judgement>,
    /// The uncertainty of the areas from draws of the inputs.
    pub uncertainty: Option<&'a Uncertainty>,
}

impl<'a> Assessment<'a> {
    /// The advice for the curve of the first headline, or else the first advice.
    pub(crate) fn foremost_advice(&self) -> Option<&'a Advice> {
        let uncertainty = self.uncertainty?;
        let headlines = self.judgement.into_iter().flat_map(|judgement| &judgement.headlines);
        let of_headline = |headline: &Headline| match headline.basis {
            Basis::Curve { curve, .. } => uncertainty.advice_for(curve, headline.load),
            Basis::RangeOfModels { .. } => None,
        };
        headlines.filter_map(of_headline).next().or_else(|| uncertainty.advice.first())
    }
}

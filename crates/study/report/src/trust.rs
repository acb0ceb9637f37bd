//! How far the results of a scene can be trusted, where that was asked.

use judge::{Headline, Judgement, RestsOn};
use uncertainty::{Advice, Uncertainty};

/// What boundary elements and draws say of the results of a scene.
#[derive(Debug, Clone, Copy, Default)]
pub struct Trust<'a> {
    /// What boundary elements say of its curves, where they were asked.
    pub judgement: Option<&'a Judgement>,
    /// What draws of its inputs say of its areas, where some were made.
    pub uncertainty: Option<&'a Uncertainty>,
}

impl<'a> Trust<'a> {
    /// The advice for the curve that the judge's first number rests on; the first there is where that has none.
    pub(crate) fn foremost_advice(&self) -> Option<&'a Advice> {
        let uncertainty = self.uncertainty?;
        let headlines = self.judgement.into_iter().flat_map(|judgement| &judgement.headlines);
        let of_headline = |headline: &Headline| match headline.rests_on {
            RestsOn::Curve { curve, .. } => uncertainty.advice_for(curve, headline.load),
            RestsOn::RangeOfModels { .. } => None,
        };
        headlines.filter_map(of_headline).next().or_else(|| uncertainty.advice.first())
    }
}

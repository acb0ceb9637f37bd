//! The models of a load beside the elements that they are compared with.

use judge::{AreaRange, Basis, CurveVerdict, Headline, Judgement, Reference, Verdict};
use serde::Serialize;

/// The models that are compared with the same elements.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReferenceGroup {
    /// The bodies that the elements press.
    pub reference: Reference,
    /// The area fraction of the elements; `None` if they were not pressed, or have a range alone.
    pub area_fraction: Option<f64>,
    /// The range of that area; `None` if they were not pressed.
    pub range: Option<AreaRange>,
    /// The models, the nearest to the elements first.
    pub models: Vec<ModelCell>,
}

/// A model beside the elements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ModelCell {
    /// The curve, by index.
    pub curve: usize,
    /// Its area fraction.
    pub area_fraction: Option<f64>,
    /// The area over that of the elements, with the whole band.
    pub ratio: Option<f64>,
    /// The verdict.
    pub verdict: Verdict,
}

/// The number of models by verdict: of those compared with the elements of the estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Tally {
    /// Models that agree with the elements.
    pub agree: usize,
    /// Models with too large or too small an area.
    pub off: usize,
    /// Models whose assumptions do not hold.
    pub not_valid: usize,
    /// Models that were not compared.
    pub not_judged: usize,
    /// Models that were compared with other elements.
    pub of_other_elements: usize,
}

impl Tally {
    pub(crate) fn count(references: &[ReferenceGroup], leading: Reference) -> Self {
        let mut tally = Tally::default();
        let (own, others): (Vec<_>, Vec<_>) = references.iter().partition(|group| group.reference == leading);
        tally.of_other_elements = others.iter().map(|group| group.models.len()).sum();
        for cell in own.iter().flat_map(|group| &group.models) {
            match cell.verdict {
                Verdict::Agrees => tally.agree += 1,
                Verdict::TooLarge | Verdict::TooSmall => tally.off += 1,
                Verdict::OutOfRange => tally.not_valid += 1,
                Verdict::NotJudged => tally.not_judged += 1,
            }
        }
        tally
    }
}

/// The elements that models of a load are compared with first: those of the headline.
pub(crate) fn leading_reference(headline: Option<&Headline>) -> Reference {
    match headline.map(|headline| headline.basis) {
        Some(Basis::Elements(reference)) => reference,
        _ => Reference::Elastic,
    }
}

/// The models of a load by the elements that they are compared with; the elements of the headline come first.
pub(crate) fn groups(judgement: &Judgement, load: usize) -> Vec<ReferenceGroup> {
    let leading = leading_reference(judgement.headline(load));
    let mut groups: Vec<ReferenceGroup> = Vec::new();
    for verdict in judgement.curves.iter().filter(|verdict| verdict.load == load) {
        let cell = cell(verdict);
        match groups.iter_mut().find(|group| group.reference == verdict.reference) {
            Some(group) => group.models.push(cell),
            None => {
                let of_group = judgement
                    .references
                    .iter()
                    .find(|area| area.load == load && area.reference == verdict.reference);
                groups.push(ReferenceGroup {
                    reference: verdict.reference,
                    area_fraction: of_group.and_then(|area| Some(area.elements?.area_fraction)),
                    range: of_group.and_then(|area| area.range),
                    models: vec![cell],
                });
            }
        }
    }
    let off = |cell: &ModelCell| cell.ratio.map_or(f64::INFINITY, |ratio| ratio.ln().abs());
    for group in &mut groups {
        group.models.sort_by(|a, b| off(a).total_cmp(&off(b)));
    }
    groups.sort_by_key(|group| group.reference != leading);
    groups
}

fn cell(verdict: &CurveVerdict) -> ModelCell {
    ModelCell {
        curve: verdict.curve,
        area_fraction: verdict.area_fraction,
        ratio: verdict.ratio(),
        verdict: verdict.verdict,
    }
}

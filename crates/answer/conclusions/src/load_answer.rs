//! The conclusion for one load: the area, its range, and how the models compare.

use judge::{
    AGREEMENT, AreaRange, Basis, CurveVerdict, ElementArea, Headline, Judgement, Reference, Verdict,
};
use serde::Serialize;
use study::models::Choice;

use study::interface::InterfaceStates;

use super::asked::{AskedValue, Questions};
use super::cause::Cause;
use super::evidence::Evidence;
use super::seal::SealUnderLoad;

/// The conclusion for a load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// The load, by index.
    pub load: usize,
    /// The load as typed.
    pub label: String,
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// The area that touches.
    pub area: AreaEstimate,
    /// What that area hangs on.
    pub cause: Cause,
    /// The area if the hardness does not grow at small scales, if that lies outside the range.
    pub otherwise: Option<OtherHardness>,
    /// The closed form nearest to the elements, among those that agree with them; a cell of `references`.
    pub best_model: Option<ModelCell>,
    /// The models, by the elements that they are compared with; those of the estimate first.
    pub references: Vec<ReferenceGroup>,
    /// The number of models by verdict.
    pub tally: Tally,
    /// The seal under this load, if the scene has one.
    pub seal: Option<SealUnderLoad>,
    /// What the scene asks of its interface besides.
    pub asked: Vec<AskedValue>,
}

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
    /// The factor between the ends that the elements, or the models, leave.
    pub factor_of_elements: f64,
    /// What uncertain scans, instruments and materials add; `None` without draws.
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

impl Answer {
    /// Draws the conclusion for a load; `None` if no curve has an area under it.
    pub(crate) fn new(
        evidence: &Evidence<'_>,
        states: Option<&InterfaceStates<'_>>,
        load: usize,
    ) -> Option<Self> {
        let uncertainty = evidence.uncertainty;
        let given = &evidence.scene.needs.loads[load];
        let headline = evidence.judgement.and_then(|judgement| judgement.headline(load));
        let references = evidence.judgement.map_or_else(Vec::new, |judgement| groups(judgement, load));
        let cells = || references.iter().flat_map(|group| &group.models);
        let best_model = headline
            .and_then(|headline| headline.best_curve)
            .and_then(|best| cells().find(|cell| cell.curve == best).copied());
        let area = match headline {
            Some(headline) => AreaEstimate::from_headline(evidence, headline),
            None => AreaEstimate::from_models(evidence, load)?,
        };
        let mut found = Answer {
            area,
            cause: Cause::Unknown,
            load,
            label: given.label.clone(),
            nominal_pressure_pa: given.nominal_pressure_pa(),
            otherwise: headline.and_then(|headline| OtherHardness::new(headline, &area)),
            best_model,
            tally: Tally::count(&references, leading_reference(headline)),
            references,
            seal: states.and_then(|states| SealUnderLoad::new(states, uncertainty, load)),
            asked: states.map_or_else(Vec::new, |states| {
                Questions { states, uncertainty, load, area: &area }.answers()
            }),
        };
        found.cause = Cause::new(evidence, &found);
        Some(found)
    }

    /// Returns the factor between the areas with a constant hardness and with one that grows at small scales, if it decides: if it
    /// leaves the range, or if only a range is known that is wider than what counts as agreement.
    #[must_use]
    pub fn factor_of_hardness(&self) -> Option<f64> {
        let of_range = || {
            let ratio = self.area.high / self.area.low;
            (self.area.source == Source::Elements(Reference::Growing) && ratio > AGREEMENT).then_some(ratio)
        };
        self.otherwise.map(|other| other.ratio).or_else(of_range)
    }

    /// Returns the curve whose area stands for the elements where these have none, as along the cutoff: the best model, or
    /// else the one nearest to the elements of the estimate.
    #[must_use]
    pub fn nearest_curve(&self) -> Option<usize> {
        let nearest = || self.references.first()?.models.first();
        match self.area.source {
            Source::Model { curve } => Some(curve),
            _ => self.best_model.as_ref().or_else(nearest).map(|cell| cell.curve),
        }
    }
}

impl AreaEstimate {
    fn from_headline(evidence: &Evidence<'_>, headline: &Headline) -> Self {
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
            factor_of_elements: headline.high / headline.low,
            of_inputs: None,
        };
        plain.widened(evidence, headline.load, headline.best_curve)
    }

    fn from_models(evidence: &Evidence<'_>, load: usize) -> Option<Self> {
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
        let plain = AreaEstimate { area_fraction, low, high, source, factor_of_elements, of_inputs: None };
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
        // The interval of a model that does not yield says nothing of bodies that do.
        let yields = matches!(self.source, Source::Elements(Reference::Yielding { .. }));
        let is_alike = |curve: &usize| !yields || curves[*curve].model.entry().has(Choice::Strength);
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

impl OtherHardness {
    fn new(headline: &Headline, area: &AreaEstimate) -> Option<Self> {
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

impl Tally {
    fn count(references: &[ReferenceGroup], leading: Reference) -> Self {
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
fn leading_reference(headline: Option<&Headline>) -> Reference {
    match headline.map(|headline| headline.basis) {
        Some(Basis::Elements(reference)) => reference,
        _ => Reference::Elastic,
    }
}

/// The models of a load by the elements that they are compared with; the elements of the headline come first.
fn groups(judgement: &Judgement, load: usize) -> Vec<ReferenceGroup> {
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

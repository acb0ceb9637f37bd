//! Draws between the computed ones: a polynomial in features of a drawn spectrum and of its bodies says where the logarithm
//! of a result lies, and computed draws near to it say how far the polynomial is off.
//!
//! To draw the inputs takes microseconds, to compute a result up to milliseconds. So many more inputs are drawn than results
//! are computed, and the seed moves the ends of an interval less: what the polynomial explains scatters as if every draw had
//! been computed. A polynomial that explains nothing leaves the computed draws, each counted about as often.

use numerics::line_through;
use numerics::parallel::map;
use spectrum::{Normalisation, cumulative_moments_to};

use crate::inputs::Inputs;
use crate::surface_scatter::DrawOf;

/// Draws of the inputs for each computed one.
const DENSITY: usize = 32;

/// The fewest computed draws for each term of the polynomial.
const DRAWS_PER_TERM: usize = 8;

/// Scales from the median of a feature beyond which the polynomial is linear in it and fits no draw: Student's distribution
/// of few scans reaches very far.
const CURVED_WITHIN: f64 = 3.0;

/// A term that the terms before it explain up to this share of its size is left out.
const DEPENDENT: f64 = 1e-6;

/// Computed draws around a draw whose errors of the polynomial it may take.
const AROUND: usize = 9;

/// Probability below the lower and above the upper quantile at which errors are compared.
const TAIL: f64 = 0.025;

/// Draws of the inputs, of which the first are computed, as terms of a polynomial.
#[derive(Debug)]
pub(crate) struct DenseDraws {
    /// The number of computed draws.
    computed: usize,
    /// The draws whose inputs are in the range of spectra, the computed ones first.
    draws: Vec<usize>,
    /// Terms of the polynomial in each of these draws, orthonormal over the central draws among the computed ones.
    terms: Vec<Vec<f64>>,
    /// Places among `draws` of computed draws whose features are all near their median.
    central: Vec<usize>,
}

/// ln of a quantity in many draws.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DenseValues {
    /// ln of the quantity, in rising order if it was filled up.
    pub values: Vec<f64>,
    /// The standard error of a quantile over the one that as many computed draws would leave, at least 1.
    pub error_factor: f64,
}

impl DenseValues {
    /// The values in computed draws alone.
    pub fn of_computed(values: Vec<f64>) -> Self {
        DenseValues { values, error_factor: 1.0 }
    }
}

impl DenseDraws {
    /// Draws the inputs of `computed` draws, numbered from 0, and of more. `cutoff_m` is the shortest wavelength that takes
    /// part, if the scene sets one.
    pub fn new(inputs: &Inputs, cutoff_m: Option<f64>, computed: usize) -> Self {
        let numbers: Vec<u64> = (0..(DENSITY * computed) as u64).collect();
        let features = map(&numbers, |&draw| features(inputs, cutoff_m, DrawOf::all(draw)));
        Self::from_features(&features, computed)
    }

    fn from_features(features: &[Option<Vec<f64>>], computed: usize) -> Self {
        let draws: Vec<usize> = (0..features.len()).filter(|&draw| features[draw].is_some()).collect();
        let of_draws: Vec<&Vec<f64>> = features.iter().flatten().collect();
        let count = of_draws.first().map_or(0, |first| first.len());
        let scaled: Vec<Vec<f64>> = (0..count)
            .filter_map(|at| scaled(of_draws.iter().map(|features| features[at]).collect()))
            .collect();
        let is_central = |place: &usize| scaled.iter().all(|feature| feature[*place].abs() <= CURVED_WITHIN);
        let central: Vec<usize> =
            (0..draws.len()).take_while(|&place| draws[place] < computed).filter(is_central).collect();
        let terms = orthonormal(polynomial(&scaled, draws.len()), &central);
        DenseDraws { computed, draws, terms, central }
    }

    /// The number of computed draws.
    pub fn computed(&self) -> usize {
        self.computed
    }

    /// Fills up the values of a quantity in the computed draws; `None` has no value.
    pub fn fill(&self, computed: &[Option<f64>]) -> DenseValues {
        let present: Vec<f64> = computed.iter().copied().flatten().collect();
        let as_computed = DenseValues::of_computed(present.clone());
        let varies = present.windows(2).any(|pair| pair[0] != pair[1]);
        let is_enough = self.central.len() >= DRAWS_PER_TERM * self.terms.len();
        if !varies || !is_enough || computed.len() != self.computed {
            return as_computed;
        }
        let mean = present.iter().sum::<f64>() / present.len() as f64;
        let off_mean = |place: usize| computed[self.draws[place]].map_or(0.0, |value| value - mean);
        let mut fitted = vec![mean; self.draws.len()];
        for term in &self.terms {
            let coefficient: f64 = self.central.iter().map(|&place| term[place] * off_mean(place)).sum();
            fitted.iter_mut().zip(term).for_each(|(fitted, term)| *fitted += coefficient * term);
        }
        let of_computed = self.draws.iter().zip(&fitted).take_while(|(draw, _)| **draw < self.computed);
        let known = Known::new(of_computed.map(|(&draw, &fitted)| (fitted, computed[draw])).collect());
        let value = |(draw, &fitted): (usize, &f64)| known.value(fitted, draw);
        let mut values: Vec<f64> = fitted.iter().enumerate().filter_map(value).collect();
        values.sort_by(f64::total_cmp);
        let unexplained = known.unexplained(&values);
        let density = values.len() as f64 / present.len() as f64;
        DenseValues { values, error_factor: (1.0 + unexplained * density).sqrt() }
    }
}

/// Computes the features of a draw: logarithms of the moments of its spectrum, of its ends and of its steepest scale, of its
/// composite modulus and of its strength. `None` out of the range of spectra.
fn features(inputs: &Inputs, cutoff_m: Option<f64>, draw: DrawOf) -> Option<Vec<f64>> {
    let mut features = Vec::new();
    if let Some(psd) = inputs.psd(draw)? {
        let cutoff_m = cutoff_m.unwrap_or(psd.shortest_wavelength_m());
        let moments = *cumulative_moments_to(&psd, Normalisation::Parseval, cutoff_m).last()?;
        features.extend([moments.m0_m2, moments.m2, moments.m4_per_m2]);
        let samples = psd.wavelengths_m().iter().zip(psd.c1d_m3());
        let mut samples = samples.filter(|(wavelength_m, _)| **wavelength_m >= cutoff_m);
        // A stack hangs on the scale whose amplitude is largest over its wavelength, and the waves of a surface on the ends of
        // its spectrum.
        let steepness = samples.clone().map(|(wavelength_m, c1d_m3)| c1d_m3 / wavelength_m.powi(3));
        let (first, last) = (samples.clone().next()?.1, samples.next_back()?.1);
        features.extend([*first, *last, steepness.fold(0.0, f64::max)]);
    }
    if let Some(drawn) = inputs.material(draw) {
        features.extend([drawn.pair.composite_modulus_pa(), drawn.strength_over_centre]);
        features.extend(drawn.strain_gradient_length_m);
    }
    features.iter_mut().for_each(|feature| *feature = feature.ln());
    features.iter().all(|feature| feature.is_finite()).then_some(features)
}

/// Scales a feature to its median and its middle half, as the normal distribution has it; `None` if it does not vary.
fn scaled(mut feature: Vec<f64>) -> Option<Vec<f64>> {
    const MIDDLE_HALF: f64 = 1.349;
    let mut sorted = feature.clone();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted[(share * (sorted.len() - 1) as f64) as usize];
    let (median, middle_half) = (at(0.5), at(0.75) - at(0.25));
    let range = at(1.0) - at(0.0);
    let scale = if middle_half > 0.0 { middle_half / MIDDLE_HALF } else { range };
    feature.iter_mut().for_each(|value| *value = (*value - median) / scale);
    (scale > 0.0).then_some(feature)
}

/// The terms of a polynomial of second degree, which goes on in a straight line beyond the central draws.
fn polynomial(features: &[Vec<f64>], draws: usize) -> Vec<Vec<f64>> {
    let mut terms = vec![vec![1.0; draws]];
    terms.extend(features.iter().cloned());
    let held = |value: f64| value.clamp(-CURVED_WITHIN, CURVED_WITHIN);
    for (at, one) in features.iter().enumerate() {
        let products = features[at..]
            .iter()
            .map(|other| one.iter().zip(other).map(|(one, other)| held(*one) * held(*other)).collect());
        terms.extend(products);
    }
    terms
}

/// Makes terms orthonormal over some of the draws, in their order, and leaves out those that the ones before explain.
fn orthonormal(terms: Vec<Vec<f64>>, over: &[usize]) -> Vec<Vec<f64>> {
    let product =
        |one: &[f64], other: &[f64]| over.iter().map(|&place| one[place] * other[place]).sum::<f64>();
    let mut found: Vec<Vec<f64>> = Vec::new();
    for mut term in terms {
        let size = product(&term, &term).sqrt();
        // Twice is enough to be orthogonal to rounding.
        for _ in 0..2 {
            for before in &found {
                let share = product(before, &term);
                term.iter_mut().zip(before).for_each(|(term, before)| *term -= share * before);
            }
        }
        let left = product(&term, &term).sqrt();
        if left > DEPENDENT * size {
            term.iter_mut().for_each(|value| *value /= left);
            found.push(term);
        }
    }
    found
}

/// Computed draws in the order of their fitted values.
struct Known {
    fitted: Vec<f64>,
    /// `None` for a draw without a value.
    computed: Vec<Option<f64>>,
    /// Slope of the computed against the fitted values around each draw, 1 where the fit is good: it ends where a quantity no
    /// longer changes.
    slopes: Vec<f64>,
}

impl Known {
    fn new(mut pairs: Vec<(f64, Option<f64>)>) -> Self {
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (fitted, computed): (Vec<f64>, Vec<Option<f64>>) = pairs.iter().copied().unzip();
        let slope = |at: usize| {
            let around = &pairs[at.saturating_sub(AROUND)..pairs.len().min(at + AROUND + 1)];
            let line = line_through(around.iter().filter_map(|pair| Some((pair.0, pair.1?))));
            line.map_or(0.0, |line| line.slope.clamp(0.0, 1.0))
        };
        let slopes = (0..pairs.len()).map(slope).collect();
        Known { fitted, computed, slopes }
    }

    /// Returns the value of a draw with a fitted value: that of one of the computed draws around it, draw by draw in turn, moved
    /// along the slope there. If all took the nearest, computed draws in gaps would count for more than others. `None` if the
    /// computed draw has no value.
    fn value(&self, fitted: f64, draw: usize) -> Option<f64> {
        let below = self.fitted.partition_point(|other| *other < fitted);
        let near = (below + draw % AROUND).saturating_sub(AROUND / 2).min(self.fitted.len() - 1);
        Some(self.computed[near]? + self.slopes[near] * (fitted - self.fitted[near]))
    }

    /// Computes the share of the variance of a quantile that the fit leaves to the computed draws: that of the number of draws
    /// below the quantile, given their fitted values, over that of the number of draws without a fit.
    fn unexplained(&self, sorted: &[f64]) -> f64 {
        let off = self.fitted.iter().zip(&self.computed);
        let mut off: Vec<f64> = off.filter_map(|(fitted, computed)| Some((*computed)? - fitted)).collect();
        off.sort_by(f64::total_cmp);
        let at = |probability: f64| sorted[(probability * (sorted.len() - 1) as f64) as usize];
        let of_end = |end: f64| {
            let variance = |fitted: &f64| {
                let below = off.partition_point(|off| fitted + off <= end) as f64 / off.len() as f64;
                below * (1.0 - below)
            };
            self.fitted.iter().map(variance).sum::<f64>() / self.fitted.len() as f64
        };
        (0.5 * (of_end(at(TAIL)) + of_end(at(1.0 - TAIL))) / (TAIL * (1.0 - TAIL))).min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;
    use rand_distr::{Distribution, StandardNormal, StudentT};

    use super::*;
    use crate::quantiles::interval;

    const COMPUTED: usize = 1000;

    /// Draws of two features with long tails, and ln of a quantity that depends on them and on something else.
    fn drawn(seed: u64, unseen: f64) -> (DenseDraws, Vec<Option<f64>>) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let tails = StudentT::new(2.0).unwrap();
        let features: Vec<Option<Vec<f64>>> = (0..DENSITY * COMPUTED)
            .map(|_| Some(vec![0.1 * tails.sample(&mut random), StandardNormal.sample(&mut random)]))
            .collect();
        let mut value = |features: &Vec<f64>| {
            let beside: f64 = StandardNormal.sample(&mut random);
            features[0].tanh() - features[1] + 0.2 * features[0] * features[1] + unseen * beside
        };
        let computed = features[..COMPUTED].iter().flatten().map(|features| Some(value(features))).collect();
        (DenseDraws::from_features(&features, COMPUTED), computed)
    }

    /// Standard deviation of the upper end of the interval over seeds, and the one that is stated, without and with dense draws.
    fn scatter(unseen: f64) -> [(f64, f64); 2] {
        const SEEDS: u64 = 60;
        let mut ends: [Vec<(f64, f64)>; 2] = Default::default();
        for seed in 0..SEEDS {
            let (dense, computed) = drawn(seed, unseen);
            let plain = interval(&computed.iter().copied().flatten().collect::<Vec<_>>(), 0.95).unwrap();
            let filled = dense.fill(&computed);
            let filled = interval(&filled.values, 0.95).unwrap().with_errors_times(filled.error_factor);
            for (ends, found) in ends.iter_mut().zip([plain, filled]) {
                ends.push((found.high.value, found.high.standard_error));
            }
        }
        ends.map(|ends| {
            let count = ends.len() as f64;
            let mean = |of: &dyn Fn(&(f64, f64)) -> f64| ends.iter().map(of).sum::<f64>() / count;
            let middle = mean(&|end| end.0);
            (mean(&|end| (end.0 - middle).powi(2)).sqrt(), mean(&|end| end.1))
        })
    }

    #[test]
    fn ends_scatter_less_by_what_the_features_explain_and_say_so() {
        let [(plain, _), (filled, stated)] = scatter(0.0);
        assert!(filled < 0.35 * plain, "{filled} {plain}");
        assert!((0.6..1.6).contains(&(stated / filled)), "{stated} {filled}");
        // Where features explain little, nothing is lost, and nothing is promised.
        let [(plain, _), (filled, stated)] = scatter(3.0);
        assert!(filled < 1.15 * plain, "{filled} {plain}");
        assert!((0.6..1.6).contains(&(stated / filled)), "{stated} {filled}");
    }

    #[test]
    fn filled_draws_have_the_distribution_of_many_computed_ones() {
        let (dense, computed) = drawn(7, 0.3);
        let found = interval(&dense.fill(&computed).values, 0.95).unwrap();
        let mut random = ChaCha8Rng::seed_from_u64(8);
        let tails = StudentT::new(2.0).unwrap();
        let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
        let mut tails_random = ChaCha8Rng::seed_from_u64(9);
        let many: Vec<f64> = (0..200_000)
            .map(|_| {
                let (one, other): (f64, f64) = (0.1 * tails.sample(&mut tails_random), normal());
                one.tanh() - other + 0.2 * one * other + 0.3 * normal()
            })
            .collect();
        let expected = interval(&many, 0.95).unwrap();
        let length = expected.high.value - expected.low.value;
        for (found, expected) in [(found.low, expected.low), (found.median, expected.median)] {
            assert!((found.value - expected.value).abs() < 0.02 * length, "{found:?} {expected:?}");
        }
        assert!((found.high.value - expected.high.value).abs() < 0.02 * length, "{found:?}");
    }

    #[test]
    fn few_draws_and_draws_that_do_not_vary_stay_as_they_are() {
        let features = vec![Some(vec![0.0]); DENSITY * 30];
        let dense = DenseDraws::from_features(&features, 30);
        let same = vec![Some(2.0); 30];
        assert_eq!(dense.fill(&same), DenseValues { values: vec![2.0; 30], error_factor: 1.0 });
        let nothing = DenseDraws::from_features(&vec![None; DENSITY * 30], 30);
        assert_eq!(nothing.fill(&[Some(1.0), None, Some(3.0)]).values, [1.0, 3.0]);
    }
}

//! Intervals from draws, and their Monte Carlo errors.

use std::f64::consts::LN_2;

use statrs::distribution::{Continuous, ContinuousCDF, Normal};

/// The largest distance of a result from the middle of its draws that counts, in standard deviations.
const FARTHEST: f64 = 0.5;

/// A quantile of draws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantile {
    /// The quantile.
    pub value: f64,
    /// Its standard error, which more draws would shrink.
    pub standard_error: f64,
}

/// An interval with as many draws below it as above, and their median.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub low: Quantile,
    /// The median.
    pub median: Quantile,
    /// The upper end.
    pub high: Quantile,
    /// The standard error of the length high - low.
    pub length_standard_error: f64,
}

impl Interval {
    /// The standard error of the length as a share of it; 0 if the draws differ by rounding alone. For draws of ln A this is the
    /// relative error of ln(high/low), and no end is known less well.
    pub fn relative_error(&self) -> f64 {
        const ROUNDING: f64 = 1e-12;
        let length = self.high.value - self.low.value;
        if length > ROUNDING { self.length_standard_error / length } else { 0.0 }
    }
}

/// Computes the equal-tailed interval that holds a share `level` of the draws (above 0, below 1); `None` without draws.
///
/// Quantiles are the eighth of Hyndman & Fan 1996 (Am. Stat. 50:361), whose median is the true quantile whatever the
/// distribution. Draws give no information beyond the first and the last of them, so an end beyond these is the first
/// or last draw. The number of draws below a true quantile is binomial: a standard error is half the distance between
/// the draws one standard deviation of that number to either side. With two or three draws beyond an end (95 % of 100)
/// it is rather too large.
///
/// JCGM 101:2008 (7.2) suggests 10^4/(1 - level) draws, 200,000 for 95 %, for one or two digits of the standard
/// uncertainty without a check. Its adaptive procedure (7.9) stops when twice the standard error is below the required
/// one. Here the number of draws is given and the error reported.
pub fn interval(draws: &[f64], level: f64) -> Option<Interval> {
    let mut sorted = draws.to_vec();
    sorted.sort_by(f64::total_cmp);
    if sorted.is_empty() {
        return None;
    }
    let below = (1.0 - level) / 2.0;
    let low = quantile(&sorted, below);
    let high = quantile(&sorted, 1.0 - below);
    // Both ends rest on the same draws: the numbers below them are correlated by below/(1 - below).
    let correlation = below / (1.0 - below);
    Some(Interval {
        low,
        median: quantile(&sorted, 0.5),
        high,
        length_standard_error: error_of_difference(low.standard_error, high.standard_error, correlation),
    })
}

/// Computes the standard error of the difference of two values with a correlation from 0 to 1.
fn error_of_difference(first: f64, second: f64, correlation: f64) -> f64 {
    // (a - b)^2 + 2 (1 - r) a b neither overflows nor cancels.
    (first - second).hypot((2.0 * (1.0 - correlation)).sqrt() * first.sqrt() * second.sqrt())
}

/// Mirrors the logarithm of a share A about another one, on the scale ln(-ln(1 - A)), nearly ln A for small shares, on which
/// it stays below 1. A share of 1 or more, which theories without a limit give, has no such scale: its logarithm is mirrored.
fn mirrored(ln_share: f64, ln_centre: f64) -> f64 {
    if ln_share >= 0.0 || ln_centre >= 0.0 {
        return 2.0 * ln_centre - ln_share;
    }
    bounded(2.0 * unbounded(ln_centre) - unbounded(ln_share))
}

/// Logarithm of a share below which it agrees with -ln(1 - A) to rounding.
const SMALL: f64 = -40.0;

/// Computes ln(-ln(1 - A)) from ln A < 0, to full precision at both ends.
fn unbounded(ln_share: f64) -> f64 {
    if ln_share < SMALL {
        return ln_share;
    }
    let ln_rest = if ln_share > -LN_2 { (-ln_share.exp_m1()).ln() } else { (-ln_share.exp()).ln_1p() };
    (-ln_rest).ln()
}

/// Inverts [`unbounded`].
fn bounded(unbounded: f64) -> f64 {
    if unbounded < SMALL {
        return unbounded;
    }
    let ln_rest = -unbounded.exp();
    if ln_rest < -LN_2 { (-ln_rest.exp()).ln_1p() } else { (-ln_rest.exp_m1()).ln() }
}

/// Computes the interval of the logarithm of an area about the result of the best estimates: each end is the mean of the ends
/// of two intervals.
///
/// * The percentiles of the draws, corrected for bias (`percentiles_about`). From few scans, the truth lies above them
///   more often than below.
/// * The draws mirrored about the result ("basic" bootstrap, Davison & Hinkley 1997, Bootstrap Methods and their
///   Application, 5.2.1), on the logarithmic scale. They are exact if the result is a scale parameter, as is the mean
///   square height if a single wave dominates. From few scans, the truth lies below them more often than above.
///
/// The mean was chosen on synthetic studies, in which it misses to one side about as often as to the other
/// (`docs/theory/intervals.md`). A result beyond all draws counts as the outermost.
pub fn area_interval_about(best: f64, draws: &[f64], level: f64) -> Option<Interval> {
    let percentiles = percentiles_about(best, draws, level)?;
    let plain = interval(draws, level)?;
    if plain.low.value == plain.high.value {
        return Some(plain);
    }
    let lowest = draws.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = draws.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let centre = best.clamp(lowest, highest);
    // Where no draw is above full contact, a mirror image about full contact is not either.
    let limit = if highest <= 0.0 { 0.0 } else { f64::INFINITY };
    let mean = |end: Quantile, other: Quantile| Quantile {
        value: (0.5 * (end.value + mirrored(other.value, centre))).min(limit),
        standard_error: 0.5 * (end.standard_error + other.standard_error),
    };
    Some(Interval {
        low: mean(percentiles.low, plain.high),
        median: mean(percentiles.median, plain.median),
        high: mean(percentiles.high, plain.low),
        length_standard_error: 0.5 * (percentiles.length_standard_error + plain.length_standard_error),
    })
}

/// Computes the percentiles about the result of the best estimates, corrected for bias: a result off the middle of its
/// draws lies as far off the middle of its interval. With z0 the normal quantile of the share of draws below the
/// result, the quantiles are those of the normal probabilities 2 z0 - z, 2 z0 and 2 z0 + z (Efron 1981, Can. J. Stat.
/// 9:139). Smooth results with little scatter lie in the middle of their draws, and their interval is that of
/// [`interval`]. Largest values, and moments of inputs that scatter by factors, do not.
///
/// z0 is limited to half a standard deviation. If a result is the larger or the smaller of two that nearly agree, z0
/// follows its own error, and twice z0 would lead away from the truth. Synthetic studies confirm the limit
/// (`docs/theory/intervals.md`): with it, intervals hold the truth as often as they should, for spectra of all slopes.
pub(crate) fn percentiles_about(best: f64, draws: &[f64], level: f64) -> Option<Interval> {
    let plain = interval(draws, level)?;
    if plain.low.value == plain.high.value {
        return Some(plain);
    }
    let count = draws.len() as f64;
    let below = draws.iter().filter(|draw| **draw < best).count() as f64;
    let equal = draws.iter().filter(|draw| **draw == best).count() as f64;
    let share = (below + 0.5 * equal) / count;
    let normal = Normal::standard();
    let off = normal.inverse_cdf(share).clamp(-FARTHEST, FARTHEST);
    let half = normal.inverse_cdf(0.5 + 0.5 * level);
    let mut sorted = draws.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |deviate: f64| quantile(&sorted, normal.cdf(2.0 * off + deviate));
    // The standard error of the share moves both ends together.
    let is_told = off.abs() < FARTHEST;
    let off_error = if is_told { (share * (1.0 - share) / count).sqrt() / normal.pdf(off) } else { 0.0 };
    let moved = |end: Quantile| {
        let by_off = 2.0 * off_error * (plain.high.value - plain.low.value) / (2.0 * half);
        Quantile { standard_error: end.standard_error.hypot(by_off), ..end }
    };
    let (low, high) = (at(-half), at(half));
    // The length is known no better than that of the plain interval, whose ends are farther from the outermost draws.
    let of_ends = low.standard_error.hypot(high.standard_error);
    let length_standard_error = of_ends.max(plain.length_standard_error);
    Some(Interval { low: moved(low), median: moved(at(0.0)), high: moved(high), length_standard_error })
}

fn quantile(sorted: &[f64], probability: f64) -> Quantile {
    let n = sorted.len() as f64;
    let rank = ((n + 1.0 / 3.0) * probability + 1.0 / 3.0).clamp(1.0, n);
    let scatter = (n * probability * (1.0 - probability)).sqrt();
    let (before, after) = ((rank - scatter).max(1.0), (rank + scatter).min(n));
    let standard_error = if after > before {
        (at_rank(sorted, after) - at_rank(sorted, before)) * scatter / (after - before)
    } else {
        0.0
    };
    Quantile { value: at_rank(sorted, rank), standard_error }
}

/// The value at a rank, from 1 on, interpolated between the draws on either side.
fn at_rank(sorted: &[f64], rank: f64) -> f64 {
    let below = rank.floor();
    let share = rank - below;
    let first = sorted[below as usize - 1];
    if share > 0.0 { first + share * (sorted[below as usize] - first) } else { first }
}

#[cfg(test)]
mod tests {
    use chacha20::ChaCha8Rng;
    use chacha20::rand_core::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    use super::{area_interval_about, interval, mirrored, percentiles_about};

    /// Quantile of the normal distribution at 97.5 %.
    const HIGH: f64 = 1.959_963_984_540_054;

    fn normal(draws: usize, seed: u64) -> Vec<f64> {
        let random = ChaCha8Rng::seed_from_u64(seed);
        StandardNormal.sample_iter(random).take(draws).collect()
    }

    #[test]
    fn the_ends_are_those_of_the_normal_distribution() {
        let found = interval(&normal(100_000, 1), 0.95).unwrap();
        for (quantile, expected) in [(found.low, -HIGH), (found.median, 0.0), (found.high, HIGH)] {
            assert!((quantile.value - expected).abs() < 3.0 * quantile.standard_error, "{found:?}");
            assert!(quantile.standard_error < 0.012, "{found:?}");
        }
    }

    #[test]
    fn ranks_are_those_of_the_eighth_definition() {
        // For the values 1 to 20 a quantile equals its rank: (20 + 1/3) p + 1/3.
        let found = interval(&(1..=20).map(f64::from).rev().collect::<Vec<_>>(), 0.8).unwrap();
        for (quantile, probability) in [(found.low, 0.1), (found.median, 0.5), (found.high, 0.9)] {
            let expected = (20.0 + 1.0 / 3.0) * probability + 1.0 / 3.0;
            assert!((quantile.value - expected).abs() < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn stated_errors_are_the_scatter_of_repeats() {
        const REPEATS: usize = 400;
        // Four standard errors of a share of 400 are 0.09; of 100 draws two or three lie beyond an end.
        for (draws, at_most) in [(100, 0.85), (1000, 0.77)] {
            let repeats: Vec<_> =
                (0..REPEATS).map(|seed| interval(&normal(draws, seed as u64), 0.95).unwrap()).collect();
            let covered = |held: &dyn Fn(&super::Interval) -> bool| {
                repeats.iter().filter(|found| held(found)).count() as f64 / REPEATS as f64
            };
            let within = |quantile: super::Quantile, truth: f64| {
                (quantile.value - truth).abs() < quantile.standard_error
            };
            for covered in [
                covered(&|found| within(found.low, -HIGH)),
                covered(&|found| within(found.median, 0.0)),
                covered(&|found| within(found.high, HIGH)),
                covered(&|found| {
                    (found.high.value - found.low.value - 2.0 * HIGH).abs() < found.length_standard_error
                }),
            ] {
                assert!((0.59..at_most).contains(&covered), "{draws}: {covered}");
            }
        }
    }

    #[test]
    fn an_interval_holds_the_next_draw_as_often_as_it_says() {
        const REPEATS: u64 = 2000;
        let held = |seed: &u64| {
            let mut draws = normal(201, *seed);
            let next = draws.pop().unwrap();
            let found = interval(&draws, 0.9).unwrap();
            found.low.value < next && next < found.high.value
        };
        let held = (0..REPEATS).filter(held).count() as f64 / REPEATS as f64;
        assert!((held - 0.9).abs() < 0.02, "{held}");
    }

    #[test]
    fn draws_that_do_not_differ_have_no_error() {
        for draws in [1, 2, 1000] {
            let found = interval(&vec![0.25; draws], 0.95).unwrap();
            assert_eq!([found.low.value, found.median.value, found.high.value], [0.25; 3]);
            assert_eq!(
                [found.low.standard_error, found.length_standard_error, found.relative_error()],
                [0.0; 3]
            );
        }
        assert_eq!(interval(&[], 0.95), None);
        let rounded: Vec<f64> = (0..100).map(|at| 0.25 + f64::from(at % 2) * f64::EPSILON).collect();
        assert_eq!(interval(&rounded, 0.95).unwrap().relative_error(), 0.0);
    }

    #[test]
    fn few_draws_end_at_the_outermost() {
        let found = interval(&[3.0, 1.0, 2.0], 0.95).unwrap();
        assert_eq!([found.low.value, found.median.value, found.high.value], [1.0, 2.0, 3.0]);
        assert!(found.relative_error() > 0.0);
    }

    #[test]
    fn an_interval_lies_on_the_other_side_of_a_result_than_its_draws() {
        let mut numbers = ChaCha8Rng::seed_from_u64(5);
        let mut normal = || -> f64 { StandardNormal.sample(&mut numbers) };
        let (best, off) = (3.0, 0.3);
        let draws: Vec<f64> = (0..4001).map(|_| best + off + normal()).collect();
        let found = area_interval_about(best, &draws, 0.95).unwrap();
        let middle = best - off;
        for (end, expected) in
            [(found.low, middle - HIGH), (found.median, middle), (found.high, middle + HIGH)]
        {
            assert!((end.value - expected).abs() < 3.0 * end.standard_error, "{end:?} {expected}");
        }
        let same = area_interval_about(2.0, &[2.0; 50], 0.95).unwrap();
        assert_eq!((same.low.value, same.high.value, same.relative_error()), (2.0, 2.0, 0.0));
        // Beyond all draws it counts as half a standard deviation.
        let beyond = percentiles_about(1e3, &draws, 0.95).unwrap();
        assert!((beyond.median.value - (best + off + 1.0)).abs() < 0.1, "{beyond:?}");
    }

    #[test]
    fn mirrored_shares_stay_below_one() {
        let draws: Vec<f64> = normal(2001, 3).iter().map(|draw| (0.6 + 0.1 * draw.tanh()).ln()).collect();
        for best in [0.69f64.ln(), 0.6f64.ln()] {
            let found = area_interval_about(best, &draws, 0.95).unwrap();
            assert!(
                found.low.value < found.median.value && found.median.value < found.high.value,
                "{found:?}"
            );
            assert!(found.high.value < 0.0, "{found:?}");
        }
        // Full contact in the best estimate and in a part of the draws.
        let draws: Vec<f64> =
            (0..100).map(|at| if at < 60 { 0.0 } else { -0.01 * f64::from(at - 59) }).collect();
        let found = area_interval_about(0.0, &draws, 0.95).unwrap();
        assert!(found.low.value < 0.0 && found.high.value == 0.0, "{found:?}");
        // Small shares are mirrored as their logarithms.
        assert!((mirrored(-12.0, -11.0) + 10.0).abs() < 1e-4);
    }
}

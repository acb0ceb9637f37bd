//! Where a function with square roots before its knots is sampled, so that power laws between the samples follow it.

/// Steps more than smoothness asks for, by which the last ones before the knot become short.
const STEPS_TO_KNOT: usize = 6;
/// An interval narrower than this in ln q belongs to a dense spectrum, which is sampled well enough by its own samples.
const DENSE: f64 = 0.02;

/// Wavevectors inside the interval from `start` to the knot `end`, without either, in steps of at most `widest` in ln q
/// that close up to the knot: both the integrals of a spectrum with a kink and those of one with an end behave there like
/// the root of the distance.
pub(crate) fn before_knot(start: f64, end: f64, widest: f64) -> impl Iterator<Item = f64> {
    let ln_ratio = (end / start).ln();
    // The first of the steps, whose sums are squares, is less than twice as wide as their mean.
    let steps = if ln_ratio < DENSE { 1 } else { STEPS_TO_KNOT + (2.0 * ln_ratio / widest).ceil() as usize };
    (1..steps).map(move |step| {
        let left = 1.0 - step as f64 / steps as f64;
        end * (-ln_ratio * left * left).exp()
    })
}

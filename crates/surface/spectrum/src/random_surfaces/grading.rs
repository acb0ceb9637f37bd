//! Sample points for functions with square roots at their knots, dense enough for power laws between the samples.

/// Steps beyond those that smoothness needs; they make the last steps before the knot short.
const STEPS_TO_KNOT: usize = 6;
/// Width in ln q below which the samples of a spectrum are dense enough by themselves.
const DENSE: f64 = 0.02;

/// Yields wavevectors strictly between `start` and the knot `end`, in steps of at most `widest` in ln q that shrink
/// towards the knot. There, integrals of a spectrum with a kink or an end behave like the square root of the distance.
pub(crate) fn before_knot(start: f64, end: f64, widest: f64) -> impl Iterator<Item = f64> {
    let ln_ratio = (end / start).ln();
    // Positions are squares, so the first step is less than twice as wide as the mean.
    let steps = if ln_ratio < DENSE { 1 } else { STEPS_TO_KNOT + (2.0 * ln_ratio / widest).ceil() as usize };
    (1..steps).map(move |step| {
        let left = 1.0 - step as f64 / steps as f64;
        end * (-ln_ratio * left * left).exp()
    })
}

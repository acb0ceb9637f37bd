//! Newton's method held inside a bracket.

/// The zero of `f` in [low, high], where f(low) <= 0 <= f(high); `f` returns its value and its derivative.
///
/// Newton steps from `start`, and a bisection wherever a step would leave the bracket, which shrinks at every step.
/// The result is exact to rounding: Newton's steps square their error, so that the first one below 1e-10 of the argument
/// is the last (waiting for one that changes nothing cost a quarter of all evaluations), and bisection goes on to the
/// last place.
pub(crate) fn newton_in_bracket(
    mut low: f64,
    mut high: f64,
    start: f64,
    mut f: impl FnMut(f64) -> (f64, f64),
) -> f64 {
    // Bisection alone exhausts the doubles of any bracket of one sign in about 60 steps once exponents agree.
    const MOST_STEPS: usize = 200;
    const LAST_STEP: f64 = 1e-10;
    let mut x = start.clamp(low, high);
    for _ in 0..MOST_STEPS {
        let (value, slope) = f(x);
        if value == 0.0 {
            return x;
        }
        if value < 0.0 {
            low = x
        } else {
            high = x
        }
        let newton = x - value / slope;
        let inside = low < newton && newton < high;
        let next = if inside { newton } else { 0.5 * (low + high) };
        let settled = (next - x).abs() <= if inside { LAST_STEP } else { f64::EPSILON } * x.abs();
        x = next;
        if settled {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::newton_in_bracket;

    #[test]
    fn a_simple_zero_is_found_to_rounding() {
        let root = newton_in_bracket(0.0, 10.0, 1.0, |x| (x * x - 2.0, 2.0 * x));
        assert!((root - 2f64.sqrt()).abs() < 4e-16);
    }

    #[test]
    fn steps_that_would_leave_the_bracket_are_replaced() {
        // Newton alone diverges on atan from 3.
        let root =
            newton_in_bracket(-20.0, 3.5, 3.0, |x: f64| ((x - 1.0).atan(), 1.0 / (1.0 + (x - 1.0).powi(2))));
        assert!((root - 1.0).abs() < 1e-15);
    }
}

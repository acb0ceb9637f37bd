//! Zeros of functions that change sign once in a bracket. Every method keeps the bracket and so cannot diverge.

/// Finds the zero of a function in [low, high] by Newton's method; requires f(low) <= 0 <= f(high).
///
/// `f` returns the value and the derivative. Newton's method starts at `start`; a step that would leave the bracket is
/// replaced by a bisection, and every step shrinks the bracket. The result is exact to rounding: Newton steps square
/// their error, so the first one below 1e-10 of the argument is the last (waiting for a step of zero cost a quarter of
/// all evaluations); bisection continues to the last place.
#[must_use]
pub fn newton_in_bracket(
    mut low: f64,
    mut high: f64,
    start: f64,
    mut f: impl FnMut(f64) -> (f64, f64),
) -> f64 {
    // Bisection alone exhausts the doubles in a bracket of one sign in about 60 steps once exponents agree.
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

/// Finds the zero of `f` in [low, high] to rounding; f has opposite signs at the ends.
///
/// Uses the secant of Anderson & Bjorck, which keeps the bracket, and a bisection whenever three steps have not halved
/// it.
#[must_use]
pub fn zero_in_bracket(low: f64, high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    // On a plateau secants gain nothing and only every third to sixth step halves the bracket; 60 halvings are needed.
    const MOST_STEPS: usize = 400;
    let (mut a, mut b) = (low, high);
    let (mut at_a, mut at_b) = (f(a), f(b));
    let mut due = 0.5 * (b - a).abs();
    for step in 1..MOST_STEPS {
        if at_b == 0.0 || (b - a).abs() <= f64::EPSILON * b.abs() {
            return b;
        }
        let secant = b - at_b * ((b - a) / (at_b - at_a));
        // A secant that does not move is next to the zero, or f(b) is tiny beside a jump. A step across b decides.
        let least = f64::EPSILON * b.abs();
        let secant = if (secant - b).abs() < least { b + least.copysign(a - b) } else { secant };
        let x = if step % 3 == 0 && (b - a).abs() > due { 0.5 * (a + b) } else { secant };
        if step % 3 == 0 {
            due = 0.5 * (b - a).abs();
        }
        let at_x = f(x);
        if at_x.signum() == at_b.signum() {
            let shrink = 1.0 - at_x / at_b;
            at_a *= if shrink > 0.0 { shrink } else { 0.5 };
        } else {
            (a, at_a) = (b, at_b);
        }
        (b, at_b) = (x, at_x);
    }
    b
}

/// Finds the boundary between failing and holding of a condition by bisection; returns the holding side.
///
/// Halves the bracket until it is narrower than `tolerance` times the returned end. `holds` is not evaluated at the
/// ends: the condition must fail at `fails_at` and hold at `holds_at`, in either order.
#[must_use]
pub fn bisect(fails_at: f64, holds_at: f64, tolerance: f64, mut holds: impl FnMut(f64) -> bool) -> f64 {
    let (mut without, mut with) = (fails_at, holds_at);
    while (with - without).abs() > tolerance * with.abs() {
        let middle = 0.5 * (without + with);
        if middle == without || middle == with {
            break;
        }
        if holds(middle) { with = middle } else { without = middle }
    }
    with
}

#[cfg(test)]
mod tests {
    use super::{bisect, newton_in_bracket, zero_in_bracket};

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

    #[test]
    fn zeros_are_found_to_rounding_in_few_steps() {
        for (low, high, zero, f) in [
            (0.0, 2.0, 2f64.sqrt(), (|x| x * x - 2.0) as fn(f64) -> f64),
            (-30.0, 5.0, 0.0, |x| x.exp_m1()),
            (1e-3, 1e3, 1.0, |x| x.ln()),
            (-1.0, 3.0, 1.0, |x| (x - 1.0).powi(3)),
        ] {
            let mut calls = 0;
            let found = zero_in_bracket(low, high, |x| {
                calls += 1;
                f(x)
            });
            let within = if zero == 1.0 && low == -1.0 { 1e-5 } else { 1e-15 };
            assert!((found - zero).abs() <= within, "{found} after {calls}");
            assert!(calls < 60, "{calls}");
        }
    }

    #[test]
    fn a_jump_is_located_from_a_side_that_is_nearly_zero() {
        let found = zero_in_bracket(1.0, 3.0, |x| if x < 2.5 { 1e-17 * (x - 3.0) } else { 0.1 });
        assert!((found - 2.5).abs() < 1e-15, "{found}");
    }

    #[test]
    fn a_sign_that_jumps_is_located_between_neighbours() {
        let found = zero_in_bracket(0.0, 1.0, |x| if x < 0.3 { -1.0 } else { 2.0 });
        assert!((found - 0.3).abs() < 1e-15);
    }

    #[test]
    fn a_boundary_is_found_from_either_side() {
        let above = bisect(1.0, 8.0, 1e-6, |x| x > 3.0);
        assert!(3.0 < above && above <= 3.0 * (1.0 + 1e-6), "{above}");
        let below = bisect(8.0, 1.0, 1e-6, |x| x < 3.0);
        assert!((3.0 * (1.0 - 2e-6)..3.0).contains(&below), "{below}");
    }

    #[test]
    fn bisection_without_tolerance_ends_between_neighbours() {
        assert_eq!(bisect(-1.0, 8.0, 0.0, |x| x >= 3.0), 3.0);
        assert_eq!(bisect(-1.0, 8.0, 0.0, |x| x > 3.0), 3f64.next_up());
    }
}

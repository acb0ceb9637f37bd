//! Zeros of functions that change sign once in a bracket. Every method keeps the bracket and so cannot diverge.

/// Finds the zero of a function in [low, high] by Newton's method; requires f(low) <= 0 <= f(high).
///
/// `f` returns the value and the derivative. Newton's method starts at `start`; a step that would leave the bracket is
/// replaced by a bisection, and every step shrinks the bracket. The result is exact to rounding: Newton steps square
/// their error, so the first one below 1e-10 of the argument is the last (waiting for a step of zero cost a quarter of
/// all evaluations); bisection continues to the last place.
#[must_use]
pub fn newton_in_bracket(low: f64, high: f64, start: f64, mut f: impl FnMut(f64) -> (f64, f64)) -> f64 {
    let mut search = NewtonSearch { low, high, x: start.clamp(low, high) };
    for _ in 0..MOST_NEWTON_STEPS {
        let (value, slope) = f(search.x);
        let is_last;
        (search, is_last) = search.step(value, slope);
        if is_last {
            break;
        }
    }
    search.x
}

/// Finds the zeros of N functions with the digits of [`newton_in_bracket`]. A step takes all N searches together, which
/// the compiler turns into vectors.
///
/// `f` returns the value and the derivative of the function of an index. It is evaluated for searches that have ended,
/// too, and must not have a branch. A bracket that is a single number yields that number after one step; NaN stays NaN.
#[inline(always)]
#[must_use]
pub fn newton_in_brackets<const N: usize>(
    mut lows: [f64; N],
    mut highs: [f64; N],
    starts: [f64; N],
    f: impl Fn(usize, f64) -> (f64, f64),
) -> [f64; N] {
    const OPEN: u64 = u64::MAX;
    let mut xs = starts;
    for ((x, &low), &high) in xs.iter_mut().zip(&lows).zip(&highs) {
        *x = if *x < low { low } else { *x };
        *x = if *x > high { high } else { *x };
    }
    let mut open = [OPEN; N];
    for _ in 0..MOST_NEWTON_STEPS {
        let mut any_open = 0;
        for i in 0..N {
            let (value, slope) = f(i, xs[i]);
            let (next, is_last) = NewtonSearch { low: lows[i], high: highs[i], x: xs[i] }.step(value, slope);
            xs[i] = if open[i] == OPEN { next.x } else { xs[i] };
            (lows[i], highs[i]) = (next.low, next.high);
            open[i] &= if is_last { 0 } else { OPEN };
            any_open |= open[i];
        }
        if any_open == 0 {
            break;
        }
    }
    xs
}

/// Bisection alone exhausts the doubles in a bracket of one sign in about 60 steps once exponents agree.
const MOST_NEWTON_STEPS: usize = 200;

/// Search by Newton's method between two steps.
#[derive(Debug, Clone, Copy)]
struct NewtonSearch {
    low: f64,
    high: f64,
    x: f64,
}

impl NewtonSearch {
    /// Returns the search after a step from value and slope at `x`, and true if that step is the last. Has no branch.
    #[inline(always)]
    fn step(self, value: f64, slope: f64) -> (Self, bool) {
        const LAST_STEP: f64 = 1e-10;
        let NewtonSearch { low, high, x } = self;
        let low = if value < 0.0 { x } else { low };
        let high = if value < 0.0 { high } else { x };
        let newton = x - value / slope;
        let inside = (low < newton) & (newton < high);
        let next = if inside { newton } else { 0.5 * (low + high) };
        let is_zero = value == 0.0;
        let settled = (next - x).abs() <= if inside { LAST_STEP } else { f64::EPSILON } * x.abs();
        (NewtonSearch { low, high, x: if is_zero { x } else { next } }, is_zero | settled)
    }
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
    use super::{bisect, newton_in_bracket, newton_in_brackets, zero_in_bracket};

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
    fn zeros_found_together_have_the_digits_of_each_alone() {
        let of = |target: f64| move |x: f64| (x.atan() + 0.01 * x - target, 1.0 / (1.0 + x * x) + 0.01);
        let targets: [f64; 64] = std::array::from_fn(|i| 0.3 * (i as f64 - 31.0));
        let start = 3.0;
        let found = newton_in_brackets([-1e4; 64], [1e4; 64], [start; 64], |i, x| of(targets[i])(x));
        for (target, found) in targets.into_iter().zip(found) {
            let alone = newton_in_bracket(-1e4, 1e4, start, of(target));
            assert_eq!(found.to_bits(), alone.to_bits(), "{target}: {found} {alone}");
        }
        assert_eq!(newton_in_brackets([-2.5], [-2.5], [-2.5], |_, x| (x, 1.0)), [-2.5]);
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

//! The zero of a function known to change its sign, and the minimum of one known to have a single one.

/// The zero of `f` in [low, high], f having opposite signs at the ends, to rounding.
///
/// The secant of Anderson & Bjorck, which keeps the bracket, with a bisection whenever three steps have not halved it.
pub(crate) fn in_bracket(low: f64, high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    // Against a plateau secants gain nothing, and only every third to sixth step halves the bracket: sixty halvings.
    const MOST_STEPS: usize = 400;
    let (mut a, mut b) = (low, high);
    let (mut at_a, mut at_b) = (f(a), f(b));
    let mut due = 0.5 * (b - a).abs();
    for step in 1..MOST_STEPS {
        if at_b == 0.0 || (b - a).abs() <= f64::EPSILON * b.abs() {
            return b;
        }
        let secant = b - at_b * ((b - a) / (at_b - at_a));
        // A secant that does not move is right next to the zero, or small at b beside a jump: a step across tells which.
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

/// Where a function with one minimum in [low, high] has it, by golden sections; the upper end of the last of them.
pub(crate) fn minimum(low: f64, high: f64, steps: usize, f: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let inside = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let (mut low, mut high) = (low, high);
    let [mut left, mut right] = inside(low, high);
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..steps {
        if at_left < at_right {
            high = right;
            (right, at_right) = (left, at_left);
            left = inside(low, high)[0];
            at_left = f(left);
        } else {
            low = left;
            (left, at_left) = (right, at_right);
            right = inside(low, high)[1];
            at_right = f(right);
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::{in_bracket, minimum};

    #[test]
    fn a_minimum_is_found_inside_and_at_the_ends() {
        assert!((minimum(-1.0, 3.0, 60, |x| (x - 0.3).powi(2)) - 0.3).abs() < 1e-7);
        assert_eq!(minimum(-1.0, 3.0, 90, |x| -x), 3.0);
        assert!((minimum(-1.0, 3.0, 90, |x| x) + 1.0).abs() < 1e-15);
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
            let found = in_bracket(low, high, |x| {
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
        let found = in_bracket(1.0, 3.0, |x| if x < 2.5 { 1e-17 * (x - 3.0) } else { 0.1 });
        assert!((found - 2.5).abs() < 1e-15, "{found}");
    }

    #[test]
    fn a_sign_that_jumps_is_located_between_neighbours() {
        let found = in_bracket(0.0, 1.0, |x| if x < 0.3 { -1.0 } else { 2.0 });
        assert!((found - 0.3).abs() < 1e-15);
    }
}

//! The minimum of a unimodal function.

/// Locates the minimum of a function that has a single one in [low, high] by golden-section search.
///
/// Returns the upper end of the bracket after `steps` sections.
#[must_use]
pub fn minimum_in_bracket(low: f64, high: f64, steps: usize, f: impl Fn(f64) -> f64) -> f64 {
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
    use super::minimum_in_bracket;

    #[test]
    fn a_minimum_is_found_inside_and_at_the_ends() {
        assert!((minimum_in_bracket(-1.0, 3.0, 60, |x| (x - 0.3).powi(2)) - 0.3).abs() < 1e-7);
        assert_eq!(minimum_in_bracket(-1.0, 3.0, 90, |x| -x), 3.0);
        assert!((minimum_in_bracket(-1.0, 3.0, 90, |x| x) + 1.0).abs() < 1e-15);
    }
}

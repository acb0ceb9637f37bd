//! Projection of pressures onto a load and bounds.

use multiversion::multiversion;

use crate::half_space::sums;

/// Projects `values` onto the values between 0 and `cap` that add up to `sum`, which is between 0 and `cap` times
/// their number. The nearest such values are shifted alike and then limited.
#[multiversion(targets("x86_64+avx2"))]
pub(crate) fn bring_to_sum(values: &mut [f64], cap: f64, sum: f64) {
    if values.is_empty() {
        return;
    }
    let [least, largest] = ends(values);
    // Below the first nothing is carried, above the second every value carries more than its share.
    let bracket = [-largest, sum / values.len() as f64 - least];
    let mut shift = shift_to_sum(values, cap, sum, bracket);
    let [carried] = sums::over_values(values, |value| [limited(value + shift, cap)]);
    let missing_at_cap = cap * values.len() as f64 - sum;
    if (sum - carried).abs() > LOST * sum.min(missing_at_cap) {
        // A last place of the shift carries more than the sum, or what is missing at the cap, allows. Shifted values tell
        // which of them are beside a bound, and the rest of the shift has digits of its own.
        values.iter_mut().for_each(|value| *value += shift);
        let last_places = 8.0 * f64::EPSILON * largest.abs().max(least.abs()).max(shift.abs());
        shift = shift_to_sum(values, cap, sum, [-last_places, last_places]);
    }
    values.iter_mut().for_each(|value| *value = limited(*value + shift, cap));
    let is_between = |value: f64| (0.0 < value) & (value < cap);
    let [carried, between] =
        sums::over_values(values, |value| [value, if is_between(value) { 1.0 } else { 0.0 }]);
    // The shift has the rounding of values that may be far larger than their remainders.
    let rest = (sum - carried) / between;
    if between > 0.0 && rest != 0.0 {
        values
            .iter_mut()
            .for_each(|value| *value = if is_between(*value) { limited(*value + rest, cap) } else { *value });
    }
}

/// Limits a value to \[0, cap\].
#[inline(always)]
fn limited(value: f64, cap: f64) -> f64 {
    let value = if value < 0.0 { 0.0 } else { value };
    if value > cap { cap } else { value }
}

/// Shift after which `values`, limited to \[0, cap\], add up to `sum`.
///
/// Newton's method, which is exact once it knows which values stay between their bounds; within a bracket, because
/// with two bounds the sum is neither convex nor concave in the shift.
#[inline(always)]
fn shift_to_sum(values: &[f64], cap: f64, sum: f64, [mut low, mut high]: [f64; 2]) -> f64 {
    let mut shift = 0.0f64.clamp(low, high.max(low));
    for _ in 0..LARGEST_PASSES {
        let [carried, between] = sums::over_values(values, |value| {
            let value = value + shift;
            let bounded = limited(value, cap);
            [bounded, if value == bounded { 1.0 } else { 0.0 }]
        });
        let missing = sum - carried;
        if missing.abs() <= ROUNDING * sum {
            break;
        }
        if missing > 0.0 {
            low = shift;
        } else {
            high = shift;
        }
        let newton = shift + missing / between;
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if next == shift {
            break;
        }
        shift = next;
    }
    shift
}

/// The least and the largest value.
#[inline(always)]
fn ends(values: &[f64]) -> [f64; 2] {
    const LANES: usize = 4;
    let (mut least, mut largest) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
    let (fours, rest) = values.as_chunks::<LANES>();
    let mut take = |lane: usize, value: f64| {
        least[lane] = if value < least[lane] { value } else { least[lane] };
        largest[lane] = if value > largest[lane] { value } else { largest[lane] };
    };
    for four in fours {
        (0..LANES).for_each(|lane| take(lane, four[lane]));
    }
    rest.iter().enumerate().for_each(|(lane, value)| take(lane, *value));
    [least.into_iter().fold(f64::INFINITY, f64::min), largest.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}

/// Relative rounding error of the sum.
const ROUNDING: f64 = 1e-15;

/// Error of the sum, relative to itself or to what is missing at the cap, from which a shift is not fine enough.
const LOST: f64 = 1e-13;

/// Passes within which bisection alone reaches the last bit; Newton's method needs four to eight.
const LARGEST_PASSES: usize = 100;

#[cfg(test)]
mod tests {
    use super::bring_to_sum;

    /// Trial pressures of the size of 1 under a load just below a cap of 1e-12: what is missing at the cap has digits that
    /// the last place of a trial pressure does not have.
    #[test]
    fn a_load_just_below_the_cap_is_met() {
        let cap = 1e-12;
        for values in [[-1.0, 1.0, 1.0, -1.0], [-0.3, 1.0, 0.7, -0.2], [1.0; 4]] {
            for missing in [0.3, 1e-3, 1e-6, 1e-9] {
                let sum = 4.0 * cap * (1.0 - missing);
                let mut brought = values;
                bring_to_sum(&mut brought, cap, sum);
                let carried: f64 = brought.iter().sum();
                assert!(
                    (carried / sum - 1.0).abs() < 1e-15,
                    "{values:?}, {missing}: {carried} instead of {sum}"
                );
            }
        }
    }

    #[test]
    fn shifted_and_bounded_values_carry_the_load() {
        let values: Vec<f64> = (0..1001).map(|k| ((k * 37) % 101) as f64 / 50.0 - 1.3).collect();
        for cap in [0.5, 2.0, f64::INFINITY] {
            for mean in [1e-6, 0.1, 0.3, 0.4999] {
                for far in [0.0, 1e9] {
                    let sum = mean * values.len() as f64;
                    let mut brought: Vec<f64> = values.iter().map(|value| value + far).collect();
                    bring_to_sum(&mut brought, cap, sum);
                    assert!(brought.iter().all(|value| (0.0..=cap).contains(value)));
                    let carried: f64 = brought.iter().sum();
                    assert!(
                        (carried / sum - 1.0).abs() < 1e-12,
                        "cap {cap}, mean {mean}: {carried} instead of {sum}"
                    );
                }
            }
        }
    }
}

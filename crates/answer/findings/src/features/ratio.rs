//! The ratio of two curves.

use super::Point;

/// The first curve over the second, at the wavelengths that both have.
pub fn ratio(numerator: &[Point], denominator: &[Point]) -> Vec<Point> {
    let mut below = denominator.iter().peekable();
    let at = |&(wavelength_m, value): &Point| {
        while below.next_if(|(other_m, _)| *other_m > wavelength_m).is_some() {}
        let (_, other) = below.next_if(|(other_m, _)| *other_m == wavelength_m)?;
        Some((wavelength_m, value / other))
    };
    numerator.iter().filter_map(at).collect()
}

/// The wavelengths \[m\] at which a ratio of curves passes through 1, on straight lines between the logarithms of
/// neighbouring points. A ratio that stays at exactly 1 and leaves on the other side passes where it leaves.
pub fn crossings(ratio: &[Point]) -> Vec<f64> {
    let mut found = Vec::new();
    let mut last: Option<(f64, f64)> = None;
    for (index, &(wavelength_m, value)) in ratio.iter().enumerate() {
        let height = value.ln();
        if height == 0.0 {
            continue;
        }
        if let Some((_, before)) = last.filter(|(_, before)| before.signum() != height.signum()) {
            let (beside_m, beside) = ratio[index - 1];
            let share = if beside == 1.0 { 0.0 } else { before / (before - height) };
            found.push(beside_m * (wavelength_m / beside_m).powf(share));
        }
        last = Some((wavelength_m, height));
    }
    found
}

/// The longest wavelength \[m\] from which on a ratio of curves stays a factor `factor` > 1 or more from 1, to either
/// side; `None` if its end does not.
pub fn parts_at(ratio: &[Point], factor: f64) -> Option<f64> {
    last_stretch(ratio, |value| value >= factor || value <= 1.0 / factor)
}

/// The longest wavelength \[m\] from which on a ratio of curves stays within `tolerance` of 1; `None` if its end does
/// not.
pub fn agrees_from(ratio: &[Point], tolerance: f64) -> Option<f64> {
    last_stretch(ratio, |value| (value - 1.0).abs() <= tolerance)
}

fn last_stretch(ratio: &[Point], holds: impl Fn(f64) -> bool) -> Option<f64> {
    ratio.iter().rev().take_while(|(_, value)| holds(*value)).last().map(|(wavelength_m, _)| *wavelength_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_common_wavelengths_are_compared() {
        let above = [(1e-3, 8.0), (1e-4, 6.0), (1e-6, 2.0)];
        let below = [(1e-4, 2.0), (1e-5, 1.0), (1e-6, 4.0)];
        assert_eq!(ratio(&above, &below), [(1e-4, 3.0), (1e-6, 0.5)]);
        assert_eq!(ratio(&[], &below), []);
    }

    #[test]
    fn crossings_lie_between_the_points_or_where_the_curves_part_again() {
        let passing = [(1e-2, 4.0), (1e-4, 0.25)];
        assert!((crossings(&passing)[0] / 1e-3 - 1.0).abs() < 1e-12);
        let leaving = [(1e-2, 1.0), (1e-3, 2.0), (1e-4, 1.0), (1e-5, 1.0), (1e-6, 0.5), (1e-7, 0.4)];
        assert_eq!(crossings(&leaving), [1e-5]);
        let touching = [(1e-2, 2.0), (1e-3, 1.0), (1e-4, 2.0)];
        assert!(crossings(&touching).is_empty());
    }

    #[test]
    fn parting_and_agreeing_are_for_good() {
        let ratio = [(1e-2, 1.0), (1e-3, 1.5), (1e-4, 1.05), (1e-5, 0.6), (1e-6, 0.5)];
        assert_eq!(parts_at(&ratio, 1.2), Some(1e-5));
        assert_eq!(parts_at(&ratio[..3], 1.2), None);
        assert_eq!(agrees_from(&ratio[..3], 0.1), Some(1e-4));
        assert_eq!(agrees_from(&ratio, 0.1), None);
    }
}

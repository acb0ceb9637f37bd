//! Numbers that programs write in the place of missing points, without saying so.

/// Such numbers, without their sign.
const SENTINELS: [f64; 13] = [
    999.0,
    999.25,
    9999.0,
    9999.99,
    99999.0,
    999_999.0,
    32767.0,
    32768.0,
    65535.0,
    2_147_483_647.0,
    2_147_483_648.0,
    1e10,
    1e30,
];
/// Least distance of such a number from all other heights, over their range.
const FAR: f64 = 0.5;
/// Fewest repetitions of the lowest or the highest height that make it such a number.
const REPEATED: usize = 3;

/// Notes a number that is far off all other heights and may stand for missing points.
pub(super) fn note(heights: impl Iterator<Item = f64> + Clone) -> Option<String> {
    let is_one = |height: &f64| SENTINELS.contains(&height.abs());
    let ends = || {
        [heights.clone().reduce(f64::min)?, heights.clone().reduce(f64::max)?]
            .into_iter()
            .find(|end| heights.clone().filter(|height| height == end).count() >= REPEATED)
    };
    let found = heights.clone().find(is_one).or_else(ends)?;
    let others = heights.clone().filter(|height| *height != found);
    let (low, high) = others
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| (low.min(height), high.max(height)));
    let is_far = found < low - FAR * (high - low) || found > high + FAR * (high - low);
    let count = heights.filter(|height| *height == found).count();
    is_far.then(|| {
        format!(
            "{found} stands in {count} places, far off all other heights: if it marks missing points, write a line 'no data = {found}' \
             above the numbers"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_far_off_may_mark_missing_points() {
        let is_noted = |heights: &[f64]| note(heights.iter().copied()).is_some();
        assert!(is_noted(&[1.0, 5.0, -9999.0, 3.0, -9999.0]) && is_noted(&[200.0, 99999.0, 310.0]));
        assert!(!is_noted(&[1.0, 5.0, 3.0]) && !is_noted(&[9000.0, 9999.0, 5000.0]) && !is_noted(&[]));
    }
}

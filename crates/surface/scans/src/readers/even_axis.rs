//! Even axes: the spacing of positions that are evenly spaced, and the grid that two axes of points span.

/// The share of the spacing that the rounding of positions may take up before even spacing is a guess.
const DISCERNIBLE: f64 = 0.25;
/// Most grid points per point; the others are missing. More would be no map, and two scattered
/// points could demand a vast grid.
const SPARSEST: usize = 4;

/// One axis of a grid.
pub(crate) struct ScanAxis {
    pub(crate) first: f64,
    pub(crate) spacing: f64,
    /// At least 1.
    pub(crate) count: usize,
}

impl ScanAxis {
    /// The axis of positions in any order, each known within a rounding; none where they are on no even one.
    pub(crate) fn fit(mut values: Vec<f64>, rounding: f64) -> Option<Self> {
        sort(&mut values);
        let first = *values.first()?;
        if values.len() == 1 {
            // One column or row, which the map refuses with its own words.
            return Some(Self { first, spacing: 1.0, count: 1 });
        }
        if let Some(spacing) = even_spacing(&values, rounding) {
            return Some(Self { first, spacing, count: values.len() });
        }
        // Instruments print the same position with a last digit that varies. The first of a group stands for it, so
        // that a creeping sequence of close values does not merge into one; groups must lie well apart.
        values.dedup_by(|value, group| *value - *group <= 2.0 * rounding);
        let spacing = even_spacing(&values, 3.0 * rounding).filter(|&spacing| spacing > 8.0 * rounding)?;
        Some(Self { first, spacing, count: values.len() })
    }

    /// The even axis with as many values, from the lowest to the highest; none where there are no values.
    pub(crate) fn nearest(mut values: Vec<f64>) -> Option<Self> {
        sort(&mut values);
        let (first, last, count) = (*values.first()?, *values.last()?, values.len());
        Some(Self { first, spacing: (last - first) / (count.max(2) - 1) as f64, count })
    }

    pub(crate) fn index(&self, position: f64) -> usize {
        // A saturating conversion; the bound holds for positions between the first and the last.
        (((position - self.first) / self.spacing).round() as usize).min(self.count - 1)
    }

    pub(crate) fn position(&self, index: usize) -> f64 {
        self.first + index as f64 * self.spacing
    }
}

/// Each value once, rising.
fn sort(values: &mut Vec<f64>) {
    values.sort_by(f64::total_cmp);
    values.dedup();
}

/// Number of points of the grid; none where so many points hardly fill it.
pub(crate) fn points_of_grid(x: &ScanAxis, y: &ScanAxis, points: usize) -> Option<usize> {
    x.count.checked_mul(y.count).filter(|&size| size / SPARSEST <= points)
}

/// The spacing of rising positions that are evenly spaced within the rounding of their digits.
pub(crate) fn even_spacing(positions: &[f64], rounding: f64) -> Option<f64> {
    let (&first, &last) = (positions.first()?, positions.last()?);
    evenly_spaced(positions.iter().copied().enumerate(), (first, last), positions.len() - 1, rounding)
}

/// The spacing of numbered positions from the first to the last, so many steps on, where they are even.
pub(crate) fn evenly_spaced(
    mut positions: impl Iterator<Item = (usize, f64)>,
    (first, last): (f64, f64),
    steps: usize,
    rounding: f64,
) -> Option<f64> {
    if steps == 0 {
        return None;
    }
    let spacing = (last - first) / steps as f64;
    let bound = rounding.min(DISCERNIBLE * spacing);
    let is_even =
        |(index, position): (usize, f64)| (position - (first + index as f64 * spacing)).abs() <= bound;
    positions.all(is_even).then_some(spacing)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spacings_are_even_within_the_printed_digits() {
        let rounded: Vec<f64> = (0..1000).map(|i| (f64::from(i) * 99.56).round() / 1e6).collect();
        assert!((even_spacing(&rounded, 1e-6).unwrap() / 99.56e-6 - 1.0).abs() < 1e-5);
        assert_eq!(even_spacing(&rounded, 1e-7), None);
        let cut_off: Vec<f64> = (0..1000).map(|i| (f64::from(i) * 99.56).floor() / 1e6).collect();
        assert!(even_spacing(&cut_off, 1e-6).is_some());
        // Whole numbers that are not evenly spaced are not rounded thirds.
        assert_eq!(even_spacing(&[0.0, 1.0, 3.0, 4.0], 1.0), None);
        assert_eq!(even_spacing(&[0.0, 1.0, 2.0, 3.0], 1.0), Some(1.0));
        assert_eq!(even_spacing(&[1.0], 1.0), None);
    }
}

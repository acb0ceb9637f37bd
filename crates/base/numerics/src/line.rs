//! The least-squares line through points.

/// Slope of a least-squares line, and how far its points are spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedLine {
    /// Change of y per x.
    pub slope: f64,
    /// Root of the sum of squares of x about the mean, above 0: the slope's standard error is that of y over this.
    pub spread: f64,
}

/// Fits a line to points (x, y) by least squares; `None` for fewer than two different x.
#[must_use]
pub fn line_through(points: impl Iterator<Item = (f64, f64)> + Clone) -> Option<FittedLine> {
    let (mut count, mut sum_x, mut sum_y) = (0.0, 0.0, 0.0);
    for (x, y) in points.clone() {
        count += 1.0;
        sum_x += x;
        sum_y += y;
    }
    let (mean_x, mean_y) = (sum_x / count, sum_y / count);
    let (mut squares, mut products) = (0.0, 0.0);
    for (x, y) in points {
        squares += (x - mean_x).powi(2);
        products += (x - mean_x) * (y - mean_y);
    }
    (squares > 0.0).then(|| FittedLine { slope: products / squares, spread: squares.sqrt() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_line_have_its_slope_and_one_place_has_none() {
        let line = line_through([(1.0, 5.0), (2.0, 3.0), (3.0, 1.0)].into_iter()).unwrap();
        assert_eq!((line.slope, line.spread), (-2.0, 2f64.sqrt()));
        // The middle of three points does not tilt a line through the others.
        let line = line_through([(-1.0, 0.0), (0.0, 9.0), (1.0, 4.0)].into_iter()).unwrap();
        assert_eq!(line.slope, 2.0);
        for points in [&[][..], &[(1.0, 2.0)], &[(1.0, 2.0), (1.0, 3.0)]] {
            assert_eq!(line_through(points.iter().copied()), None);
        }
    }
}

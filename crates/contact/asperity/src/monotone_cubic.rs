//! Piecewise cubic interpolation that keeps the monotonicity of its data: PCHIP, i.e. the three-point slopes of
//! Fritsch & Butland (1984), SIAM J. Sci. Stat. Comput. 5:300, within the bounds of Fritsch & Carlson (1980).

/// Monotone interpolant of monotone data, with a continuous slope.
#[derive(Debug, Clone)]
pub struct MonotoneCubic {
    x: Vec<f64>,
    y: Vec<f64>,
    slope: Vec<f64>,
}

impl MonotoneCubic {
    /// Interpolates at least three points of rising x.
    #[must_use]
    pub fn through(x: Vec<f64>, y: Vec<f64>) -> Self {
        let steps: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let secants: Vec<f64> = y.windows(2).zip(&steps).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
        let last = steps.len() - 1;
        let mut slope = vec![end_slope([steps[0], steps[1]], [secants[0], secants[1]])];
        slope.extend((0..last).map(|i| inner_slope([steps[i], steps[i + 1]], [secants[i], secants[i + 1]])));
        slope.push(end_slope([steps[last], steps[last - 1]], [secants[last], secants[last - 1]]));
        MonotoneCubic { x, y, slope }
    }

    /// Value and slope at x between the first and the last point.
    #[must_use]
    pub fn at(&self, x: f64) -> (f64, f64) {
        let i = self.x.partition_point(|&knot| knot <= x).clamp(1, self.x.len() - 1) - 1;
        let h = self.x[i + 1] - self.x[i];
        let t = (x - self.x[i]) / h;
        let rise = self.y[i + 1] - self.y[i];
        let (from, to) = (h * self.slope[i], h * self.slope[i + 1]);
        let (square, cube) = (3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise);
        let value = self.y[i] + t * (from + t * (square + t * cube));
        (value, (from + t * (2.0 * square + t * 3.0 * cube)) / h)
    }
}

/// Weighted harmonic mean of the secants; zero if they differ in sign.
fn inner_slope([before, after]: [f64; 2], [left, right]: [f64; 2]) -> f64 {
    if left * right <= 0.0 {
        return 0.0;
    }
    let (w_left, w_right) = (2.0 * after + before, after + 2.0 * before);
    (w_left + w_right) / (w_left / left + w_right / right)
}

/// Slope of the parabola through three points at an end, limited so that the end piece stays monotone.
fn end_slope([near, far]: [f64; 2], [secant, next]: [f64; 2]) -> f64 {
    let slope = ((2.0 * near + far) * secant - near * next) / (near + far);
    if slope * secant <= 0.0 {
        0.0
    } else if secant * next <= 0.0 && slope.abs() > 3.0 * secant.abs() {
        3.0 * secant
    } else {
        slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_met_and_slopes_are_continuous_and_monotone() {
        let x = vec![0.0, 1.0, 1.5, 4.0, 4.1];
        let y = vec![0.0, 0.1, 3.0, 3.1, 9.0];
        let curve = MonotoneCubic::through(x.clone(), y.clone());
        for (x, y) in x.iter().zip(&y) {
            assert!((curve.at(*x).0 - y).abs() < 1e-14);
        }
        for knot in &x[1..4] {
            assert!((curve.at(knot - 1e-9).1 - curve.at(knot + 1e-9).1).abs() < 1e-5);
        }
        let values: Vec<f64> = (0..=410).map(|i| curve.at(f64::from(i) / 100.0).0).collect();
        assert!(values.is_sorted());
    }

    #[test]
    fn a_straight_line_is_reproduced() {
        let curve = MonotoneCubic::through(vec![0.0, 1.0, 5.0, 6.0], vec![1.0, 3.0, 11.0, 13.0]);
        for x in [0.0, 0.3, 2.2, 5.9] {
            let (value, slope) = curve.at(x);
            assert!((value - (1.0 + 2.0 * x)).abs() < 1e-14 && (slope - 2.0).abs() < 1e-14);
        }
    }
}

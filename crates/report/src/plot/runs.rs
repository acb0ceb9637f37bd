//! Lines that break where nothing was measured.

/// The parts of a line whose points lie on one side of each gap, a gap given by its two ends in either order.
pub(super) fn runs(points: &[(f64, f64)], gaps: &[[f64; 2]]) -> Vec<Vec<(f64, f64)>> {
    let crosses = |a: f64, b: f64| {
        let (low, high) = (a.min(b), a.max(b));
        gaps.iter().any(|[from, to]| low <= from.min(*to) && from.max(*to) <= high)
    };
    points.chunk_by(|a, b| !crosses(a.0, b.0)).map(<[_]>::to_vec).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_breaks_over_a_gap_and_nowhere_else() {
        let line = [(1.0, 1.0), (2.0, 2.0), (9.0, 3.0), (10.0, 4.0)];
        assert_eq!(runs(&line, &[]), [line.to_vec()]);
        assert_eq!(runs(&line, &[[9.0, 2.0]]), [line[..2].to_vec(), line[2..].to_vec()]);
        assert_eq!(runs(&line, &[[4.0, 20.0]]), [line.to_vec()], "a gap of another line");
    }
}

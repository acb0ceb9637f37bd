//! Lines of very many points, thinned without a visible change.

/// The number of points above which a line is thinned: a few for each pixel of a plot's width.
const MAX_POINTS: usize = 2000;

/// Columns into which a thinned line is sorted; each keeps up to four points, so that at most [`MAX_POINTS`] remain.
const COLUMNS: usize = MAX_POINTS / 4;

/// Thins points whose abscissas run one way: each narrow column keeps its first, lowest, highest and last point, so
/// that no peak and no dip is lost.
pub(super) fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let (Some(&(first, _)), Some(&(last, _))) = (points.first(), points.last()) else { return points };
    if points.len() <= MAX_POINTS || first == last {
        return points;
    }
    let column =
        |(x, _): &(f64, f64)| (((x - first) / (last - first) * COLUMNS as f64) as usize).min(COLUMNS - 1);
    points.chunk_by(|a, b| column(a) == column(b)).flat_map(outline).collect()
}

/// The first, lowest, highest and last of some points, each once and in order.
fn outline(column: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let by_height = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
    let lowest = (0..column.len()).min_by(by_height);
    let highest = (0..column.len()).max_by(by_height);
    let mut kept: Vec<usize> = lowest.into_iter().chain(highest).chain([0, column.len() - 1]).collect();
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|at| column[at]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dense_line_keeps_its_ends_peaks_and_dips() {
        let mut points: Vec<(f64, f64)> =
            (0..100_000).map(|i| (-f64::from(i), (f64::from(i) / 1e4).sin())).collect();
        points[54_321].1 = -7.0;
        points[76_543].1 = 9.0;
        let drawn = thinned(points.clone());
        assert!(drawn.len() <= MAX_POINTS, "{}", drawn.len());
        for kept in [points[0], points[54_321], points[76_543], points[99_999]] {
            assert!(drawn.contains(&kept));
        }
        assert!(drawn.windows(2).all(|pair| pair[0].0 > pair[1].0), "the order stays");
    }

    #[test]
    fn a_line_of_few_points_is_drawn_as_it_is() {
        let points: Vec<(f64, f64)> = (0..2000).map(|i| (f64::from(i), 1.0)).collect();
        assert_eq!(thinned(points.clone()), points);
        assert_eq!(thinned(Vec::new()), []);
    }
}

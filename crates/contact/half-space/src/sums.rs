//! Sums over maps, in an order that depends on their size alone.

/// Points of a block: within it, four lanes are added up side by side; blocks follow one another.
const BLOCK: usize = 512;

/// Lanes added up side by side, so that no addition waits for the one before.
const LANES: usize = 4;

/// Computes several sums over the indices below `count` at once.
///
/// The order depends on `count` only, and the rounding grows with the number of blocks instead of points.
#[inline]
pub(crate) fn over<const K: usize>(count: usize, mut terms: impl FnMut(usize) -> [f64; K]) -> [f64; K] {
    let mut total = [0.0; K];
    let mut first = 0;
    while first < count {
        let last = (first + BLOCK).min(count);
        let mut lanes = [[0.0; K]; LANES];
        for at in (first..last).step_by(LANES) {
            for (lane, sums) in lanes.iter_mut().enumerate() {
                if at + lane < last {
                    add(sums, terms(at + lane));
                }
            }
        }
        let [a, b, c, d] = lanes;
        for k in 0..K {
            total[k] += (a[k] + b[k]) + (c[k] + d[k]);
        }
        first = last;
    }
    total
}

#[inline]
fn add<const K: usize>(sums: &mut [f64; K], terms: [f64; K]) {
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum += term;
    }
}

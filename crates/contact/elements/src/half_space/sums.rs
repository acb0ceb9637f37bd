//! Sums over maps, in an order that depends on their size alone.

/// Points of a block: within it, four lanes are added up side by side; blocks follow one another.
const BLOCK: usize = 512;

/// Lanes added up side by side, so that no addition waits for the one before.
const LANES: usize = 4;

/// Computes several sums over the indices below `count` at once.
///
/// The order depends on `count` only, and the rounding grows with the number of blocks instead of points.
#[inline(always)]
pub(crate) fn over<const K: usize>(count: usize, mut terms: impl FnMut(usize) -> [f64; K]) -> [f64; K] {
    let mut total = [0.0; K];
    let mut first = 0;
    while first < count {
        let last = (first + BLOCK).min(count);
        let rest = last - (last - first) % LANES;
        let mut lanes = [[0.0; LANES]; K];
        for at in (first..rest).step_by(LANES) {
            (0..LANES).for_each(|lane| add(&mut lanes, lane, terms(at + lane)));
        }
        (rest..last).enumerate().for_each(|(lane, at)| add(&mut lanes, lane, terms(at)));
        add_block(&mut total, &lanes);
        first = last;
    }
    total
}

/// Computes several sums over values at once, in the order of [`over`].
#[inline(always)]
pub(crate) fn over_values<const K: usize>(
    values: &[f64],
    mut terms: impl FnMut(f64) -> [f64; K],
) -> [f64; K] {
    let mut total = [0.0; K];
    for block in values.chunks(BLOCK) {
        let (fours, rest) = block.as_chunks::<LANES>();
        let mut lanes = [[0.0; LANES]; K];
        for four in fours {
            (0..LANES).for_each(|lane| add(&mut lanes, lane, terms(four[lane])));
        }
        rest.iter().enumerate().for_each(|(lane, value)| add(&mut lanes, lane, terms(*value)));
        add_block(&mut total, &lanes);
    }
    total
}

#[inline(always)]
fn add<const K: usize>(lanes: &mut [[f64; LANES]; K], lane: usize, terms: [f64; K]) {
    for (lanes, term) in lanes.iter_mut().zip(terms) {
        lanes[lane] += term;
    }
}

#[inline(always)]
fn add_block<const K: usize>(total: &mut [f64; K], lanes: &[[f64; LANES]; K]) {
    for (total, [a, b, c, d]) in total.iter_mut().zip(lanes) {
        *total += (a + b) + (c + d);
    }
}

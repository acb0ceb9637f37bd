//! Sums whose error hardly grows with the number of terms, fast enough for every height of a map.

/// Number of terms summed in lanes; longer slices are halved and added pairwise.
const BLOCK: usize = 512;
const LANES: usize = 8;

/// Sums `term` over the values.
pub(crate) fn sum_of(values: &[f64], term: impl Fn(f64) -> f64 + Copy) -> f64 {
    if values.len() > BLOCK {
        let (left, right) = values.split_at(values.len() / 2);
        return sum_of(left, term) + sum_of(right, term);
    }
    let mut lanes = [0.0; LANES];
    let mut groups = values.chunks_exact(LANES);
    for group in &mut groups {
        for (lane, &value) in lanes.iter_mut().zip(group) {
            *lane += term(value);
        }
    }
    let rest: f64 = groups.remainder().iter().map(|&value| term(value)).sum();
    lanes.iter().sum::<f64>() + rest
}

/// Sums the products of two slices of equal length.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let [sum] = sums_of(a, b, |a, b| [a * b]);
    sum
}

/// Sums several terms over the pairs of values of two slices of equal length.
pub(crate) fn sums_of<const K: usize>(
    a: &[f64],
    b: &[f64],
    terms: impl Fn(f64, f64) -> [f64; K] + Copy,
) -> [f64; K] {
    if a.len() > BLOCK {
        let middle = a.len() / 2;
        let (left, right) =
            (sums_of(&a[..middle], &b[..middle], terms), sums_of(&a[middle..], &b[middle..], terms));
        return std::array::from_fn(|k| left[k] + right[k]);
    }
    let mut lanes = [[0.0; LANES]; K];
    let mut add = |lane: usize, terms: [f64; K]| {
        for (lanes, term) in lanes.iter_mut().zip(terms) {
            lanes[lane] += term;
        }
    };
    let ((a_groups, a_rest), (b_groups, b_rest)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    for (a, b) in a_groups.iter().zip(b_groups) {
        for lane in 0..LANES {
            add(lane, terms(a[lane], b[lane]));
        }
    }
    for (lane, (&a, &b)) in a_rest.iter().zip(b_rest).enumerate() {
        add(lane, terms(a, b));
    }
    lanes.map(|lanes| lanes.iter().sum())
}

/// Mean and sum of squared deviations, joined from parts without cancellation.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spread {
    count: f64,
    mean: f64,
    pub(crate) squares: f64,
}

impl Spread {
    /// Writes `value` of the inputs to `outputs` and computes their spread in one pass.
    ///
    /// In a block, mean square minus squared mean may lose digits of a small scatter, but no more than the rounding of
    /// its mean square, which is small for detrended values.
    pub(crate) fn mapped<const K: usize>(
        inputs: [&[f64]; K],
        outputs: &mut [f64],
        value: impl Fn([f64; K]) -> f64,
    ) -> Self {
        let mut spread = Self::default();
        for (block, outputs) in outputs.chunks_mut(BLOCK).enumerate() {
            let inputs = inputs.map(|input| &input[block * BLOCK..][..outputs.len()]);
            spread = spread.joined(Self::of_block(inputs, outputs, &value));
        }
        spread
    }

    fn of_block<const K: usize>(
        inputs: [&[f64]; K],
        outputs: &mut [f64],
        value: impl Fn([f64; K]) -> f64,
    ) -> Self {
        let count = outputs.len() as f64;
        let (mut sums, mut squares) = ([0.0; LANES], [0.0; LANES]);
        let inputs = inputs.map(|input| input.as_chunks::<LANES>());
        let (groups, rest) = outputs.as_chunks_mut::<LANES>();
        for (group, outputs) in groups.iter_mut().enumerate() {
            let inputs = inputs.map(|(groups, _)| &groups[group]);
            for lane in 0..LANES {
                let value = value(inputs.map(|input| input[lane]));
                outputs[lane] = value;
                sums[lane] += value;
                squares[lane] += value * value;
            }
        }
        for (lane, output) in rest.iter_mut().enumerate() {
            let value = value(inputs.map(|(_, rest)| rest[lane]));
            *output = value;
            sums[lane] += value;
            squares[lane] += value * value;
        }
        let mean = sums.iter().sum::<f64>() / count;
        Self { count, mean, squares: (squares.iter().sum::<f64>() - count * mean * mean).max(0.0) }
    }

    /// Joins two parts: Chan, Golub & LeVeque (1983), Am. Stat. 37:242.
    pub(crate) fn joined(self, other: Self) -> Self {
        let count = self.count + other.count;
        if count == 0.0 {
            return self;
        }
        let step = other.mean - self.mean;
        Self {
            count,
            mean: self.mean + step * (other.count / count),
            squares: self.squares + other.squares + step * step * (self.count * other.count / count),
        }
    }

    /// Scales the values by a factor.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { mean: factor * self.mean, squares: factor * factor * self.squares, ..self }
    }

    /// Returns the mean squared deviation.
    pub(crate) fn variance(self) -> f64 {
        self.squares / self.count
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn parts_join_to_the_whole() {
        let values: Vec<f64> = (0..3001).map(|i| 1.5 + (f64::from(i) * 0.7).sin()).collect();
        let mut copy = values.clone();
        let spread = Spread::mapped([&values], &mut copy, |[value]| value);
        let mean = sum_of(&values, |value| value) / 3001.0;
        let variance = sum_of(&values, |value| (value - mean).powi(2)) / 3001.0;
        assert_relative_eq!(spread.variance(), variance, max_relative = 1e-14);
        assert_eq!(copy, values);
        assert_relative_eq!(dot(&values, &values), sum_of(&values, |v| v * v), max_relative = 1e-15);
    }
}

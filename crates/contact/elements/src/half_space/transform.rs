//! Convolution of a map with an even kernel through the two-dimensional Fourier transform.

use std::sync::Arc;

use numerics::transforms::{Complex, Fft, FftNum, Precision};

/// Columns that are transformed together: a cache line, or two, in every row.
const BLOCK: usize = 8;

/// Multiplies a real map by a real and even function of the wave vector.
///
/// Two rows of the map are the real and the imaginary part of one complex row, so that nothing is transformed twice,
/// and rows of odd length cost no more. The mirrored halves of a complex row are separated while a block of columns
/// is gathered; the block is transformed, multiplied and transformed back before it leaves the cache.
pub(crate) struct Convolution<T: Precision> {
    /// Rows and columns of the map, which may be smaller than the period: the rest is zero, and its result unused.
    map: [usize; 2],
    /// Rows and columns of the period.
    period: [usize; 2],
    /// One factor for each |wave number|: `period.columns / 2 + 1` columns of `period.rows / 2 + 1` values.
    factors: Vec<T>,
    along_rows: [Arc<dyn Fft<T>>; 2],
    along_columns: [Arc<dyn Fft<T>>; 2],
    buffers: Buffers<T>,
}

/// Work space of a convolution, made at its first use.
struct Buffers<T> {
    /// Complex rows, each of two rows of the map.
    pairs: Vec<Complex<T>>,
    /// Block of columns, one behind the other.
    block: Vec<Complex<T>>,
    scratch: Vec<Complex<T>>,
}

impl<T: Precision> Convolution<T> {
    /// Creates the convolution of maps of `map` rows and columns, repeated (or padded with zeros) to `period`;
    /// `factor(row, column)` multiplies the wave with so many periods along y and x.
    pub(crate) fn new(map: [usize; 2], period: [usize; 2], factor: impl Fn(usize, usize) -> f64) -> Self {
        let [rows, columns] = period;
        let along_rows = T::plan_both_ways(columns);
        let along_columns = if rows == columns { along_rows.clone() } else { T::plan_both_ways(rows) };
        // A factor of 1/2 for separating two rows; the rest normalises the transforms.
        let share = 0.5 / (rows as f64 * columns as f64);
        let factors = (0..=columns / 2).flat_map(|column| (0..=rows / 2).map(move |row| (row, column)));
        Self {
            map,
            period,
            factors: factors
                .map(|(row, column)| {
                    T::from_f64(share * factor(row, column)).expect("a factor within the range")
                })
                .collect(),
            along_rows,
            along_columns,
            buffers: Buffers { pairs: Vec::new(), block: Vec::new(), scratch: Vec::new() },
        }
    }

    /// Convolves `values` into `into`.
    pub(crate) fn apply(&mut self, values: &[T], into: &mut [T]) {
        self.multiply(values);
        self.rows_back(into);
    }

    /// Convolves `values` in place.
    pub(crate) fn apply_in_place(&mut self, values: &mut [T]) {
        self.multiply(values);
        self.rows_back(values);
    }

    /// Convolves `values` in place, in the work space of another convolution.
    pub(crate) fn apply_in_place_within(&mut self, other: &mut Self, values: &mut [T]) {
        std::mem::swap(&mut self.buffers, &mut other.buffers);
        self.apply_in_place(values);
        std::mem::swap(&mut self.buffers, &mut other.buffers);
    }

    /// Computes the product with the factors, transformed back along the columns alone.
    fn multiply(&mut self, values: &[T]) {
        self.make_room();
        self.rows_forward(values);
        for first in (0..=self.period[1] / 2).step_by(BLOCK) {
            self.multiply_columns(first);
        }
    }

    /// Extends the work space to what this convolution needs.
    fn make_room(&mut self) {
        let ([rows, columns], zero) = (self.period, Complex::new(T::zero(), T::zero()));
        let plans = self.along_rows.iter().chain(&self.along_columns);
        let scratch = plans.map(|plan| plan.get_inplace_scratch_len()).max().unwrap_or(0);
        let extend = |buffer: &mut Vec<Complex<T>>, count: usize| {
            if buffer.len() < count {
                buffer.resize(count, zero);
            }
        };
        let pairs = self.pairs() * columns;
        extend(&mut self.buffers.pairs, pairs);
        extend(&mut self.buffers.block, BLOCK * rows);
        extend(&mut self.buffers.scratch, scratch);
    }

    /// Number of complex rows.
    fn pairs(&self) -> usize {
        self.map[0].div_ceil(2)
    }

    fn rows_forward(&mut self, values: &[T]) {
        let ([_, columns], width) = (self.map, self.period[1]);
        let zero = Complex::new(T::zero(), T::zero());
        let Buffers { pairs, scratch, .. } = &mut self.buffers;
        for (pair, values) in pairs.chunks_exact_mut(width).zip(values.chunks(2 * columns)) {
            let (first, second) = values.split_at(columns);
            if second.is_empty() {
                pair.iter_mut().zip(first).for_each(|(to, &re)| *to = Complex::new(re, T::zero()));
            } else {
                let both = first.iter().zip(second);
                pair.iter_mut().zip(both).for_each(|(to, (&re, &im))| *to = Complex::new(re, im));
            }
            pair[columns..].fill(zero);
            self.along_rows[0].process_with_scratch(pair, scratch);
        }
    }

    /// Transforms the columns from `first` on, multiplies them and transforms them back.
    fn multiply_columns(&mut self, first: usize) {
        let [rows, width] = self.period;
        let zero = Complex::new(T::zero(), T::zero());
        let last = (first + BLOCK).min(width / 2 + 1);
        let (used, count) = (self.map[0], self.pairs());
        let Buffers { pairs, block, scratch } = &mut self.buffers;
        for (pair, line) in pairs.chunks_exact(width).take(count).enumerate() {
            for column in first..last {
                let [even, odd] = taken_apart(line[column], line[mirrored(column, width)]);
                let to = &mut block[(column - first) * rows..][..rows];
                to[2 * pair] = even;
                if 2 * pair + 1 < used {
                    to[2 * pair + 1] = odd;
                }
            }
        }
        for column in first..last {
            let values = &mut block[(column - first) * rows..][..rows];
            values[used..].fill(zero);
            self.along_columns[0].process_with_scratch(values, scratch);
            let factors = &self.factors[column * (rows / 2 + 1)..][..rows / 2 + 1];
            let (upwards, downwards) = values.split_at_mut(factors.len());
            upwards.iter_mut().zip(factors).for_each(|(value, &factor)| *value = *value * factor);
            let mirror = factors[1..rows.div_ceil(2)].iter().rev();
            downwards.iter_mut().zip(mirror).for_each(|(value, &factor)| *value = *value * factor);
            self.along_columns[1].process_with_scratch(values, scratch);
        }
        for (pair, line) in pairs.chunks_exact_mut(width).take(count).enumerate() {
            for column in first..last {
                let from = &block[(column - first) * rows..][..rows];
                let odd = if 2 * pair + 1 < used { from[2 * pair + 1] } else { zero };
                let [value, mirror] = put_together(from[2 * pair], odd);
                line[mirrored(column, width)] = mirror;
                line[column] = value;
            }
        }
    }

    fn rows_back(&mut self, into: &mut [T]) {
        let ([_, columns], width) = (self.map, self.period[1]);
        let Buffers { pairs, scratch, .. } = &mut self.buffers;
        for (pair, into) in pairs.chunks_exact_mut(width).zip(into.chunks_mut(2 * columns)) {
            self.along_rows[1].process_with_scratch(pair, scratch);
            let (first, second) = into.split_at_mut(columns);
            first.iter_mut().zip(&*pair).for_each(|(to, value)| *to = value.re);
            second.iter_mut().zip(&*pair).for_each(|(to, value)| *to = value.im);
        }
    }
}

/// Column of the opposite wave.
fn mirrored(column: usize, width: usize) -> usize {
    if column == 0 { 0 } else { width - column }
}

/// Twice the transforms of the real and the imaginary part, from the transform of both at a wave and at its opposite.
#[inline]
fn taken_apart<T: FftNum>(value: Complex<T>, mirror: Complex<T>) -> [Complex<T>; 2] {
    [
        Complex::new(value.re + mirror.re, value.im - mirror.im),
        Complex::new(value.im + mirror.im, mirror.re - value.re),
    ]
}

/// Transform of even + i odd at a wave and at its opposite.
#[inline]
fn put_together<T: FftNum>(even: Complex<T>, odd: Complex<T>) -> [Complex<T>; 2] {
    [Complex::new(even.re - odd.im, even.im + odd.re), Complex::new(even.re + odd.im, odd.re - even.im)]
}

//! Inverse transform of half a Hermitian spectrum to real values on a grid.

use std::sync::Arc;

use numerics::transforms::{Complex64, ComplexToReal, Fft};

/// Columns transformed together, because their rows are contiguous in memory.
const BLOCK: usize = 8;

/// Amplitudes of waves and the grid on which they are summed.
pub(crate) struct HalfSpectrum {
    rows: usize,
    columns: usize,
    /// Row-major, columns/2 + 1 per row; negative wavenumbers are the conjugates of these.
    amplitudes: Vec<Complex64>,
    /// Number of leading columns that may be nonzero.
    occupied: usize,
}

impl HalfSpectrum {
    pub(crate) fn new(rows: usize, columns: usize) -> Self {
        let amplitudes = vec![Complex64::ZERO; rows * (columns / 2 + 1)];
        Self { rows, columns, amplitudes, occupied: 0 }
    }

    /// Adds the samples of the real wave 2 Re a exp(2 pi i (m x/columns + n y/rows)), 0 <= m <= columns/2 and |n| <=
    /// rows/2. At the highest wavenumbers a wave and its conjugate coincide.
    pub(crate) fn add(&mut self, m: usize, n: i64, amplitude: Complex64) {
        let width = self.columns / 2 + 1;
        let row = |n: i64| n.rem_euclid(self.rows as i64) as usize;
        self.amplitudes[row(n) * width + m] += amplitude;
        if m == 0 || 2 * m == self.columns {
            self.amplitudes[row(-n) * width + m] += amplitude.conj();
        }
        self.occupied = self.occupied.max(m + 1);
    }

    /// Sums all waves at the points, row by row.
    pub(crate) fn sum(mut self) -> Vec<f64> {
        self.transform_columns(&numerics::transforms::inverse(self.rows));
        self.transform_rows(&numerics::transforms::inverse_to_real(self.columns))
    }

    fn transform_columns(&mut self, transform: &Arc<dyn Fft<f64>>) {
        let width = self.columns / 2 + 1;
        let mut block = vec![Complex64::ZERO; BLOCK * self.rows];
        let mut scratch = vec![Complex64::ZERO; transform.get_inplace_scratch_len()];
        for first in (0..self.occupied).step_by(BLOCK) {
            let wide = BLOCK.min(self.occupied - first);
            for (row, values) in self.amplitudes.chunks_exact(width).enumerate() {
                for (column, value) in values[first..first + wide].iter().enumerate() {
                    block[column * self.rows + row] = *value;
                }
            }
            transform.process_with_scratch(&mut block[..wide * self.rows], &mut scratch);
            for (row, values) in self.amplitudes.chunks_exact_mut(width).enumerate() {
                for (column, value) in values[first..first + wide].iter_mut().enumerate() {
                    *value = block[column * self.rows + row];
                }
            }
        }
    }

    fn transform_rows(&mut self, transform: &Arc<dyn ComplexToReal<f64>>) -> Vec<f64> {
        let width = self.columns / 2 + 1;
        let mut heights = vec![0.0; self.rows * self.columns];
        let mut scratch = transform.make_scratch_vec();
        let rows = self.amplitudes.chunks_exact_mut(width).zip(heights.chunks_exact_mut(self.columns));
        for (values, heights) in rows {
            // Real up to rounding, because the columns are Hermitian.
            values[0].im = 0.0;
            if self.columns.is_multiple_of(2) {
                values[width - 1].im = 0.0;
            }
            transform
                .process_with_scratch(values, heights, &mut scratch)
                .expect("the lengths are those of the transform, and the ends are real");
        }
        heights
    }
}

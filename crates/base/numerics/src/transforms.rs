//! Discrete Fourier transforms of any length, of complex and of real numbers.
//!
//! ```
//! use numerics::transforms::{self, Complex64};
//!
//! let mut values = vec![Complex64::new(1.0, 0.0); 6];
//! transforms::forward(6).process(&mut values);
//! assert_eq!(values[0].re, 6.0);
//!
//! // Of n real numbers, n/2 + 1 values suffice.
//! let real = transforms::forward_of_real(6);
//! let (mut numbers, mut waves) = (vec![1.0; 6], real.make_output_vec());
//! real.process(&mut numbers, &mut waves)?;
//! assert_eq!((waves.len(), waves[0].re), (4, 6.0));
//! # Ok::<(), transforms::FftError>(())
//! ```
//!
//! Nothing is normalised: forth and back multiplies by the length. The last digits depend on the processor, since wider
//! vectors fuse and order sums differently.

use std::sync::Arc;

pub use realfft::{ComplexToReal, FftError, RealToComplex};
pub use rustfft::num_complex::{Complex, Complex64};
pub use rustfft::{Fft, FftNum};

use realfft::RealFftPlanner;
use rustfft::FftPlanner;

/// Precision of transforms: `f64` or `f32`.
pub trait Precision: FftNum {
    /// Plans the transforms of some values with exp(-2 pi i jk/n) and with exp(2 pi i jk/n).
    fn plan_both_ways(length: usize) -> [Arc<dyn Fft<Self>>; 2];
}

impl Precision for f64 {
    fn plan_both_ways(length: usize) -> [Arc<dyn Fft<f64>>; 2] {
        both_ways(length)
    }
}

impl Precision for f32 {
    fn plan_both_ways(length: usize) -> [Arc<dyn Fft<f32>>; 2] {
        both_ways(length)
    }
}

/// Compiles all kernels for a precision: no function of this kind may be public.
fn both_ways<T: FftNum>(length: usize) -> [Arc<dyn Fft<T>>; 2] {
    let mut planner = FftPlanner::new();
    [planner.plan_fft_forward(length), planner.plan_fft_inverse(length)]
}

/// Plans the transform of `length` values with exp(-2 pi i jk/n).
#[must_use]
pub fn forward(length: usize) -> Arc<dyn Fft<f64>> {
    FftPlanner::new().plan_fft_forward(length)
}

/// Plans the transform of `length` values with exp(2 pi i jk/n).
#[must_use]
pub fn inverse(length: usize) -> Arc<dyn Fft<f64>> {
    FftPlanner::new().plan_fft_inverse(length)
}

/// Plans the transform of `length` real numbers to the waves 0, 1, ..., length/2.
#[must_use]
pub fn forward_of_real(length: usize) -> Arc<dyn RealToComplex<f64>> {
    RealFftPlanner::new().plan_fft_forward(length)
}

/// Plans the transform of the waves 0, 1, ..., length/2 to `length` real numbers.
#[must_use]
pub fn inverse_to_real(length: usize) -> Arc<dyn ComplexToReal<f64>> {
    RealFftPlanner::new().plan_fft_inverse(length)
}

//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod gap_bias;
mod gaps;
mod kept_moments;
mod narrow_lines;
mod noise;
mod robust_averages;
mod skewness;
mod tips;
mod transform_areal;
mod transform_composite;
mod transform_lines;
mod transform_support;
mod transform_uneven;

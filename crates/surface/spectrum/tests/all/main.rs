//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod abel;
mod area_spectra;
mod mends;
mod moments;
mod properties;
mod random_surfaces;
mod read;
mod refused;
mod roughness_parameters;
mod self_affine_fit;
mod series;
mod shared_exports;
mod units;
#[cfg(feature = "xlsx")]
mod workbook;

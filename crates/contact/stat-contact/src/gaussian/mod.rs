//! The Gaussian density of the heights and its integrals, in units of sigma_s: u = d/sigma_s is the separation,
//! s = w/sigma_s the interference.

mod coefficients;
pub mod density;
pub mod hertz_load;
pub mod moments;
pub mod polynomial;
pub mod window;

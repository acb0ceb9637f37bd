#![doc = include_str!("../README.md")]

pub mod gaussian;
mod legendre;
mod line;
mod linear_system;
mod minimum;
pub mod parallel;
mod roots;
#[cfg(feature = "transforms")]
pub mod transforms;

pub use legendre::{GaussLegendre, legendre_integral_above, legendre_polynomials};
pub use line::{FittedLine, line_through};
pub use linear_system::solve;
pub use minimum::minimum_in_bracket;
pub use roots::{bisect, newton_in_bracket, newton_in_brackets, zero_in_bracket};

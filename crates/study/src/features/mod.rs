//! Features of curves: where they settle, dip, level off, cross, and how steep they are.
//!
//! ```
//! use study::features::{convergence, dips, widest_plateau};
//!
//! // Area against cutoff, from long to short wavelengths.
//! let curve = [(1e-4, 0.3), (1e-5, 0.1), (1e-6, 0.15), (1e-7, 0.151), (1e-8, 0.15)];
//! assert_eq!(dips(&curve, 1.2)[0].wavelength_m, 1e-5);
//! assert_eq!(widest_plateau(&curve, 1.05).unwrap().longest_m, 1e-6);
//! assert!(convergence(&curve, 0.01).unwrap().converged);
//! ```
//!
//! A curve is a slice of points, cutoff wavelength \[m\] and a value > 0, from long to short wavelengths. Nothing here knows
//! which model or spectrum a curve comes from. All passes are linear in the number of points.

mod dip;
mod plateau;
mod ratio;
mod share;
mod slope;

pub use dip::{Dip, dips};
pub use plateau::{Plateau, widest_plateau};
pub use ratio::{agrees_from, crossings, parts_at, ratio};
pub use share::{DecadeShare, decade_shares};
pub use slope::{between, log_slope, log_slopes};
pub use stacked_contact::{Convergence, convergence};

/// A cutoff wavelength \[m\], and the value of a curve there.
pub type Point = (f64, f64);

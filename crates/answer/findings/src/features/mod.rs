//! Features of curves: settling, dips, plateaus, crossings, slopes, and the decades that decide.
//!
//! A curve is a slice of points, cutoff wavelength in m and a value > 0, from long to short wavelengths. Nothing here knows
//! which model or spectrum a curve comes from. All passes are linear in the number of points.

mod dip;
mod plateau;
mod ratio;
mod share;
mod slope;

pub use dip::{Dip, dips};
pub use plateau::{Plateau, widest_plateau};
pub use ratio::{agrees_from, crossings, parts_at, ratio};
pub use share::{DecadeShare, decade_shares, decisive_decade, slope_shares};
pub use slope::{between, log_slope, log_slopes};
pub use stacked_contact::{Convergence, convergence};

/// A cutoff wavelength \[m\], and the value of a curve there.
pub type Point = (f64, f64);

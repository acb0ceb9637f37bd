//! Search for the separation that carries a pressure.
//!
//! Everything is in u = d/sigma_s and ln p, which is nearly a parabola of u. Pressure falls with u wherever u > 0,
//! whatever the law: dp/du is eta Int F(s) g'(u+s) ds, and g' is negative there. Elsewhere p turns at most as often
//! as F does, the Gaussian being variation diminishing: a force with one maximum makes a pressure with one, whose far
//! side holds the larger separation, and only a force that steps down or dips between two rises has to be scanned.
//!
//! From the top: [`largest`] chooses the start and the solution among several; [`converge`] solves from a start, cell
//! by cell, by the steps of [`step`] within a [`bracket`]; [`scan`] finds crossings slowly and surely, where steps do
//! not converge; [`problem`] holds the load and the pressure as a function of separation.

pub mod bracket;
pub mod converge;
pub mod largest;
pub mod problem;
pub mod scan;
pub mod step;

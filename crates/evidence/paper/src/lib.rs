//! The statements of Jackson & Jacobs on the real contact area of ultrananocrystalline diamond, each checked against
//! the curves that this program computes.
//!
//! ```
//! use scene::Template;
//! use paper::{Evidence, Verdict, ledger};
//!
//! let evidence = [Evidence::compute(Template::UncdReconstructed)?];
//! let rows = ledger(&evidence);
//! assert_eq!(rows.len(), 20);
//! // The converged real pressure of about 8 H is not what the clamped law gives.
//! assert_eq!(rows[4].findings[0].1.verdict, Verdict::NotReproduced);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! * [`Evidence`]: a scene of the paper with its results;
//! * [`ledger`]: a [`Row`] per statement, with a [`Finding`] per spectrum: a value computed from the curves, a verdict, and
//!   one honest sentence;
//! * [`parts`]: what each statement says, thing by thing, with a mark for every [`Reading`] of the text;
//! * [`table`] and [`parts_table`]: both for `claims.csv` and `parts.csv`;
//! * [`other_models`]: what models that the paper does not have say of its surface, outside the ledger's counts;
//! * [`opening`]: both as the opening of a report.
//!
//! Nothing is tuned to make a row pass: the criterion for reproduction is written beside a statement before any
//! number.
#![deny(missing_docs)]

mod claims;
mod evidence;
mod ledger;
mod other_models;
mod section;

pub use claims::{ledger, parts};
pub use evidence::{Evidence, Reading};
pub use ledger::{Finding, Part, Row, Statement, UNKNOWN, Verdict, parts_table, parts_that_hold, table};
pub use other_models::{OtherModel, other_models, other_models_table};
pub use section::opening;

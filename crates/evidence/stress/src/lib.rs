//! Random extreme states by the million, tested against the promises of every result (`docs/develop/stress.md`).
//!
//! ```
//! let tally = stress::run(stress::Scope::Everything, 0..200, 1, |_| ());
//! assert_eq!(tally.states["hertz"], 29);
//! ```
//!
//! Main types:
//! * [`StatisticalCase`], [`AsperityCase`], [`StackCase`]: the numbers of a state, drawn from its own [`Draw`];
//!   printed, they are literals for a regression test.
//! * [`Trial`]: the tests of one state; [`Tally`]: the outcome of many, worst cases included.
//! * [`Condition`]: sensitivity of the answers to their inputs.
//!
//! Not here: reference values of high precision, which are in `tests/reference`.
#![deny(missing_docs)]

mod asperity_case;
mod condition;
mod draw;
mod law;
mod material;
mod reference_quadrature;
mod report;
mod run;
mod stack_case;
mod statistical;
mod statistical_trial;
mod tally;

pub use asperity_case::{AsperityCase, try_asperity};
pub use condition::{Condition, Slopes, conditions, slopes};
pub use draw::Draw;
pub use law::Response;
pub use material::{Material, Reach};
pub use reference_quadrature::{Integrals, integrals};
pub use report::{summary, write_csv};
pub use run::{Scope, run};
pub use stack_case::{StackCase, try_stack};
pub use statistical::{Kind, Question, StatisticalCase};
pub use statistical_trial::{Sample, try_state};
pub use tally::{Record, Spread, Tally, Trial, WorstCase};

//! Run time against error: this program beside scipy, `ContactMechanics` and fixed grids, in one run on one machine.
//!
//! ```
//! let table = work_precision::reference::committed()?;
//! let hertz = &table[0];
//! let answer = work_precision::ours::answer(hertz, &hertz.states[1], work_precision::point::Given::Pressure, 1e-10);
//! assert!(work_precision::point::Given::Pressure.error(&answer, &hertz.states[1]) < 1e-9);
//! # Ok::<(), String>(())
//! ```
//!
//! The steps, one module each:
//! * [`reference`](mod@reference): the states with their high-precision values, `tests/reference/work_precision.csv`;
//! * [`ours`] and [`competitors`]: who answers, and how long that takes; [`clock`] is the stopwatch;
//! * [`study`]: asks everybody everything, and yields a [`point::Point`] per answer, held against its reference;
//! * [`kernels`], [`stack`] and [`scaling`]: what single asperities and scales of a stack cost, and how the program grows;
//! * [`verdicts`]: whether a competitor is ever both faster and more accurate, and by how much we are ahead;
//! * `surrogate`, behind the feature of that name: what an interval costs by plain sampling and by fitted polynomials;
//! * [`files`], [`pictures`], [`sections`], [`page`]: `docs/develop/performance/` and the tables of
//!   `docs/develop/performance.md`.
//!
//! Times are of one thread, the shortest of many repetitions: machines are shared, and the shortest is the least disturbed.
#![deny(missing_docs)]

pub mod clock;
pub mod competitors;
pub mod files;
pub mod kernels;
pub mod machine;
pub mod ours;
pub mod page;
pub mod pictures;
pub mod point;
pub mod reference;
pub mod scaling;
pub mod sections;
pub mod stack;
pub mod study;
#[cfg(feature = "surrogate")]
pub mod surrogate;
pub mod verdicts;

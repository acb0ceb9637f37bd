//! Run time against error: this program beside scipy, `ContactMechanics` and fixed grids, in one run on one machine.
//!
//! ```
//! use work_precision::point::GivenQuantity;
//!
//! let table = work_precision::reference::committed()?;
//! let hertz = &table[0];
//! let answer = work_precision::ours::answer(hertz, &hertz.states[1], GivenQuantity::Pressure, 1e-10);
//! assert!(GivenQuantity::Pressure.error(&answer, &hertz.states[1]) < 1e-9);
//! # Ok::<(), String>(())
//! ```
//!
//! The steps, one module each:
//! * [`reference`](mod@reference): the states with their high-precision values, `tests/reference/work_precision.csv`;
//! * [`ours`] and [`competitors`]: the engines; [`clock`] is the stopwatch;
//! * [`study`]: puts every question to every engine, and yields a [`point::Point`] per answer, compared with its
//!   reference;
//! * [`stack`]: cost of a scale of a stack;
//! * [`parts`]: what is measured one by one beside the states: [`kernels`], [`elements`], [`persson_states`], [`bracket`], [`intervals`],
//!   [`scan_files`], [`python_calls`] and [`scaling`] with its [`inputs`]; [`uncertain_scene`] is what intervals are of, [`bench`](mod@bench) what all are measured with; [`processes`] is for what is measured from outside, [`seeds`] for repetitions;
//! * [`verdicts`]: competitors that are both faster and more accurate, if any, and our lead otherwise;
//! * `surrogate`, behind the feature of that name: cost of an interval by plain sampling and by fitted polynomials;
//! * [`square_map`]: maps that are handed to programs of ours from scripts;
//! * [`files`], [`pictures`], [`sections`], [`page`]: `docs/develop/performance/` and the tables of `docs/develop/performance.md`.
//!
//! Times are of one thread, the shortest of many repetitions, because the shortest is the least disturbed.
#![deny(missing_docs)]

pub mod bench;
pub mod bracket;
pub mod clock;
pub mod competitors;
pub mod elements;
pub mod files;
pub mod inputs;
pub mod intervals;
pub mod kernels;
pub mod machine;
pub mod ours;
pub mod page;
pub mod parts;
pub mod persson_states;
pub mod pictures;
pub mod point;
pub mod processes;
pub mod python_calls;
pub mod reference;
pub mod scaling;
pub mod scan_files;
pub mod sections;
pub mod seeds;
pub mod square_map;
pub mod stack;
pub mod study;
#[cfg(feature = "surrogate")]
pub mod surrogate;
pub mod uncertain_scene;
pub mod verdicts;

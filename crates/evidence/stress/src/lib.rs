//! Random extreme states by the million, tested against the promises of every result (`docs/develop/stress.md`).
//!
//! ```
//! let tally = stress::run(stress::Scope::Everything, 0..200, 1, |_| ());
//! assert_eq!(tally.states["hertz"], 29);
//! ```
//!
//! Main types:
//! * [`StatisticalCase`], and a [`Case`] for each [`Group`]: the numbers of a state, drawn from its own [`Draw`];
//!   printed, they are literals for a regression test.
//! * [`Trial`]: the tests of one state; [`Tally`]: the outcome of many, worst cases included.
//!
//! Not here: reference values of high precision, which are in `tests/reference`.
#![deny(missing_docs)]

mod adhesion_case;
mod asperity_case;
mod ball_case;
mod draw;
mod drawn_map;
mod drawn_scan;
mod drawn_spectrum;
mod elements_case;
mod interfaces_case;
mod intervals_case;
mod law;
mod law_tables_case;
mod material;
mod persson_case;
mod reference_quadrature;
mod report;
mod roughness_case;
mod run;
mod scans_case;
mod spectra_case;
mod stack_case;
mod statistical;
mod statistical_trial;
mod summits_case;
mod tally;

pub use adhesion_case::AdhesionCase;
pub use asperity_case::AsperityCase;
pub use ball_case::BallCase;
pub use draw::Draw;
pub use drawn_map::SmallMap;
pub use drawn_scan::DrawnScan;
pub use elements_case::ElementsCase;
pub use interfaces_case::InterfacesCase;
pub use intervals_case::IntervalsCase;
pub use law::Response;
pub use law_tables_case::{LawTablesCase, Shape};
pub use material::{Material, Reach};
pub use persson_case::{Coating, Deformation, Growth, PerssonCase};
pub use reference_quadrature::{Integrals, integrals};
pub use report::{summary, write_csv};
pub use roughness_case::RoughnessCase;
pub use run::{Group, Scope, run};
pub use scans_case::ScansCase;
pub use spectra_case::SpectraCase;
pub use stack_case::StackCase;
pub use statistical::{Kind, Question, StatisticalCase};
pub use statistical_trial::{Sample, try_state};
pub use summits_case::SummitsCase;
pub use tally::{Case, Record, Refused, Spread, Tally, Trial, WorstCase};

//! Run time and error of this program beside what users have today, in one run on one machine.
//!
//! Each module measures a part: [`laws`] of one asperity, [`states`] of populations, boundary [`elements`], [`persson_states`],
//! [`scan_files`] and [`python_calls`]. The Python of the others is in `competitors/`; a script there prints the rows of its part.
//! [`costs`] joins them, and [`map_programs`] has what these scripts call.
//!
//! Times are of one thread, the shortest of many repetitions, because the shortest is the least disturbed.
#![deny(missing_docs)]

pub mod clock;
pub mod costs;
pub mod csv_rows;
pub mod elements;
pub mod environment;
pub mod laws;
pub mod machine;
pub mod map_programs;
pub mod part;
pub mod persson_states;
pub mod python_calls;
pub mod reference;
pub mod scan_files;
pub mod states;
pub mod words;

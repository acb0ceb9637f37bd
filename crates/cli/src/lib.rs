//! The `truearea` command line as a library: scenes, plans, tables and figures.
//!
//! ```
//! use cli::scene::{Scene, Template};
//!
//! let scene = Scene::builtin(Template::UncdReconstructed).expect("a scene that comes with the program");
//! let results = scene.plan().compute().expect("nothing in it is out of bounds");
//! let (first_curve, first_load) = (&results.curves[0], 0);
//! let (shortest_m, area_fraction) = *first_curve.area_fractions(first_load).last().unwrap();
//! assert!(shortest_m < 1e-9 && area_fraction < 1.0);
//! ```
//!
//! How a question becomes an answer: [`args`] is what may be typed, a [`scene`] what it means in SI units, a [`plan`]
//! what has to be computed for it and no more, its [`plan::Results`] what every table ([`tables`]) and figure
//! ([`figure`], [`plot`]) is made from.
#![deny(missing_docs)]

pub mod answer;
pub mod args;
pub mod asperity_table;
mod commands;
mod explain;
pub mod failure;
pub mod features;
pub mod figure;
pub mod material;
pub mod output;
pub mod plan;
pub mod plot;
pub mod products;
mod progress;
mod provenance;
pub mod report;
pub mod scene;
pub mod sensitivity;
mod stderr;
mod summary;
pub mod surface;
pub mod table;
pub mod tables;
mod timings;
pub mod topography;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;

/// Runs the program on its command line, the program's name first, and yields its exit status: 0, 2 for bad input, 1
/// for what could not be written.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    let args: Vec<OsString> = args.into_iter().collect();
    let typed: Vec<String> = args.iter().skip(1).map(|arg| arg.to_string_lossy().into_owned()).collect();
    match args::Args::try_parse_from(&args) {
        Ok(parsed) => commands::run(parsed, &typed.join(" "))
            .map_or_else(failure::Failure::report, |()| ExitCode::SUCCESS),
        Err(error) => {
            // Help and the version are no errors; a closed pipe is nobody's concern here.
            let _ = error.print();
            ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
        }
    }
}

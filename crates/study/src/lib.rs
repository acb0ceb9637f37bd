//! Studies of real contact: a surface, a material and loads, what has to be computed for them, what comes out, and what
//! it means; all of it as data.
//!
//! ```
//! use study::scene::{Scene, Template};
//!
//! let scene = Scene::builtin(Template::UncdReconstructed)?;
//! let results = scene.plan().compute()?;
//! let (first_curve, first_load) = (&results.curves[0], 0);
//! let (shortest_m, area_fraction) = *first_curve.area_fractions(first_load).last().unwrap();
//! assert!(shortest_m < 1e-9 && area_fraction < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! How a question becomes an answer: a [`scene`] is what was asked for, in SI units and checked, its files from whoever
//! hands over their bytes ([`Files`]); a [`plan`] is what has to be computed for it and no more; its [`plan::Results`] are
//! what every table ([`result_tables`]) and figure ([`figure`]) is made from; an [`answer::Answer`] is what they say.
//!
//! What it does not do: it opens no paths, prints nothing, knows no clock, and runs on one thread unless the feature
//! `parallel` is on.

pub mod answer;
pub mod features;
pub mod figure;
mod files;
pub mod material;
pub mod models;
pub mod plan;
pub mod provenance;
pub mod result_tables;
pub mod rows;
pub mod scene;
pub mod sensitivity;
pub mod surface;
pub mod topography;

pub use files::{Files, NoFiles};
pub use parallel::{Progress, Unobserved};

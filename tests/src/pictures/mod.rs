//! The pictures of `docs/`, drawn from the program's own laws: `cargo xtask docs` writes them, a test compares them.
//!
//! ```
//! let picture = tests::pictures::pictures().into_iter().find(|picture| picture.name == "strength").unwrap();
//! assert!(picture.svg.starts_with("<svg"));
//! assert!(tests::pictures::path(picture.name).ends_with("docs/pictures/strength.svg"));
//! ```

mod same_picture;
mod sinusoid;
mod spectrum_and_stack;
mod sphere;
mod statistical;
mod strength;

pub use same_picture::is_same_picture;

use std::path::PathBuf;

use asperity::{Break, ElasticBody, MaterialPair};
use report::plot;
use staging::StagedFiles;
use study::figure::{Axis, FigureData, Series, Shows};

use crate::committed_file;

/// No picture is to weigh more: they are reviewed as text and loaded with every page.
pub const MOST_BYTES: usize = 30 * 1024;

/// A picture of the documentation.
pub struct Picture {
    /// The name of its file, without extension.
    pub name: &'static str,
    /// The document.
    pub svg: String,
}

/// Every picture of the documentation, drawn now.
pub fn pictures() -> Vec<Picture> {
    [
        spectrum_and_stack::moments(),
        sphere::force_and_area(),
        sphere::mean_pressure(),
        sinusoid::elastic_area(),
        sinusoid::plastic_area(),
        sinusoid::deformation(),
        strength::strength(),
        statistical::separation(),
        statistical::load(),
        spectrum_and_stack::area(),
        spectrum_and_stack::sampling(),
        spectrum_and_stack::strain_gradient(),
    ]
    .into()
}

/// The file of a picture.
pub fn path(name: &str) -> PathBuf {
    committed_file(&format!("docs/pictures/{name}.svg"))
}

/// The committed pictures that are not what the program draws now: those that differ, are absent, or are none of its.
pub fn stale() -> Vec<String> {
    let drawn = pictures();
    let differs = |picture: &&Picture| {
        !std::fs::read_to_string(path(picture.name))
            .is_ok_and(|committed| is_same_picture(&committed, &picture.svg))
    };
    let mut stale: Vec<String> =
        drawn.iter().filter(differs).map(|picture| picture.name.to_owned()).collect();
    let committed = std::fs::read_dir(committed_file("docs/pictures")).into_iter().flatten();
    let names = committed.filter_map(|entry| Some(entry.ok()?.path().file_stem()?.to_str()?.to_owned()));
    stale.extend(names.filter(|name| !drawn.iter().any(|picture| picture.name == name)));
    stale.sort();
    stale
}

/// Draws every picture anew; none is touched where one cannot be written.
///
/// # Errors
/// A file cannot be written.
pub fn rewrite() -> Result<(), Box<dyn std::error::Error>> {
    std::fs::create_dir_all(committed_file("docs/pictures"))?;
    let mut files = StagedFiles::default();
    for picture in pictures() {
        files.stage(&path(picture.name), |out| out.write_all(picture.svg.as_bytes()))?;
    }
    Ok(files.publish()?)
}

/// A body to look at laws with: steel, E* = 231 GPa against a rigid flat.
fn steel() -> MaterialPair {
    body(210e9, 0.3)
}

const STEEL: &str = "E = 210 GPa, ν = 0.3, rigid counterface";

fn body(youngs_modulus_pa: f64, poisson_ratio: f64) -> MaterialPair {
    let body = ElasticBody::new(youngs_modulus_pa, poisson_ratio).expect("a body within its bounds");
    MaterialPair::against_rigid(body)
}

fn picture(
    name: &'static str,
    [title, subject]: [&str; 2],
    [x_label, y_label]: [&'static str; 2],
    series: Vec<Series>,
) -> Picture {
    let figure = FigureData {
        name: name.to_owned(),
        shows: Shows::Area,
        title: title.to_owned(),
        x: Axis { column: "x", label: x_label },
        x_label: x_label.to_owned(),
        y_label,
        series,
        bands: Vec::new(),
        gaps: Vec::new(),
        marks: Vec::new(),
    };
    let provenance = ["drawn by `cargo xtask docs` from the laws of the program; do not edit".to_owned()];
    Picture { name, svg: plot::svg(&figure, subject, &provenance) }
}

/// A line under a condition, which its colour stands for.
fn line(condition: &str, colour: usize, points: Vec<(f64, f64)>) -> Series {
    Series::under(condition, colour, points)
}

/// Dashes the line, to tell it from others of its colour.
fn dashed(curve: &str, dash: usize, line: Series) -> Series {
    Series { curve: curve.to_owned(), dash, ..line }
}

/// `count` values in geometric steps; both ends are met exactly.
fn geometric([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let steps = (count - 1) as f64;
    let inner = (1..count - 1).map(|i| from * (to / from).powf(i as f64 / steps));
    std::iter::once(from).chain(inner).chain([to]).collect()
}

/// The values, and both sides of every break between them, so that a jump is drawn upright.
fn with_breaks(mut values: Vec<f64>, breaks: impl IntoIterator<Item = Break>) -> Vec<f64> {
    let (first, last) = (values[0], values[values.len() - 1]);
    let inside = breaks.into_iter().filter(|b| first < b.at && b.at < last);
    values.extend(inside.flat_map(|b| [b.at * (1.0 - 1e-9), b.at * (1.0 + 1e-9)]));
    values.sort_by(f64::total_cmp);
    values
}

fn along(values: &[f64], law: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    values.iter().map(|&x| (x, law(x))).collect()
}

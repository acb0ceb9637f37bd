//! Pictures of `docs/`, drawn from the program's own laws: `cargo xtask docs` writes them, a test compares them.
//!
//! ```
//! let picture = tests::pictures::pictures().into_iter().find(|picture| picture.name == "strength").unwrap();
//! assert!(picture.svg.starts_with("<svg"));
//! assert!(tests::pictures::path(picture.name).ends_with("docs/pictures/strength.svg"));
//! ```

pub mod contact_challenge;
mod nature;
mod responses;
mod same_picture;
mod sinusoid;
mod spectrum_and_stack;
mod sphere;
mod statistical;
mod strength;

pub use same_picture::is_same_picture;

use std::path::PathBuf;

use asperity::{Break, ElasticBody, MaterialPair};
use report::chart;
use study::figure::{Axis, FigureData, Series, Shows};
use tables::staging::StagedFiles;

use crate::committed_file;

/// Largest size of a picture: pictures are reviewed as text and loaded with every page.
pub const MOST_BYTES: usize = 30 * 1024;

/// Note in every picture.
const PROVENANCE: &str = "drawn by `cargo xtask docs` from the laws of the program; do not edit";

/// Picture of the documentation.
pub struct Picture {
    /// Name of its file, without extension.
    pub name: &'static str,
    /// Contents of the file.
    pub svg: String,
}

/// Draws every picture of the documentation.
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
        contact_challenge::area_over_load(),
        responses::pull_off(),
        responses::shear_loop(),
        nature::resistances(),
        nature::joints(),
    ]
    .into()
}

/// Path of a picture.
pub fn path(name: &str) -> PathBuf {
    committed_file(&format!("docs/pictures/{name}.svg"))
}

/// Committed pictures that differ from those drawn now, are missing, or are not drawn any more.
pub fn stale() -> Vec<String> {
    let drawn = pictures();
    let differs = |picture: &&Picture| {
        !std::fs::read_to_string(path(picture.name))
            .is_ok_and(|committed| is_same_picture(&committed, &picture.svg))
    };
    let mut stale: Vec<String> =
        drawn.iter().filter(differs).map(|picture| picture.name.to_owned()).collect();
    let committed = std::fs::read_dir(committed_file("docs/pictures")).into_iter().flatten();
    let svgs = committed.filter_map(Result::ok).map(|entry| entry.path());
    // A photograph of the report in a browser is not drawn here.
    let svgs = svgs.filter(|path| path.extension().is_some_and(|extension| extension == "svg"));
    let names = svgs.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()));
    stale.extend(names.filter(|name| !drawn.iter().any(|picture| picture.name == name)));
    stale.sort();
    stale
}

/// Draws every picture anew; writes none if one cannot be written.
///
/// # Errors
/// The error of writing.
pub fn rewrite() -> Result<(), Box<dyn std::error::Error>> {
    std::fs::create_dir_all(committed_file("docs/pictures"))?;
    let mut files = StagedFiles::default();
    for picture in pictures() {
        files.stage(&path(picture.name), |out| out.write_all(picture.svg.as_bytes()))?;
    }
    files.publish()?;
    Ok(())
}

/// Body of the pictures: steel, E* = 231 GPa against a rigid flat.
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
    // Ordinates without a unit are shares, in percent.
    let shows = if y_label.ends_with(" (Pa)") { Shows::Response } else { Shows::Area };
    let x = Axis { column: "x", label: x_label };
    let figure = FigureData { title: title.to_owned(), ..FigureData::new(name, shows, x, y_label, series) };
    Picture { name, svg: chart::svg(&figure, subject, &[PROVENANCE.to_owned()]) }
}

/// Line under a condition.
fn line(condition: &str, condition_index: usize, points: Vec<(f64, f64)>) -> Series {
    dashed("", 0, Series::under(condition, condition_index, points))
}

/// Line of a curve with a dash pattern: 0 is solid. The drawing dashes the first curve of several and leaves the second solid.
fn dashed(curve: &str, dash: usize, line: Series) -> Series {
    let curve_index = match dash {
        0 => 1,
        1 => 0,
        more => more,
    };
    Series { curve: curve.to_owned(), curve_index, ..line }
}

/// `count` values in geometric steps; both ends are met exactly.
fn geometric([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let steps = (count - 1) as f64;
    let inner = (1..count - 1).map(|i| from * (to / from).powf(i as f64 / steps));
    std::iter::once(from).chain(inner).chain([to]).collect()
}

/// Adds both sides of every break between the values, so that a jump is drawn upright.
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

//! Golden curves: every curve of every figure of the scenes that come with the program, as text that reviewers can
//! read.

use std::path::PathBuf;

use approx::relative_eq;
use findings::features::convergence;
use insta::Snapshot;
use insta::comparator::Comparator;
use insta::internals::SnapshotContents;
use report::products;
use scene::{Scene, Template};
use study::figure::FigureData;
use tables::Cells;

use crate::committed_file;

/// Relative deviation from which a golden value counts as changed.
pub const TOLERANCE: f64 = 1e-9;

/// Picture of the README, and its figure.
const README_PICTURE: (&str, Template, &str) =
    ("docs/contact-area.svg", Template::UncdReconstructed, "figure-4");

/// Curve of a figure, under all its conditions, with the name of its snapshot.
pub struct GoldenCurve {
    /// Name `scene__figure__curve`, or `scene__figure` for a figure of one quantity.
    pub name: String,
    /// Figure with this curve alone.
    pub data: FigureData,
}

/// Computes every curve of every figure of every scene, by the code that `cargo xtask reproduce` runs.
pub fn curves() -> Vec<GoldenCurve> {
    let of_scene = |template: Template| {
        let (scene, results) = computed(template);
        let figures = products::figures(&scene, &results);
        figures
            .into_iter()
            .flat_map(move |figure| curves_of(&format!("{}__{}", template.name(), figure.name), &figure))
    };
    [Template::UncdMeasured, Template::UncdReconstructed].into_iter().flat_map(of_scene).collect()
}

fn curves_of(prefix: &str, figure: &FigureData) -> Vec<GoldenCurve> {
    let mut curves: Vec<GoldenCurve> = Vec::new();
    for series in &figure.series {
        let name = match series.curve.as_str() {
            "" => prefix.to_owned(),
            curve => format!("{prefix}__{}", curve.replace(' ', "-")),
        };
        match curves.iter_mut().find(|known| known.name == name) {
            Some(known) => known.data.series.push(series.clone()),
            None => {
                let data = FigureData { series: vec![series.clone()], bands: Vec::new(), ..figure.clone() };
                curves.push(GoldenCurve { name, data });
            }
        }
    }
    curves
}

fn computed(template: Template) -> (Scene, study::plan::Results) {
    let scene = Scene::builtin(template).expect("a scene of the program's own");
    let results = scene.plan().compute().expect("a scene of the program's own");
    (scene, results)
}

impl GoldenCurve {
    /// Returns the curve as text: a line of column names, then a line per abscissa, with twelve digits.
    pub fn text(&self) -> String {
        // The linear laws follow from the spectrum, which has lines of its own.
        let table = FigureData { bands: Vec::new(), ..self.data.clone() }.table();
        let mut lines = vec![table.columns().map(|(name, _)| name.to_owned()).collect::<Vec<_>>().join(",")];
        for row in 0..table.rows() {
            let cell = |cells: &Cells| match cells {
                Cells::Numbers(numbers) => {
                    numbers[row].map_or(String::new(), |value| format!("{value:.11e}"))
                }
                _ => unreachable!("figures hold numbers alone"),
            };
            lines.push(table.columns().map(|(_, cells)| cell(cells)).collect::<Vec<_>>().join(","));
        }
        lines.join("\n")
    }

    /// Path of the snapshot.
    pub fn path(&self) -> PathBuf {
        committed_file(&format!("tests/golden/{}.snap", self.name))
    }

    /// Accepted text, if any.
    pub fn accepted(&self) -> Option<String> {
        let file = std::fs::read_to_string(self.path()).ok()?;
        // A snapshot is a block of metadata between two lines of dashes, and the text.
        file.splitn(3, "---\n").nth(2).map(|text| text.trim_end().to_owned())
    }

    /// True if the curve agrees with the accepted one.
    pub fn is_as_accepted(&self) -> bool {
        let columns = self.accepted().and_then(|accepted| deviations(&accepted, &self.text()));
        columns.is_some_and(|columns| columns.iter().all(|(_, deviation)| *deviation <= TOLERANCE))
    }
}

/// Summary for reviewers: a line per line of a figure, with its ends, its extremes, and the point from which it
/// settles.
pub fn summary(curves: &[GoldenCurve]) -> String {
    let mut lines =
        vec!["curve | line | points | first | last | least | most | within 1 % of the last from".to_owned()];
    for curve in curves {
        for series in &curve.data.series {
            let values = || series.points.iter().map(|(_, value)| *value);
            let (first, last) =
                (values().next().unwrap_or(f64::NAN), values().next_back().unwrap_or(f64::NAN));
            let against_cutoff = !series.curve.is_empty() && curve.data.x.column == "wavelength_m";
            let settled = convergence(&series.points, 0.01).filter(|_| against_cutoff);
            lines.push(format!(
                "{} | {} | {} | {first:.4e} | {last:.4e} | {:.4e} | {:.4e} | {}",
                curve.name,
                if series.condition.is_empty() { "-" } else { &series.condition },
                series.points.len(),
                values().fold(f64::INFINITY, f64::min),
                values().fold(f64::NEG_INFINITY, f64::max),
                settled.map_or_else(|| "-".to_owned(), |found| format!("{:.4e} m", found.wavelength_m)),
            ));
        }
    }
    lines.join("\n")
}

/// Text snapshots whose numbers agree to the golden tolerance.
#[derive(Clone)]
pub struct Numbers;

impl Comparator for Numbers {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        match (reference.contents(), test.contents()) {
            (SnapshotContents::Text(accepted), SnapshotContents::Text(computed)) => {
                deviations(&accepted.to_string(), &computed.to_string())
                    .is_some_and(|columns| columns.iter().all(|(_, deviation)| *deviation <= TOLERANCE))
            }
            _ => false,
        }
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// Largest relative deviation of each column; `None` if names or lengths differ.
pub fn deviations(accepted: &str, computed: &str) -> Option<Vec<(String, f64)>> {
    let (accepted, computed) = (columns(accepted)?, columns(computed)?);
    let same_shape = accepted.len() == computed.len()
        && accepted.iter().zip(&computed).all(|(a, c)| a.0 == c.0 && a.1.len() == c.1.len());
    same_shape.then(|| {
        let largest =
            |a: &[f64], c: &[f64]| a.iter().zip(c).map(|(&a, &c)| deviation(a, c)).fold(0.0, f64::max);
        accepted.iter().zip(&computed).map(|((name, a), (_, c))| (name.clone(), largest(a, c))).collect()
    })
}

fn deviation(accepted: f64, computed: f64) -> f64 {
    if relative_eq!(accepted, computed, epsilon = 0.0, max_relative = f64::EPSILON)
        || both_empty(accepted, computed)
    {
        return 0.0;
    }
    let relative = (computed / accepted - 1.0).abs();
    if relative.is_nan() { f64::INFINITY } else { relative }
}

/// Returns true if both are NaN, as empty cells are read.
fn both_empty(accepted: f64, computed: f64) -> bool {
    accepted.is_nan() && computed.is_nan()
}

/// Columns of a snapshot's text by name; empty cells are NaN.
pub(crate) fn columns(text: &str) -> Option<Vec<(String, Vec<f64>)>> {
    let mut lines = text.lines();
    let mut columns: Vec<(String, Vec<f64>)> =
        lines.next()?.split(',').map(|name| (name.to_owned(), vec![])).collect();
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        if cells.len() != columns.len() {
            return None;
        }
        for ((_, values), cell) in columns.iter_mut().zip(cells) {
            values.push(if cell.is_empty() { f64::NAN } else { cell.parse().ok()? });
        }
    }
    Some(columns)
}

/// Returns true if the README's picture is the figure as drawn now.
pub fn readme_picture_is_current() -> bool {
    std::fs::read_to_string(committed_file(README_PICTURE.0))
        .is_ok_and(|committed| committed == readme_picture())
}

/// Draws the README's picture anew.
pub fn rewrite_readme_picture() {
    tables::staging::write_file(&committed_file(README_PICTURE.0), readme_picture())
        .expect("the docs are writable");
}

fn readme_picture() -> String {
    let (_, template, figure) = README_PICTURE;
    let (scene, results) = computed(template);
    let at = scene.figures.iter().position(|of_scene| of_scene.name == figure);
    let drawn = products::figure_documents(&scene, &results, None).nth(at.expect("a figure of that scene"));
    drawn.expect("every figure is drawn").svg()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deviation_is_found_in_its_column_and_a_change_of_shape_is_reported() {
        let accepted = "x,a,b\n1e0,2e0,4e0\n2e0,0e0,5e0";
        let found = deviations(accepted, "x,a,b\n1e0,2e0,4e0\n2e0,0e0,5.0005e0").unwrap();
        assert_eq!(found[0], ("x".to_owned(), 0.0));
        assert_eq!(found[1], ("a".to_owned(), 0.0));
        assert!((found[2].1 - 1e-4).abs() < 1e-9);
        assert_eq!(deviations(accepted, "x,a,b\n1e0,2e0,4e0"), None);
        assert_eq!(deviations(accepted, "x,a,c\n1e0,2e0,4e0\n2e0,0e0,5e0"), None);
        assert_eq!(deviations("x\nNaN", "x\n1e0").unwrap()[0].1, f64::INFINITY);
    }
}

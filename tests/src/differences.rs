//! Page of changed golden curves: old and new drawn over each other, with the deviation of each line.

use std::path::PathBuf;

use maud::{DOCTYPE, Markup, PreEscaped, html};
use report::chart;
use study::figure::{FigureData, Series};

use crate::committed_file;
use crate::golden::{GoldenCurve, TOLERANCE, columns, deviations};

/// Writes the page on the curves that differ from the accepted ones, and returns its path; `None` if all agree.
///
/// # Panics
/// If the page cannot be written.
pub fn write_differences(curves: &[GoldenCurve]) -> Option<PathBuf> {
    let changed: Vec<&GoldenCurve> = curves.iter().filter(|curve| !curve.is_as_accepted()).collect();
    if changed.is_empty() {
        return None;
    }
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| committed_file("target"), PathBuf::from);
    std::fs::create_dir_all(&target).expect("the target folder is writable");
    let path = target.join("golden-differences.html");
    let page = page(&changed).into_string();
    tables::staging::write_file(&path, page).expect("the target folder is writable");
    Some(path)
}

fn page(changed: &[&GoldenCurve]) -> Markup {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                title { "Golden curves that changed" }
                style { "body{font-family:sans-serif;max-width:60rem;margin:2rem auto} td,th{padding:0 .8rem;text-align:right}" }
            }
            body {
                h1 { (changed.len()) " golden curves changed by more than " (format!("{TOLERANCE:e}")) }
                p { "Pale: as accepted. Dashed: as computed now. " code { "cargo xtask golden --accept" } " takes the new ones." }
                @for curve in changed { (section(curve)) }
            }
        }
    }
}

fn section(curve: &GoldenCurve) -> Markup {
    let accepted = curve.accepted();
    let moved = accepted.as_ref().and_then(|accepted| deviations(accepted, &curve.text()));
    html! {
        h2 { (curve.name) }
        @match (&accepted, moved) {
            (None, _) => p { "New: nothing was accepted before." },
            (Some(_), None) => p { "Other lines, or another number of points, than accepted." },
            (Some(_), Some(columns)) => table {
                tr { th { "line" } th { "largest relative deviation" } }
                @for (name, deviation) in columns { tr { td { (name) } td { (format!("{deviation:.1e}")) } } }
            },
        }
        (PreEscaped(chart::svg(&overlaid(curve, accepted.as_deref()), &curve.name, &[])))
    }
}

/// Draws the accepted lines beneath the computed ones.
fn overlaid(curve: &GoldenCurve, accepted: Option<&str>) -> FigureData {
    let columns = accepted.and_then(columns).unwrap_or_default();
    let abscissas = columns.first().map(|(_, values)| values.as_slice()).unwrap_or_default();
    let old = |(index, (name, values)): (usize, &(String, Vec<f64>))| {
        let points = abscissas.iter().copied().zip(values.iter().copied());
        Series {
            column: name.clone(),
            curve: "accepted".to_owned(),
            condition: String::new(),
            condition_in_full: String::new(),
            load: None,
            curve_index: 1,
            look: None,
            condition_index: Some(index),
            points: points.filter(|(_, value)| !value.is_nan()).collect(),
        }
    };
    let new = |(index, series): (usize, &Series)| Series {
        curve: "computed now".to_owned(),
        curve_index: 0,
        look: None,
        condition_index: Some(index),
        ..series.clone()
    };
    let old = columns.iter().skip(1).enumerate().map(old);
    let series = old.chain(curve.data.series.iter().enumerate().map(new)).collect();
    FigureData { name: curve.name.clone(), series, ..curve.data.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_shows_old_and_new_over_each_other() {
        let mut curves = crate::golden::curves();
        let last = curves.last_mut().expect("curves");
        last.data.series[0].points[3].1 *= 1.001;
        let changed = [&*last];
        let page = page(&changed).into_string();
        assert!(page.contains("1.0e-3") && page.contains(&last.name), "{page}");
        assert!(page.contains("accepted") && page.contains("computed now") && page.contains("<svg"));
        assert!(!last.is_as_accepted());
    }
}

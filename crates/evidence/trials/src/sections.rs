//! Tables of `docs/guide/which-model.md`.

use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::ElementsRow;
use crate::programme::SPREADS_OVER_HARDNESS;
use crate::ratios::RatioRow;

/// Factor within which a model agrees (`docs/guide/judge.md`).
const AGREEMENT: f64 = 4.0 / 3.0;
/// Light load p/(E* h') under which spectra of different widths are compared.
const LIGHT: f64 = 0.01;

/// Quantity by which rows belong to a column of a table.
type Quantity = fn(&RatioRow) -> f64;

/// Columns of a table: headings, and from where to where the quantity lies.
type Columns<'c> = &'c [(&'c str, f64, f64)];

/// Returns the page with new tables; its text is written by hand.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks a section.
pub fn written(page: &str, elements: &[ElementsRow], ratios: &[RatioRow]) -> Result<String, TrialError> {
    const LOADS: Columns<'_> = &[
        ("p/(E\\* h') to 0.04", 0.0, 0.05),
        ("0.07 to 0.25", 0.05, 0.3),
        ("0.4 and more", 0.3, f64::INFINITY),
    ];
    const WIDTHS: Columns<'_> = &[
        ("α to 3", 0.0, 3.1),
        ("5 to 12", 3.1, 12.0),
        ("17 to 51", 12.0, 100.0),
        ("140 to 771", 100.0, f64::INFINITY),
    ];
    let (yielding, elastic): (Vec<&RatioRow>, Vec<&RatioRow>) =
        ratios.iter().partition(|row| row.spread_over_hardness.is_some());
    let light: Vec<&RatioRow> =
        elastic.iter().copied().filter(|row| row.pressure_over_gradient == LIGHT).collect();
    let headings = SPREADS_OVER_HARDNESS.map(|ratio| format!("s/H = {}", three_digits(ratio)));
    let hardnesses: Vec<(&str, f64, f64)> = headings
        .iter()
        .zip(SPREADS_OVER_HARDNESS)
        .map(|(heading, ratio)| (heading.as_str(), ratio, ratio * 1.01))
        .collect();
    let sections = [
        ("elastic", ranges(&elastic, |row| row.pressure_over_gradient, LOADS)),
        ("widths", ranges(&light, |row| row.alpha, WIDTHS)),
        ("hardness", ranges(&yielding, |row| row.spread_over_hardness.unwrap_or(0.0), &hardnesses)),
        ("extent", extent(elements)),
    ];
    sections.into_iter().try_fold(page.to_owned(), |page, (name, contents)| {
        with_section(&page, name, &contents).map_err(TrialError::Page)
    })
}

/// Smallest and largest ratio of every model in each column, and its share of agreement.
fn ranges(rows: &[&RatioRow], quantity: Quantity, columns: Columns<'_>) -> String {
    let mut models: Vec<&str> = Vec::new();
    for row in rows {
        if !models.contains(&row.model.as_str()) {
            models.push(&row.model);
        }
    }
    let line = |model: &&str| {
        let of_model = || rows.iter().copied().filter(|row| row.model == *model);
        let cell = |&(_, from, to): &(&str, f64, f64)| {
            range(of_model().filter(|row| (from..to).contains(&quantity(row))).map(|row| row.ratio))
        };
        let mut cells = vec![format!("`{model}`")];
        cells.extend(columns.iter().map(cell));
        cells.push(format!("{} of {}", of_model().filter(|row| agrees(row)).count(), of_model().count()));
        cells
    };
    let lines: Vec<Vec<String>> = models.iter().map(line).collect();
    let mut headings = vec!["model"];
    headings.extend(columns.iter().map(|(heading, ..)| *heading));
    headings.push("agrees");
    table(&headings, &lines)
}

/// Extent of the study.
fn extent(elements: &[ElementsRow]) -> String {
    let mut bands = Vec::new();
    for row in elements {
        if !bands.contains(&row.band()) {
            bands.push(row.band());
        }
    }
    let solved: u64 = elements.iter().map(|row| row.realisations).sum();
    format!(
        "{} spectra, α from {}; {} areas, each the mean over 4 to 12 surfaces, {solved} contacts on the finer grids.\n",
        bands.len(),
        range(elements.iter().map(|row| row.alpha)),
        elements.len(),
    )
}

/// Range of some values.
fn range(values: impl Iterator<Item = f64>) -> String {
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high { "-".to_owned() } else { format!("{} to {}", three_digits(low), three_digits(high)) }
}

/// Returns true for a ratio within 3/4 and 4/3, widened by two standard errors.
fn agrees(row: &RatioRow) -> bool {
    let error = 2.0 * row.standard_error;
    (1.0 / AGREEMENT - error..=AGREEMENT + error).contains(&row.ratio)
}

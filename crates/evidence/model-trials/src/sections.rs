//! Tables of `docs/guide/which-model.md`.

use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::ElementsRow;
use crate::gluing::{GluingRow, error_of};
use crate::hardness::plastic_areas;
use crate::pictures::models;
use crate::programme::{HARD_PRESSURES, HURST_EXPONENTS, SPREADS_OVER_HARDNESS};
use crate::ratios::RatioRow;
use crate::refit::NayakForm;
use crate::windows::WindowsRow;

/// Factor within which a model agrees (`docs/guide/judge.md`).
const AGREEMENT: f64 = 4.0 / 3.0;

/// Results from which the tables are made.
#[derive(Clone, Copy, Debug)]
pub struct Findings<'f> {
    /// Areas of boundary elements.
    pub elements: &'f [ElementsRow],
    /// Ratios of models to boundary elements.
    pub ratios: &'f [RatioRow],
    /// Models on wide bands and on their windows.
    pub windows: &'f [WindowsRow],
    /// Results of gluing two decades.
    pub gluing: &'f [GluingRow],
}

/// Returns the page with new tables; its text is written by hand.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks a section.
pub fn written(page: &str, findings: &Findings<'_>) -> Result<String, TrialError> {
    let sections = [
        ("elastic", elastic(findings.ratios)),
        ("hardness", hardness(findings.ratios)),
        ("plastic", plastic(findings.elements)),
        ("windows", windows(findings.windows)),
        ("gluing", gluing(findings)),
        ("constants", constants(findings.elements)),
        ("extent", extent(findings.elements)),
    ];
    sections.into_iter().try_fold(page.to_owned(), |page, (name, contents)| {
        with_section(&page, name, &contents).map_err(TrialError::Page)
    })
}

/// Smallest and largest ratio of every elastic model, at light, medium and heavy loads, and its share of agreement.
fn elastic(rows: &[RatioRow]) -> String {
    let elastic: Vec<&RatioRow> = rows.iter().filter(|row| row.spread_over_hardness.is_none()).collect();
    let bands: [(&str, [f64; 2]); 3] = [
        ("p/(E\\* h') to 0.04", [0.0, 0.05]),
        ("0.07 to 0.25", [0.05, 0.3]),
        ("0.4 and more", [0.3, f64::INFINITY]),
    ];
    let lines: Vec<Vec<String>> = models(&elastic)
        .iter()
        .map(|model| {
            let of_model = || elastic.iter().filter(|row| row.model == *model);
            let within = |[from, to]: [f64; 2]| {
                of_model().filter(move |row| (from..to).contains(&row.pressure_over_gradient)).copied()
            };
            let mut cells = vec![format!("`{model}`")];
            cells.extend(bands.iter().map(|(_, band)| range(within(*band).map(|row| row.ratio))));
            cells.push(share(of_model().copied()));
            cells
        })
        .collect();
    let mut columns = vec!["model"];
    columns.extend(bands.iter().map(|(name, _)| *name));
    columns.push("agrees");
    table(&columns, &lines)
}

/// Smallest and largest ratio of every yielding model at each s/H.
fn hardness(rows: &[RatioRow]) -> String {
    let yielding: Vec<&RatioRow> = rows.iter().filter(|row| row.spread_over_hardness.is_some()).collect();
    let lines: Vec<Vec<String>> = models(&yielding)
        .iter()
        .map(|model| {
            let of_model = || yielding.iter().filter(|row| row.model == *model).copied();
            let at = |ratio: &f64| {
                range(of_model().filter(|row| row.spread_over_hardness == Some(*ratio)).map(|row| row.ratio))
            };
            let mut cells = vec![format!("`{model}`")];
            cells.extend(SPREADS_OVER_HARDNESS.iter().map(at));
            cells.push(share(of_model()));
            cells
        })
        .collect();
    let columns: Vec<String> =
        SPREADS_OVER_HARDNESS.iter().map(|ratio| format!("s/H = {}", three_digits(*ratio))).collect();
    let mut names = vec!["model"];
    names.extend(columns.iter().map(String::as_str));
    names.push("agrees");
    table(&names, &lines)
}

/// Plastic areas by elements and by Persson's theory, medians over the spectra.
fn plastic(elements: &[ElementsRow]) -> String {
    let areas = plastic_areas(elements);
    let line = |spread: f64, pressure: f64| {
        let at = || {
            areas.iter().filter(move |row| {
                row.spread_over_hardness == spread && row.pressure_over_gradient == pressure
            })
        };
        let judged = at().map(|row| row.judged);
        let ratio = at().map(|row| row.persson / row.judged);
        vec![
            three_digits(spread),
            three_digits(pressure),
            range(judged),
            three_digits(at().map(|row| row.persson).fold(0.0, f64::max)),
            range(ratio),
        ]
    };
    let lines: Vec<Vec<String>> = SPREADS_OVER_HARDNESS
        .iter()
        .flat_map(|&spread| HARD_PRESSURES.iter().map(move |&pressure| (spread, pressure)))
        .map(|(spread, pressure)| line(spread, pressure))
        .collect();
    table(&["s/H", "p/(E\\* h')", "plastic area, elements", "Persson", "ratio"], &lines)
}

/// Agreement of the ratios on windows with that of the whole band.
fn windows(rows: &[WindowsRow]) -> String {
    let mut names: Vec<&str> = Vec::new();
    rows.iter().for_each(|row| {
        if !names.contains(&row.model.as_str()) {
            names.push(&row.model);
        }
    });
    let lines: Vec<Vec<String>> = names
        .iter()
        .map(|name| {
            let of_model = || rows.iter().filter(|row| row.model == *name);
            let beyond: Vec<f64> = of_model().filter_map(|row| row.beyond).collect();
            let within = beyond.iter().filter(|beyond| **beyond == 1.0).count();
            let worst = beyond
                .iter()
                .copied()
                .fold(1.0, |worst: f64, one| if one.ln().abs() > worst.ln().abs() { one } else { worst });
            let on_windows =
                of_model().flat_map(|row| [row.least_on_windows, row.largest_on_windows]).flatten();
            let none = || "-".to_owned();
            vec![
                format!("`{name}`")
                    .replace("`last decade`", "p/p_w × last decade")
                    .replace("`last decade and a half`", "p/p_w × last decade and a half"),
                range(of_model().map(|row| row.whole)),
                if beyond.is_empty() { none() } else { range(on_windows) },
                if beyond.is_empty() { none() } else { format!("{within} of {}", beyond.len()) },
                if beyond.is_empty() { none() } else { three_digits(worst) },
            ]
        })
        .collect();
    table(&["model", "ratio, whole band", "ratios, windows", "within", "worst factor beyond"], &lines)
}

/// Error of gluing, for every exponent and load.
fn gluing(findings: &Findings<'_>) -> String {
    let mut loads: Vec<f64> = findings.gluing.iter().map(|row| row.pressure_over_gradient).collect();
    loads.sort_by(f64::total_cmp);
    loads.dedup();
    let cell = |load: f64, hurst: f64| {
        let same = |row: &&GluingRow| row.pressure_over_gradient == load && row.hurst_exponent == hurst;
        let error = findings.gluing.iter().find(same).and_then(|row| error_of(row, findings.elements));
        error.map_or_else(
            || "-".to_owned(),
            |(off, error)| {
                format!("{:+.1} % ± {:.1}", 100.0 * off, 100.0 * error)
                    .replace("-0.0", "+0.0")
                    .replace('-', "−")
            },
        )
    };
    let lines: Vec<Vec<String>> = loads
        .iter()
        .map(|&load| {
            let mut cells = vec![three_digits(load)];
            cells.extend(HURST_EXPONENTS.iter().map(|&hurst| cell(load, hurst)));
            cells
        })
        .collect();
    table(&["p/(E\\* h')", "H = 0.3", "H = 0.5", "H = 0.8"], &lines)
}

/// Constants of `algebraic-nayak`, of the program and refitted.
fn constants(elements: &[ElementsRow]) -> String {
    let fitted = NayakForm::fitted(elements);
    let line = |name: &str, form: &NayakForm| {
        let misfit = form.misfit(elements);
        vec![
            name.to_owned(),
            format!("{:.4}", form.a),
            format!("{:.4}", form.b),
            format!("{:.1} %", 100.0 * misfit.rms),
            format!("{:+.1} %", 100.0 * misfit.worst).replace('-', "−"),
            misfit.well_known.to_string(),
            format!("{:.1}", misfit.rms_in_standard_errors),
            format!("{:+.1}", misfit.worst_in_standard_errors).replace('-', "−"),
        ]
    };
    table(
        &["constants", "a", "b", "rms", "worst", "of so many areas", "rms, all, in standard errors", "worst"],
        &[line("the program's", &NayakForm::OF_THE_PROGRAM), line("fitted here", &fitted)],
    )
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
    let alpha =
        |pick: fn(f64, f64) -> f64, start: f64| elements.iter().map(|row| row.alpha).fold(start, pick);
    format!(
        "{} spectra, α from {} to {}; {} areas, each the mean over 4 to 12 surfaces, {solved} contacts on the finer grids.\n",
        bands.len(),
        three_digits(alpha(f64::min, f64::INFINITY)),
        three_digits(alpha(f64::max, 0.0)),
        elements.len(),
    )
}

/// Range of some values.
fn range(values: impl Iterator<Item = f64>) -> String {
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high { "-".to_owned() } else { format!("{} to {}", three_digits(low), three_digits(high)) }
}

/// Share of some ratios within 3/4 and 4/3, each widened by two standard errors.
fn share<'r>(rows: impl Iterator<Item = &'r RatioRow>) -> String {
    let (mut agree, mut all) = (0, 0);
    for row in rows {
        let error = 2.0 * row.standard_error;
        agree += u32::from((1.0 / AGREEMENT - error..=AGREEMENT + error).contains(&row.ratio));
        all += 1;
    }
    format!("{agree} of {all}")
}

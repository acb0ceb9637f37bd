//! Power spectra from CSV, plain text, JSON and workbooks.

mod contact_engineering;
mod density;
mod error;
mod gwyddion;
mod header;
mod json;
mod layout;
mod lines;
mod mend;
mod named;
mod nameless;
mod names;
mod options;
mod rows;
mod select;
mod series;
mod table;
mod unit;
mod workbook;

pub use error::{Encoding, Field, FieldProblem, LineProblem, ReadError};
pub use header::Abscissa;
pub use json::JsonError;
pub use mend::{ReadMend, ReadOption, Wanted};
pub use options::{ReadOptions, UnitError};
pub use select::SeriesError;
pub use series::SeriesName;
pub use workbook::WorkbookError;

use std::io::Read;

use serde::Serialize;

use crate::convention::Convention;
use crate::psd::Psd;
use layout::Layout;
use lines::decode;
use nameless::nameless;
use names::Header;
use options::GivenUnits;
use rows::samples;
use select::select;
use series::{ColumnKind, Columns, Series};
use table::Table;

/// A power spectrum with the comments of its file and the assumptions made.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PsdFile {
    /// The spectrum.
    pub psd: Psd,
    /// Comment lines before the first row, without `#` and surrounding blanks; for a workbook, names and values above
    /// the table.
    pub comments: Vec<String>,
    /// Choices and assumptions where the file states nothing, one sentence each.
    pub notes: Vec<String>,
}

/// Reads a power spectrum from UTF-8 text (CSV with `,`, `;` or tab, or columns separated by blanks), JSON or, with the
/// feature `xlsx`, a workbook. The content determines the format.
///
/// Columns are recognised by name, in any order and case: `wavelength` or `lambda`, `wavevector` or `q`, `frequency` or
/// `f`, and `c1d`, `w1`, `psd` or `ciso`, each with its unit (`lambda_nm`, `q_rad_per_m`, `PSD (µm³)`) or in SI units;
/// Gwyddion's `k (1/m)` and Persson's `C (m^4)` need their unit. Standard errors are read as well
/// (`standard error of PSD (m³)`, `C1D_se_m3`); other columns are ignored. Wavelength has precedence over wavevector
/// over frequency, and the others must agree with it to 0.001. C1D has precedence over other spectra. Lines that begin
/// with `#` are comments.
///
/// In JSON the rows are an array of objects with these names, `[{"lambda_m": 1e-6, "C1D_m3": 1e-22}, ...]`.
///
/// Exports of contact.engineering (TXT, CSV, XLSX, JSON) and text exports of Gwyddion's graphs may hold several series.
/// [`ReadOptions::series`] and [`ReadOptions::subject`] choose one; the default is the only one, else `1D PSD along x`
/// of the average over the dataset or of the only subject. In these exports, rows without a value of the spectrum are
/// left out, with a note.
///
/// # Errors
/// [`ReadError`] for the first error in the file, with line, column, value and bound.
pub fn read_psd(input: impl Read, options: &ReadOptions) -> Result<PsdFile, ReadError> {
    let units = options.units()?;
    let Content { mut comments, series } = Content::read(input)?;
    let is_only = series.len() == 1;
    let series = select(series, options)?;
    let in_sheet = |error| match &series.sheet {
        Some(sheet) => ReadError::InSheet { sheet: sheet.clone(), error: Box::new(error) },
        None => error,
    };
    let (psd, mut notes) = read_series(&series, options, &units).map_err(in_sheet)?;
    comments.extend(series.comments);
    // Comments of a file with several series name all of them.
    let commented = if is_only { &comments[..] } else { &[] };
    notes.extend(area_series_note(commented.iter().chain(&[series.name.to_string()])));
    notes.extend(area_note(&psd));
    Ok(PsdFile { psd, comments, notes })
}

/// Lists the names of the spectra in a file that [`read_psd`] reads, in their order.
///
/// # Errors
/// [`ReadError`] for a file that cannot be split into series; its numbers are not checked.
pub fn series_names(input: impl Read) -> Result<Vec<SeriesName>, ReadError> {
    Ok(Content::read(input)?.series.into_iter().map(|series| series.name).collect())
}

/// Returns true if a file holds a power spectrum, by the names of its columns or as a JSON series.
///
/// Bare columns of numbers do not count. The numbers are not checked, so [`read_psd`] may still refuse the file.
pub fn is_psd(input: impl Read) -> bool {
    let options = ReadOptions::default();
    let Ok(units) = options.units() else { return false };
    let is_one = |series: &Series| match series.columns.kind {
        ColumnKind::Arrays { .. } => true,
        ColumnKind::Named => layout(&series.columns, &options, &units, &mut Vec::new()).is_ok(),
        ColumnKind::Numbered => false,
    };
    Content::read(input).is_ok_and(|content| content.series.iter().any(is_one))
}

/// A file split into its series.
struct Content {
    comments: Vec<String>,
    series: Vec<Series>,
}

impl Content {
    fn read(mut input: impl Read) -> Result<Self, ReadError> {
        let mut bytes = Vec::new();
        input.read_to_end(&mut bytes)?;
        if workbook::is_archive(&bytes) {
            return Ok(Self { comments: Vec::new(), series: workbook::series(&bytes)? });
        }
        let text = decode(&bytes)?;
        if json::is_json(text) {
            return Ok(Self { comments: Vec::new(), series: json::series(text)? });
        }
        let table = Table::open(text)?;
        Ok(Self { series: table.series()?, comments: table.comments })
    }
}

/// Assigns the columns of a series and notes assumptions.
fn layout(
    columns: &Columns,
    options: &ReadOptions,
    units: &GivenUnits<'_>,
    notes: &mut Vec<String>,
) -> Result<Layout, ReadError> {
    match columns.kind {
        ColumnKind::Named | ColumnKind::Arrays { named: true } => {
            Header { line: columns.line, names: &columns.names, options, units }.layout(notes)
        }
        ColumnKind::Numbered | ColumnKind::Arrays { named: false } => {
            nameless(columns, options, units, notes)
        }
    }
}

/// Reads the spectrum of a series, with notes on choices, omissions and assumptions.
fn read_series(
    series: &Series,
    options: &ReadOptions,
    units: &GivenUnits,
) -> Result<(Psd, Vec<String>), ReadError> {
    let mut notes = series.notes.clone();
    let layout = layout(&series.columns, options, units, &mut notes)?;
    // Programs that name their series write 1/m and mean rad/m; Persson's C is defined by it.
    if series.columns.kind == ColumnKind::Named
        && series.name == SeriesName::default()
        && layout.density.convention != Convention::Persson
    {
        let Columns { line, names, .. } = &series.columns;
        notes.extend(Header { line: *line, names, options, units }.bare_wavevector_note(layout.abscissa));
    }
    let (samples, missing) = samples(series, &layout)?;
    if missing > 0 {
        let rows = if missing == 1 {
            "1 row without a value is"
        } else {
            &format!("{missing} rows without a value are")
        };
        notes.push(format!("{rows} left out"));
    }
    let wavelengths_m = samples.iter().map(|sample| sample.wavelength_m).collect();
    let values = samples.iter().map(|sample| sample.value).collect();
    let errors = samples.iter().map(|sample| sample.standard_error).collect();
    let psd = Psd::from_samples(wavelengths_m, values, layout.density.convention);
    Ok((psd.with_checked_standard_errors(errors), notes))
}

/// Warns of contact.engineering's series 'q/π × 2D PSD', which has the unit of C1D but is another quantity.
fn area_series_note<'n>(mut names: impl Iterator<Item = &'n String>) -> Option<String> {
    let series = names.find(|name| name.contains("q/π × 2D PSD"))?;
    Some(format!(
        "the series '{series}' is q/pi times a two-dimensional spectrum, which is C1D only for a Hurst exponent \
         of 1/2"
    ))
}

/// Notes the conversion of an area spectrum to C1D.
fn area_note(psd: &Psd) -> Option<String> {
    let convention = psd.convention();
    (convention.metre_power() == 4).then(|| {
        format!(
            "the spectrum is that of an area ({convention}): the waves of a surface are taken from it as it is. Moments, stacks and \
             asperities take C1D, by the Abel integral over its samples for an isotropic surface without roughness beyond them{}",
            if psd.standard_errors().is_some() { "; standard errors are lost" } else { "" }
        )
    })
}

//! Graphs exported as text by Gwyddion: plain, for gnuplot, or separated by semicolons.
//!
//! Two lines hold names and units, `k  W<sub>1</sub>` and `[m^-1]  [m^3]`, optionally below a line of descriptions. For
//! gnuplot they are comments, one pair per curve. Several curves are in columns side by side, each with its own
//! abscissa or all with that of the first column; a dash or an empty field fills the rows beyond the end of a curve.

use csv::StringRecord;

use crate::read::error::{LineProblem, ReadError};
use crate::read::lines::is_number;
use crate::read::series::{ColumnKind, Columns, Row, Series, SeriesName};

/// Reads the curves of an export; `None` for a file that does not begin like one.
///
/// # Errors
/// [`LineProblem::Ragged`] for a row of another length than the units, whose numbers cannot be assigned to curves.
pub(crate) fn series(text: &str) -> Result<Option<Vec<Series>>, ReadError> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut heading: Vec<String> = Vec::new();
    let mut unnumbered = 0;
    for (i, line) in text.lines().enumerate() {
        let content = line.trim();
        let is_comment = content.starts_with('#');
        let content = content.trim_start_matches('#').trim();
        if content.is_empty() {
            continue;
        }
        if is_comment || !begins_with_a_number(content) {
            heading.push(without_markup(content));
            // A heading has at most descriptions, names and units; a longer one belongs to another kind of file.
            unnumbered += usize::from(!is_comment);
            if unnumbered > 3 {
                return Ok(None);
            }
            continue;
        }
        if !heading.is_empty() {
            match Block::under(&heading, i) {
                Some(block) => blocks.push(block),
                None if unnumbered > 0 => return Ok(None),
                // Comments among the numbers.
                None => {}
            }
            heading.clear();
            unnumbered = 0;
        }
        // Numbers without such a heading belong to another kind of file.
        let Some(block) = blocks.last_mut() else { return Ok(None) };
        block.push(i + 1, content)?;
    }
    Ok((!blocks.is_empty()).then(|| blocks.into_iter().flat_map(|block| block.curves).collect()))
}

fn begins_with_a_number(content: &str) -> bool {
    let first = content.split([';', ' ', '\t']).find(|field| !field.is_empty());
    first == Some("-") || is_number(first)
}

/// Curves side by side.
struct Block {
    curves: Vec<Series>,
    has_semicolons: bool,
    /// Number of columns, and the line of their units.
    columns: usize,
    line: usize,
    /// True if the first column is the abscissa of every curve.
    is_merged: bool,
}

impl Block {
    /// Parses a heading that ends in `line` into empty curves.
    fn under(heading: &[String], line: usize) -> Option<Self> {
        let [above @ .., names, units] = heading else { return None };
        let units = bracketed(units)?;
        let has_semicolons = names.contains(';');
        let names = cells(names, has_semicolons, units.len())?;
        let columns = units.len();
        let is_merged = columns > 2 && units[2] != units[0];
        if columns < 2 || !is_merged && columns % 2 != 0 {
            return None;
        }
        let count = if is_merged { columns - 1 } else { columns / 2 };
        let descriptions = above.last().and_then(|text| cells(text, has_semicolons, count));
        let curve = |curve: usize| {
            let name = |column: usize| match units[column] {
                "" => names[column].clone(),
                unit => format!("{} [{unit}]", names[column]),
            };
            let (x, y) = places(is_merged, curve);
            let titles = vec![name(x), name(y)];
            let series = match &descriptions {
                Some(descriptions) => Some(descriptions[curve].clone()),
                None => is_merged.then(|| names[y].clone()),
            };
            let name = SeriesName { series, ..SeriesName::default() };
            Series::new(name, Columns { names: titles, line, kind: ColumnKind::Named }, Vec::new())
        };
        let curves = (0..count).map(curve).collect();
        Some(Self { curves, has_semicolons, columns, line, is_merged })
    }

    fn push(&mut self, line: usize, content: &str) -> Result<(), ReadError> {
        let fields: Vec<&str> = if self.has_semicolons {
            content.strip_suffix(';').unwrap_or(content).split(';').map(str::trim).collect()
        } else {
            content.split_whitespace().collect()
        };
        if fields.len() != self.columns {
            let (found, expected) = (fields.len(), self.columns);
            return Err(LineProblem::Ragged { found, first_line: self.line, expected }.at(line));
        }
        for (curve, series) in self.curves.iter_mut().enumerate() {
            let (x, y) = places(self.is_merged, curve);
            let (x, y) = (fields[x], fields[y]);
            if matches!(y, "" | "-") {
                continue;
            }
            if x.parse() == Ok(0.0) {
                series.notes.push(format!("line {line}, the wavevector 0, is left out"));
                continue;
            }
            series.rows.push(Row { line, fields: StringRecord::from(vec![x, y]) });
        }
        Ok(())
    }
}

fn places(is_merged: bool, curve: usize) -> (usize, usize) {
    if is_merged { (0, curve + 1) } else { (2 * curve, 2 * curve + 1) }
}

/// Splits a line of bracketed units; `None` if there is text outside the brackets.
fn bracketed(line: &str) -> Option<Vec<&str>> {
    let mut units = Vec::new();
    let mut rest = line.trim();
    while !rest.is_empty() {
        let (unit, after) = rest.strip_prefix('[')?.split_once(']')?;
        units.push(unit.trim());
        rest = after.trim_start_matches([';', ' ', '\t']);
    }
    Some(units)
}

/// Splits a line of a heading into `count` cells; `None` for another number.
fn cells(line: &str, has_semicolons: bool, count: usize) -> Option<Vec<String>> {
    let cells: Vec<&str> = if has_semicolons {
        line.trim().trim_end_matches(';').split(';').map(str::trim).collect()
    } else {
        // Single blanks belong to a name.
        line.split("  ")
            .flat_map(|part| part.split('\t'))
            .map(str::trim)
            .filter(|cell| !cell.is_empty())
            .collect()
    };
    let words: Vec<&str> = line.split_whitespace().collect();
    let cells = if cells.len() == count { cells } else { words };
    (cells.len() == count).then(|| cells.into_iter().map(str::to_owned).collect())
}

/// Removes tags, as in `W<sub>1</sub>`.
fn without_markup(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some((before, tag)) = rest.split_once('<') {
        plain.push_str(before);
        rest = tag.split_once('>').map_or("", |(_, after)| after);
    }
    plain + rest
}

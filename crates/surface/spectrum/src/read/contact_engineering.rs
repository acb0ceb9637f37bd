//! Text exports of contact.engineering: blocks under `# Columns:` lines, and CSV with columns that name the series.

use std::collections::HashMap;

use crate::read::error::{LineProblem, ReadError};
use crate::read::lines::comment;
use crate::read::series::{ColumnKind, Columns, Row, Series, SeriesName};

/// Splits the rows into the series under lines `# Columns: ...`; the text has at least one such line.
///
/// A comment `type: name` underlined with `=` begins a subject. A comment underlined with `-`, or right above the line,
/// is the title of a series; without a subject it may read `subject - series`.
pub(crate) fn blocks(text: &str, mut rows: Vec<Row>) -> Vec<Series> {
    let mut found = headings(text);
    let mut series = Vec::new();
    while let Some((name, columns)) = found.pop() {
        // The first heading also takes the rows above it; the file has no others.
        let start = if found.is_empty() { 0 } else { rows.partition_point(|row| row.line < columns.line) };
        let mut block = Series::new(name, columns, rows.split_off(start));
        block.may_miss_values = true;
        series.push(block);
    }
    series.reverse();
    series
}

/// Returns true if a line reads `# Columns: ...`.
pub(crate) fn has_columns_comment(text: &str) -> bool {
    text.lines().filter_map(comment).any(|text| text.starts_with(COLUMNS))
}

const COLUMNS: &str = "Columns:";

fn headings(text: &str) -> Vec<(SeriesName, Columns)> {
    let mut found = Vec::new();
    let mut subject: Option<(String, String)> = None;
    let mut title: Option<&str> = None;
    let mut above: Option<&str> = None;
    for (i, text) in text.lines().enumerate().filter_map(|(i, line)| Some((i, comment(line)?))) {
        if let Some(names) = text.strip_prefix(COLUMNS) {
            let names = names.split(',').map(|name| name.trim().to_owned()).collect();
            let columns = Columns { names, line: i + 1, kind: ColumnKind::Named };
            found.push((series_name(subject.as_ref(), title.take().or(above)), columns));
            above = None;
        } else if is_underline(text, '=') {
            subject = above.and_then(split_subject);
            (title, above) = (None, None);
        } else if is_underline(text, '-') {
            (title, above) = (above, None);
        } else {
            above = Some(text);
        }
    }
    found
}

fn is_underline(text: &str, of: char) -> bool {
    text.len() > 2 && text.chars().all(|character| character == of)
}

/// Splits `topography: sample 1`; `None` for a title such as `Power spectral density`, which is not a subject.
fn split_subject(title: &str) -> Option<(String, String)> {
    let (subject_type, subject) = title.split_once(": ")?;
    let is_word = !subject_type.is_empty() && !subject_type.contains(char::is_whitespace);
    is_word.then(|| (subject_type.to_owned(), subject.trim().to_owned()))
}

fn series_name(subject: Option<&(String, String)>, title: Option<&str>) -> SeriesName {
    let title = title.filter(|title| !title.is_empty());
    if let Some((subject_type, subject)) = subject {
        return SeriesName {
            subject_type: Some(subject_type.clone()),
            subject: Some(subject.clone()),
            series: title.map(str::to_owned),
        };
    }
    let (subject, series) = match title.and_then(|title| title.rsplit_once(" - ")) {
        Some((subject, series)) => (Some(subject), Some(series)),
        None => (None, title),
    };
    SeriesName {
        subject_type: None,
        subject: subject.map(|subject| subject.trim().to_owned()),
        series: series.map(|series| series.trim().to_owned()),
    }
}

/// Columns of a table that name the series of each row.
#[derive(Clone, Copy, Default)]
struct NameColumns {
    subject_type: Option<usize>,
    subject: Option<usize>,
    series: Option<usize>,
}

impl NameColumns {
    fn find(names: &[String]) -> Self {
        let find = |accepted: &[&str]| {
            names.iter().position(|name| accepted.iter().any(|one| name.eq_ignore_ascii_case(one)))
        };
        Self {
            subject_type: find(&["subject type"]),
            subject: find(&["subject", "subject name"]),
            series: find(&["series", "data series"]),
        }
    }

    fn name(self, row: &Row) -> SeriesName {
        let text = |column: Option<usize>| {
            let text = row.fields.get(column?)?.trim();
            (!text.is_empty()).then(|| text.to_owned())
        };
        SeriesName {
            subject_type: text(self.subject_type),
            subject: text(self.subject),
            series: text(self.series),
        }
    }
}

/// Groups the rows of a table with a header by the series they name, in the order of their first rows.
///
/// # Errors
/// [`LineProblem::Ragged`] for a row of another length in a table of series, where names could come from the wrong
/// column.
pub(crate) fn grouped(names: Vec<String>, line: usize, rows: Vec<Row>) -> Result<Vec<Series>, ReadError> {
    let name_columns = NameColumns::find(&names);
    let columns = || Columns { names: names.clone(), line, kind: ColumnKind::Named };
    if rows.is_empty() || name_columns.subject.is_none() && name_columns.series.is_none() {
        return Ok(vec![Series::new(SeriesName::default(), columns(), rows)]);
    }
    let mut series: Vec<Series> = Vec::new();
    let mut places: HashMap<SeriesName, usize> = HashMap::new();
    for row in rows {
        let (found, expected) = (row.fields.len(), names.len());
        if found != expected {
            return Err(LineProblem::Ragged { found, first_line: line, expected }.at(row.line));
        }
        let name = name_columns.name(&row);
        let place = *places.entry(name).or_insert_with_key(|name| {
            let mut begun = Series::new(name.clone(), columns(), Vec::new());
            begun.may_miss_values = true;
            series.push(begun);
            series.len() - 1
        });
        series[place].rows.push(row);
    }
    Ok(series)
}

//! Numbers above a scan that are no heights: how many points follow, how long it is.
//!
//! Lines of numbers are a preamble where their width is not that of the lines that follow, or where one of them is the
//! number of these lines.

use super::style::{FORMAT, content, count_of_fields, holds_numbers};
use crate::error::{FilePlace, ScanReadError};
use crate::numbers;
use units::LengthUnit;

/// Most lines of a preamble.
const MOST: usize = 8;
/// Lines that are looked at: a preamble, lines of words in it, and enough of the scan to tell its width.
const LOOKED_AT: usize = 4 * MOST;
/// Fewest heights whose number is no chance, and in which a number that is written differently stands out.
const TELLING: usize = 8;

/// Lines of numbers above a scan, from 1, and their text.
#[derive(Default)]
pub(super) struct Preamble<'t> {
    lines: Vec<(usize, &'t str)>,
}

impl<'t> Preamble<'t> {
    /// Finds the lines above the scan of a text.
    pub(super) fn find(text: &'t str) -> Self {
        let behind_header = || content(text).skip_while(|(_, line)| !holds_numbers(line));
        let looked_at: Vec<(usize, &str, bool)> = behind_header()
            .take(LOOKED_AT)
            .map(|(number, line)| (number, line, holds_numbers(line)))
            .collect();
        let lines = by_width(&looked_at).or_else(|| by_count(&looked_at, || behind_header().count()));
        Self { lines: lines.unwrap_or_default() }
    }

    /// The last line, 0 where there is none.
    pub(super) fn end(&self) -> usize {
        self.lines.last().map_or(0, |(line, _)| *line)
    }

    /// Compares the numbers with the columns and rows that follow and returns the length of a line where they tell it, in m.
    ///
    /// # Errors
    /// [`ScanReadError::BadField`] if they state more points than there are: the file is cut off.
    pub(super) fn take(
        &self,
        across: usize,
        rows: usize,
        notes: &mut Vec<String>,
    ) -> Result<Option<f64>, ScanReadError> {
        if across == 1
            && let [(_, length), (_, count)] = self.lines[..]
            && let Some(length_mm) = numbers::finite(&length.replace(',', ".")).and_then(numbers::positive)
            && numbers::count(count) == Some(rows)
        {
            notes.push(format!(
                "lines {} and {}, {length} and {count}, are taken for the length in mm and the number of points, not for heights",
                self.lines[0].0, self.lines[1].0
            ));
            return Ok(Some(LengthUnit::MILLIMETRE.to_m(length_mm)));
        }
        for &(line, text) in &self.lines {
            let fields: Vec<&str> = text.split(|c: char| c.is_whitespace() || ";,".contains(c)).collect();
            let counts: Vec<usize> = fields.iter().filter_map(|field| numbers::count(field)).collect();
            let stated = match counts[..] {
                _ if counts.len() < fields.len() => None,
                [count] => Some((count, if across > 3 { rows * across } else { rows })),
                [x, y] if across > 3 && x == across => Some((y, rows)),
                [x, y] if across > 3 && y == across => Some((x, rows)),
                [x, y] if across <= 3 => Some((x.saturating_mul(y), rows)),
                _ => None,
            };
            let is_told = [rows, across, rows * across].map(Some).contains(&stated.map(|(count, _)| count));
            match stated {
                Some((count, found)) if count > found && !is_told => {
                    return Err(FORMAT.bad(
                        FilePlace::Line(line),
                        "the number of points in the file",
                        found.to_string(),
                        format!("{count}, if that is what '{text}' states above the lines of numbers"),
                        "export the file again if it is cut off, else delete this line",
                    ));
                }
                Some(_) if is_told => {
                    notes.push(format!("line {line}, {text}, is taken for numbers of points, not for heights"));
                }
                _ => notes.push(format!(
                    "line {line}, {text}, stands above lines of another kind: it is not used, and taken for no heights"
                )),
            }
        }
        Ok(None)
    }
}

/// Lines of another width than all that follow, which agree in theirs.
fn by_width<'t>(looked_at: &[(usize, &'t str, bool)]) -> Option<Vec<(usize, &'t str)>> {
    let numeric: Vec<(usize, &str)> = looked_at
        .iter()
        .filter(|(_, _, is_numeric)| *is_numeric)
        .map(|(line, text, _)| (*line, *text))
        .collect();
    let last_words = looked_at.iter().rfind(|(_, _, is_numeric)| !is_numeric).map_or(0, |(line, ..)| *line);
    let widths: Vec<Width> = numeric.iter().map(|(_, text)| Width::of(text)).collect();
    let body = widths.last()?;
    let count = widths.iter().rposition(|width| !width.agrees(body))? + 1;
    let is_above = widths[..count].iter().all(|width| !width.agrees(body)) && count <= MOST;
    let lines = numeric[..count].to_vec();
    let is_told_apart = numeric.len() >= count + 2 && numeric[count].0 > last_words;
    (is_above && is_told_apart).then_some(lines)
}

/// Lines of one number each, one of which is the number of the lines that follow.
fn by_count<'t>(
    looked_at: &[(usize, &'t str, bool)],
    lines: impl FnOnce() -> usize,
) -> Option<Vec<(usize, &'t str)>> {
    let is_words = |(_, _, is_numeric): &&(usize, &str, bool)| !is_numeric;
    let (words, last_words) = (
        looked_at.iter().filter(is_words).count(),
        looked_at.iter().rfind(is_words).map_or(0, |(line, ..)| *line),
    );
    let first: Vec<(usize, &str)> = looked_at
        .iter()
        .filter(|line| !is_words(line))
        .take(MOST)
        .map(|(line, text, _)| (*line, *text))
        .collect();
    let mut stated = first.iter().enumerate().filter_map(|(at, (_, text))| Some((at, numbers::count(text)?)));
    if !first.iter().all(|(_, text)| Width::of(text).all == 1) || stated.clone().next().is_none() {
        return None;
    }
    let all = lines() - words;
    // Other numbers may stand between the count and the heights.
    let end = stated.find_map(|(at, count)| {
        Some(all.checked_sub(count)?).filter(|end| *end > at && *end < MOST && count >= TELLING)
    })?;
    let is_behind_words = first.get(end).is_some_and(|(line, _)| *line > last_words);
    is_behind_words.then(|| first[..end].to_vec())
}

/// The number of fields of a line, with empty ones at its end and without.
struct Width {
    all: usize,
    filled: usize,
}

impl Width {
    fn of(line: &str) -> Self {
        let filled = line.trim_end_matches(|c: char| c.is_whitespace() || ";,".contains(c));
        Self { all: count_of_fields(line), filled: count_of_fields(filled) }
    }

    fn agrees(&self, other: &Self) -> bool {
        self.all == other.all || self.filled == other.filled
    }
}

/// Refuses a column of heights with one of the first numbers written as a count, the others with the same decimals.
pub(super) fn refuse_odd_count(fields: &[(usize, &str)]) -> Result<(), ScanReadError> {
    let decimals = |field: &str| field.split_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
    let is_count = |field: &str| numbers::count(field).is_some_and(|count| count > 1);
    let Some(&(line, odd)) = fields.iter().take(3).rfind(|(_, field)| is_count(field)) else { return Ok(()) };
    let mut others = fields.iter().filter(|(at, _)| *at > line).map(|(_, field)| decimals(field));
    let Some(usual) = others.next().filter(|usual| *usual > 0) else { return Ok(()) };
    if fields.len() < TELLING || !others.all(|other| other == usual) {
        return Ok(());
    }
    Err(FORMAT.bad(
        FilePlace::Line(line),
        "a height",
        odd,
        format!("written with {usual} decimals like those below it"),
        "delete the lines above the heights, or write the number as they are",
    ))
}

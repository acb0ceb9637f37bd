//! The lines of numbers of a text that are its scan, and those above them that are not.

use super::preamble::Preamble;
use super::style::{
    content, count_of_fields, holds_missing_points, holds_numbers, is_blank, is_comment, is_separator,
    shortened,
};

/// The lines of the numbers of a scan.
pub(super) struct Body<'t> {
    text: &'t str,
    /// The first line, from 1.
    pub(super) first_line: usize,
    /// Numbers above it that are no heights.
    pub(super) preamble: Preamble<'t>,
    /// The lines below it, from the last on.
    footer: Vec<&'t str>,
}

impl<'t> Body<'t> {
    /// Finds the lines of numbers; none where there are none.
    pub(super) fn find(text: &'t str) -> Option<Self> {
        let (text, footer) = without_footer(text);
        let preamble = Preamble::find(text);
        let first_line = first_row(text, preamble.end())?;
        Some(Self { text, first_line, preamble, footer })
    }

    /// Names the lines below the numbers.
    pub(super) fn footer_note(&self) -> Option<String> {
        let first = self.footer.last()?;
        let more = match self.footer.len() - 1 {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        Some(format!("not read below the numbers: '{}'{more}", shortened(first)))
    }

    /// The text down to the last line of numbers.
    pub(super) fn text(&self) -> &'t str {
        self.text
    }

    /// The line right above the numbers, if it is neither empty nor a comment.
    pub(super) fn line_above(&self) -> Option<(usize, &'t str)> {
        let number = self.first_line.checked_sub(1).filter(|number| *number > self.preamble.end())?;
        let line = self.text.lines().nth(number - 1)?.trim_matches(is_blank);
        (!line.is_empty() && !is_comment(line)).then_some((number, line))
    }

    /// The lines of numbers, with all that follows the first of them, trimmed of blanks.
    pub(super) fn rows(&self) -> impl Iterator<Item = (usize, &'t str)> {
        let first = self.first_line;
        content(self.text).skip_while(move |(number, _)| *number < first)
    }

    /// The first line of numbers behind an empty one or a comment, where such lines separate blocks of them, not each from
    /// the next.
    pub(super) fn second_block(&self) -> Option<usize> {
        let (mut rows, mut breaks, mut first_break) = (0, 0, None);
        let mut is_behind_empty = false;
        for (index, line) in self.text.lines().enumerate().skip(self.first_line - 1) {
            let line = line.trim_matches(is_blank);
            if line.is_empty() || is_comment(line) {
                is_behind_empty = rows > 0;
            } else {
                if is_behind_empty {
                    breaks += 1;
                    first_break.get_or_insert(index + 1);
                }
                rows += 1;
                is_behind_empty = false;
            }
        }
        first_break.filter(|_| breaks + 1 < rows)
    }

    /// Lines of numbers with the separators at their ends, which mark empty fields; tabs only where they are separators.
    pub(super) fn whole_rows(&self, with_tabs: bool) -> impl Iterator<Item = (usize, &'t str)> {
        let first = self.first_line;
        let is_margin = move |character: char| is_blank(character) && !(with_tabs && character == '\t');
        let lines =
            self.text.lines().enumerate().map(move |(index, line)| (index + 1, line.trim_matches(is_margin)));
        lines.filter(move |(number, line)| *number >= first && !line.is_empty() && !is_comment(line))
    }
}

/// Most lines of statistics and remarks below a scan.
const LONGEST_FOOTER: usize = 24;

/// Separates the lines of words below the numbers, from the last on: statistics and remarks.
fn without_footer(text: &str) -> (&str, Vec<&str>) {
    let (mut kept, mut footer) = (text, Vec::new());
    while footer.len() < LONGEST_FOOTER {
        let end = kept.trim_end_matches(is_blank);
        let start = end.rfind('\n').map_or(0, |at| at + 1);
        let line = end[start..].trim_matches(is_blank);
        if !is_of_words(line) {
            break;
        }
        footer.push(line);
        kept = &text[..start];
    }
    (kept, footer)
}

/// Returns true for a line of words, perhaps with numbers; not for a row of a map with a word in it.
fn is_of_words(line: &str) -> bool {
    let is_number = |word: &&str| word.parse::<f64>().is_ok();
    let (words, numbers) = (count_of_fields(line), line.split(is_separator).filter(is_number).count());
    line.starts_with(|c: char| c.is_alphabetic() || c == '"')
        && !holds_numbers(line)
        && !holds_missing_points(line)
        && (words <= 3 || 2 * numbers < words)
}

/// The first line of the scan behind a line: of numbers, or the first of the lines of missing points right above it
/// with as many fields.
fn first_row(text: &str, behind: usize) -> Option<usize> {
    let mut missing: Option<(usize, usize)> = None;
    for (number, line) in content(text).skip_while(|(number, _)| *number <= behind) {
        let fields = count_of_fields(line);
        if holds_numbers(line) {
            return Some(missing.filter(|&(_, count)| count == fields).map_or(number, |(first, _)| first));
        }
        missing = match missing {
            _ if !holds_missing_points(line) => None,
            Some((first, count)) if count == fields => Some((first, count)),
            _ => Some((number, fields)),
        };
    }
    None
}

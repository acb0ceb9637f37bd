//! Separators of thousands, which look like decimal marks.

use super::style::{FORMAT, shortened};
use crate::error::{FilePlace, ScanReadError};

/// The numbers of a column, by how they are written.
#[derive(Clone, Default)]
pub(super) struct Thousands {
    /// The first number of groups of three digits, `1,234` or `-12.500`, with its line.
    grouped: Option<(usize, String)>,
    /// The first whole number of three digits, as there are beside thousands.
    small: Option<String>,
    /// True once a number shows that marks are decimal ones, or that thousands have no mark.
    is_clear: bool,
}

impl Thousands {
    /// Takes a number as it is written.
    pub(super) fn take(&mut self, field: &str, line: usize) {
        if self.is_clear {
            return;
        }
        let digits = field.trim_start_matches(['+', '-']);
        let is_whole = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
        match digits.split_once(['.', ',']) {
            None if digits.is_empty() || !is_whole(digits) => {}
            None if digits.len() < 3 => {}
            None if digits.len() == 3 => {
                self.small.get_or_insert_with(|| field.to_owned());
            }
            None => self.is_clear = true,
            Some((lead, rest)) => {
                let is_grouped = (1..=3).contains(&lead.len()) && !lead.starts_with('0') && rest.len() == 3;
                if is_grouped && is_whole(lead) && is_whole(rest) {
                    self.grouped.get_or_insert_with(|| (line, field.to_owned()));
                } else {
                    self.is_clear = true;
                }
            }
        }
    }

    /// Notes a column of which every number has a comma before three digits, behind more than one.
    pub(super) fn note(&self) -> Option<String> {
        let (_, grouped) = self.grouped.as_ref().filter(|_| !self.is_clear && self.small.is_none())?;
        let lead = grouped.trim_start_matches(['+', '-']).split_once(',')?.0;
        (lead.len() > 1).then(|| format!("numbers such as '{grouped}' are read with a decimal comma"))
    }

    /// Refuses a column in which all marks may separate thousands.
    pub(super) fn refuse(&self) -> Result<(), ScanReadError> {
        let (Some((line, grouped)), Some(small), false) = (&self.grouped, &self.small, self.is_clear) else {
            return Ok(());
        };
        Err(FORMAT.bad(
            FilePlace::Line(*line),
            "a number",
            format!("'{}', beside '{small}'", shortened(grouped)),
            "either of thousands or with decimals",
            "write it without a mark of thousands, or all numbers with three decimals",
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_decimal_ones_where_a_number_shows_it() {
        let is_refused = |fields: &[&str]| {
            let mut column = Thousands::default();
            fields.iter().enumerate().for_each(|(at, field)| column.take(field, at + 1));
            column.refuse().is_err()
        };
        assert!(is_refused(&["1,234", "567", "12,345"]) && is_refused(&["800", "-1.234"]));
        for clear in [
            &["1,234", "0,567"][..],
            &["1.234", "5.67", "8"],
            &["1.234", "2.345"],
            &["0", "1", "1.001"],
            &["1.234", "567", "1234"],
            &["0.125", "1.234", "567"],
            &["1234", "567"],
            &["1.234", "5e3", "7", "1.5"],
            &["", "nan"],
        ] {
            assert!(!is_refused(clear), "{clear:?}");
        }
    }
}

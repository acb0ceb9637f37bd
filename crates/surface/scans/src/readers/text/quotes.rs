//! Cells in quotes, as spreadsheets write them.

use std::borrow::Cow;

use super::style::holds_numbers;

/// Takes the quotes off the cells of a text whose numbers stand in quotes. Tabs then separate them, in every line.
pub(super) fn unquoted(text: Cow<'_, str>) -> Cow<'_, str> {
    let quoted = || text.lines().filter(|line| line.contains('"'));
    let Some(row) = quoted().find(|line| holds_numbers(&line.replace('"', " "))) else { return text };
    let separator = separator_behind_quotes(row).or_else(|| quoted().find_map(separator_behind_quotes));
    let mut bare = String::with_capacity(text.len());
    for line in text.lines() {
        push_cells(&mut bare, line, separator);
        bare.push('\n');
    }
    if !text.ends_with('\n') {
        bare.pop();
    }
    Cow::Owned(bare)
}

/// The separator behind the first cell in quotes.
fn separator_behind_quotes(line: &str) -> Option<char> {
    let (_, behind) = line.trim_start().strip_prefix('"')?.split_once('"')?;
    behind.trim_start_matches(' ').chars().next().filter(|next| ",;\t".contains(*next))
}

/// Appends a line without its quotes. A pair of them within a cell stands for one.
fn push_cells(bare: &mut String, line: &str, separator: Option<char>) {
    let mut is_quoted = false;
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if is_quoted && letters.next_if_eq(&'"').is_some() => bare.push('"'),
            '"' => is_quoted = !is_quoted,
            '\t' if is_quoted => bare.push(' '),
            letter if !is_quoted && Some(letter) == separator => bare.push('\t'),
            letter => bare.push(letter),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotes_are_taken_off_where_numbers_stand_in_them() {
        for (text, bare) in [
            ("\"x, um\",\"z\"\n\"0.5\",\"1.5\"\n", "x, um\tz\n0.5\t1.5\n"),
            ("\"x\";\"z\"\n\"0,5\";\"1,5\"", "x\tz\n0,5\t1,5"),
            ("\"x \"\"a\"\"\",z\n\"1\",\"2\"\n", "x \"a\"\tz\n1\t2\n"),
            ("\"Unit\",\"um\"\n\n\"1\",\"\",\"3\"\n", "Unit\tum\n\n1\t\t3\n"),
            ("\"1\"\n\"2\"\n", "1\n2\n"),
            // Quotes of a header alone stay.
            ("\"x\",\"z\"\n0.5,1.5\n", "\"x\",\"z\"\n0.5,1.5\n"),
        ] {
            assert_eq!(unquoted(Cow::Borrowed(text)), bare);
        }
    }
}

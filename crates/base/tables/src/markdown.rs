//! Tables as Markdown, and pages that hold them between text written by hand.

/// Formats a table; the first column is left-aligned, the others are numbers.
#[must_use]
pub fn table(columns: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = line(columns.iter().map(|&column| column.to_owned()).collect());
    text += &line(
        columns.iter().enumerate().map(|(i, _)| if i == 0 { "---" } else { "---:" }.to_owned()).collect(),
    );
    rows.iter().for_each(|row| text += &line(row.clone()));
    text
}

/// Returns the page with the contents of a section replaced: the lines between `<!-- measured: NAME -->` and `<!--
/// end -->`.
///
/// # Errors
/// A message if the page has no such section.
pub fn with_section(page: &str, name: &str, contents: &str) -> Result<String, String> {
    let opening = format!("<!-- measured: {name} -->\n");
    let missing = || format!("the page has no section {name}");
    let (before, rest) = page.split_once(&opening).ok_or_else(missing)?;
    let (_, after) = rest.split_once("<!-- end -->").ok_or_else(missing)?;
    Ok(format!("{before}{opening}\n{}\n\n<!-- end -->{after}", contents.trim_end()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_section_is_replaced_and_everything_else_stays() {
        let page =
            "words\n<!-- measured: a -->\nold\n<!-- end -->\nmore\n<!-- measured: b -->\n<!-- end -->\n";
        let new = with_section(page, "a", "| x |\n").unwrap();
        assert_eq!(
            new,
            "words\n<!-- measured: a -->\n\n| x |\n\n<!-- end -->\nmore\n<!-- measured: b -->\n<!-- end -->\n"
        );
        assert_eq!(with_section(&new, "a", "| x |\n").unwrap(), new);
        assert!(with_section(page, "c", "").is_err());
    }

    #[test]
    fn a_table_has_a_rule_under_its_columns() {
        let text = table(&["law", "time"], &[vec!["hertz".to_owned(), "1 µs".to_owned()]]);
        assert_eq!(text, "| law | time |\n| --- | ---: |\n| hertz | 1 µs |\n");
    }
}

//! Formulas of pages as MathML, which browsers draw themselves: no script, no font, no network.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

/// Replaces the formulas of a page of Markdown: blocks marked `math`, and `$..$` outside of code.
///
/// # Errors
/// The formula that cannot be read, and why.
pub(super) fn as_mathml(page: &str) -> Result<String, String> {
    let mut text = String::with_capacity(page.len());
    let mut fence: Option<Fence> = None;
    for line in page.lines() {
        let marker = line.trim_start();
        match &mut fence {
            None if marker.starts_with("```math") => fence = Some(Fence::Math(String::new())),
            None if marker.starts_with("```") => {
                fence = Some(Fence::Code);
                push_line(&mut text, line);
            }
            None => push_line(&mut text, &inline(line)?),
            Some(Fence::Code) => {
                if marker.starts_with("```") {
                    fence = None;
                }
                push_line(&mut text, line);
            }
            Some(Fence::Math(formula)) if marker.starts_with("```") => {
                let block = mathml(formula, MathDisplay::Block)?;
                push_line(&mut text, &format!("<div class=\"formula\">{block}</div>"));
                fence = None;
            }
            Some(Fence::Math(formula)) => push_line(formula, line),
        }
    }
    Ok(text)
}

/// Block between lines of three backticks.
enum Fence {
    Code,
    Math(String),
}

fn push_line(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
}

/// Replaces the formulas of a line of prose; code between backticks stays.
fn inline(line: &str) -> Result<String, String> {
    let mut text = String::new();
    for (at, part) in line.split('`').enumerate() {
        if at > 0 {
            text.push('`');
        }
        let is_code = at % 2 == 1;
        if is_code || part.matches('$').count() < 2 {
            text.push_str(part);
            continue;
        }
        let mut rest = part;
        while let Some((before, from)) = rest.split_once('$') {
            let Some((formula, after)) = from.split_once('$') else { break };
            text.push_str(before);
            text.push_str(&mathml(formula, MathDisplay::Inline)?);
            rest = after;
        }
        text.push_str(rest);
    }
    Ok(text)
}

fn mathml(formula: &str, display: MathDisplay) -> Result<String, String> {
    let converter =
        LatexToMathML::new(MathCoreConfig::default()).map_err(|_| "macros of formulas".to_owned())?;
    let converted = converter
        .convert_with_local_state(formula, display)
        .map_err(|error| format!("the formula {formula}: {error}"))?;
    Ok(shielded(&converted.mathml.replace('\n', " ")))
}

/// Markup whose text Markdown leaves as it is, in tables too.
fn shielded(markup: &str) -> String {
    let mut inside_tag = false;
    markup.chars().fold(String::with_capacity(markup.len()), |mut text, letter| {
        match letter {
            '<' => inside_tag = true,
            '>' => inside_tag = false,
            _ => {}
        }
        match letter {
            '|' | '*' | '_' | '[' | ']' | '`' | '\\' | '~' if !inside_tag => {
                text.push_str(&format!("&#{};", u32::from(letter)));
            }
            _ => text.push(letter),
        }
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_mathml_and_code_stays() {
        let page = "Area $A_n$, `$HOME`.\n\n```sh\necho $A $B\n```\n\n```math\n\\frac{a}{b}\n```\n";
        let text = as_mathml(page).unwrap();
        assert!(text.contains("<math") && text.contains("<msub>"));
        assert!(text.contains("`$HOME`") && text.contains("echo $A $B"));
        assert!(text.contains("<mfrac>") && !text.contains("```math"));
    }

    #[test]
    fn a_bar_in_a_formula_does_not_end_a_cell_of_a_table() {
        let row = inline("| $|x|$ | y |").unwrap();
        assert_eq!(row.matches('|').count(), 3);
    }

    #[test]
    fn formulas_that_cannot_be_read_are_errors() {
        assert!(as_mathml("$\\frac{a}$\n").is_err());
        assert!(as_mathml("$\\nosuchcommand$\n").is_err());
    }
}

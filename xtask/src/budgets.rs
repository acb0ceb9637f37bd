//! Budgets of the house: lines of source for each crate, and words for the documentation.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use xtask::checkout;

/// The budgets, beside the sources of this program.
const BUDGETS: &str = "xtask/budgets.txt";

/// Name of the budget of words.
const WORDS_OF_DOCS: &str = "docs";

/// Budgets that are exceeded or missing, a line each. `crates` are the folders of the crates by their names.
pub(crate) fn faults(crates: &BTreeMap<String, PathBuf>) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut most = parse(&std::fs::read_to_string(checkout(BUDGETS))?)?;
    let mut used = Vec::new();
    for (name, folder) in crates {
        used.push((name.as_str(), "lines", count(&folder.join("src"), "rs", |text| text.lines().count())?));
    }
    let words = count(&checkout("docs"), "md", |text| text.split_whitespace().count())?;
    used.push((WORDS_OF_DOCS, "words", words));
    let mut faults = Vec::new();
    for (name, unit, used) in used {
        match most.remove(name) {
            Some(most) if used <= most => {}
            Some(most) => faults.push(format!(
                "{name} has {used} {unit} and may have {most}: remove some, or add a line to {BUDGETS} that says why it grows"
            )),
            None => faults.push(format!("{name} has no budget: add it to {BUDGETS}")),
        }
    }
    faults.extend(most.keys().map(|name| format!("{BUDGETS}: {name} is not a crate")));
    Ok(faults)
}

/// Sums the lines of each name: a number, or a rise such as `+40` with its reason behind it.
fn parse(text: &str) -> Result<BTreeMap<String, usize>, String> {
    let mut budgets = BTreeMap::new();
    for (at, line) in text.lines().enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
    {
        let refused = |expected: &str| format!("{BUDGETS}, line {}: expected {expected}", at + 1);
        let mut words = line.split_whitespace();
        let (name, number) = words.next().zip(words.next()).ok_or_else(|| refused("a name and a number"))?;
        let rises = number.starts_with('+');
        if rises == words.next().is_none() {
            return Err(refused("a reason behind a rise, and nothing behind a budget"));
        }
        let number: usize = number.parse().map_err(|_| refused("a whole number"))?;
        match (budgets.get_mut(name), rises) {
            (Some(budget), true) => *budget += number,
            (None, false) => drop(budgets.insert(name.to_owned(), number)),
            _ => return Err(refused("one budget for each name, and its rises behind it")),
        }
    }
    Ok(budgets)
}

/// Sums what `measure` finds in the files below a folder that have an extension.
fn count(folder: &Path, extension: &str, measure: fn(&str) -> usize) -> std::io::Result<usize> {
    let mut sum = 0;
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found == extension) {
                sum += measure(&std::fs::read_to_string(path)?);
            }
        }
    }
    Ok(sum)
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn a_budget_is_its_number_and_the_rises_that_have_a_reason() {
        let budgets =
            parse("# lines\ntruearea-units 2000\ndocs 65000\ntruearea-units +40 names of scales\n").unwrap();
        assert_eq!(
            budgets.into_iter().collect::<Vec<_>>(),
            [("docs".to_owned(), 65000), ("truearea-units".to_owned(), 2040)]
        );
        for refused in [
            "units",
            "units many",
            "units 10 why",
            "units 10\nunits +1",
            "units 10\nunits 20",
            "units +1 why",
        ] {
            parse(refused).unwrap_err();
        }
    }
}

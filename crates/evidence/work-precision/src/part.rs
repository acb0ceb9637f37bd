//! Parts of the page that are measured one by one.

use crate::environment::Environment;
use crate::{costs, elements, laws, persson_states, python_calls, scan_files, states};

/// Part of the page: a file of numbers, and a table of them.
#[derive(Debug)]
pub struct Part {
    /// Name on the command line, of its section, and of its file.
    pub name: &'static str,
    /// Measures the rows of its file as CSV; the error says why that cannot be done here.
    pub measure: fn(&Environment) -> Result<String, String>,
    /// Makes the table of the rows.
    pub table: fn(&str) -> Result<String, String>,
}

/// All parts, in the order of the page.
pub const PARTS: [Part; 6] = [
    Part { name: "states", measure: states::measure, table: costs::table_of },
    Part { name: "laws", measure: laws::measure, table: costs::table_of },
    Part { name: "persson", measure: persson_states::measure, table: costs::table_of },
    Part { name: "elements", measure: elements::measure, table: elements::table_of },
    Part { name: "scans", measure: scan_files::measure, table: scan_files::table_of },
    Part { name: "python", measure: python_calls::measure, table: python_calls::table_of },
];

#[cfg(test)]
mod tests {
    use tables::markdown::with_section;

    use super::*;
    use crate::reference::repository;

    #[test]
    fn the_tables_of_the_page_are_those_of_the_files() {
        let page = std::fs::read_to_string(repository("docs/develop/performance.md")).unwrap();
        for part in &PARTS {
            let file = repository("docs/develop/performance").join(format!("{}.csv", part.name));
            let table = (part.table)(&std::fs::read_to_string(file).unwrap()).unwrap();
            assert_eq!(with_section(&page, part.name, &table).unwrap(), page, "{}", part.name);
        }
    }
}

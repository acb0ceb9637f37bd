//! Parts of the page that are measured one by one, each with tables and files of its own.

use crate::bench::{Bench, Contents};
use crate::reference::repository;
use crate::{
    bracket, elements, files, intervals, kernels, persson_states, pictures, python_calls, scaling,
    scan_files, sections,
};

/// Part that can be measured alone.
#[derive(Debug)]
pub struct Part {
    /// Name on the command line and of its section.
    pub name: &'static str,
    /// Measures it; the error says why it cannot be measured here.
    pub measure: fn(&mut Bench) -> Result<Contents, String>,
}

/// All parts, in the order in which they are measured.
pub const PARTS: [Part; 8] = [
    Part { name: "kernels", measure: of_kernels },
    Part { name: "elements", measure: elements::measure },
    Part { name: "persson", measure: persson_states::measure },
    Part { name: "judge", measure: bracket::measure },
    Part { name: "intervals", measure: intervals::measure },
    Part { name: "scans", measure: scan_files::measure },
    Part { name: "python", measure: python_calls::measure },
    Part { name: "scaling", measure: of_scaling },
];

fn of_kernels(bench: &mut Bench) -> Result<Contents, String> {
    let costs = kernels::costs(bench.worker.as_mut())?;
    Ok(Contents {
        sections: vec![
            ("kernels", sections::kernel_costs(&costs)),
            ("kernel-verdicts", sections::kernel_verdicts(&costs)),
        ],
        files: vec![("kernels.csv", files::kernels_csv(&costs, &bench.facts))],
    })
}

fn of_scaling(bench: &mut Bench) -> Result<Contents, String> {
    let scaling = scaling::measure(repository("target/work-precision/tables"))?;
    Ok(Contents {
        sections: vec![("scaling", sections::growths(&scaling))],
        files: vec![
            ("scaling.csv", files::scaling_csv(&scaling, &bench.facts)),
            ("scaling.svg", pictures::scaling(&scaling, &bench.facts)),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_has_a_section_of_its_name() {
        let page = std::fs::read_to_string(repository("docs/develop/performance.md")).unwrap();
        for part in &PARTS {
            assert!(page.contains(&format!("<!-- measured: {} -->\n", part.name)), "{}", part.name);
        }
    }
}

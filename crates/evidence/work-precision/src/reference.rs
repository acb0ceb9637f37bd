//! States and their high-precision values: `tests/reference/work_precision.csv`, made by `make_work_precision.py`.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// Population of a material under a law, in the names of the table's columns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Case {
    /// Law of the asperities: `hertz`, `ep-sphere`, `elastic-sine` (Rostami & Jackson), `ep-sine`.
    pub model: String,
    /// Young's modulus \[Pa\]; the counterface is rigid.
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Macroscopic yield strength \[Pa\].
    pub yield_strength_pa: f64,
    /// Strain-gradient length \[m\]; `None` without.
    pub strain_gradient_length_m: Option<f64>,
    /// Radius of the asperities \[m\].
    pub radius_m: f64,
    /// Number of asperities per nominal area \[m^-2\].
    pub density_per_m2: f64,
    /// Standard deviation of the heights \[m\].
    pub sigma_s_m: f64,
}

impl Case {
    /// Name of the law, with strain gradient if it has one.
    pub fn law(&self) -> String {
        let gradient = if self.strain_gradient_length_m.is_some() { ", strain gradient" } else { "" };
        format!("{}{gradient}", self.model)
    }
}

/// State with values of 20 digits, read as doubles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Separation from the mean of the asperity heights \[m\].
    pub separation_m: f64,
    /// Separation in standard deviations.
    pub separation_over_sigma: f64,
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Real over nominal area.
    pub area_fraction: f64,
}

/// States of one population under one law.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Name of the population.
    pub population: String,
    /// Population and law.
    pub case: Case,
    /// States of the population.
    pub states: Vec<State>,
}

/// Row of the table. Repeats the columns of a case, because csv cannot flatten them.
#[derive(Deserialize)]
struct Row {
    population: String,
    model: String,
    youngs_modulus_pa: f64,
    poisson_ratio: f64,
    yield_strength_pa: f64,
    strain_gradient_length_m: Option<f64>,
    radius_m: f64,
    density_per_m2: f64,
    sigma_s_m: f64,
    separation_m: f64,
    pressure_pa: f64,
    area_fraction: f64,
}

/// Reads the committed table.
///
/// # Errors
/// A message with the file if it cannot be read.
pub fn committed() -> Result<Vec<Group>, String> {
    read(&repository("tests/reference/work_precision.csv"))
}

/// Reads a table of states, gathered by population and law.
///
/// # Errors
/// A message with the file if it cannot be read.
pub fn read(path: &Path) -> Result<Vec<Group>, String> {
    let failed = |error: csv::Error| format!("{}: {error}", path.display());
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).map_err(failed)?;
    let mut groups: Vec<Group> = Vec::new();
    for row in reader.deserialize() {
        let (population, case, state) = parts(row.map_err(failed)?);
        match groups.iter_mut().find(|group| group.population == population && group.case == case) {
            Some(group) => group.states.push(state),
            None => groups.push(Group { population, case, states: vec![state] }),
        }
    }
    Ok(groups)
}

fn parts(row: Row) -> (String, Case, State) {
    let case = Case {
        model: row.model,
        youngs_modulus_pa: row.youngs_modulus_pa,
        poisson_ratio: row.poisson_ratio,
        yield_strength_pa: row.yield_strength_pa,
        strain_gradient_length_m: row.strain_gradient_length_m,
        radius_m: row.radius_m,
        density_per_m2: row.density_per_m2,
        sigma_s_m: row.sigma_s_m,
    };
    let state = State {
        separation_m: row.separation_m,
        separation_over_sigma: row.separation_m / row.sigma_s_m,
        pressure_pa: row.pressure_pa,
        area_fraction: row.area_fraction,
    };
    (row.population, case, state)
}

/// Row of a table, by column; cells that are no numbers are left out.
pub type Columns = HashMap<String, f64>;

/// Reads a table of `tests/reference` whose columns are numbers.
///
/// # Errors
/// A message with the file if it cannot be read.
pub fn columns(table: &str) -> Result<Vec<Columns>, String> {
    let path = repository("tests/reference").join(table);
    let failed = |error: csv::Error| format!("{table}: {error}");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).map_err(failed)?;
    let names = reader.headers().map_err(failed)?.clone();
    let row = |record: Result<csv::StringRecord, csv::Error>| {
        let record = record.map_err(failed)?;
        let numbers = names.iter().zip(&record);
        Ok(numbers.filter_map(|(name, cell)| Some((name.to_owned(), cell.parse().ok()?))).collect())
    };
    reader.records().map(row).collect()
}

/// Path of a file of this repository, from its top.
pub fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..").join(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_population_has_every_law_at_the_same_separations() {
        let groups = committed().unwrap();
        assert_eq!(groups.len(), 18);
        for group in &groups {
            let separations: Vec<i64> =
                group.states.iter().map(|state| state.separation_over_sigma.round() as i64).collect();
            assert_eq!(separations, [-3, 0, 3, 6, 20], "{} {}", group.population, group.case.law());
            assert!(group.states.is_sorted_by(|near, far| near.pressure_pa > far.pressure_pa));
        }
    }
}

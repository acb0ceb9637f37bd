//! Laws of one asperity, for a number and for a thousand at once, beside Python and numpy: time and error over the tables of
//! single asperities in `tests/reference`, whose rows lie in the hard regions of each law.

use std::hint::black_box;

use asperity::{
    ElasticBody, ElasticPlasticSinusoid, ElasticSinusoid, Hardness, Hertz, JacksonGreen, MaterialPair,
};

use crate::clock::seconds_per_call;
use crate::costs::{Cost, joined, median};
use crate::csv_rows::parse;
use crate::environment::Environment;
use crate::reference::{Columns, columns, repository};

const BUDGET_OF_A_ROW_S: f64 = 1e-3;
/// Copies of a row's interference that a law takes at once; `laws_of_one.py` gives numpy as many.
const BATCH: usize = 1000;

/// Force and area, or pressure and area, at an interference.
type One = Box<dyn Fn(f64) -> (f64, f64)>;
/// Forces and areas at many interferences, into slices.
type Many = Box<dyn Fn(&[f64], &mut [f64], &mut [f64])>;

/// Law: its name and table, itself at a row for one number and for many, and the columns of its results.
struct Law {
    name: &'static str,
    table: &'static str,
    at_row: fn(&Columns) -> (One, Many),
    exact: [&'static str; 2],
}

const LAWS: [Law; 4] = [
    Law {
        name: "hertz",
        table: "sphere.csv",
        at_row: |row| {
            let hertz = Hertz::new(&pair(row), row["radius_m"]);
            (
                Box::new(move |w_m| (hertz.force_n(w_m), hertz.area_m2(w_m))),
                Box::new(move |w_m, forces_n, areas_m2| hertz.forces_and_areas(w_m, forces_n, areas_m2)),
            )
        },
        exact: ["hertz_force_n", "hertz_area_m2"],
    },
    Law {
        name: "ep-sphere",
        table: "sphere.csv",
        at_row: |row| {
            let strength_pa = row["yield_strength_pa"];
            let sphere = JacksonGreen::new(&pair(row), row["radius_m"], strength_pa, Hardness::default());
            (
                Box::new(move |w_m| sphere.force_and_area(w_m)),
                Box::new(move |w_m, forces_n, areas_m2| sphere.forces_and_areas(w_m, forces_n, areas_m2)),
            )
        },
        exact: ["jackson_green_force_n", "jackson_green_area_m2"],
    },
    Law {
        name: "elastic-sine",
        table: "sinusoid_interference.csv",
        at_row: |row| {
            let sinusoid = ElasticSinusoid::new(&pair(row), row["aspect_ratio"]);
            (
                Box::new(move |depth| sinusoid.pressure_and_area_at_interference(depth)),
                Box::new(move |depths, pressures_pa, areas| {
                    sinusoid.pressures_and_areas_at_interferences(depths, pressures_pa, areas);
                }),
            )
        },
        exact: ["pressure_elastic_pa", "area_fraction_elastic"],
    },
    Law {
        name: "ep-sine",
        table: "sinusoid_interference.csv",
        at_row: |row| {
            let strength_pa = row["yield_strength_pa"];
            let sinusoid = ElasticPlasticSinusoid::new(&pair(row), row["aspect_ratio"], strength_pa);
            (
                Box::new(move |depth| sinusoid.pressure_and_area_at_interference(depth)),
                Box::new(move |depths, pressures_pa, areas| {
                    sinusoid.pressures_and_areas_at_interferences(depths, pressures_pa, areas);
                }),
            )
        },
        exact: ["pressure_ep_pa", "area_fraction_ep"],
    },
];

/// Computes every row of the tables with every program.
///
/// # Errors
/// A message if a table cannot be read, or if the script fails.
pub fn measure(environment: &Environment) -> Result<String, String> {
    let mut costs = Vec::new();
    for law in &LAWS {
        costs.extend(law.costs()?);
    }
    let printed = environment.output("laws_of_one.py", [repository("tests/reference")])?;
    costs.extend(parse::<Cost>(&printed)?);
    joined(&costs, median)
}

impl Law {
    /// Our costs at every row of the table, of one number and of each of many.
    fn costs(&self) -> Result<Vec<Cost>, String> {
        let (mut first, mut second) = (vec![0.0; BATCH], vec![0.0; BATCH]);
        let mut costs = Vec::new();
        for row in columns(self.table)? {
            let ((one, many), at) = ((self.at_row)(&row), interference(&row));
            let seconds = seconds_per_call(BUDGET_OF_A_ROW_S, || one(black_box(at)));
            costs.push(Cost::new(self.name, "truearea", seconds, self.error(&row, one(at))));
            let interferences = vec![at; BATCH];
            let seconds = seconds_per_call(BUDGET_OF_A_ROW_S, || {
                many(black_box(&interferences), &mut first, &mut second);
                black_box((&first, &second));
            });
            let error = self.error(&row, (first[0], second[0]));
            costs.push(Cost::new(self.name, "truearea, each of 1000", seconds / BATCH as f64, error));
        }
        Ok(costs)
    }

    /// Larger of the relative errors of the two results.
    fn error(&self, row: &Columns, found: (f64, f64)) -> f64 {
        let [first, second] = self.exact.map(|column| row[column]);
        let relative =
            |value: f64, exact: f64| if value == exact { 0.0 } else { (value / exact - 1.0).abs() };
        relative(found.0, first).max(relative(found.1, second))
    }
}

/// Interference of a row in m; over the amplitude for sinusoids.
fn interference(row: &Columns) -> f64 {
    let amplitude_m = row.get("wavelength_m").map_or(1.0, |wavelength_m| row["aspect_ratio"] * wavelength_m);
    row["interference_m"] / amplitude_m
}

fn pair(row: &Columns) -> MaterialPair {
    let body = ElasticBody::new(row["youngs_modulus_pa"], row["poisson_ratio"]).expect("a body of the table");
    MaterialPair::against_rigid(body)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_law_is_right_where_it_is_hard_and_many_are_as_one() {
        for law in &LAWS {
            let rows = columns(law.table).unwrap();
            assert!(rows.len() > 100, "{}", law.name);
            let at_row = |row: &Columns| {
                let ((one, many), at) = ((law.at_row)(row), interference(row));
                let (mut first, mut second) = ([0.0; 3], [0.0; 3]);
                many(&[at; 3], &mut first, &mut second);
                let alone = one(at);
                assert_eq!((first, second), ([alone.0; 3], [alone.1; 3]), "{}: {row:?}", law.name);
                law.error(row, alone)
            };
            let mut errors: Vec<f64> = rows.iter().map(at_row).collect();
            errors.sort_by(f64::total_cmp);
            assert!(median(&errors) < 1e-14, "{}", law.name);
        }
    }
}

//! Cost of one asperity: force and area at an interference, area at a pressure, against the tables of single
//! asperities in `tests/reference`, whose rows lie in the hard regions of each law.

use std::f64::consts::TAU;
use std::hint::black_box;

use asperity::{
    ElasticBody, ElasticPlasticSinusoid, ElasticSinusoid, Hardness, Hertz, JacksonGreen, MaterialPair,
};

use crate::clock::seconds_per_call;
use crate::competitors::{Question, Row, Setting, States, Worker};
use crate::reference::{Case, Columns, columns};

const OUR_BUDGET_S: f64 = 0.05;
const BUDGET_OF_A_ROW_S: f64 = 1e-3;
/// Copies of a row's interference that a law takes at once; `worker.py` gives numpy as many.
const BATCH: usize = 1000;

/// Cost of one evaluation of a law.
#[derive(Debug, Clone, PartialEq)]
pub struct KernelCost {
    /// Quantity that is evaluated.
    pub kernel: &'static str,
    /// Cost of this program.
    pub ours: Cost,
    /// Cost of this program, per number of a slice of a thousand; `None` for laws that take one number at a time.
    pub batch: Option<Cost>,
    /// Cost of the same formulas in Python, a number at a time; `None` if not compared.
    pub scalar: Option<Cost>,
    /// Cost in numpy, per number of an array of a thousand.
    pub array: Option<Cost>,
}

/// Time and error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Seconds per evaluation.
    pub seconds: f64,
    /// Median relative error over the table.
    pub median_error: f64,
}

/// Evaluation of a law at one row, with two results.
type Evaluation = Box<dyn Fn() -> (f64, f64)>;

/// Evaluation of a law at many interferences: these, and slices for the two results.
type BatchEvaluation = Box<dyn Fn(&[f64], &mut [f64], &mut [f64])>;

/// Law prepared for a row, for many interferences, and the interference of the row.
type Batch = fn(&Columns) -> (BatchEvaluation, f64);

/// Kernel: its table, its law prepared for a row, and the columns of its two results.
struct Kernel {
    name: &'static str,
    table: &'static str,
    law: fn(&Columns) -> Evaluation,
    /// Evaluation at many interferences; `None` for laws that take one number at a time.
    batch: Option<Batch>,
    exact: [&'static str; 2],
    /// Name of the law in Python.
    model: Option<&'static str>,
}

const KERNELS: [Kernel; 7] = [
    Kernel {
        name: "Hertz: force, area",
        table: "sphere.csv",
        law: |row| {
            let (hertz, w_m) = (Hertz::new(&pair(row), row["radius_m"]), row["interference_m"]);
            Box::new(move || (hertz.force_n(black_box(w_m)), hertz.area_m2(w_m)))
        },
        batch: Some(|row| {
            let hertz = Hertz::new(&pair(row), row["radius_m"]);
            (
                Box::new(move |w_m, forces_n, areas_m2| hertz.forces_and_areas(w_m, forces_n, areas_m2)),
                row["interference_m"],
            )
        }),
        exact: ["hertz_force_n", "hertz_area_m2"],
        model: Some("hertz"),
    },
    Kernel {
        name: "Jackson & Green: force, area",
        table: "sphere.csv",
        law: |row| {
            let (sphere, w_m) = (sphere(row), row["interference_m"]);
            Box::new(move || sphere.force_and_area(black_box(w_m)))
        },
        batch: Some(|row| {
            let sphere = sphere(row);
            (
                Box::new(move |w_m, forces_n, areas_m2| sphere.forces_and_areas(w_m, forces_n, areas_m2)),
                row["interference_m"],
            )
        }),
        exact: ["jackson_green_force_n", "jackson_green_area_m2"],
        model: Some("ep-sphere"),
    },
    Kernel {
        name: "elastic sinusoid at an interference: pressure, area",
        table: "sinusoid_interference.csv",
        law: |row| {
            let (sinusoid, depth) = (ElasticSinusoid::new(&pair(row), row["aspect_ratio"]), depth(row));
            Box::new(move || sinusoid.pressure_and_area_at_interference(black_box(depth)))
        },
        batch: Some(|row| {
            let sinusoid = ElasticSinusoid::new(&pair(row), row["aspect_ratio"]);
            (
                Box::new(move |depths, pressures_pa, area_fractions| {
                    sinusoid.pressures_and_areas_at_interferences(depths, pressures_pa, area_fractions);
                }),
                depth(row),
            )
        }),
        exact: ["pressure_elastic_pa", "area_fraction_elastic"],
        model: Some("elastic-sine"),
    },
    Kernel {
        name: "elastic-plastic sinusoid at an interference: pressure, area",
        table: "sinusoid_interference.csv",
        law: |row| {
            let (sinusoid, depth) = (plastic(row), depth(row));
            Box::new(move || sinusoid.pressure_and_area_at_interference(black_box(depth)))
        },
        batch: Some(|row| {
            let sinusoid = plastic(row);
            (
                Box::new(move |depths, pressures_pa, area_fractions| {
                    sinusoid.pressures_and_areas_at_interferences(depths, pressures_pa, area_fractions);
                }),
                depth(row),
            )
        }),
        exact: ["pressure_ep_pa", "area_fraction_ep"],
        model: Some("ep-sine"),
    },
    Kernel {
        name: "elastic sinusoid at a pressure: area",
        table: "sinusoid.csv",
        law: |row| {
            let (sinusoid, p_pa) =
                (ElasticSinusoid::new(&pair(row), row["aspect_ratio"]), row["pressure_pa"]);
            Box::new(move || twice(sinusoid.area_fraction(black_box(p_pa))))
        },
        batch: None,
        exact: ["area_fraction_elastic"; 2],
        model: None,
    },
    Kernel {
        name: "elastic-plastic sinusoid at a pressure: area",
        table: "sinusoid.csv",
        law: |row| {
            let (sinusoid, p_pa) = (plastic(row), row["pressure_pa"]);
            Box::new(move || twice(sinusoid.area_fraction(black_box(p_pa))))
        },
        batch: None,
        exact: ["area_fraction_ep"; 2],
        model: None,
    },
    Kernel {
        name: "elastic-plastic sinusoid at a pressure: mean gap",
        table: "sinusoid.csv",
        law: |row| {
            let (sinusoid, p_pa) = (plastic(row), row["pressure_pa"]);
            Box::new(move || twice(sinusoid.mean_gap_over_amplitude(black_box(p_pa))))
        },
        batch: None,
        exact: ["mean_gap_over_amplitude"; 2],
        model: None,
    },
];

/// Costs of every law of one asperity, beside the same formulas in Python if there is a worker.
///
/// # Errors
/// A message if a table cannot be read.
pub fn costs(mut worker: Option<&mut Worker>) -> Result<Vec<KernelCost>, String> {
    KERNELS.iter().map(|kernel| cost(kernel, worker.as_deref_mut())).collect()
}

fn cost(kernel: &Kernel, worker: Option<&mut Worker>) -> Result<KernelCost, String> {
    let rows = columns(kernel.table)?;
    let laws: Vec<_> = rows.iter().map(kernel.law).collect();
    let seconds =
        seconds_per_call(OUR_BUDGET_S, || laws.iter().map(|law| law().1).sum::<f64>()) / rows.len() as f64;
    let errors = laws.iter().zip(&rows).map(|(law, row)| error(kernel, row, law()));
    let ours = Cost { seconds, median_error: median(errors) };
    let (scalar, array) = match (kernel.model, worker) {
        (Some(model), Some(worker)) => theirs(kernel, model, &rows, worker),
        _ => (None, None),
    };
    Ok(KernelCost { kernel: kernel.name, ours, batch: batch_cost(kernel, &rows), scalar, array })
}

/// Cost per number of [`BATCH`] copies of a row's interference: the mean over the rows.
fn batch_cost(kernel: &Kernel, rows: &[Columns]) -> Option<Cost> {
    let batch = kernel.batch?;
    let (mut first, mut second) = (vec![0.0; BATCH], vec![0.0; BATCH]);
    let mut at_row = |row: &Columns| {
        let (law, interference) = batch(row);
        let interferences = vec![interference; BATCH];
        let seconds = seconds_per_call(BUDGET_OF_A_ROW_S, || {
            law(black_box(&interferences), &mut first, &mut second);
            black_box((&first, &second));
        });
        (seconds / BATCH as f64, error(kernel, row, (first[0], second[0])))
    };
    let costs: Vec<(f64, f64)> = rows.iter().map(&mut at_row).collect();
    let seconds = costs.iter().map(|(seconds, _)| seconds).sum::<f64>() / rows.len() as f64;
    Some(Cost { seconds, median_error: median(costs.into_iter().map(|(_, error)| error)) })
}

/// Costs in Python, a number at a time and in arrays: the mean over the rows.
fn theirs(
    kernel: &Kernel,
    model: &str,
    rows: &[Columns],
    worker: &mut Worker,
) -> (Option<Cost>, Option<Cost>) {
    let answers = rows.iter().map(|row| {
        let (case, at) = (case(model, row), States::One(row["interference_m"]));
        let (setting, seconds) = (Setting::Nodes(0), BUDGET_OF_A_ROW_S);
        worker.ask(&Question { engine: "kernel", setting, by_pressure: false, case: &case, at, seconds })
    });
    let Ok(answers) = answers.collect::<Result<Vec<Vec<Row>>, String>>() else { return (None, None) };
    let of = |at: usize| {
        let answers: Option<Vec<&Row>> = answers.iter().map(|answer| answer.get(at)).collect();
        let answers = answers?;
        let errors = answers
            .iter()
            .zip(rows)
            .map(|(answer, row)| error(kernel, row, (answer.number(0), answer.number(1))));
        let seconds = answers.iter().map(|answer| answer.seconds).sum::<f64>() / rows.len() as f64;
        Some(Cost { seconds, median_error: median(errors) })
    };
    (of(0), of(1))
}

/// Row as a population of one asperity per square metre with a spread of one metre, so that pressure is force; for
/// sinusoids with the density that gives their wavelength.
fn case(model: &str, row: &Columns) -> Case {
    let (density_per_m2, radius_m) = match row.get("wavelength_m") {
        Some(wavelength_m) => {
            let amplitude_m = row["aspect_ratio"] * wavelength_m;
            (2.0 / wavelength_m.powi(2), (wavelength_m / TAU).powi(2) / amplitude_m)
        }
        None => (1.0, row["radius_m"]),
    };
    Case {
        model: model.to_owned(),
        youngs_modulus_pa: row["youngs_modulus_pa"],
        poisson_ratio: row["poisson_ratio"],
        yield_strength_pa: row["yield_strength_pa"],
        strain_gradient_length_m: None,
        radius_m,
        density_per_m2,
        sigma_s_m: 1.0,
    }
}

fn pair(row: &Columns) -> MaterialPair {
    let body = ElasticBody::new(row["youngs_modulus_pa"], row["poisson_ratio"]).expect("a body of the table");
    MaterialPair::against_rigid(body)
}

fn sphere(row: &Columns) -> JacksonGreen {
    JacksonGreen::new(&pair(row), row["radius_m"], row["yield_strength_pa"], Hardness::default())
}

fn plastic(row: &Columns) -> ElasticPlasticSinusoid {
    ElasticPlasticSinusoid::new(&pair(row), row["aspect_ratio"], row["yield_strength_pa"])
}

/// Interference over amplitude.
fn depth(row: &Columns) -> f64 {
    row["interference_m"] / (row["aspect_ratio"] * row["wavelength_m"])
}

fn twice(value: f64) -> (f64, f64) {
    (value, value)
}

fn error(kernel: &Kernel, row: &Columns, found: (f64, f64)) -> f64 {
    let [first, second] = kernel.exact.map(|column| row[column]);
    let relative = |value: f64, exact: f64| if value == exact { 0.0 } else { (value / exact - 1.0).abs() };
    relative(found.0, first).max(relative(found.1, second))
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kernel_is_right_where_its_law_is_hard() {
        for kernel in &KERNELS {
            let rows = columns(kernel.table).unwrap();
            assert!(rows.len() > 100, "{}", kernel.name);
            let errors = rows.iter().map(|row| error(kernel, row, (kernel.law)(row)()));
            assert!(median(errors) < 1e-14, "{}", kernel.name);
        }
    }

    #[test]
    fn a_law_at_many_interferences_has_the_results_of_one() {
        for kernel in &KERNELS {
            let Some(batch) = kernel.batch else { continue };
            for row in columns(kernel.table).unwrap() {
                let (law, interference) = batch(&row);
                let (mut first, mut second) = ([0.0; 3], [0.0; 3]);
                law(&[interference; 3], &mut first, &mut second);
                let (alone, alone_too) = (kernel.law)(&row)();
                assert_eq!((first, second), ([alone; 3], [alone_too; 3]), "{}: {row:?}", kernel.name);
            }
        }
    }
}

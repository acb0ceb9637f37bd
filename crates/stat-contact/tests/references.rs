//! States against the project's high-precision table, which lies beside a development checkout.

use std::path::Path;

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, InterferenceLaw, Model, Population, StatisticalContact};

/// A row of the table: the contact, its height spread, and separation, pressure and area fraction.
struct Row {
    model: Model,
    gradient: bool,
    contact: StatisticalContact,
    sigma_s_m: f64,
    separation_m: f64,
    pressure_pa: f64,
    area_fraction: f64,
}

fn rows() -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/reference/statistical.csv");
    match std::fs::read_to_string(&path) {
        Ok(text) => text.lines().skip(1).map(row).collect(),
        Err(_) => {
            eprintln!("shared/reference/statistical.csv is absent beside the checkout: not compared here");
            Vec::new()
        }
    }
}

fn row(line: &str) -> Row {
    let cells: Vec<&str> = line.split(',').collect();
    let number = |i: usize| cells[i].parse::<f64>().unwrap_or_else(|_| panic!("{line}: cell {i}"));
    let model: Model = cells[0].parse().unwrap();
    let length_m = (!cells[4].is_empty()).then(|| number(4));
    let strength = NixGao::constant(number(3)).unwrap();
    let strength = length_m.map_or(strength, |length_m| strength.with_strain_gradient(length_m).unwrap());
    let law = match model {
        Model::Hertz => AsperityLaw::Hertz,
        Model::EpSphere => AsperityLaw::EpSphere { strength, hardness: Hardness::default() },
        Model::ElasticSine => AsperityLaw::ElasticSine { interference: InterferenceLaw::default() },
        Model::EpSine => AsperityLaw::EpSine { strength },
    };
    let pair = MaterialPair::against_rigid(ElasticBody::new(number(1), number(2)).unwrap());
    let population = Population::new(number(5), number(6), number(7)).unwrap();
    Row {
        model,
        gradient: length_m.is_some(),
        contact: StatisticalContact::new(&pair, &population, &law),
        sigma_s_m: number(7),
        separation_m: number(8),
        pressure_pa: number(9),
        area_fraction: number(10),
    }
}

fn deviation(computed: f64, reference: f64) -> f64 {
    (computed / reference - 1.0).abs()
}

#[test]
fn pressure_and_area_agree_with_the_table() {
    for row in rows() {
        let state = row.contact.at_separation(row.separation_m, 1e-12).unwrap();
        let bar = if row.gradient { 1e-11 } else { 1e-12 };
        let found = [
            deviation(state.pressure_pa, row.pressure_pa),
            deviation(state.area_fraction, row.area_fraction),
        ];
        assert!(found.iter().all(|&d| d < bar), "{} at {:e}: {found:?}", row.model, row.separation_m);
    }
}

#[test]
fn estimated_errors_bound_the_true_ones_at_every_tolerance() {
    for row in rows() {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let state = row.contact.at_separation(row.separation_m, tolerance).unwrap();
            let made = deviation(state.pressure_pa, row.pressure_pa)
                .max(deviation(state.area_fraction, row.area_fraction));
            let estimate = state.error_estimate;
            assert!(made <= estimate, "{} at {tolerance:e}: {made:e}, estimated {estimate:e}", row.model);
            assert!(estimate < 10.0 * tolerance, "{} at {tolerance:e}: {estimate:e}", row.model);
        }
    }
}

#[test]
fn separation_and_area_are_found_from_the_pressure_from_any_start() {
    for row in rows() {
        let starts = [None, Some(-40.0), Some(-1.0), Some(0.5), Some(6.0), Some(55.0)];
        let mut found = Vec::new();
        for start in starts {
            let start = start.map(|u| row.contact.at_separation(u * row.sigma_s_m, 1e-4).unwrap());
            let state = row.contact.at_pressure(row.pressure_pa, 1e-12, start.as_ref()).unwrap();
            let separation_m = state.separation_m.expect("the table's pressures are carried");
            let off = (separation_m - row.separation_m).abs() / row.sigma_s_m;
            let area_off = deviation(state.area_fraction, row.area_fraction);
            assert!(off < 1e-10 && area_off < 1e-10, "{}: {off:e} {area_off:e}", row.model);
            found.push(separation_m / row.sigma_s_m);
        }
        let spread = found.iter().fold(0.0, |spread: f64, u| spread.max((u - found[0]).abs()));
        assert!(spread <= 2e-14 * found[0].abs().max(1.0), "{}: {found:?}", row.model);
    }
}

#[test]
fn a_looser_tolerance_costs_less() {
    let rows = rows();
    let cost = |tolerance: f64| -> usize {
        rows.iter()
            .map(|row| row.contact.at_separation(row.separation_m, tolerance).unwrap().evaluations)
            .sum()
    };
    let costs = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12].map(cost);
    assert!(rows.is_empty() || costs.is_sorted_by(|a, b| a < b), "{costs:?}");
}

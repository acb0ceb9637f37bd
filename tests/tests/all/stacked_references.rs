//! The stacked model, level by level, against high-precision tables.

use std::num::NonZeroU32;

use asperity::{ElasticBody, MaterialPair, NixGao};
use spectrum::{AmplitudeDefinition, ReadOptions, amplitudes, read_psd};
use stacked_contact::{Scale, StackedModel, levels};
use tests::{Deviations, ReferenceTable, committed_file};

/// The rows of a table that belong to one curve, by what tells curves apart.
fn curves(table: &ReferenceTable) -> Vec<Vec<usize>> {
    let keys = ["model", "strain_gradient_length_m", "youngs_modulus_pa", "nominal_pressure_pa"]
        .map(|column| table.text(column));
    let key = |row: usize| keys.each_ref().map(|column| column[row]);
    let mut curves: Vec<Vec<usize>> = Vec::new();
    for row in 0..table.len() {
        match curves.last_mut() {
            Some(curve) if key(curve[0]) == key(row) => curve.push(row),
            _ => curves.push(vec![row]),
        }
    }
    curves
}

fn model(table: &ReferenceTable, row: usize) -> StackedModel {
    let number = |column| table.numbers(column)[row];
    let body = ElasticBody::new(number("youngs_modulus_pa"), number("poisson_ratio")).unwrap();
    let pair = MaterialPair::against_rigid(body);
    let strength = NixGao::constant(number("yield_strength_pa")).unwrap();
    match (table.text("model")[row], table.text("strain_gradient_length_m")[row]) {
        ("elastic", _) => StackedModel::Elastic { pair },
        ("elastic-plastic", "") => StackedModel::ElasticPlastic { pair, strength, area: Default::default() },
        ("elastic-plastic", length_m) => {
            let strength = strength.with_strain_gradient(length_m.parse().unwrap()).unwrap();
            StackedModel::ElasticPlastic { pair, strength, area: Default::default() }
        }
        (other, _) => panic!("no model {other}"),
    }
}

/// Levels computed from the table's own scales, against its results.
fn compare(name: &str) {
    let table = ReferenceTable::committed(name);
    let [wavelengths, amplitudes, pressures, areas, real_pressures, pressures_in] = [
        "wavelength_m",
        "amplitude_m",
        "nominal_pressure_pa",
        "area_fraction",
        "real_pressure_pa",
        "pressure_in_pa",
    ]
    .map(|column| table.numbers(column));
    let (strengths, regimes) = (table.text("yield_strength_level_pa"), table.text("regime"));
    let mut deviations = Deviations::default();
    for rows in curves(&table) {
        let scales =
            rows.iter().map(|&row| Scale { wavelength_m: wavelengths[row], amplitude_m: amplitudes[row] });
        for (level, &row) in levels(&model(&table, rows[0]), pressures[rows[0]], scales).zip(&rows) {
            deviations.note(level.area_fraction, areas[row]);
            deviations.note(level.real_pressure_pa, real_pressures[row]);
            deviations.note(level.pressure_in_pa, pressures_in[row]);
            assert_eq!(level.regime.name(), regimes[row], "{name}, row {row}");
            match level.yield_strength_pa {
                Some(strength_pa) => deviations.note(strength_pa, strengths[row].parse().unwrap()),
                None => assert_eq!(strengths[row], "", "{name}, row {row}"),
            }
        }
    }
    deviations.assert_within(name, 1e-13, 1e-11);
}

#[test]
fn elastic_stacks_agree_level_by_level() {
    compare("stacked_uncd_elastic.csv");
}

#[test]
fn elastic_plastic_stacks_agree_level_by_level() {
    compare("stacked_uncd_ep_low.csv");
    compare("stacked_uncd_ep_high.csv");
    compare("stacked_uncd_measured.csv");
}

#[test]
fn stacks_with_strain_gradient_agree_level_by_level() {
    compare("stacked_uncd_gradient_low.csv");
    compare("stacked_uncd_gradient_high.csv");
}

#[test]
fn soft_metals_and_polymers_agree_level_by_level() {
    compare("stacked_metal.csv");
    compare("stacked_metal_flattened.csv");
    compare("stacked_polymer.csv");
}

#[test]
fn resampled_stacks_agree_level_by_level() {
    compare("stacked_resampled_5.csv");
    compare("stacked_resampled_20.csv");
}

#[test]
fn resampling_gives_the_scales_of_those_stacks() {
    let file = std::fs::File::open(committed_file("data/uncd_psd_reconstructed.csv")).unwrap();
    let psd = read_psd(file, &ReadOptions::default()).unwrap().psd.profile().unwrap();
    for per_decade in [5, 20] {
        let table = ReferenceTable::committed(&format!("stacked_resampled_{per_decade}.csv"));
        let rows = curves(&table).remove(0);
        let resampled = psd.resampled(NonZeroU32::new(per_decade).unwrap());
        assert_eq!(resampled.len(), rows.len());
        let (wavelengths, expected) = (table.numbers("wavelength_m"), table.numbers("amplitude_m"));
        let mut deviations = Deviations::default();
        for (scale, &row) in amplitudes(&resampled, AmplitudeDefinition::Eq5).iter().zip(&rows) {
            deviations.note(scale.wavelength_m, wavelengths[row]);
            deviations.note(scale.amplitude_m, expected[row]);
        }
        deviations.assert_within(&format!("{per_decade} scales per decade"), 1e-14, 1e-13);
    }
}

//! The laws of one asperity against high-precision tables.

use asperity::{ElasticBody, ElasticPlasticSinusoid, Hardness, Hertz, JacksonGreen, MaterialPair};
use tests::{Deviations, ReferenceTable};

fn pairs(table: &ReferenceTable) -> Vec<MaterialPair> {
    let moduli = table.numbers("youngs_modulus_pa");
    let ratios = table.numbers("poisson_ratio");
    moduli
        .iter()
        .zip(ratios)
        .map(|(&e, nu)| MaterialPair::against_rigid(ElasticBody::new(e, nu).unwrap()))
        .collect()
}

/// Compares each named column with what `law` computes for it, row by row. Where the table tells how much a result
/// magnifies the rounding of its inputs, the deviation counts beyond that.
fn compare<const N: usize>(
    table: &ReferenceTable,
    columns: [&str; N],
    max: f64,
    law: impl Fn(usize) -> [f64; N],
) {
    let mut deviations: [Deviations; N] = std::array::from_fn(|_| Deviations::default());
    let references = columns.map(|column| table.numbers(column));
    let conditions = table.has("condition").then(|| table.numbers("condition"));
    for row in 0..table.len() {
        let unavoidable = conditions.as_ref().map_or(0.0, |conditions| 2.0 * conditions[row] * f64::EPSILON);
        for (column, computed) in law(row).into_iter().enumerate() {
            deviations[column].note_beyond(unavoidable, computed, references[column][row]);
        }
    }
    for (column, deviation) in columns.into_iter().zip(deviations) {
        deviation.assert_within(column, max / 100.0, max);
    }
}

fn compare_spheres(table: &ReferenceTable, max: f64) {
    let pairs = pairs(table);
    let [strengths, radii, interferences] =
        ["yield_strength_pa", "radius_m", "interference_m"].map(|column| table.numbers(column));
    let columns = [
        "hertz_force_n",
        "hertz_area_m2",
        "jackson_green_force_n",
        "jackson_green_area_m2",
        "jackson_green_force_cosine_hardness_n",
    ];
    compare(table, columns, max, |row| {
        let w = interferences[row];
        let hertz = Hertz::new(&pairs[row], radii[row]);
        let [published, cosine] = [Hardness::JacksonGreen2005, Hardness::Cosine]
            .map(|hardness| JacksonGreen::new(&pairs[row], radii[row], strengths[row], hardness));
        [hertz.force_n(w), hertz.area_m2(w), published.force_n(w), published.area_m2(w), cosine.force_n(w)]
    });
}

fn compare_sinusoids(table: &ReferenceTable, max: f64) {
    let pairs = pairs(table);
    let [strengths, aspect_ratios, pressures] =
        ["yield_strength_pa", "aspect_ratio", "pressure_pa"].map(|column| table.numbers(column));
    let columns = [
        "complete_contact_pressure_elastic_pa",
        "area_fraction_elastic",
        "critical_aspect_ratio",
        "complete_contact_pressure_ep_pa",
        "area_fraction_ep",
        "mean_gap_over_amplitude",
    ];
    compare(table, columns, max, |row| {
        let p = pressures[row];
        let law = ElasticPlasticSinusoid::new(&pairs[row], aspect_ratios[row], strengths[row]);
        [
            law.elastic().complete_contact_pressure_pa(),
            law.elastic().area_fraction(p),
            law.critical_aspect_ratio(),
            law.complete_contact_pressure_pa(),
            law.area_fraction(p),
            law.mean_gap_over_amplitude(p),
        ]
    });
}

fn compare_interferences(table: &ReferenceTable, max: f64) {
    let pairs = pairs(table);
    let [strengths, wavelengths, aspect_ratios, interferences] =
        ["yield_strength_pa", "wavelength_m", "aspect_ratio", "interference_m"]
            .map(|column| table.numbers(column));
    let columns = ["pressure_elastic_pa", "area_fraction_elastic", "pressure_ep_pa", "area_fraction_ep"];
    compare(table, columns, max, |row| {
        let w = interferences[row] / (aspect_ratios[row] * wavelengths[row]);
        let law = ElasticPlasticSinusoid::new(&pairs[row], aspect_ratios[row], strengths[row]);
        let (elastic, plastic) =
            (law.elastic().pressure_at_interference_pa(w), law.pressure_at_interference_pa(w));
        [elastic, law.elastic().area_fraction(elastic), plastic, law.area_fraction(plastic)]
    });
}

#[test]
fn spheres_agree_with_the_shared_table() {
    if let Some(table) = ReferenceTable::shared("reference/sphere.csv") {
        compare_spheres(&table, 2e-13);
    }
}

#[test]
fn sinusoids_agree_with_the_shared_table() {
    if let Some(table) = ReferenceTable::shared("reference/sinusoid.csv") {
        compare_sinusoids(&table, 2e-13);
    }
}

#[test]
fn sinusoids_at_an_interference_agree_with_the_shared_table() {
    if let Some(table) = ReferenceTable::shared("reference/sinusoid_interference.csv") {
        compare_interferences(&table, 2e-12);
    }
}

#[test]
fn spheres_agree_with_the_hard_regions() {
    compare_spheres(&ReferenceTable::committed("sphere.csv"), 2e-13);
}

#[test]
fn sinusoids_agree_with_the_hard_regions() {
    compare_sinusoids(&ReferenceTable::committed("sinusoid.csv"), 2e-13);
}

#[test]
fn sinusoids_at_an_interference_agree_with_the_hard_regions() {
    compare_interferences(&ReferenceTable::committed("sinusoid_interference.csv"), 2e-12);
}

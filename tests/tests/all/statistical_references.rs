//! The statistical models at given separations against high-precision tables, from -60 to 60 standard deviations.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, ContactState, InterferenceLaw, Population, StatisticalContact};
use tests::{Deviations, ReferenceTable, shared_file};

fn state(table: &ReferenceTable, row: usize) -> ContactState {
    let number = |column| table.numbers(column)[row];
    let strength = NixGao::constant(number("yield_strength_pa")).unwrap();
    let strength = match table.text("strain_gradient_length_m")[row] {
        "" => strength,
        length_m => strength.with_strain_gradient(length_m.parse().unwrap()).unwrap(),
    };
    let law = match table.text("model")[row] {
        "hertz" => AsperityLaw::Hertz,
        "ep-sphere" => AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None },
        "elastic-sine" => AsperityLaw::ElasticSine { interference: InterferenceLaw::default() },
        "ep-sine" => AsperityLaw::EpSine { strength },
        other => panic!("no table has a law {other}"),
    };
    let body = ElasticBody::new(number("youngs_modulus_pa"), number("poisson_ratio")).unwrap();
    let population =
        Population::new(number("radius_m"), number("density_per_m2"), number("sigma_s_m")).unwrap();
    let contact = StatisticalContact::new(&MaterialPair::against_rigid(body), &population, &law);
    contact.at_separation(number("separation_m"), 1e-12).unwrap()
}

fn compare(table: &ReferenceTable) {
    let (pressures, areas) = (table.numbers("pressure_pa"), table.numbers("area_fraction"));
    let lengths = table.text("strain_gradient_length_m");
    let (mut plain, mut gradient) = (Deviations::default(), Deviations::default());
    for row in 0..table.len() {
        let state = state(table, row);
        let deviations = if lengths[row].is_empty() { &mut plain } else { &mut gradient };
        // References below the smallest double read as zero, and so do the results.
        deviations.note(state.pressure_pa, pressures[row]);
        deviations.note(state.area_fraction, areas[row]);
    }
    plain.assert_within("without strain gradient", 1e-13, 1e-12);
    gradient.assert_within("with strain gradient", 1e-13, 1e-11);
}

#[test]
#[ignore = "needs the shared folder"]
fn states_agree_with_the_shared_table() {
    compare(&ReferenceTable::read(&shared_file("reference/statistical.csv")));
}

#[test]
fn states_agree_over_the_whole_range_of_separations() {
    compare(&ReferenceTable::committed("statistical_extra.csv"));
}

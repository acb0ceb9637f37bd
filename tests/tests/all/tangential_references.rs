//! Tangential loads, held against closed forms of a sphere and of an exponential law with 40 digits.

use std::collections::BTreeMap;

use interface::tangential::{ShearedBody, ShearedPair};
use tests::shared_file;

#[test]
#[ignore = "needs the shared folder"]
fn sheared_contacts_agree_with_the_references() {
    let reference = std::fs::read(shared_file("reference/tangential.csv")).unwrap();
    let mut compared = 0;
    for row in csv::Reader::from_reader(&reference[..]).deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let number = |column: &str| row[column].parse::<f64>().unwrap();
        let (nu, load, scale) = (number("poisson"), number("normal"), number("law_scale"));
        // A sphere that slides has no rest that sticks: its limit is approached.
        let (share, tolerance) = match number("tangential_share") {
            share if share < 1.0 => (share, 1e-10),
            _ => (1.0 - 1e-15, 1e-9),
        };
        let body = ShearedBody { shear_modulus_pa: 1.0, poisson_ratio: nu };
        let modulus = 1.0 / (1.0 - nu);
        let pair = ShearedPair::new(number("friction"), modulus, body, Some(body)).unwrap();
        let is_sphere = row["law"].starts_with("sphere");
        let stiffness = |load: f64| match is_sphere {
            true => 2.0 * modulus * (0.75 * load / modulus).cbrt(),
            false => load / scale,
        };
        let found = pair.respond(load, share, |load| Ok::<f64, ()>(stiffness(load))).unwrap();
        for (found, column) in [
            (found.displacement_m, "displacement"),
            (found.initial_stiffness_pa_per_m, "initial_stiffness"),
            (found.dissipation_j_per_m2, "dissipation_per_cycle"),
        ] {
            approx::assert_relative_eq!(found, number(column), max_relative = tolerance);
        }
        compared += 1;
    }
    assert_eq!(compared, 20);
}

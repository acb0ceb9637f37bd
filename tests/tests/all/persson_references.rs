//! Persson's theory against high-precision tables.

use persson::growing_hardness::areas_of_squared_growth;
use persson::separation::{SeparationKnot, SeparationLaw};
use persson::{ContactAreas, EnergyFactor, constant_hardness, elastic};
use tests::{Deviations, ReferenceTable};

/// The rows of a kind, each by the numbers of its columns.
fn rows_of<'t>(
    table: &'t ReferenceTable,
    kind: &'t str,
) -> impl Iterator<Item = impl Fn(&str) -> f64 + 't> + 't {
    let kinds = table.text("kind");
    (0..table.len()).filter(move |&row| kinds[row] == kind).map(move |row| {
        move |column: &str| {
            let cell = table.text(column)[row];
            cell.parse().unwrap_or_else(|_| panic!("{column}: {cell:?}"))
        }
    })
}

#[test]
fn areas_under_a_constant_hardness_agree() {
    let table = ReferenceTable::committed("persson.csv");
    let [mut areas, mut densities] = [Deviations::default(), Deviations::default()];
    for number in rows_of(&table, "constant") {
        let (pressure_pa, spread_pa) = (number("p_pa"), number("s_pa"));
        let found = constant_hardness::areas(pressure_pa, spread_pa, 1.0);
        areas.note(found.contact(), number("area_contact"));
        areas.note(found.elastic, number("area_elastic"));
        areas.note(found.plastic, number("area_plastic"));
        areas.note(found.gap, number("area_gap"));
        let density = constant_hardness::stress_density_per_pa(0.9, pressure_pa, spread_pa, 1.0);
        densities.note(density, number("density_at_0p9_h_per_pa"));
    }
    areas.assert_within("areas", 1e-15, 1e-12);
    densities.assert_within("densities", 1e-14, 1e-11);
}

/// Notes shares under a growing hardness, which are accurate relative to the share in contact.
fn note_growing(deviations: &mut Deviations, found: ContactAreas, number: impl Fn(&str) -> f64) {
    let contact = number("area_contact");
    deviations.note(found.contact(), contact);
    deviations.note(contact + (found.elastic - number("area_elastic")), contact);
    deviations.note(contact + (found.plastic - number("area_plastic")), contact);
}

#[test]
fn areas_under_a_growing_hardness_agree() {
    let table = ReferenceTable::committed("persson.csv");
    let mut areas = Deviations::default();
    for number in rows_of(&table, "growing") {
        let found = areas_of_squared_growth(number("p_pa"), number("s_pa"), 1.0, number("c"));
        note_growing(&mut areas, found, number);
    }
    areas.assert_within("areas", 1e-7, 1e-6);
}

#[test]
fn areas_agree_with_the_given_table() {
    let table = ReferenceTable::committed("persson_given.csv");
    let [mut constant, mut densities, mut growing] = [0, 1, 2].map(|_| Deviations::default());
    for number in rows_of(&table, "constant-hardness") {
        let [pressure_pa, spread_pa, hardness_pa] = ["p_pa", "s_pa", "h0_pa"].map(&number);
        let found = constant_hardness::areas(pressure_pa, spread_pa, hardness_pa);
        constant.note(elastic::area_fraction(pressure_pa, spread_pa), number("area_elastic_theory"));
        constant.note(found.contact(), number("area_contact"));
        constant.note(found.elastic, number("area_elastic"));
        constant.note(found.plastic, number("area_plastic"));
        let stress_pa = 0.3 * hardness_pa;
        let density =
            constant_hardness::stress_density_per_pa(stress_pa, pressure_pa, spread_pa, hardness_pa);
        densities.note(density, number("density_at_0p3_h_per_pa"));
    }
    constant.assert_within("constant hardness", 1e-15, 1e-12);
    densities.assert_within("densities", 1e-14, 1e-9);
    for number in rows_of(&table, "growing-hardness") {
        let [pressure_pa, spread_pa, hardness_pa, growth] = ["p_pa", "s_pa", "h0_pa", "c"].map(&number);
        let found = areas_of_squared_growth(pressure_pa, spread_pa, hardness_pa, growth);
        note_growing(&mut growing, found, number);
    }
    growing.assert_within("growing hardness", 1e-7, 1e-6);
}

#[test]
fn separations_agree_with_the_given_table() {
    let table = ReferenceTable::committed("persson_given.csv");
    // Persson's C(q) = C0 q^-3.6 from 1e4 to 1e6 rad/m under a modulus of 1 Pa: V = (pi/2) Int q^3 C dq.
    let variance_pa2 = |q: f64| {
        std::f64::consts::FRAC_PI_2 * 0.000_023_041_816_986_325_86 * (q.powf(0.4) - 1e4f64.powf(0.4)) / 0.4
    };
    let knot = |q: f64| SeparationKnot {
        wavevector_rad_per_m: q,
        variance_pa2: variance_pa2(q),
        variance_exponent: 0.4,
    };
    let knots = [1e4, 1e6].map(knot);
    let many: Vec<SeparationKnot> = (0..=37).map(|i| knot(1e4 * 100f64.powf(f64::from(i) / 37.0))).collect();
    let mut deviations = Deviations::default();
    for number in rows_of(&table, "separation") {
        // By one interval of the spectrum and by many.
        for knots in [&knots[..], &many] {
            let last = *SeparationLaw::new(knots, 1.0, EnergyFactor::new(number("gamma")).unwrap())
                .along(number("p_pa"))
                .last()
                .unwrap();
            deviations.note(last.mean_gap_m, number("u_m"));
            deviations.note(last.stiffness_pa_per_m, number("k_pa_per_m"));
        }
    }
    deviations.assert_within("separation and stiffness", 1e-13, 1e-10);
    let mut light = Deviations::default();
    // u_0 in m and p_00 in Pa by g, of ten digits.
    for (factor, length_m, pressure_pa) in
        [(1.0, 6.321451744e-6, 0.01884593055), (0.45, 2.844653285e-6, 0.08385494254)]
    {
        let law = SeparationLaw::new(&knots, 1.0, EnergyFactor::new(factor).unwrap()).light_loads().unwrap();
        light.note(law.decay_length_m, length_m);
        light.note(law.reference_pressure_pa, pressure_pa);
    }
    light.assert_within("light loads", 1e-9, 1e-9);
}

//! Conductances as cards and as a plain table.

use std::convert::Infallible;

use interface::finite_elements::{
    ConductanceError, ConductancePoint, ConductanceTable, ContactLaw, Dialect, Flow, SamplingError,
    UnitSystem,
};

/// Points of pressure \[Pa\], conductance of the spots and of the gas.
fn points(rows: &[[f64; 3]]) -> Vec<ConductancePoint> {
    let point =
        |&[pressure_pa, contact_si, gas_si]: &[f64; 3]| ConductancePoint { pressure_pa, contact_si, gas_si };
    rows.iter().map(point).collect()
}

fn heat(rows: &[[f64; 3]]) -> ConductanceTable {
    ConductanceTable::new(Flow::Heat, &points(rows)).unwrap()
}

/// The lines without comments.
fn card(table: &ConductanceTable, dialect: Dialect, units: UnitSystem) -> String {
    let text = table.to_text(dialect, units, &[]).unwrap();
    let is_card = |line: &&str| !line.starts_with("**") && !line.starts_with('#');
    text.lines().filter(is_card).map(|line| format!("{line}\n")).collect()
}

#[test]
fn gas_acts_beside_the_spots_and_alone_without_pressure() {
    let table = heat(&[[1e6, 1e5, 1e4], [2e6, 3e5, 2e4]]);
    for (pressure_pa, conductance) in [(0.0, 1e4), (5e5, 6e4), (1e6, 1.1e5), (1.5e6, 2.15e5), (9e6, 3.2e5)] {
        assert!((table.conductance_si(pressure_pa) / conductance - 1.0).abs() < 1e-14);
    }
    // 1 W/(m^2 K) is 1e-3 mW/(mm^2 K).
    let (calculix, abaqus) = (Dialect::Calculix, Dialect::Abaqus);
    assert_eq!(
        card(&table, calculix, UnitSystem::Millimetres),
        "*GAP CONDUCTANCE\n1.E1, 0.\n1.1E2, 1.\n3.2E2, 2.\n"
    );
    assert!(card(&table, abaqus, UnitSystem::Si).starts_with("*GAP CONDUCTANCE, PRESSURE\n1.E4, 0.\n"));
    assert_eq!(
        card(&table, Dialect::Csv, UnitSystem::Millimetres),
        "pressure_MPa,conductance_mW_per_mm2_K,contact_mW_per_mm2_K,gas_mW_per_mm2_K\n0,10,0,10\n1,110,100,10\n\
         2,320,300,20\n"
    );
}

#[test]
fn currents_have_an_electrical_card_in_abaqus_and_the_thermal_one_in_calculix() {
    let table = ConductanceTable::new(Flow::Current, &points(&[[1e6, 1e11, 0.0]])).unwrap();
    assert_eq!(
        card(&table, Dialect::Abaqus, UnitSystem::Millimetres),
        "*GAP ELECTRICAL CONDUCTANCE, PRESSURE\n0., 0.\n1.E8, 1.\n"
    );
    assert_eq!(card(&table, Dialect::Calculix, UnitSystem::Si), "*GAP CONDUCTANCE\n0., 0.\n1.E11, 1.E6\n");
    assert_eq!(
        card(&table, Dialect::Csv, UnitSystem::Si),
        "pressure_Pa,conductance_S_per_m2\n0,0\n1000000,100000000000\n"
    );
}

#[test]
fn comments_name_the_traps_of_the_code_and_fit_its_lines() {
    let table = heat(&[[1e6 / 3.0, 1e5 / 7.0, 0.0], [2e6, 3e5, 0.0]]);
    let provenance = ["word ".repeat(80)];
    for (dialect, traps) in [
        (Dialect::Calculix, vec!["NODE TO SURFACE", "NLGEOM", "LINEAR", "TABULAR", "*STEP", "mW/(mm^2 K)"]),
        (Dialect::Abaqus, vec!["PRESSURE", "*SURFACE INTERACTION", "mW/(mm^2 K)"]),
        (Dialect::Csv, vec!["MPa"]),
    ] {
        let text = table.to_text(dialect, UnitSystem::Millimetres, &provenance).unwrap();
        for trap in traps {
            assert!(text.contains(trap), "{trap} is not in {text}");
        }
        assert!(text.lines().all(|line| line.len() <= 104), "{text}");
        let is_short = |cell: &str| dialect == Dialect::Csv || cell.trim().len() <= 20;
        let numbers = text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
        assert!(numbers.clone().count() == 3 && numbers.flat_map(|line| line.split(',')).all(is_short));
    }
    let current = ConductanceTable::new(Flow::Current, &points(&[[1.0, 1.0, 0.0]])).unwrap();
    let text = current.to_text(Dialect::Calculix, UnitSystem::Si, &[]).unwrap();
    assert!(text.contains("potentials as temperatures"), "{text}");
}

#[test]
fn tables_that_codes_misread_are_refused() {
    let made = |rows: &[[f64; 3]]| ConductanceTable::new(Flow::Heat, &points(rows));
    assert_eq!(made(&[]).unwrap_err(), ConductanceError::Empty);
    for second in [[1.0, 2.0, 0.0], [2.0, -1.0, 0.0], [2.0, f64::NAN, 0.0], [2.0, 2.0, -1.0]] {
        assert_eq!(made(&[[1.0, 1.0, 0.0], second]).unwrap_err(), ConductanceError::Row { row: 2 });
    }
    let many: Vec<[f64; 3]> = (1..=200).map(|row| [f64::from(row), 1.0, 0.0]).collect();
    let many = heat(&many);
    let refused = many.to_text(Dialect::Calculix, UnitSystem::Si, &[]).unwrap_err();
    assert_eq!(refused, ConductanceError::TooManyRows { rows: 201, most: 200 });
    assert!(many.to_text(Dialect::Abaqus, UnitSystem::Si, &[]).is_ok());
}

#[test]
fn lines_keep_the_tolerance_with_few_rows() {
    // A step at 0.3 MPa beside a power law.
    let exact = |pressure_pa: f64| {
        let step = if pressure_pa < 3e5 { 1.0 } else { 1.2 };
        let contact_si = step * 1e3 * pressure_pa.powf(0.95);
        ConductancePoint { pressure_pa, contact_si, gas_si: 1e8 }
    };
    let sampled = |tolerance: f64| {
        ConductanceTable::sample(Flow::Heat, [1e4, 1e8], tolerance, |pressure_pa| {
            Ok::<_, Infallible>(exact(pressure_pa))
        })
        .unwrap()
    };
    for (tolerance, most) in [(0.01, 40), (1e-4, 200)] {
        let table = sampled(tolerance);
        assert!(table.points.len() < most && table.points[1].pressure_pa == 1e4, "{}", table.points.len());
        assert_eq!(table.points[0], ConductancePoint { pressure_pa: 0.0, contact_si: 0.0, gas_si: 1e8 });
        assert_eq!(table.points.last().unwrap().pressure_pa, 1e8);
        for at in 0..=1000 {
            let pressure_pa = 1e4 * 1e4f64.powf(f64::from(at) / 1000.0);
            let off = table.conductance_si(pressure_pa) / exact(pressure_pa).total_si() - 1.0;
            assert!(off.abs() <= tolerance, "{pressure_pa}: {off:e}");
        }
    }
    let refused = |range_pa, tolerance| {
        ConductanceTable::sample(Flow::Heat, range_pa, tolerance, |at_pa| Ok::<_, Infallible>(exact(at_pa)))
            .unwrap_err()
    };
    assert!(matches!(refused([2.0, 1.0], 0.01), SamplingError::EmptyRange { from_pa: 2.0, to_pa: 1.0 }));
    assert!(matches!(refused([1.0, 2.0], 0.9), SamplingError::Value(_)));
    let none =
        ConductanceTable::sample(Flow::Heat, [1.0, 2.0], ContactLaw::TOLERANCE, Err::<ConductancePoint, _>);
    assert_eq!(none.unwrap_err(), SamplingError::Source(1.0));
}

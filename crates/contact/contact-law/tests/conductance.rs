//! Conductances as cards, and heat between two blocks in CalculiX.

use std::fmt::Write;
use std::process::Command;

use contact_law::{ConductanceError, ConductanceTable, Dialect, ExponentialLaw, Heading, UnitSystem};

#[test]
fn gas_acts_beside_the_spots_and_alone_without_pressure() {
    let table = ConductanceTable::new(&[[1e6, 1e5], [2e6, 3e5]], 1e4).unwrap();
    for (pressure_pa, conductance) in [(0.0, 1e4), (5e5, 6e4), (1e6, 1.1e5), (1.5e6, 2.1e5), (9e6, 3.1e5)] {
        assert!((table.conductance_w_per_m2_k(pressure_pa) / conductance - 1.0).abs() < 1e-14);
    }
    // 1 W/(m^2 K) is 1e-3 mW/(mm^2 K).
    let card = table.card(Dialect::Calculix, UnitSystem::Millimetres).unwrap();
    assert!(card.ends_with("*GAP CONDUCTANCE\n1.E1, 0.\n1.1E2, 1.\n3.1E2, 2.\n"), "{card}");
    let card = table.card(Dialect::Abaqus, UnitSystem::Si).unwrap();
    assert!(card.contains("*GAP CONDUCTANCE, PRESSURE\n1.E4, 0.\n"), "{card}");
}

#[test]
fn tables_that_codes_misread_are_refused() {
    assert_eq!(ConductanceTable::new(&[], 0.0).unwrap_err(), ConductanceError::Empty);
    for rows in [[[1.0, 1.0], [1.0, 2.0]], [[1.0, 1.0], [2.0, -1.0]], [[1.0, 1.0], [2.0, f64::NAN]]] {
        assert_eq!(ConductanceTable::new(&rows, 0.0).unwrap_err(), ConductanceError::Row { row: 2 });
    }
    let many: Vec<[f64; 2]> = (1..=200).map(|row| [f64::from(row), 1.0]).collect();
    let many = ConductanceTable::new(&many, 0.0).unwrap();
    let refused = many.card(Dialect::Calculix, UnitSystem::Si).unwrap_err();
    assert_eq!(refused, ConductanceError::TooManyRows { rows: 201, most: 200 });
    assert_eq!(many.card(Dialect::Csv, UnitSystem::Si).unwrap_err(), ConductanceError::NoCard);
}

/// Blocks of 1 mm with a conductivity of 50 mW/(mm K), at 0 and 100 K at their far ends; the law closes a clearance.
#[test]
#[ignore = "needs CalculiX"]
fn calculix_conducts_heat_as_the_table_says() {
    let law = ExponentialLaw {
        decay_length_m: 1e-6,
        reference_pressure_pa: 100e6,
        holds_up_to_pa: 50e6,
        share: 0.01,
    };
    let units = UnitSystem::Millimetres;
    let heading = Heading { name: Heading::NAME.to_owned(), provenance: Vec::new() };
    let spots = [[5e6, 2e4], [2e7, 6e4], [6e7, 1e5]];
    let table = ConductanceTable::new(&spots, 5e3).unwrap();
    let interaction = Dialect::Calculix.exponential(&law, units, &heading).unwrap()
        + &table.card(Dialect::Calculix, units).unwrap();
    let clearance_mm = 4e-3;
    let mut nodes = String::new();
    let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
    let places = [-1.0, 0.0, clearance_mm, clearance_mm + 1.0].into_iter();
    let places = places.flat_map(|z| corners.iter().map(move |(x, y)| (x, y, z)));
    for (at, (x, y, z)) in places.enumerate() {
        writeln!(nodes, "{}, {x}., {y}., {z:.12}", at + 1).unwrap();
    }
    let deck = format!(
        "*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE=C3D8, ELSET=BLOCKS\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         2, 9, 10, 11, 12, 13, 14, 15, 16\n*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.\n*CONDUCTIVITY\n50.\n\
         *SOLID SECTION, ELSET=BLOCKS, MATERIAL=STEEL\n*NSET, NSET=BOTTOM\n1, 2, 3, 4\n*NSET, NSET=TOP\n13, 14, 15, 16\n\
         *SURFACE, NAME=MASTER, TYPE=ELEMENT\n1, S2\n*SURFACE, NAME=SLAVE, TYPE=ELEMENT\n2, S1\n\
         {interaction}*CONTACT PAIR, INTERACTION=ROUGH, TYPE=NODE TO SURFACE\nSLAVE, MASTER\n\
         *INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 0.\n*BOUNDARY\nALL, 1, 2\nBOTTOM, 3, 3\n*STEP, NLGEOM, INC=1000\n\
         *COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE\n0.1, 1., 1.E-6, 0.1\n*CONTROLS, PARAMETERS=FIELD\n1.E-9, 1.E-9\n*BOUNDARY\nBOTTOM, 11, 11, 0.\nTOP, 11, 11, 100.\n\
         TOP, 3, 3, -3.5E-3\n*NODE PRINT, NSET=ALL\nNT\n*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY\nRF\n*END STEP\n"
    );
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("heat.inp"), deck).unwrap();
    let output = Command::new("ccx").arg("heat").current_dir(folder.path()).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && said.contains("Job finished"), "{said}");
    let results = std::fs::read_to_string(folder.path().join("heat.dat")).unwrap();
    let numbers =
        |line: &str| -> Vec<f64> { line.split_whitespace().filter_map(|cell| cell.parse().ok()).collect() };
    let blocks: Vec<&str> = results.split("temperatures for").skip(1).collect();
    let mut seen = 0;
    for block in blocks {
        let (temperatures, forces) = block.split_once("total force").expect(block);
        let temperatures: Vec<f64> = temperatures
            .lines()
            .skip(1)
            .map(numbers)
            .filter(|row| row.len() == 2)
            .map(|row| row[1])
            .collect();
        let force = forces.lines().skip(1).map(numbers).find(|row| row.len() == 3).unwrap();
        let pressure_pa = 1e6 * force[2].abs();
        let flux_mw_per_mm2 = 50.0 * (temperatures[4] - temperatures[0]);
        let conductance = 1e3 * flux_mw_per_mm2 / (temperatures[8] - temperatures[4]);
        let expected = table.conductance_w_per_m2_k(pressure_pa);
        println!("{pressure_pa:e} Pa: {conductance:e}, table {expected:e}");
        assert!((conductance / expected - 1.0).abs() < 1e-6, "{pressure_pa}: {conductance} {expected}");
        seen += 1;
    }
    assert!(seen >= 8, "{results}");
}

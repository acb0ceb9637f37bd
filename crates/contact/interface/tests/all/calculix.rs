//! A punch on a block in CalculiX, with a rough surface between them.

use std::fmt::Write;
use std::process::Command;

use crate::support::{sampled, separation};
use interface::finite_elements::{Dialect, ExponentialLaw, Heading, UnitSystem};

/// Steel cubes of 1 mm on each other, in N and mm, at first a clearance apart, the upper one pressed down.
struct Punch {
    interaction: String,
    clearance_mm: f64,
    pressed_mm: f64,
}

/// Values on the slave surface: overclosures (below 0 for clearances) \[mm\], and pressures \[MPa\].
struct Said {
    overclosures_mm: Vec<f64>,
    pressures_mpa: Vec<f64>,
}

impl Punch {
    /// The input of CalculiX, with the contact pair of nodes and faces that the comments of tables require.
    fn deck(&self) -> String {
        let mut nodes = String::new();
        let planes = [-1.0, 0.0, self.clearance_mm, self.clearance_mm + 1.0];
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let places = planes.iter().flat_map(|z| corners.iter().map(move |(x, y)| (x, y, z)));
        for (at, (x, y, z)) in places.enumerate() {
            writeln!(nodes, "{}, {x}., {y}., {z:.12}", at + 1).unwrap();
        }
        format!(
            "*NODE\n{nodes}*ELEMENT, TYPE=C3D8, ELSET=BLOCK\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
             *ELEMENT, TYPE=C3D8, ELSET=PUNCH\n2, 9, 10, 11, 12, 13, 14, 15, 16\n\
             *MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.3\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=STEEL\n\
             *SOLID SECTION, ELSET=PUNCH, MATERIAL=STEEL\n*NSET, NSET=BOTTOM\n1, 2, 3, 4\n\
             *NSET, NSET=TOP\n13, 14, 15, 16\n*NSET, NSET=ALL, GENERATE\n1, 16\n\
             *SURFACE, NAME=MASTER, TYPE=ELEMENT\n1, S2\n*SURFACE, NAME=SLAVE, TYPE=ELEMENT\n2, S1\n\
             {}*CONTACT PAIR, INTERACTION=ROUGH, TYPE=NODE TO SURFACE\nSLAVE, MASTER\n\
             *BOUNDARY\nALL, 1, 2\nBOTTOM, 3, 3\n*STEP, INC=1000\n*STATIC\n0.02, 1., 1.E-6, 0.02\n\
             *BOUNDARY\nTOP, 3, 3, {:.12}\n*CONTACT PRINT\nCDIS, CSTR\n*END STEP\n",
            self.interaction, -self.pressed_mm
        )
    }

    /// Runs CalculiX on it.
    fn run(&self) -> Said {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("punch.inp"), self.deck()).unwrap();
        let output = Command::new("ccx").arg("punch").current_dir(folder.path()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success() && said.contains("Job finished"), "{said}");
        let results = std::fs::read_to_string(folder.path().join("punch.dat")).unwrap();
        let first_of_rows = |heading: &str| -> Vec<f64> {
            let blocks =
                results.split("relative contact").skip(1).flat_map(|block| block.split("contact stress"));
            let wanted = blocks.filter(|block| block.trim_start().starts_with(heading));
            let rows = wanted.flat_map(|block| {
                let rows = block.lines().skip(1).map(|line| line.split_whitespace().collect::<Vec<_>>());
                rows.filter(|cells| cells.len() == 4)
                    .map(|cells| cells[1].parse::<f64>().unwrap())
                    .collect::<Vec<_>>()
            });
            rows.collect()
        };
        let clearances_mm = first_of_rows("displacement");
        let pressures_mpa = first_of_rows("(slave node,press");
        assert!(!clearances_mm.is_empty() && clearances_mm.len() == pressures_mpa.len(), "{results}");
        Said { overclosures_mm: clearances_mm.iter().map(|clearance| -clearance).collect(), pressures_mpa }
    }
}

fn heading() -> Heading {
    Heading { name: Heading::NAME.to_owned(), provenance: Vec::new() }
}

#[test]
#[ignore = "needs CalculiX"]
fn a_punch_on_a_block_is_carried_by_the_law() {
    let exact = separation();
    for [from_pa, to_pa] in [[1e4, 1e8], [1e5, 5e9]] {
        let law = sampled([from_pa, to_pa], 0.01);
        let whole_mm = 1e3 * law.overclosure_m(exact.whole(to_pa).mean_gap_m);
        let interaction = Dialect::Calculix.table(&law, UnitSystem::Millimetres, &heading(), &[]).unwrap();
        // The cubes themselves give way by p/E over 2 mm, a little less for being held at their sides.
        let pressed_mm = whole_mm + 1e-6 * to_pa / 210e3;
        let said = Punch { interaction, clearance_mm: 0.0, pressed_mm }.run();
        let (mut worst_pressure, mut worst_gap, mut seen) = (0.0f64, 0.0f64, 0);
        for (overclosure_mm, pressure_mpa) in said.overclosures_mm.iter().zip(&said.pressures_mpa) {
            let pressure_pa = 1e6 * pressure_mpa;
            if pressure_pa < from_pa {
                continue;
            }
            assert!(pressure_pa < to_pa, "pressed beyond the table: {pressure_pa}");
            let gap_m = law.cut().mean_gap_m - 1e-3 * overclosure_mm;
            worst_gap = worst_gap.max((gap_m / exact.whole(pressure_pa).mean_gap_m - 1.0).abs());
            worst_pressure =
                worst_pressure.max((law.pressure_pa(1e-3 * overclosure_mm) / pressure_pa - 1.0).abs());
            seen += 1;
        }
        let most_pa = 1e6 * said.pressures_mpa.iter().copied().fold(0.0, f64::max);
        println!(
            "{} rows, {seen} states up to {most_pa:e} Pa: gap off by {worst_gap:e}, pressure of the table by {worst_pressure:e}",
            law.points.len()
        );
        assert!(seen > 50 && most_pa > 0.05 * to_pa, "{seen} states up to {most_pa:e} Pa");
        // Seven digits are printed.
        assert!(worst_gap < 0.01 && worst_pressure < 1e-4, "{worst_gap} {worst_pressure}");
    }
}

#[test]
#[ignore = "needs CalculiX"]
fn beyond_the_table_the_pressure_is_held() {
    let law = sampled([1e4, 1e6], 0.01);
    let whole_mm = 1e3 * law.overclosure_m(separation().whole(1e6).mean_gap_m);
    let interaction = Dialect::Calculix.table(&law, UnitSystem::Millimetres, &heading(), &[]).unwrap();
    let said = Punch { interaction, clearance_mm: 0.0, pressed_mm: 1.5 * whole_mm }.run();
    let last_mpa = *said.pressures_mpa.last().unwrap();
    assert!((last_mpa - 1.0).abs() < 1e-6, "{last_mpa}");
}

#[test]
#[ignore = "needs CalculiX"]
fn the_exponential_form_is_the_law_of_light_loads_at_a_clearance() {
    let exact = separation();
    let light = exact.light_loads().unwrap();
    let law = ExponentialLaw {
        decay_length_m: light.decay_length_m,
        reference_pressure_pa: light.reference_pressure_pa,
        holds_up_to_pa: exact.light_load_limit_pa(0.01).unwrap(),
        share: 0.01,
    };
    let interaction = Dialect::Calculix.exponential(&law, UnitSystem::Millimetres, &heading()).unwrap();
    let clearance_mm = 1e3 * 4.5 * light.decay_length_m;
    let said = Punch { interaction, clearance_mm, pressed_mm: 0.5 * clearance_mm }.run();
    let carried =
        said.overclosures_mm.iter().zip(&said.pressures_mpa).filter(|(_, pressure)| **pressure > 0.0);
    let mut seen = 0;
    for (overclosure_mm, pressure_mpa) in carried {
        let expected_pa = law.pressure_pa(-1e-3 * overclosure_mm);
        assert!(
            (1e6 * pressure_mpa / expected_pa - 1.0).abs() < 1e-4,
            "{overclosure_mm} {pressure_mpa} {expected_pa}"
        );
        seen += 1;
    }
    assert!(seen > 50, "{seen}");
}

//! `law --model bem`: laws by boundary elements that yield, and a punch on a block in CalculiX with one of them between.

use std::fmt::Write;
use std::process::Command;

use crate::support::{Bench, Ran, numbers};

/// Aluminium on steel, milled: waves from 439 um to 6.9 um, a fall with q^-2.6 from 120 um on, an rms height of 0.8 um.
fn joint(options: &[&[&str]]) -> Ran {
    let bench = Bench::new();
    let row = |at: i32| {
        let wavelength_m = 439e-6 * 64f64.powf(-f64::from(at) / 20.0);
        format!("{wavelength_m:e},{:e}\n", 1.9e-17 * (wavelength_m / 120e-6).min(1.0).powf(2.6))
    };
    bench.write("psd.csv", format!("wavelength_m,C1D_m3\n{}", (0..=20).map(row).collect::<String>()));
    let call = ["law", "psd.csv", "--model", "bem", "--material", "aluminium 6061-T6", "--on", "steel C45"];
    let small = ["--grid", "128", "--realisations", "3", "--pressure-range", "1MPa:50MPa"];
    bench.run(&[&call[..], &small, &options.concat()].concat())
}

/// Pressures and overclosures of a card.
fn rows(card: &str) -> Vec<[f64; 2]> {
    let lines = card.lines().filter(|line| !line.starts_with('*'));
    let cells = lines.map(|line| line.split_once(", ").unwrap());
    cells.map(|(one, other)| [one, other].map(|cell| cell.parse().unwrap())).collect()
}

fn table(ran: Ran) -> String {
    ran.ok().lines().filter(|line| !line.starts_with('#')).map(|line| format!("{line}\n")).collect()
}

#[test]
fn a_card_and_a_plain_table_of_elements_are_one_law() {
    let card = joint(&[&["--dialect", "calculix", "--units", "N-mm"]]).ok();
    let table = table(joint(&[&["--dialect", "csv", "--units", "N-mm"]]));
    let [pressures_mpa, overclosures_mm] =
        ["pressure_MPa", "overclosure_mm"].map(|name| numbers(&table, name));
    let rows = rows(&card);
    assert_eq!((rows.len(), rows[0]), (pressures_mpa.len(), [0.0; 2]));
    for (row, (pressure, overclosure)) in rows.iter().zip(pressures_mpa.iter().zip(&overclosures_mm)).skip(1)
    {
        assert!((row[0] / pressure - 1.0).abs() < 1e-12 && (row[1] / overclosure - 1.0).abs() < 1e-11);
    }
    let [distance_mm, gap_mm, loading, unloading] = [
        "mean_plane_distance_mm",
        "mean_gap_mm",
        "loading_stiffness_MPa_per_mm",
        "unloading_stiffness_MPa_per_mm",
    ]
    .map(|name| numbers(&table, name));
    let last = pressures_mpa.len() - 1;
    // Most of the contact flows.
    assert!(distance_mm[last] < gap_mm[last] && 1.5 * loading[last] < unloading[last]);
    assert!((distance_mm[0] - distance_mm[last]) / overclosures_mm[last] - 1.0 < 1e-12);
    let heat = joint(&[&[
        "--dialect",
        "csv",
        "--quantity",
        "heat",
        "--counterface-thermal-conductivity",
        "50W/(mK)",
        "--error",
        "0.05",
    ]]);
    let conductance = numbers(&self::table(heat), "conductance_W_per_m2_K");
    assert!(conductance.is_sorted() && conductance[0] == 0.0);
}

#[test]
fn random_surfaces_belong_to_elements_alone() {
    let call = ["law", "builtin:uncd-measured", "--pressure-range", "1MPa:10MPa", "--dialect", "csv"];
    let elastic = ["--model", "persson", "--youngs-modulus", "1GPa", "--poisson-ratio", "0"];
    let flowed = ["--model", "yovanovich", "--quantity", "heat", "--indentation-hardness", "1GPa"];
    let conductors = ["--thermal-conductivity=5W/(mK)", "--counterface-thermal-conductivity=5W/(mK)"];
    for model in [&elastic[..], &[&flowed[..], &conductors].concat()] {
        let fine = [&call[..], model].concat();
        Bench::new().run(&fine).ok();
        Bench::new().run(&[&fine[..], &["--grid", "64"]].concat()).refused_naming(&["--grid"]);
    }
    joint(&[&["--dialect", "calculix", "--form", "exponential"]]).refused_naming(&["--form"]);
}

/// Steel cubes of 1 mm on each other, the upper one pressed down by more than the law closes.
#[test]
#[ignore = "needs CalculiX"]
fn calculix_obeys_the_law_of_a_metal_that_yields() {
    let card = joint(&[&["--dialect", "calculix", "--units", "N-mm"]]).ok();
    let table = rows(&card);
    let [most_mpa, closed_mm] = table[table.len() - 1];
    let mut nodes = String::new();
    let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
    let places = [-1.0, 0.0, 0.0, 1.0].into_iter();
    let places = places.flat_map(|z| corners.iter().map(move |(x, y)| (x, y, z)));
    for (at, (x, y, z)) in places.enumerate() {
        writeln!(nodes, "{}, {x}., {y}., {z:.12}", at + 1).unwrap();
    }
    // The cubes themselves give way by p/E over 2 mm.
    let pressed_mm = closed_mm + most_mpa / 210e3;
    let deck = format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=C3D8, ELSET=BLOCKS\n1, 1, 2, 3, 4, 5, 6, 7, 8\n2, 9, 10, 11, 12, 13, 14, 15, 16\n\
         *MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.3\n*SOLID SECTION, ELSET=BLOCKS, MATERIAL=STEEL\n\
         *NSET, NSET=BOTTOM\n1, 2, 3, 4\n*NSET, NSET=TOP\n13, 14, 15, 16\n*NSET, NSET=ALL, GENERATE\n1, 16\n\
         *SURFACE, NAME=MASTER, TYPE=ELEMENT\n1, S2\n*SURFACE, NAME=SLAVE, TYPE=ELEMENT\n2, S1\n\
         {card}*CONTACT PAIR, INTERACTION=ROUGH, TYPE=NODE TO SURFACE\nSLAVE, MASTER\n*BOUNDARY\nALL, 1, 2\nBOTTOM, 3, 3\n\
         *STEP, INC=1000\n*STATIC\n0.02, 1., 1.E-6, 0.02\n*BOUNDARY\nTOP, 3, 3, {:.12}\n*CONTACT PRINT\nCDIS, CSTR\n*END STEP\n",
        -pressed_mm
    );
    let bench = Bench::new();
    bench.write("punch.inp", deck);
    let output = Command::new("ccx").arg("punch").current_dir(bench.path("")).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && said.contains("Job finished"), "{said}");
    let results = std::fs::read_to_string(bench.path("punch.dat")).unwrap();
    // Blocks of clearances, then of pressures, with four numbers in a row.
    let first_of = |heading: &str| -> Vec<f64> {
        let blocks = results.split("relative contact").flat_map(|block| block.split("contact stress"));
        let rows = blocks.filter(|block| block.trim_start().starts_with(heading)).flat_map(str::lines);
        let cells = rows.map(|line| line.split_whitespace().collect::<Vec<_>>());
        cells.filter(|cells| cells.len() == 4).filter_map(|cells| cells[1].parse().ok()).collect()
    };
    let (clearances_mm, pressures_mpa) = (first_of("displacement"), first_of("(slave node,press"));
    assert_eq!(clearances_mm.len(), pressures_mpa.len());
    let (mut worst, mut seen) = (0.0f64, 0);
    for (clearance_mm, pressure_mpa) in clearances_mm.iter().zip(&pressures_mpa) {
        let above = table.partition_point(|row| row[1] < -clearance_mm);
        // Below 1 MPa the law is cut off.
        if above < 2 || above == table.len() {
            continue;
        }
        let ([from_mpa, from_mm], [to_mpa, to_mm]) = (table[above - 1], table[above]);
        let expected_mpa = from_mpa + (to_mpa - from_mpa) * (-clearance_mm - from_mm) / (to_mm - from_mm);
        worst = worst.max((pressure_mpa / expected_mpa - 1.0).abs());
        seen += 1;
    }
    println!("{seen} states, pressures off by {worst:e}");
    assert!(seen > 50 && worst < 2e-6, "{seen} states off by {worst:e}");
}

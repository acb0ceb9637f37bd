//! `gap` and `law`: mean gap and stiffness under loads, and as finite element codes read them.

use std::f64::consts::{E, PI, TAU};

use crate::support::{Bench, column, numbers};

const COLUMNS: &str =
    "nominal_pressure_pa,area_fraction,mean_gap_m,mean_plane_distance_m,stiffness_pa_per_m,u0_m,p00_pa";
const DIAMOND: [&str; 4] = ["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2"];
const UNIT: [&str; 4] = ["--youngs-modulus", "1Pa", "--poisson-ratio", "0"];

/// C = 2.304e-5 q^-3.6 from 1e4 to 1e6 rad/m, h_rms = 6 um, whose profiles have C1D = pi^2 C q: two samples say it all.
fn power_law() -> Bench {
    let bench = Bench::new();
    let row = |q: f64| format!("{:e},{:e}\n", TAU / q, PI * PI * 0.000_023_041_816_986_325_86 * q.powf(-2.6));
    bench.write("psd.csv", format!("lambda_m,C1D_m3\n{}{}", row(1e4), row(1e6)));
    bench
}

fn gap(bench: &Bench, psd: &str, options: &[&[&str]]) -> crate::support::Ran {
    bench.run(&[&["gap", psd], &options.concat()[..]].concat())
}

fn law(bench: &Bench, options: &[&[&str]]) -> crate::support::Ran {
    let call = ["law", "builtin:uncd-reconstructed", "--pressure-range", "10kPa:10MPa"];
    bench.run(&[&call[..], &DIAMOND, &options.concat()].concat())
}

/// Pressures and overclosures.
fn rows(table: &str) -> Vec<[f64; 2]> {
    let lines = table.lines().filter(|line| !line.starts_with('*'));
    lines
        .map(|line| {
            let (pressure, overclosure) = line.split_once(", ").unwrap();
            [pressure, overclosure].map(|cell| cell.parse().unwrap())
        })
        .collect()
}

#[test]
fn elements_of_a_material_with_a_hardness_yield_in_gap_as_in_bem() {
    let bench = Bench::new();
    let waves = ["builtin:uncd-measured", "--grid", "32", "--realisations", "1", "--shortest", "1um"];
    let soft = ["--indentation-hardness", "2GPa", "--pressure", "1GPa"];
    let pressed = |command: &str, more: &[&str]| {
        let table = bench.run(&[&[command], &waves[..], &soft, &DIAMOND, more].concat()).ok();
        ["mean_gap_m", "stiffness_pa_per_m"].map(|name| column(&table, name)[0].to_owned())
    };
    let yielding = pressed("gap", &["--model", "bem"]);
    assert_eq!(yielding, pressed("bem", &["--saturation", "1H"]));
    assert_ne!(yielding, pressed("bem", &[]));
}

#[test]
fn the_gap_of_perssons_theory_agrees_with_references() {
    // gamma, p, u and K by independent quadratures; then u0 and p00.
    let bench = power_law();
    for (gamma, light, states) in [
        (
            "0.45",
            [2.844653285e-6, 0.08385494254],
            vec![
                ("1e-4Pa", 1.91416391700605e-5, 35.0598908863103),
                ("1e-3Pa", 1.25254210044303e-5, 342.978525765205),
                ("1e-2Pa", 5.5269982660541e-6, 3160.50234158949),
                ("0.1Pa", 2.41601004312858e-7, 149084.76473024),
            ],
        ),
        (
            "1",
            [6.321451744e-6, 0.01884593055],
            vec![
                ("1e-3Pa", 1.87599020675443e-5, 163.266583800347),
                ("0.1Pa", 1.42462876598766e-7, 232417.788084321),
            ],
        ),
    ] {
        let loads: Vec<&str> = states.iter().flat_map(|state| ["--pressure", state.0]).collect();
        let table = gap(
            &bench,
            "psd.csv",
            &[&["--model", "persson", "--band", "1d", "--gamma", gamma], &loads, &UNIT],
        )
        .ok();
        assert_eq!(table.lines().next().unwrap(), COLUMNS);
        let [gaps, stiffnesses] = ["mean_gap_m", "stiffness_pa_per_m"].map(|name| numbers(&table, name));
        for (at, (_, gap_m, stiffness)) in states.iter().enumerate() {
            assert!((gaps[at] / gap_m - 1.0).abs() < 1e-8, "{gamma}: {} {gap_m}", gaps[at]);
            assert!(
                (stiffnesses[at] / stiffness - 1.0).abs() < 1e-8,
                "{gamma}: {} {stiffness}",
                stiffnesses[at]
            );
        }
        for (name, expected) in ["u0_m", "p00_pa"].into_iter().zip(light) {
            assert!((numbers(&table, name)[0] / expected - 1.0).abs() < 1e-8, "{name}");
        }
    }
}

#[test]
fn asperities_are_as_far_from_the_mean_plane_as_from_their_own_and_its_offset() {
    let bench = Bench::new();
    let psd = "builtin:uncd-reconstructed";
    let loads = ["--pressures", "10kPa:100MPa:4"];
    let moments = bench.run(&["moments", psd]).ok();
    let offset_m: f64 = column(&moments, "offset_m").last().unwrap().parse().unwrap();
    let curve = bench.run(&[&["statistical", psd, "--model", "hertz"], &loads[..], &DIAMOND].concat()).ok();
    let cutoffs = numbers(&moments, "wavelength_m").len();
    let table = gap(&bench, psd, &[&["--model", "hertz"], &loads, &DIAMOND]).ok();
    let [gaps, areas, stiffnesses] =
        ["mean_gap_m", "area_fraction", "stiffness_pa_per_m"].map(|name| numbers(&table, name));
    for load in 0..4 {
        let last = |name: &str| column(&curve, name)[(load + 1) * cutoffs - 1].parse::<f64>().unwrap();
        assert!((gaps[load] - last("separation_m") - offset_m).abs() < 1e-9 * offset_m, "{load}");
        assert!((areas[load] / last("area_fraction") - 1.0).abs() < 1e-9, "{load}");
    }
    assert!(stiffnesses.is_sorted() && gaps.is_sorted_by(|more, less| more > less));
    assert_eq!(column(&table, "u0_m"), [""; 4]);
}

#[test]
fn boundary_elements_have_the_gap_of_their_surfaces() {
    let bench = power_law();
    let of = |command: &str, options: &[&str]| {
        let random = ["--grid", "64", "--realisations", "2", "--shortest", "60um", "--pressure", "1e-3Pa"];
        bench.run(&[&[command, "psd.csv"], options, &random[..], &UNIT].concat()).ok()
    };
    let (gap, bem) = (of("gap", &["--model", "bem"]), of("bem", &[]));
    for name in ["mean_gap_m", "stiffness_pa_per_m"] {
        assert_eq!(column(&gap, name), column(&bem, name));
    }
    assert!(column(&gap, "p00_pa") == [""] && numbers(&gap, "mean_gap_m")[0] > 1e-6);
}

#[test]
fn a_law_is_the_gap_below_that_of_first_touch() {
    let bench = Bench::new();
    let first = format!("{}Pa", 1e4 / E);
    for model in ["persson", "hertz", "bgt"] {
        for (dialect, units, length_m, pressure_pa) in
            [("abaqus", "N-mm", 1e-3, 1e6), ("calculix", "SI", 1.0, 1.0), ("calculix", "N-mm", 1e-3, 1e6)]
        {
            let text = law(&bench, &[&["--model", model, "--dialect", dialect, "--units", units]]).ok();
            assert!(text.contains(&format!("Units {units}")) && text.starts_with("** truearea "), "{text}");
            let rows = rows(&text);
            assert!(rows[0] == [0.0, 0.0] && rows.len() > 20, "{text}");
            let loads: Vec<String> = std::iter::once(first.clone())
                .chain(
                    [rows[1], rows[rows.len() / 2], rows[rows.len() - 1]]
                        .map(|row| format!("{}Pa", row[0] * pressure_pa)),
                )
                .collect();
            let loads: Vec<&str> = loads.iter().flat_map(|load| ["--pressure", load]).collect();
            let table =
                gap(&bench, "builtin:uncd-reconstructed", &[&["--model", model], &loads, &DIAMOND]).ok();
            let gaps = numbers(&table, "mean_gap_m");
            for (row, gap_m) in [rows[1], rows[rows.len() / 2], rows[rows.len() - 1]].iter().zip(&gaps[1..]) {
                let overclosure_m = row[1] * length_m;
                assert!(((gaps[0] - gap_m) / overclosure_m - 1.0).abs() < 1e-8, "{model} {dialect} {units}");
            }
        }
    }
}

#[test]
fn a_law_has_forms_and_a_plain_table() {
    let bench = Bench::new();
    let persson = ["--model", "persson", "--units", "N-mm"];
    let csv = law(&bench, &[&persson, &["--dialect", "csv", "--output", "law.csv"]]);
    assert_eq!(csv.ok(), "");
    let csv = bench.read("law.csv");
    assert_eq!(numbers(&csv, "pressure_MPa").last(), Some(&10.0));
    assert_eq!((numbers(&csv, "overclosure_mm")[0], numbers(&csv, "pressure_MPa")[0]), (0.0, 0.0));
    assert!(numbers(&csv, "area_fraction").is_sorted() && numbers(&csv, "mean_gap_mm")[0] > 0.0);
    let exponential =
        law(&bench, &[&persson, &["--dialect", "calculix", "--form", "exponential", "--name", "LAP"]]).ok();
    let light =
        gap(&bench, "builtin:uncd-reconstructed", &[&["--model", "persson", "--pressure", "1kPa"], &DIAMOND])
            .ok();
    let [clearance_mm, pressure_mpa] = rows(&exponential)[0];
    assert!((clearance_mm / (100f64.ln() * 1e3 * numbers(&light, "u0_m")[0]) - 1.0).abs() < 1e-12);
    assert!((pressure_mpa / (1e-6 * numbers(&light, "p00_pa")[0]) - 1.0).abs() < 1e-12);
    assert!(exponential.contains("*SURFACE INTERACTION, NAME=LAP\n"), "{exponential}");
}

#[test]
fn models_of_asperities_warn_beyond_light_loads() {
    let bench = Bench::new();
    // The rms gradient is 1: some 1e-4 and a fifth touch.
    for (pressure, warnings) in [("1e-4Pa", 0), ("0.2Pa", 1)] {
        let call = ["gap", "builtin:contact-challenge", "--model", "bgt", "--pressure", pressure];
        let ran = bench.run(&[&call[..], &UNIT].concat());
        assert_eq!(ran.remarks(&["asperities push each other down"]).len(), warnings, "{}", ran.stderr);
    }
}

fn shear(bench: &Bench, options: &[&[&str]]) -> crate::support::Ran {
    let call = ["tangential", "psd.csv", "--pressure", "1e-3Pa", "--friction", "0.3"];
    bench.run(&[&call[..], &UNIT, &options.concat()].concat())
}

#[test]
fn a_sheared_surface_follows_its_normal_law() {
    let bench = power_law();
    // Waves of profiles have no tail of heights.
    let theory = ["--model", "persson", "--band", "1d"];
    let normal = gap(&bench, "psd.csv", &[&theory[..], &["--pressure", "1e-3Pa"], &UNIT]).ok();
    let table = shear(&bench, &[&theory]).ok();
    let [shares, stiffness, lost] =
        ["share_of_sliding", "initial_stiffness_pa_per_m", "dissipation_j_per_m2"]
            .map(|name| numbers(&table, name));
    assert_eq!(shares.len(), 11);
    // eta = (2 - nu)/(2 (1 - nu)) = 1 for a body with nu = 0 against a rigid one.
    let expected = numbers(&normal, "stiffness_pa_per_m")[0];
    assert!(stiffness.iter().all(|found| (found / expected - 1.0).abs() < 1e-12), "{stiffness:?} {expected}");
    // Under light loads K = p/u0, whose loss has a closed form.
    let (f, p, u0) = (0.3, 1e-3, numbers(&normal, "u0_m")[0]);
    for (share, lost) in shares.iter().zip(lost).filter(|(share, _)| **share >= 0.1) {
        let closed = f * f * u0 * p * (-8.0 * share - (8.0 - 4.0 * share) * (-share).ln_1p());
        assert!((lost / closed - 1.0).abs() < 0.02, "{share}: {lost} {closed}");
    }
}

#[test]
fn an_asperity_model_whose_stiffness_falls_with_the_load_is_not_sheared() {
    let bench = Bench::new();
    let sheared = |pressure: &str| {
        let call = ["tangential", "builtin:uncd-measured", "--model", "elastic-sine", "--material", "PTFE"];
        let load = ["--friction", "0.2", "--tangential-stress", "5MPa", "--pressure", pressure];
        bench.run(&[&call[..], &load].concat())
    };
    sheared("30MPa").ok();
    sheared("250MPa").refused_naming(&["stiffness", "250 MPa", "--pressure"]);
}

#[test]
fn a_loop_is_drawn_for_each_tangential_load_that_sticks() {
    let bench = power_law();
    let drawn = |options: &[&str]| {
        shear(&bench, &[&["--model", "persson", "--figure", "loop.svg"], options]).ok();
        bench.read("loop.svg")
    };
    let one = drawn(&["--tangential-stress", "1e-4Pa"]);
    for label in [">first loading<", ">unloading<", ">reloading<", "J/m² lost"] {
        assert!(one.contains(label), "{label}: {one}");
    }
    let shares = drawn(&[]);
    assert_eq!(shares.matches("lost per cycle").count(), 3, "{shares}");
}

#[test]
fn a_stress_beyond_friction_slides() {
    let bench = power_law();
    let stresses = ["--model", "hertz", "--tangential-stress", "1e-4Pa", "--tangential-stress", "3e-4Pa"];
    let table = shear(&bench, &[&stresses]).ok_remarking(&["1 of 2 loads", "slides"]);
    assert_eq!(column(&table, "displacement_m")[1], "");
    let stuck: f64 = column(&table, "stuck_area_fraction")[0].parse().unwrap();
    assert!(stuck < numbers(&table, "area_fraction")[0]);
}

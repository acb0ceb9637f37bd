//! `bem`: maps and random surfaces pressed by boundary elements.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use crate::support::{Bench, column, numbers};

/// E* of 1 GPa.
const ELASTIC: [&str; 4] = ["--youngs-modulus", "1GPa", "--poisson-ratio", "0"];
/// A spectrum of an area between 1/8 m and 1/64 m, Ciso falling as q^-3.6.
const CISO_M4: f64 = 1e-9;

fn call<'a>(parts: &[&[&'a str]]) -> Vec<&'a str> {
    [&["bem"], &parts.concat()[..], &ELASTIC].concat()
}

/// Waves of 0.1 um along x, as a matrix of text; columns and rows span 1 um a side where they are as many.
fn waves(columns: usize, rows: usize) -> String {
    let mut text = String::new();
    for _ in 0..rows {
        let row = (0..columns).map(|i| format!("{:e}", 0.1 * (TAU * i as f64 / columns as f64).cos()));
        let _ = writeln!(text, "{}", row.collect::<Vec<_>>().join(" "));
    }
    text
}

const WAVES: [&str; 8] =
    ["waves.txt", "--unit", "um", "--size", "1um", "--boundary", "periodic", "--detrend=mean"];

fn with_waves(columns: usize, rows: usize) -> Bench {
    let bench = Bench::new();
    bench.write("waves.txt", waves(columns, rows));
    bench
}

fn with_spectrum() -> Bench {
    let bench = Bench::new();
    let row = |waves: f64| format!("{:e},{:e}\n", 1.0 / waves, CISO_M4 * waves.powf(-3.6));
    bench.write("ciso.csv", format!("wavelength_m,Ciso_m4\n{}{}{}", row(8.0), row(20.0), row(64.0)));
    bench
}

const SURFACES: [&str; 9] =
    ["ciso.csv", "--grid", "256", "--box", "1m", "--longest", "125mm", "--shortest", "15.625mm"];

#[test]
fn heights_that_repeat_themselves_lose_their_mean_and_no_plane() {
    let bench = with_waves(64, 8);
    let pressed = |detrend: &[&str]| {
        let call = call(&[&WAVES[..WAVES.len() - 1], detrend, &["--pressure", "100MPa"]]);
        numbers(&bench.run(&call).ok(), "largest_pressure_pa")[0]
    };
    assert_eq!(pressed(&[]), pressed(&["--detrend=mean"]));
    assert_ne!(pressed(&[]), pressed(&["--detrend=plane"]));
}

#[test]
fn a_line_is_pressed_as_a_surface_that_does_not_change_across_it() {
    let load = ["--pressure", "100MPa"];
    let line = with_waves(64, 1);
    let [of_line, of_rows] = [&line, &with_waves(64, 4)].map(|bench| bench.run(&call(&[&WAVES, &load])).ok());
    for name in ["area_fraction", "mean_gap_m", "stiffness_pa_per_m"] {
        let [line, rows] = [&of_line, &of_rows].map(|table| numbers(table, name)[0]);
        assert!((line / rows - 1.0).abs() < 1e-9, "{name}: {line} {rows}");
    }
    line.run(&call(&[&["waves.txt", "--unit", "um", "--size", "1um"], &load])).refused_naming(&["periodic"]);
}

#[test]
fn a_smaller_load_behind_a_larger_one_that_yielded_is_no_unloading() {
    let bench = with_waves(64, 8);
    let said = |pressures: [&str; 2], saturation: &[&str]| {
        let loads = ["--pressure", pressures[0], "--pressure", pressures[1]];
        let ran = bench.run(&call(&[&WAVES, &loads, saturation]));
        assert_eq!(ran.status, 0, "{}", ran.stderr);
        ran.stderr.contains("unloading")
    };
    let yields = ["--saturation", "300MPa"];
    assert!(said(["200MPa", "100MPa"], &yields));
    assert!(!said(["100MPa", "200MPa"], &yields) && !said(["200MPa", "100MPa"], &[]));
}

#[test]
fn what_is_not_computed_is_refused_with_the_way_out() {
    let bench = with_spectrum();
    let ball = [
        "--ball-radius",
        "1mm",
        "--force",
        "1N",
        "--work-of-adhesion",
        "50mJ/m^2",
        "--adhesion-range",
        "1nm",
    ];
    bench.run(&call(&[&["ciso.csv"], &ball])).refused_naming(&["parabola"]);
    bench.run(&call(&[&["ciso.csv"], &["--unload", "1MPa"]])).refused_naming(&["--unload", "saturation"]);
    bench.run(&call(&[&["ciso.csv"], &["--temperature", "400K"]])).refused_naming(&["at that temperature"]);
    let scene = "[surface]\npsd = \"ciso.csv\"\n[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0\ntemperature = \"400 K\"\n";
    bench.write("hot.toml", scene).run(&["run", "hot.toml"]).refused_naming(&[
        "temperature",
        "hot.toml",
        "6",
    ]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_grid_that_does_not_fit_into_memory_is_refused_with_one_that_does() {
    let bench = with_spectrum();
    let script = format!(
        "ulimit -v 2000000; {} bem ciso.csv --grid 16384 --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0",
        env!("CARGO_BIN_EXE_truearea")
    );
    let ran = std::process::Command::new("bash")
        .args(["-c", &script])
        .current_dir(bench.path(""))
        .output()
        .unwrap();
    let said = String::from_utf8(ran.stderr).unwrap();
    assert_eq!(ran.status.code(), Some(2), "{said}");
    assert!(said.contains("26.8 GB") && said.contains("use at most"), "{said}");
}

#[test]
fn the_stiffness_of_free_edges_says_that_it_holds_the_half_space_around_the_map() {
    let bench = with_waves(64, 8);
    let said = |boundary: &str| {
        let ran = bench.run(&call(&[&WAVES[..5], &["--boundary", boundary, "--pressure", "10MPa"]]));
        assert_eq!(ran.status, 0, "{}", ran.stderr);
        ran.stderr.contains("stiffness_pa_per_m")
    };
    assert!(said("free") && !said("periodic"));
}

#[test]
fn waves_touch_as_westergaard_says() {
    let bench = with_waves(64, 8);
    // p* = pi E* amplitude/wavelength.
    let complete_mpa = PI * 1e3 * 0.1;
    for share in [0.1, 0.4, 0.8] {
        let pressure = format!("{}MPa", share * complete_mpa);
        let table = bench.run(&call(&[&WAVES, &["--pressure", &pressure, "--tolerance", "1e-9"]])).ok();
        let area = numbers(&table, "area_fraction")[0];
        assert!((area - 2.0 / PI * share.sqrt().asin()).abs() <= 2.0 / 64.0, "{share}: {area}");
        let gap_um = 1e6 * numbers(&table, "mean_gap_m")[0];
        assert!((gap_um - 0.1 * (1.0 - share + share * share.ln())).abs() < 1e-4, "{share}: {gap_um}");
        let largest = numbers(&table, "largest_pressure_pa")[0] / 1e6;
        assert!((largest / (2.0 * share.sqrt() * complete_mpa) - 1.0).abs() < 0.02, "{share}: {largest}");
        assert!(numbers(&table, "residual")[0] <= 1e-9);
        assert_eq!(column(&table, "standard_error"), [""]);
    }
}

#[test]
fn ridges_leave_channels_beside_them_until_they_touch_throughout() {
    let bench = with_waves(32, 8);
    let of = |loads: &[&'static str]| bench.run(&call(&[&WAVES, loads]));
    // Contact is complete from 314 MPa on.
    let light = of(&["--pressure", "100MPa"]);
    assert_eq!(light.remarks(&["at 100 MPa", "along y"]).len(), 1, "{}", light.stderr);
    let both = of(&["--pressure", "100MPa", "--pressure", "1GPa"]);
    assert_eq!(both.remarks(&["at 100 MPa", "along y", "at 1 GPa none"]).len(), 1, "{}", both.stderr);
    let table = both.ok();
    assert_eq!(column(&table, "open_along_x"), ["0", "0"]);
    assert_eq!(column(&table, "open_along_y"), ["1", "0"]);
}

#[test]
fn the_table_has_a_row_for_each_load_and_with_realisations_one_for_each_surface() {
    let bench = with_spectrum();
    let loads = ["--pressure", "1MPa", "--pressure", "200kPa", "--realisations", "2"];
    let of = |more: &[&'static str]| bench.run(&call(&[&SURFACES, &loads, more])).ok();
    let means = of(&[]);
    assert!(means.starts_with(
        "nominal_pressure_pa,area_fraction,area_fraction_corrected,area_fraction_extrapolated,standard_error,\
         plastic_area_fraction,mean_gap_m,mean_plastic_depth_m,largest_pressure_pa,stiffness_pa_per_m,iterations,residual,\
         plastic_area_fraction_corrected,open_along_x,open_along_y\n"
    ));
    assert_eq!(column(&means, "nominal_pressure_pa"), ["1000000", "200000"]);
    let single = of(&["--per-realisation"]);
    assert_eq!(column(&single, "realisation"), ["1", "2", "1", "2"]);
    for name in ["area_fraction", "area_fraction_corrected", "area_fraction_extrapolated", "mean_gap_m"] {
        let (means, single) = (numbers(&means, name), numbers(&single, name));
        for (load, mean) in means.into_iter().enumerate() {
            let of_both = 0.5 * (single[2 * load] + single[2 * load + 1]);
            assert!((mean / of_both - 1.0).abs() < 1e-12, "{name}");
        }
    }
    let best = numbers(&single, "area_fraction_extrapolated");
    let error = numbers(&means, "standard_error")[0];
    assert!((error / (0.5 * (best[0] - best[1]).abs()) - 1.0).abs() < 1e-9);
    // The same seed makes the same surfaces, another one others; threads change nothing.
    let serial = bench.run_with_env(&call(&[&SURFACES, &loads]), "RAYON_NUM_THREADS", "1").ok();
    assert_eq!(serial, means);
    assert_ne!(of(&["--seed", "2"]), means);
}

#[test]
fn areas_are_those_of_other_boundary_elements() {
    let bench = with_spectrum();
    let end = |waves: f64| TAU * waves;
    let integral = (end(64.0).powf(0.4) - end(8.0).powf(0.4)) / 0.4;
    let gradient = (CISO_M4 * TAU.powf(3.6) / TAU * integral).sqrt();
    let pressures: Vec<String> =
        [0.15, 0.5].iter().map(|share| format!("--pressure={}GPa", share * gradient)).collect();
    let pressures: Vec<&str> = pressures.iter().map(String::as_str).collect();
    let ran = bench.run(&call(&[&SURFACES, &pressures, &["--realisations", "3"]]));
    let grid = ["note: ", "256 x 256", "1 m,", "125 mm", "15.6 mm"];
    // From judge_table.csv, counted on 512 points; here half as many are within 2 %.
    let areas = numbers(&ran.ok_remarking(&grid), "area_fraction_corrected");
    for (area, expected) in areas.into_iter().zip([0.29361, 0.73622]) {
        assert!((area / expected - 1.0).abs() < 0.02, "{area} {expected}");
    }
}

#[test]
fn a_saturated_surface_flows_and_no_point_carries_more() {
    let bench = with_waves(32, 32);
    let table = bench.run(&call(&[&WAVES, &["--pressure", "60MPa", "--saturation", "150MPa"]])).ok();
    assert!(numbers(&table, "largest_pressure_pa")[0] <= 150e6 * (1.0 + 1e-9));
    let [plastic, area] = ["plastic_area_fraction", "area_fraction"].map(|name| numbers(&table, name)[0]);
    assert!(plastic > 0.1 && plastic <= area && plastic * 150.0 <= 60.0 * (1.0 + 1e-9), "{plastic} {area}");
    assert!(numbers(&table, "mean_plastic_depth_m")[0] > 0.0);
    let in_h = bench
        .run(&call(&[&WAVES, &["--pressure=0.4H", "--saturation=1H", "--indentation-hardness=150MPa"]]))
        .ok();
    assert_eq!(column(&in_h, "plastic_area_fraction"), column(&table, "plastic_area_fraction"));
}

#[test]
fn fields_are_written_as_maps_and_pictures() {
    let bench = with_waves(32, 16);
    bench.run(&call(&[&WAVES, &["--pressure", "60MPa", "--fields", "fields", "--figure", "area.svg"]])).ok();
    let mut names: Vec<String> = std::fs::read_dir(bench.path("fields"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["load-1-surface-1-gap.png", "load-1-surface-1-pressure.png", "load-1-surface-1.nc"]);
    let bytes = |name: &str| std::fs::read(bench.path(&format!("fields/{name}"))).unwrap();
    assert!(bytes("load-1-surface-1.nc").starts_with(b"CDF\x01"));
    assert!(bytes("load-1-surface-1-gap.png").starts_with(b"\x89PNG"));
    assert!(bench.read("area.svg").contains("points in contact"));
    // The program reads its own heights, knows from the file that they are periodic, and presses them to the same area.
    let again = ["fields/load-1-surface-1.nc", "--pressure=60MPa"];
    let [again, first] =
        [bench.run(&call(&[&again])).ok(), bench.run(&call(&[&WAVES, &["--pressure", "60MPa"]])).ok()];
    assert_eq!(column(&again, "area_fraction"), column(&first, "area_fraction"));
}

#[test]
fn patches_are_the_regions_that_touch() {
    let bench = with_waves(32, 16);
    let run = |options: &[&str]| bench.run(&call(&[&WAVES, options])).ok();
    let table = run(&["--pressure", "60MPa", "--pressure", "6MPa", "--patches", "patches.csv"]);
    let patches = bench.read("patches.csv");
    assert!(patches.starts_with("nominal_pressure_pa,realisation,patch,points,area_m2,perimeter_m\n"));
    // Each load has one stripe across the periodic map, 1 um long and half as wide, with two straight sides.
    for name in ["realisation", "patch"] {
        assert_eq!(column(&patches, name), ["1", "1"]);
    }
    assert_eq!(column(&patches, "nominal_pressure_pa"), column(&table, "nominal_pressure_pa"));
    let [points, areas, perimeters] =
        ["points", "area_m2", "perimeter_m"].map(|name| numbers(&patches, name));
    for (at, share) in numbers(&table, "area_fraction").into_iter().enumerate() {
        assert_eq!(points[at], share * 512.0);
        assert!((areas[at] / (share * 0.5e-12) - 1.0).abs() < 1e-12);
        assert!((perimeters[at] / 1e-6 - 1.0).abs() < 1e-12);
    }
}

#[test]
fn patches_of_every_surface_make_up_its_area() {
    let bench = with_spectrum();
    let random =
        ["--realisations=3", "--pressures=10kPa:100kPa:2", "--per-realisation", "--patches=patches.csv"];
    let table = bench.run(&call(&[&SURFACES, &random])).ok();
    let patches = bench.read("patches.csv");
    let [pressures, realisations, order, points] =
        ["nominal_pressure_pa", "realisation", "patch", "points"].map(|name| numbers(&patches, name));
    let rows: Vec<[f64; 3]> =
        (0..points.len()).map(|at| [pressures[at], realisations[at], order[at]]).collect();
    assert!(rows.is_sorted() && rows.len() > 12, "{patches}");
    let [loads, surfaces, shares] =
        ["nominal_pressure_pa", "realisation", "area_fraction"].map(|name| numbers(&table, name));
    for ((load, surface), share) in loads.into_iter().zip(surfaces).zip(shares) {
        let of_state = |row: &usize| rows[*row][..2] == [load, surface];
        let counted: f64 = (0..points.len()).filter(of_state).map(|row| points[row]).sum();
        assert_eq!(counted, share * 256.0 * 256.0);
    }
}

#[test]
fn spots_conduct_and_a_film_adds_its_resistance() {
    let bench = with_spectrum();
    let run = |options: &[&str]| {
        let random = ["--realisations=1", "--pressure=30kPa", "--spots=spots.csv", "--fields=fields"];
        let bodies = ["--resistivity=2e-8 ohm m", "--counterface-resistivity=6e-8 ohm m"];
        bench.run(&call(&[&SURFACES, &random, &bodies, options])).ok()
    };
    let bare = run(&[]);
    let [resistance, from_stiffness] =
        ["resistance_ohm", "resistance_from_stiffness_ohm"].map(|name| numbers(&bare, name)[0]);
    assert!((resistance / from_stiffness - 1.0).abs() < 0.1, "{resistance} {from_stiffness}");
    assert_eq!(column(&bare, "resistance_from"), ["spots"]);
    let spots = bench.read("spots.csv");
    let [shares, areas] = ["current_share", "area_m2"].map(|name| numbers(&spots, name));
    assert_eq!(numbers(&bare, "spots"), [shares.len() as f64]);
    assert_eq!(numbers(&bare, "largest_share")[0], shares.iter().copied().fold(0.0, f64::max));
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    assert!(std::fs::exists(bench.path("fields/load-1-surface-1-current.png")).unwrap());
    // The current of a map with free edges spreads from all of it into the bodies.
    let map = ["waves.txt", "--unit=um", "--size=1um", "--pressure=60MPa", "--spots=spots.csv"];
    let bodies = ["--resistivity=2e-8 ohm m", "--counterface-resistivity=2e-8 ohm m"];
    let free = with_waves(32, 32).run(&call(&[&map, &bodies]));
    assert_eq!(free.remarks(&["resistance_ohm", "--boundary periodic"]).len(), 1);
    // A film of a large resistance conducts by area.
    let film = run(&["--film-resistance=1 ohm m^2", "--mean-free-path=40nm"]);
    let by_area = 1.0 / areas.iter().sum::<f64>();
    assert!((numbers(&film, "resistance_ohm")[0] / by_area - 1.0).abs() < 1e-6);
}

#[test]
fn odd_sides_and_single_rows_are_pressed_without_a_coarser_grid() {
    for (columns, rows) in [(33, 17), (32, 15)] {
        let bench = with_waves(columns, rows);
        let table = bench.run(&call(&[&WAVES, &["--pressure", "60MPa"]])).ok();
        assert_eq!(column(&table, "area_fraction_extrapolated"), [""]);
        assert!((0.2..0.4).contains(&numbers(&table, "area_fraction")[0]), "{table}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_signal_ends_the_work_and_leaves_nothing() {
    let bench = with_spectrum();
    let line = call(&[
        &SURFACES,
        &[
            "--grid=1024",
            "--pressures=1kPa:1GPa:200",
            "--tolerance=1e-12",
            "--fields=fields",
            "--output=t.csv",
        ],
    ]);
    let line: Vec<&str> = line.into_iter().filter(|word| !["--grid", "256"].contains(word)).collect();
    let mut child = std::process::Command::new("env")
        .args(["--default-signal=INT", env!("CARGO_BIN_EXE_truearea")])
        .args(line)
        .current_dir(bench.path(""))
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    // The folder is made right before the first surface is pressed.
    while !bench.path("fields").exists() {
        assert!(child.try_wait().unwrap().is_none());
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    std::thread::sleep(std::time::Duration::from_millis(300));
    let sent = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(bench.files(), ["ciso.csv"]);
}

#[test]
fn a_ball_on_a_nearly_smooth_map_is_hertz() {
    let bench = Bench::new();
    let heights = (0..128)
        .map(|row| (0..128).map(|column| format!("{} ", (row + column) % 2)).collect::<String>() + "\n");
    bench.write("flat.txt", heights.collect::<String>());
    // a = 0.2 um from F = 4 E* a^3/(3 R).
    let pressed = [
        "flat.txt:unit=pm,size=1um",
        "--ball-radius",
        "10um",
        "--force",
        "1.0666667uN",
        "--tolerance",
        "1e-8",
    ];
    let table = bench.run(&call(&[&pressed])).ok();
    let of = |name: &str| numbers(&table, name)[0];
    assert!((of("hertz_radius_m") / 0.2e-6 - 1.0).abs() < 1e-7);
    assert!((of("effective_radius_m") / of("hertz_radius_m") - 1.0).abs() < 2e-3, "{table}");
    assert!((of("peak_mean_pressure_pa") / of("hertz_pressure_pa") - 1.0).abs() < 0.01, "{table}");
    assert!((of("force_share") - (1.0 - 0.75f64.powf(1.5))).abs() < 0.01, "{table}");
    assert!((of("real_area_corrected_m2") / (PI * 0.04e-12) - 1.0).abs() < 0.02, "{table}");
}

#[test]
fn a_ball_on_surfaces_of_a_spectrum_has_a_row_for_each_place() {
    let bench = with_spectrum();
    let ball = ["--realisations", "3", "--ball-radius", "10m", "--force", "1.07MN"];
    let table = bench.run(&call(&[&SURFACES, &ball, &["--figure", "ball.svg"]])).ok();
    assert_eq!(numbers(&table, "realisation"), [1.0, 2.0, 3.0]);
    let drawn = bench.read("ball.svg");
    for label in
        [">Hertz<", ">rough flat<", ">distance from the axis (mm)<", ">standard deviation between places<"]
    {
        assert!(drawn.contains(label), "{label}: {drawn}");
    }
    let areas_m2 = numbers(&table, "real_area_m2");
    assert!(areas_m2.windows(2).all(|pair| pair[0] != pair[1] && pair[0] > 0.0), "{areas_m2:?}");
}

#[test]
fn a_cylinder_on_a_nearly_smooth_map_is_hertz() {
    let bench = Bench::new();
    let heights = (0..32)
        .map(|row| (0..256).map(|column| format!("{} ", (row + column) % 2)).collect::<String>() + "\n");
    bench.write("flat.txt", heights.collect::<String>());
    // a = 0.05 um from F' = pi a^2 E*/(4 R).
    let pressed =
        ["flat.txt:unit=pm,size=1um", "--cylinder-radius", "10um", "--force-per-length", "0.19634954N/m"];
    let table = bench.run(&call(&[&pressed])).ok();
    let of = |name: &str| numbers(&table, name)[0];
    assert!((of("hertz_half_width_m") / 0.05e-6 - 1.0).abs() < 1e-7, "{table}");
    assert!((of("effective_half_width_m") / of("hertz_half_width_m") - 1.0).abs() < 5e-3, "{table}");
    assert!((of("peak_mean_pressure_pa") / of("hertz_pressure_pa") - 1.0).abs() < 0.01, "{table}");
    // Half of the half-width is 6.4 points.
    assert!((of("force_share") - 0.609).abs() < 0.04, "{table}");
    assert!((of("real_width_corrected_m") / 0.1e-6 - 1.0).abs() < 0.05, "{table}");
}

/// Pressures of a wave with adhesion lie between pull-off and full contact, and both branches meet where the state is unique.
#[test]
fn adhesive_waves_are_pressed_and_pulled() {
    let bench = with_waves(64, 4);
    let adhesive = ["--work-of-adhesion", "20J/m^2", "--adhesion-range", "100nm"];
    let pressed = bench.run(&call(&[&WAVES, &adhesive, &["--branch", "both", "--pressure", "20MPa"]])).ok();
    let areas = numbers(&pressed, "area_fraction");
    let plain = numbers(&bench.run(&call(&[&WAVES, &["--pressure", "20MPa"]])).ok(), "area_fraction")[0];
    assert!(areas.len() == 2 && areas.iter().all(|area| *area > plain && *area <= 1.0), "{areas:?} {plain}");
    let held = bench.run(&call(&[&WAVES, &adhesive, &["--pressure=-5kPa"]])).ok();
    let [held_pa] = numbers(&held, "nominal_pressure_pa")[..] else { panic!("{held}") };
    assert!((held_pa / -5e3 - 1.0).abs() < 1e-12, "{held}");
    let pulled = bench.run(&call(&[&WAVES, &adhesive, &["--pull-off", "--figure", "pulled.svg"]])).ok();
    let drawn = bench.read("pulled.svg");
    for label in [">mean gap (nm)<", ">mean pressure (MPa)<", ">pull-off<", "\u{2212}"] {
        assert!(drawn.contains(label), "{label}: {drawn}");
    }
    let loads = ["--branch", "both", "--pressure=-1MPa", "--pressure", "20MPa", "--pressure", "60MPa"];
    bench.run(&call(&[&WAVES, &adhesive, &loads, &["--figure", "branches.svg"]])).ok();
    let drawn = bench.read("branches.svg");
    for label in [">from first touch<", ">from full contact<", ">nominal pressure (MPa)<", " %<"] {
        assert!(drawn.contains(label), "{label}: {drawn}");
    }
    let loads = numbers(&pulled, "nominal_pressure_pa");
    let strongest = loads.iter().copied().fold(0.0, f64::min);
    assert!(strongest < 0.0 && *loads.last().unwrap() > 0.25 * strongest, "{loads:?}");
}

#[test]
fn keys_that_change_no_pressed_map_are_refused_by_name() {
    let bench = with_waves(32, 32);
    for key in
        ["shortest=0.5um", "tip-radius=2um", "instrument=AFM", "z-calibration=2%", "slope-uncertainty=0.1"]
    {
        let map = format!("waves.txt:unit=um,size=1um,{key}");
        bench.run(&call(&[&[&map, "--pressure", "1MPa"]])).refused_naming(&[key.split('=').next().unwrap()]);
    }
}

//! `moments`, `amplitude`, `stacked` and `fit` as scripts see them.

use crate::support::{Bench, DIAMOND, column, numbers};

fn stacked(bench: &Bench, more: &[&str]) -> String {
    let mut args = vec!["stacked", "builtin:uncd-measured", "--model", "elastic-plastic"];
    args.extend(DIAMOND);
    args.extend(more);
    bench.run(&args).ok()
}

#[test]
fn moments_start_at_the_second_wavelength() {
    let table = Bench::new().run(&["moments", "builtin:uncd-reconstructed"]).ok();
    let mut lines = table.lines();
    assert_eq!(
        lines.next().unwrap(),
        "wavelength_m,m0_m2,m2,m4_per_m2,radius_m,density_per_m2,sigma_s_m,offset_m,nayak_alpha"
    );
    assert_eq!(lines.next().unwrap(), "0.008954647,,,,,,,,");
    assert_eq!(lines.count(), 73);
    // The published average slope is 50 degrees: 45.7 for this table.
    let slope: f64 = column(&table, "m2").last().unwrap().parse().unwrap();
    assert!((slope.sqrt().atan().to_degrees() - 45.7).abs() < 0.05);
}

#[test]
fn normalisation_as_printed_is_larger_by_pi() {
    let bench = Bench::new();
    let last = |more: &[&str]| {
        let table = bench.run(&[&["moments", "builtin:uncd-measured"], more].concat()).ok();
        column(&table, "m2").last().unwrap().parse::<f64>().unwrap()
    };
    let ratio = last(&["--normalisation", "as-printed"]) / last(&["--normalisation", "parseval"]);
    assert!((ratio / std::f64::consts::PI - 1.0).abs() < 1e-14);
}

#[test]
fn a_surface_that_is_not_gaussian_is_warned_of_on_stderr_alone() {
    let ran = Bench::new().run(&["moments", "builtin:uncd-measured"]);
    assert_eq!(ran.remarks(&["note: nayak_alpha ", "1.5 "]).len(), 1, "{}", ran.stderr);
    assert!(!ran.stdout.contains("note"));
}

#[test]
fn a_cutoff_ends_moments_between_samples_and_drops_scales() {
    let bench = Bench::new();
    let moments = bench.run(&["moments", "builtin:uncd-reconstructed", "--cutoff", "10nm"]).ok();
    assert_eq!(*numbers(&moments, "wavelength_m").last().unwrap(), 10e-9);
    let whole = bench.run(&["amplitude", "builtin:uncd-reconstructed"]).ok();
    let cut = bench.run(&["amplitude", "builtin:uncd-reconstructed", "--cutoff", "10nm"]).ok();
    assert!(numbers(&cut, "wavelength_m").into_iter().all(|wavelength_m| wavelength_m >= 10e-9));
    assert!(whole.starts_with(&cut));
}

#[test]
fn resampling_keeps_both_ends_and_counts_scales_per_decade() {
    let args = ["amplitude", "builtin:uncd-reconstructed", "--scales-per-decade", "5"];
    let wavelengths = numbers(&Bench::new().run(&args).ok(), "wavelength_m");
    assert_eq!((wavelengths[0], *wavelengths.last().unwrap()), (8.954647e-3, 4.487955e-10));
    assert_eq!(wavelengths.len(), 37);
}

#[test]
fn stacked_blocks_come_in_the_order_of_the_pressures() {
    let bench = Bench::new();
    let one = stacked(&bench, &["--pressure", "5.4MPa"]);
    assert_eq!(one.lines().next().unwrap(), "wavelength_m,amplitude_m,area_fraction,real_pressure_pa,regime");
    let both = stacked(&bench, &["--pressure", "1e-1 H", "--pressure", "5.4MPa", "--details"]);
    assert_eq!(
        both.lines().next().unwrap(),
        "nominal_pressure_pa,wavelength_m,amplitude_m,area_fraction,real_pressure_pa,regime,pressure_in_pa,yield_strength_pa"
    );
    let pressures = numbers(&both, "nominal_pressure_pa");
    assert_eq!((pressures[0], *pressures.last().unwrap()), (0.1 * 5.4e9, 5.4e6));
    assert_eq!(numbers(&both, "area_fraction")[46..], numbers(&one, "area_fraction"));
    assert_eq!(numbers(&both, "pressure_in_pa")[46], 5.4e6);
}

#[test]
fn the_elastic_model_needs_no_strength_and_ignores_one() {
    let bench = Bench::new();
    let args = |more: &[&'static str]| {
        let mut args = vec![
            "stacked",
            "builtin:uncd-measured",
            "--model",
            "elastic",
            "--pressure",
            "5.4MPa",
            "--details",
        ];
        args.extend(["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2"]);
        args.extend(more);
        args
    };
    let without = bench.run(&args(&[])).ok();
    assert_eq!(bench.run(&args(&["--yield-strength", "1GPa"])).ok(), without);
    bench
        .run(&args(&["--yield-strength", "1GPa", "--strain-gradient-length", "5um"]))
        .refused_naming(&["--strain-gradient-length", "--model elastic"]);
    assert!(column(&without, "yield_strength_pa").iter().all(|cell| cell.is_empty()));
}

#[test]
fn a_strain_gradient_strengthens_every_scale_but_the_first_up_to_its_cap() {
    let bench = Bench::new();
    let pressure = ["--pressure", "5.4MPa", "--details", "--strain-gradient-length", "5um"];
    let free = numbers(&stacked(&bench, &pressure), "yield_strength_pa");
    assert_eq!(free[0], 1.8e9);
    assert!(free[1..].iter().all(|&strength_pa| strength_pa > 1.8e9));
    let capped = stacked(&bench, &[&pressure[..], &["--strength-cap", "5 H"]].concat());
    let largest = numbers(&capped, "yield_strength_pa").into_iter().fold(0.0, f64::max);
    assert_eq!(largest, 5.0 * 5.4e9);
}

#[test]
fn an_elastic_counterface_softens_the_contact() {
    let bench = Bench::new();
    let area = |more: &[&str]| {
        let table = stacked(&bench, &[&["--pressure", "5.4MPa"], more].concat());
        *numbers(&table, "area_fraction").last().unwrap()
    };
    let soft = area(&["--counterface-youngs-modulus", "210GPa", "--counterface-poisson-ratio", "0.3"]);
    assert!(soft > area(&[]));
}

#[test]
fn the_fit_is_one_row_and_tells_when_there_is_no_rolloff() {
    let bench = Bench::new();
    let table = bench.run(&["fit", "builtin:uncd-measured"]).ok();
    assert_eq!(
        table.lines().next().unwrap(),
        "hurst_exponent,hurst_exponent_se,rolloff_wavelength_m,rolloff_wavelength_se_m,plateau_m3,plateau_se_m3,\
         rms_log10_residual,points"
    );
    assert_eq!(column(&table, "points"), ["46"]);
    let band = bench.run(&["fit", "builtin:uncd-reconstructed", "--from", "10nm", "--to", "1um"]);
    assert_eq!(band.stderr.lines().count(), 3, "{}", band.stderr);
    for words in [["note: ", "reconstruction"], ["note: ", "roll-off"], ["warning: ", "1.03"]] {
        assert_eq!(band.remarks(&words).len(), 1, "{}", band.stderr);
    }
    assert_eq!(column(&band.stdout, "rolloff_wavelength_m"), [""]);
    assert_eq!(column(&band.stdout, "points"), ["20"]);
}

#[test]
fn a_spectrum_comes_from_standard_input_without_header_too() {
    let bench = Bench::new();
    let named =
        bench.run_with_input(&["amplitude", "-"], "wavelength_m,C1D_m3\n1e-3,1e-22\n1e-4,1e-23\n").ok();
    let bare = ["amplitude", "-", "--x", "wavelength", "--convention", "c1d"];
    assert_eq!(bench.run_with_input(&bare, "1e-4 1e-23\n1e-3 1e-22\n").ok(), named);
}

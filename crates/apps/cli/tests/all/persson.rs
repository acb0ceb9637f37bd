//! `persson`: from a spectrum under loads, and row by row.

use crate::support::{Bench, column, numbers};

const ELASTIC: [&str; 6] = ["--model", "elastic", "--youngs-modulus", "463GPa", "--poisson-ratio", "0.2"];
const PLASTIC: [&str; 8] = [
    "--model",
    "elastic-plastic",
    "--youngs-modulus",
    "463GPa",
    "--poisson-ratio",
    "0.2",
    "--indentation-hardness",
    "5.4GPa",
];
const COLUMNS: &str = "wavelength_m,area_fraction,elastic_area_fraction,plastic_area_fraction,real_pressure_pa,\
                       rms_gradient,mean_gap_m,stiffness_pa_per_m,band";

fn of_diamond(bench: &Bench, options: &[&[&str]]) -> crate::support::Ran {
    bench.run(&[&["persson", "builtin:uncd-reconstructed"], &options.concat()[..]].concat())
}

#[test]
fn an_elastic_curve_follows_the_error_function_and_carries_the_load() {
    let bench = Bench::new();
    let table = of_diamond(&bench, &[&ELASTIC, &["--pressure", "540kPa"]]).ok();
    assert_eq!(table.lines().next().unwrap(), COLUMNS);
    let [areas, gradients, pressures] =
        ["area_fraction", "rms_gradient", "real_pressure_pa"].map(|name| numbers(&table, name));
    assert_eq!((areas[0], gradients[0]), (1.0, 0.0));
    let modulus = 463e9 / (1.0 - 0.2 * 0.2);
    let light = (8.0 / std::f64::consts::PI).sqrt() * 540e3 / (modulus * gradients.last().unwrap());
    assert!((areas.last().unwrap() / light - 1.0).abs() < 1e-9, "{areas:?}");
    for (area, pressure) in areas.iter().zip(pressures) {
        assert!((area * pressure / 540e3 - 1.0).abs() < 1e-14);
    }
    assert!(numbers(&table, "plastic_area_fraction").iter().all(|&share| share == 0.0));
    assert!(column(&table, "mean_gap_m").iter().all(|cell| !cell.is_empty()));
    assert_eq!(column(&table, "stiffness_pa_per_m")[0], "");
}

/// The first cutoffs of the measured spectrum had no gradient and touched everywhere, with steps behind.
#[test]
fn the_gradient_of_the_surface_rises_at_every_cutoff_of_both_diamonds() {
    let bench = Bench::new();
    let body = ["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2"];
    for spectrum in ["builtin:uncd-measured", "builtin:uncd-reconstructed"] {
        let call = ["persson", spectrum, "--model", "elastic", "--pressure", "100kPa"];
        let table = bench.run(&[&call[..], &body].concat()).ok();
        let [areas, gradients] = ["area_fraction", "rms_gradient"].map(|name| numbers(&table, name));
        assert!(gradients.windows(2).all(|pair| pair[0] < pair[1]), "{spectrum}: {gradients:?}");
        // The longest waves of the other one, of centimetres, lie flat.
        assert!(spectrum.ends_with("reconstructed") || areas[1] < 0.9, "{spectrum}: {areas:?}");
    }
}

#[test]
fn several_loads_stand_in_blocks_of_a_table_with_their_pressure_first() {
    let bench = Bench::new();
    let loads = ["--pressure", "1e-2H", "--pressures", "1MPa:10MPa:2"];
    let table = of_diamond(&bench, &[&PLASTIC, &loads]).ok();
    assert_eq!(table.lines().next().unwrap(), format!("nominal_pressure_pa,{COLUMNS}"));
    let pressures = numbers(&table, "nominal_pressure_pa");
    assert_eq!(pressures.len(), 3 * 74);
    assert_eq!([pressures[0], pressures[74], pressures[148]], [54e6, 1e6, 1e7]);
}

#[test]
fn constant_hardness_ends_in_the_load_over_it_and_has_no_elastic_gap_there() {
    let bench = Bench::new();
    let table = of_diamond(&bench, &[&PLASTIC, &["--pressure", "540kPa"]]).ok();
    let [areas, elastic, plastic] =
        ["area_fraction", "elastic_area_fraction", "plastic_area_fraction"].map(|name| numbers(&table, name));
    let gaps = column(&table, "mean_gap_m");
    assert!((areas.last().unwrap() / 1e-4 - 1.0).abs() < 1e-12);
    for at in 0..areas.len() {
        assert!((elastic[at] + plastic[at] - areas[at]).abs() <= 1e-15 * areas[at]);
        for name in ["mean_gap_m", "stiffness_pa_per_m"] {
            let empty = column(&table, name)[at].is_empty();
            let plastic = plastic[at] > 0.03 * areas[at];
            // Without roughness there is no gap to close.
            let smooth = gaps[at] == "0" && name == "stiffness_pa_per_m";
            assert_eq!(empty, plastic || smooth, "{name} {at}");
        }
    }
}

#[test]
fn a_hardness_that_grows_leaves_less_area_than_a_constant_one() {
    let bench = Bench::new();
    bench.write("sizes.csv", "contact_size_m,hardness_pa\n1e-9,20e9\n1e-6,5.4e9\n");
    let last = |law: &[&str]| {
        let table = of_diamond(&bench, &[&PLASTIC, &["--pressure", "540kPa"], law]).ok();
        *numbers(&table, "area_fraction").last().unwrap()
    };
    let elastic = of_diamond(&bench, &[&ELASTIC, &["--pressure", "540kPa"]]).ok();
    let elastic = *numbers(&elastic, "area_fraction").last().unwrap();
    let constant = last(&[]);
    assert!((last(&["--hardness-law", "power:0"]) / constant - 1.0).abs() < 1e-12);
    let power = last(&["--hardness-law", "power:0.2"]);
    let table = last(&["--hardness-law", "table:sizes.csv"]);
    assert!(elastic < power && power < constant && elastic < table && table < constant);
    let gradient = last(&["--hardness-law", "nix-gao", "--strain-gradient-length", "5um"]);
    assert!((gradient / elastic - 1.0).abs() < 1e-6, "{gradient} {elastic}");
    assert_eq!(last(&["--strain-gradient-length", "5um"]), gradient);
    let capped = last(&["--hardness-law", "power:0.2", "--strength-cap", "5GPa"]);
    assert!((capped / (540e3 / 15e9) - 1.0).abs() < 1e-6, "{capped}");
}

#[test]
fn the_load_at_the_hardness_flows_everywhere() {
    let bench = Bench::new();
    let ran = of_diamond(&bench, &[&PLASTIC, &["--pressure", "1H"]]);
    let table = ran.ok_remarking(&["1 load", "hardness"]);
    for (name, share) in
        [("area_fraction", "1"), ("elastic_area_fraction", "0"), ("plastic_area_fraction", "1")]
    {
        assert!(column(&table, name).iter().all(|cell| *cell == share), "{name}");
    }
}

#[test]
fn corrected_forms_say_that_they_are_fitted_and_touch_more() {
    let bench = Bench::new();
    let areas = |options: &[&str]| {
        let ran = of_diamond(&bench, &[&ELASTIC, &["--pressure", "540kPa"], options]);
        let fitted = ran.remarks(&["fitted", "alpha", "1.5 to 140"]);
        assert_eq!(fitted.len(), usize::from(!options.is_empty()), "{}", ran.stderr);
        *numbers(&ran.ok(), "area_fraction").last().unwrap()
    };
    let plain = areas(&[]);
    // At light loads the factor is sqrt(9/5) and 1/sqrt(0.45).
    for (name, factor) in [("wang-muser", 1.8f64.sqrt()), ("yang-persson", 0.45f64.sqrt().recip())] {
        assert!((areas(&["--correction", name]) / plain / factor - 1.0).abs() < 1e-4, "{name}");
    }
    assert!(areas(&["--correction", "algebraic-nayak"]) > plain);
}

#[test]
fn a_cut_of_the_surface_lets_less_through_than_one_of_its_profiles_and_does_not_depend_on_the_cutoff() {
    let bench = Bench::new();
    let gradients = |options: &[&str]| {
        let table = of_diamond(&bench, &[&ELASTIC, &["--pressure", "540kPa"], options]).ok();
        (numbers(&table, "wavelength_m"), numbers(&table, "rms_gradient"))
    };
    let (wavelengths, profile) = gradients(&["--band", "1d"]);
    let (_, surface) = gradients(&["--band", "2d"]);
    let at = wavelengths.iter().position(|&wavelength| wavelength < 290e-9).unwrap();
    let ratio = (surface[at] / profile[at]).powi(2);
    assert!((0.70..0.74).contains(&ratio), "{ratio}");
    let (shorter, cut) = gradients(&["--band", "2d", "--cutoff", "100nm"]);
    for (at, gradient) in cut.iter().enumerate().filter(|(at, _)| shorter[*at] == wavelengths[*at]) {
        assert!((gradient - surface[at]).abs() <= 1e-12 * surface[at], "{at}");
    }
}

const ROWS: &str = "pressure_pa,rms_pressure_pa,hardness_pa,hardness_growth
54e6,1.62e9,,
54e6,1.62e9,5.4e9,
54000000.0,5400000000.0,5400000000.0,0
270000000.0,10800000000.0,5400000000.0,0.25
6e9,1e9,5.4e9,
";

#[test]
fn rows_are_elastic_plastic_or_of_growing_hardness_each_by_itself() {
    let bench = Bench::new();
    let ran = bench.run_with_input(&["persson", "--input", "-"], ROWS);
    assert_eq!(ran.stderr.lines().count(), 1, "{}", ran.stderr);
    let table = ran.ok_remarking(&["note: 1 of 5 rows", "hardness"]);
    let expected = [
        (
            "area_fraction",
            [
                0.026_591_227_634_184_21,
                0.026_591_227_646_161_207,
                0.010_143_814_061_406_779,
                0.036_834_283_128_668_27,
                1.0,
            ],
        ),
        (
            "elastic_area_fraction",
            [
                0.026_591_227_634_184_21,
                0.026_385_205_279_316_117,
                0.000_287_628_015_872_435_3,
                0.004_328_263_305_259_235,
                0.0,
            ],
        ),
        (
            "plastic_area_fraction",
            [0.0, 0.000_206_022_366_845_089_83, 0.009_856_186_045_534_344, 0.032_506_019_823_409_04, 1.0],
        ),
    ];
    for (name, expected) in expected {
        for (at, (found, expected)) in numbers(&table, name).iter().zip(expected).enumerate() {
            // Under a growing hardness shares are accurate relative to that in contact.
            let tolerance = if at == 3 { 1e-6 * 0.0368 } else { 1e-13 * expected };
            assert!((found - expected).abs() <= tolerance, "{name} {at}: {found} {expected}");
        }
    }
}

#[test]
fn what_is_the_same_in_every_row_is_given_as_an_option() {
    let bench = Bench::new();
    let input = "rms_pressure_pa\n1.62e9\n";
    let args = ["persson", "--input", "-", "--pressure", "1e-2H", "--indentation-hardness", "5.4GPa"];
    let table = bench.run_with_input(&args, input).ok();
    assert!((numbers(&table, "plastic_area_fraction")[0] / 2.060_223_668_450_898e-4 - 1.0).abs() < 1e-12);
    let elastic = ["persson", "--input", "-", "--model", "elastic", "--pressure", "54MPa"];
    let table = bench.run_with_input(&elastic, "rms_pressure_pa,hardness_pa\n1.62e9,5.4e9\n").ok();
    assert_eq!(numbers(&table, "plastic_area_fraction"), [0.0]);
}

#[test]
fn a_figure_is_drawn_of_what_the_table_holds() {
    let bench = Bench::new();
    let options = ["--pressure", "540kPa", "--figure", "area.svg", "--hardness-law", "power:0.2"];
    of_diamond(&bench, &[&PLASTIC, &options]).ok();
    assert!(bench.read("area.svg").contains("persson"));
}

#[test]
fn columns_that_no_row_depends_on_are_named_in_one_note_and_the_table_passes() {
    let bench = Bench::new();
    let ran = bench.run_with_input(&["persson", "--input", "-", "--model", "elastic"], ROWS);
    assert_eq!(ran.remarks(&["note: ", "hardness_pa", "hardness_growth"]).len(), 1, "{}", ran.stderr);
    let table = ran.ok();
    assert!(numbers(&table, "plastic_area_fraction").iter().all(|share| *share == 0.0), "{table}");
    assert_eq!(column(&table, "hardness_growth")[3], "0.25");
    let sphere = "youngs_modulus_pa,poisson_ratio,yield_strength_pa,strain_gradient_length_m,radius_m,interference_m\n\
                  2e11,0.3,1e8,1e-6,1e-6,1e-8\n";
    let ran = bench.run_with_input(&["asperity", "sphere"], sphere);
    assert_eq!(ran.remarks(&["note: ", "strain_gradient_length_m"]).len(), 1, "{}", ran.stderr);
    assert!(numbers(&ran.ok(), "jackson_green_force_n")[0] > 0.0);
}

#[test]
fn an_amplitude_without_a_hardness_that_grows_by_it_is_refused() {
    let bench = Bench::new();
    let run =
        |more: &[&str]| of_diamond(&bench, &[&["--pressure", "5.4MPa", "--amplitude", "parseval"], more]);
    let power = [&PLASTIC[..], &["--hardness-law", "power:0.2"]].concat();
    for more in [&ELASTIC[..], &PLASTIC, &power] {
        run(more).refused_naming(&["--amplitude"]);
    }
    run(&[&PLASTIC[..], &["--hardness-law", "nix-gao", "--strain-gradient-length", "300nm"]].concat()).ok();
}

//! States that once broke a promise, as `cargo xtask stress` printed them: most in tables below `found`, with a column for each
//! argument.

use std::collections::HashMap;
use std::path::Path;

use asperity::Hardness;
use elements::half_space::Control;
use persson::Band;
use stress::{
    AdhesionCase, BallCase, Case, Coating, Deformation, Draw, DrawnScan, ElementsCase, Growth, IntervalsCase,
    Kind, LawTablesCase, Material, PerssonCase, Question, Reach, RoughnessCase, Sample, Shape, SmallMap,
    SpectraCase, StatisticalCase, Tally, Trial, try_state,
};

/// Row of a table, by column.
struct Row(HashMap<String, String>);

impl Row {
    /// Reads a table.
    fn all(name: &str) -> Vec<Row> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all/found").join(name);
        csv::Reader::from_path(path).unwrap().into_deserialize().map(|row| Row(row.unwrap())).collect()
    }

    fn text(&self, column: &str) -> &str {
        &self.0[column]
    }

    fn number(&self, column: &str) -> f64 {
        self.optional(column).unwrap_or_else(|| panic!("{column} of {}", self.text("why")))
    }

    fn optional(&self, column: &str) -> Option<f64> {
        let cell = self.text(column);
        (!cell.is_empty()).then(|| cell.parse().unwrap())
    }

    fn pair(&self, columns: [&str; 2]) -> Option<(f64, f64)> {
        let [first, second] = columns.map(|column| self.optional(column));
        first.zip(second)
    }

    fn list(&self, column: &str) -> Vec<f64> {
        self.text(column).split_whitespace().map(|cell| cell.parse().unwrap()).collect()
    }

    /// Pairs such as `1e-6:1e-24`.
    fn pairs(&self, column: &str) -> Vec<(f64, f64)> {
        let pair = |cell: &str| {
            let (first, second) = cell.split_once(':').unwrap();
            (first.parse().unwrap(), second.parse().unwrap())
        };
        self.text(column).split_whitespace().map(pair).collect()
    }

    /// Puts a state to every test, and compares whether its numbers are taken with what the row says.
    fn assert_sound<C: Case>(&self, case: &C) {
        let taken = assert_sound(case);
        assert!(
            match self.text("taken") {
                "yes" => taken,
                "no" => !taken,
                _ => true,
            },
            "{}: {case:?}",
            self.text("why")
        );
    }
}

/// Puts a state to every test, with several choices of what is drawn; returns true if its numbers are taken.
fn assert_sound<C: Case>(case: &C) -> bool {
    const DRAWS: u64 = 8;
    let mut tally = Tally::default();
    for draw in 0..DRAWS {
        Trial::new(&mut tally, "found", draw, (case, Reach::Wide), Draw::new(0, draw)).run(C::test);
    }
    assert_kept(&tally);
    tally.refused.is_empty()
}

fn assert_kept(tally: &Tally) {
    for ((_, promise), record) in &tally.records {
        assert_eq!(record.broken, 0, "{promise}: {:?}", record.worst);
    }
}

#[test]
fn statistical_states_keep_every_promise() {
    const EVERYTHING: Sample = Sample { quadrature: true, finest: true, table: true };
    // Starts of searches and separations nearby are drawn.
    const DRAWS: u64 = 6;
    for row in Row::all("statistical.csv") {
        let material = Material {
            youngs_modulus_pa: row.number("youngs_modulus_pa"),
            poisson_ratio: row.number("poisson_ratio"),
            counterface: row.pair(["counterface_pa", "counterface_poisson_ratio"]),
            strength_pa: row.number("strength_pa"),
            strain_gradient_length_m: row.optional("strain_gradient_length_m"),
            strength_cap_pa: row.optional("strength_cap_pa"),
        };
        let question = match row.optional("separation_m") {
            Some(separation_m) => Question::Separation(separation_m),
            None => Question::Pressure(row.number("pressure_pa")),
        };
        let hardness = |form: &Hardness| format!("{form:?}") == row.text("hardness");
        let case = StatisticalCase {
            kind: row.text("law").parse().unwrap(),
            material,
            hardness: Hardness::ALL.iter().copied().find(hardness).unwrap(),
            radius_m: row.number("radius_m"),
            density_per_m2: row.number("density_per_m2"),
            sigma_s_m: row.number("sigma_s_m"),
            tolerance: row.number("tolerance"),
            question,
        };
        for draw in 0..DRAWS {
            let mut tally = Tally::default();
            Trial::new(&mut tally, case.kind.name(), draw, (&case, Reach::Wide), Draw::new(0, draw))
                .run(|trial| try_state(EVERYTHING, trial));
            assert!(tally.refused.is_empty(), "{}: {case:?}", row.text("why"));
            assert_kept(&tally);
        }
    }
}

#[test]
fn states_of_persson_keep_every_promise() {
    for row in Row::all("persson.csv") {
        let growth = match row.text("growth") {
            "power" => Growth::Power(row.number("growth_value")),
            "length" => Growth::Length(row.number("growth_value")),
            "table" => Growth::Table(row.pairs("growth_table")),
            _ => Growth::Constant,
        };
        let deformation = match row.optional("hardness_pa") {
            Some(hardness_pa) => Deformation::Plastic(hardness_pa, growth, row.optional("limit_pa")),
            None => Deformation::Elastic(None),
        };
        let coating =
            |thickness_m: f64| Coating { thickness_m, base: row.pair(["base_pa", "base_poisson_ratio"]) };
        row.assert_sound(&PerssonCase {
            youngs_modulus_pa: row.number("youngs_modulus_pa"),
            poisson_ratio: row.number("poisson_ratio"),
            coating: row.optional("thickness_m").map(coating),
            spectrum: row.pairs("spectrum"),
            band: if row.text("band") == "surface" { Band::Surface } else { Band::Profile },
            deformation,
            energy_factor: row.optional("energy_factor"),
            threshold: 0.42,
            pressure_pa: row.number("pressure_pa"),
        });
    }
}

#[test]
fn pressed_maps_keep_every_promise() {
    for row in Row::all("elements.csv") {
        let map = SmallMap {
            rows: row.number("rows") as usize,
            columns: row.number("columns") as usize,
            length_x_m: row.number("length_x_m"),
            length_y_m: row.number("length_y_m"),
            heights_m: row.list("heights_m"),
        };
        row.assert_sound(&ElementsCase {
            map,
            periodic: row.text("periodic") == "yes",
            layer: row.pair(["layer_ratio", "layer_m"]),
            contact_modulus_pa: row.number("contact_modulus_pa"),
            pressure_pa: row.number("pressure_pa"),
            saturation_pa: row.optional("saturation_pa"),
            tolerance: row.number("tolerance"),
        });
    }
}

#[test]
fn numbers_that_no_law_can_hold_are_refused() {
    let usual = |youngs_modulus_pa: f64, radius_m: f64| StatisticalCase {
        kind: Kind::Hertz,
        material: Material {
            youngs_modulus_pa,
            poisson_ratio: 0.3,
            counterface: None,
            strength_pa: 1e9,
            strain_gradient_length_m: None,
            strength_cap_pa: None,
        },
        hardness: Hardness::Cosine,
        radius_m,
        density_per_m2: 1e12,
        sigma_s_m: 1e-8,
        tolerance: 1e-10,
        question: Question::Separation(0.0),
    };
    assert!(usual(1e11, 1e-6).state().is_ok());
    for (modulus_pa, radius_m) in [(5e-324, 1e-6), (1e200, 1e-6), (1e11, 1e-300), (1e11, f64::MAX)] {
        assert!(usual(modulus_pa, radius_m).state().is_err(), "{modulus_pa:e}, {radius_m:e}");
    }
}

#[test]
fn a_pressure_keeps_its_digits_where_the_density_alone_is_below_the_normal_doubles() {
    let material = Material {
        youngs_modulus_pa: 1e14,
        poisson_ratio: 0.3,
        counterface: None,
        strength_pa: 1e9,
        strain_gradient_length_m: None,
        strength_cap_pa: None,
    };
    let case = StatisticalCase {
        kind: Kind::Hertz,
        material,
        hardness: Hardness::JacksonGreen2005,
        radius_m: 1e3,
        density_per_m2: 1e20,
        sigma_s_m: 1e-5,
        tolerance: 1e-12,
        question: Question::Separation(38.2e-5),
    };
    let state = case.state().unwrap();
    assert!(state.pressure_pa.is_normal());
    assert!((state.pressure_pa.ln() - state.ln_pressure_pa).abs() < 1e-11, "{state:?}");
}

fn spiked(rows: usize, columns: usize, [length_x_m, length_y_m]: [f64; 2], height_m: f64) -> SmallMap {
    let mut heights_m = vec![0.0; rows * columns];
    heights_m[columns / 2] = height_m;
    SmallMap { rows, columns, length_x_m, length_y_m, heights_m }
}

/// A load that moves less than the heights are rounded to gave NaN; it is refused.
#[test]
fn a_ball_under_a_load_below_the_rounding_of_the_heights_is_refused() {
    let ball = BallCase {
        map: spiked(4, 4, [1.2036642746897419e-11, 2.802228278385977e-12], 0.49792903424770235),
        contact_modulus_pa: 2885511.4019242525,
        radius_m: 4.882214895294587e-10,
        force_n: 9.545004806702004e-24,
        tolerance: 1.64254788838392e-10,
    };
    assert!(!assert_sound(&ball));
}

/// A spike under no load, which the attraction of the rest does not hold.
#[test]
fn a_spike_without_load() {
    let case = AdhesionCase {
        map: spiked(8, 12, [100.06432714872398, 424.74909658232394], 408873.31991566997),
        contact_modulus_pa: 19322258472.63324,
        work_j_per_m2: 1845086356609.396,
        range_m: 603.205956108081,
        control: Control::PressurePa(0.0),
        from_contact: true,
        tolerance: 6.17559183008778e-6,
    };
    assert_sound(&case);
}

/// Two wavelengths that agree to rounding have one wavevector, and no slope between them: moments of the area were NaN.
#[test]
fn wavelengths_that_agree_to_rounding_are_refused() {
    let wavelength_m = 3.3751749523053838e-9f64;
    let rows = vec![
        (9.06925765397715e-6, 5e-23),
        (wavelength_m, 4.6e-29),
        (wavelength_m.next_down(), 4.6e-29),
        (1e-9, 1e-30),
    ];
    assert!(!assert_sound(&SpectraCase { rows, per_decade: 57 }));
}

/// Densities of 1e308 m^3 made moments infinite, and a capacity overflow.
#[test]
fn densities_that_no_surface_has_are_refused() {
    let rows = vec![(1.4e-5, 8e-13), (2.6e-6, f64::MAX), (8e-7, 1.9e307), (1e-8, 1e-155)];
    assert!(!assert_sound(&SpectraCase { rows, per_decade: 6 }));
    assert!(!assert_sound(&SpectraCase { rows: vec![(1e-5, 1e-20), (1e-6, 5e-324)], per_decade: 6 }));
}

/// Shares near 1 and shares below the smallest double were mirrored to NaN.
#[test]
fn intervals_of_areas_at_both_ends() {
    for draws in
        [vec![2.0687e-320, 2.0586e-319], vec![-745.0, -1e-300, -3.0, 1e-12], vec![740.0, 700.0, 600.0]]
    {
        for best in [-1.43e-322, -40.0, -745.0] {
            assert!(assert_sound(&IntervalsCase { draws: draws.clone(), best, level: 0.68 }));
        }
    }
}

/// Draws of 1e-161 lost the digits of their variance, and draws of 1e200 overflowed it.
#[test]
fn draws_of_every_size() {
    let shape = [
        -2.89, 2.40, -0.38, -1.14, 1.46, 1.97, 1.11, 1.88, 0.50, -0.45, -2.91, -1.75, 1.0, -1.27, 0.86, -1.2,
        -2.6,
    ];
    for size in [1e-161, 1.0, 1e200] {
        let draws: Vec<f64> = shape.iter().map(|value| size * value).collect();
        assert!(assert_sound(&IntervalsCase { best: draws[0], draws, level: 0.95 }));
    }
}

/// Overclosures that agree to the last digit of the first gap came back with another pressure; such a range is refused.
#[test]
fn a_law_whose_overclosures_are_lost_is_refused() {
    let case = LawTablesCase {
        shape: Shape::Power(2.5928659738173483),
        length_m: 4.440566203637786e-8,
        range_pa: [1894.6719479376054, 12086779709512.742],
        tolerance: 0.22524262558893815,
        units: interface::finite_elements::UnitSystem::Inches,
    };
    assert!(!assert_sound(&case));
    let huge = LawTablesCase {
        shape: Shape::Plateau(49.8),
        length_m: f64::MAX,
        range_pa: [3.4, 7.0],
        tolerance: 1e-5,
        ..case
    };
    assert!(!assert_sound(&huge));
}

/// Lengths near the smallest double, times a difference of pressures, came out below it.
#[test]
fn a_law_with_gaps_near_the_smallest_double() {
    let case = LawTablesCase {
        shape: Shape::Exponential,
        length_m: 2.2250738585072014e-308,
        range_pa: [57.09081650557628, 57.090816590051084],
        tolerance: 1.5245969905620373e-5,
        units: interface::finite_elements::UnitSystem::Si,
    };
    assert!(assert_sound(&case));
}

fn profile(heights_m: Vec<f64>, missing: Vec<usize>) -> DrawnScan {
    let length_m = 4.9e-6;
    let columns = heights_m.len();
    let (rows, positions_m) = (None, None);
    DrawnScan { columns, rows, length_x_m: length_m, length_y_m: length_m, heights_m, missing, positions_m }
}

/// Heights that are equal but for a pit gave peaks beyond the valleys, by a slope of rounding.
#[test]
fn a_plateau_with_a_pit() {
    let mut heights_m = vec![1.7004798150183264e-7; 9];
    heights_m[1] = 1.700475058418851e-7;
    let scan = profile(heights_m, vec![3]);
    let form = roughness::FormRemoval::None;
    assert!(assert_sound(&RoughnessCase { scan, form, cutoffs_m: [None, None] }));
}

/// A filter drops the only point of a profile that has a height: a panic.
#[test]
fn a_profile_without_heights_behind_its_filter() {
    let heights_m: Vec<f64> = (0..26).map(|at| 1e-7 * f64::from(at % 7)).collect();
    let scan = profile(heights_m, (0..25).collect());
    let form = roughness::FormRemoval::Plane;
    assert!(!assert_sound(&RoughnessCase { scan, form, cutoffs_m: [Some(9.02959175298666e-7), None] }));
}

/// Five points do not determine a form of six numbers: the transposed map had another one.
#[test]
fn fewer_points_than_the_form_has_numbers() {
    let mut heights_m = vec![-0.0016362023817578703; 16];
    heights_m[12] = -0.0018974200568570103;
    let missing = vec![0, 2, 3, 4, 7, 8, 9, 10, 11, 14, 15];
    let scan = DrawnScan { rows: Some(4), columns: 4, ..profile(heights_m, missing) };
    let form = roughness::FormRemoval::SecondOrder;
    assert!(assert_sound(&RoughnessCase { scan, form, cutoffs_m: [None, None] }));
}

/// Six points on two lines do not determine a form of six numbers either.
#[test]
fn points_on_two_lines_of_a_map() {
    let mut heights_m = vec![0.0; 20];
    heights_m[2] = 3.2791937194812533e-9;
    let missing = vec![1, 3, 4, 5, 7, 9, 10, 11, 13, 14, 15, 16, 17, 19];
    let scan = DrawnScan { rows: Some(5), columns: 4, ..profile(heights_m, missing) };
    let form = roughness::FormRemoval::SecondOrder;
    assert!(assert_sound(&RoughnessCase { scan, form, cutoffs_m: [None, None] }));
}

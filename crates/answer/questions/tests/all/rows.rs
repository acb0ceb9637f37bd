//! Contact laws row by row: single asperities, populations, and Persson's theory.

use std::f64::consts::PI;
use std::io::Cursor;

use asperity::{ElasticBody, ElasticPlasticSinusoid, Hardness, JacksonGreen, MaterialPair};
use numerics::parallel::Unobserved;
use persson::{constant_hardness, elastic, growing_hardness};
use questions::rows::asperity_table::AsperityTable;
use questions::rows::{
    Asperities, Flattened, GivenColumn, NarrowSpectra, Populations, RowByRow, RowRoughness, RowsError,
    StateCounts, StateRequest,
};
use questions::{LevelCounts, StatesQuestion};
use stat_contact::{AsperityLaw, Condition, Population, StatisticalContact};
use study::material::Material;
use study::models::ModelOptions;
use tables::{Cells, InputTable, TableSource};
use units::{Pressure, RemarkCode};

use crate::common::{
    Counted, STEEL_MODULUS_PA, assert_all_near, assert_near, column, filled, hard, has, model, note,
    numbers_of, steel, text_of,
};

fn table(rows: &str) -> InputTable {
    TableSource::new("rows.csv", Cursor::new(rows.to_owned().into_bytes())).unwrap().whole().unwrap()
}

/// Checks and fills a table.
fn fill(rows: &mut dyn RowByRow, text: &str) -> (InputTable, Vec<units::Remark>) {
    let mut block = table(text);
    rows.check(&block).unwrap_or_else(|refusal| panic!("{refusal}"));
    let notes = rows.fill_in(&mut block, &Unobserved).unwrap();
    (block, notes)
}

fn steel_body() -> ElasticBody {
    ElasticBody::new(200e9, 0.3).unwrap()
}

const BODY: &str = "youngs_modulus_pa,poisson_ratio,yield_strength_pa,indentation_hardness_pa";

#[test]
fn a_sphere_follows_hertz_and_jackson_and_green_whether_strength_or_hardness_is_given() {
    let text = format!(
        "{BODY},radius_m,interference_m\n200e9,0.3,1e9,,1e-3,1e-7\n200e9,0.3,,3e9,1e-3,1e-7\n\
         200e9,0.3,1e9,,1e-3,3e-4\n"
    );
    let mut spheres = Asperities::new(AsperityTable::Sphere, None);
    let (block, _) = fill(&mut spheres, &text);
    let hertz_n = |w: f64| 4.0 / 3.0 * STEEL_MODULUS_PA * (1e-3 * w.powi(3)).sqrt();
    let hertz_m2 = |w: f64| PI * 1e-3 * w;
    let pair = MaterialPair::against_rigid(steel_body());
    let [published, cosine] = [Hardness::JacksonGreen2005, Hardness::Cosine]
        .map(|hardness| JacksonGreen::new(&pair, 1e-3, 1e9, hardness));
    let ws = [1e-7, 1e-7, 3e-4];
    let expected: [(&str, &dyn Fn(f64) -> f64); 5] = [
        ("hertz_force_n", &hertz_n),
        ("hertz_area_m2", &hertz_m2),
        ("jackson_green_force_n", &|w| published.force_n(w)),
        ("jackson_green_area_m2", &|w| published.area_m2(w)),
        ("jackson_green_force_cosine_hardness_n", &|w| cosine.force_n(w)),
    ];
    assert_eq!(AsperityTable::Sphere.results(), expected.each_ref().map(|(name, _)| *name));
    for (name, of) in expected {
        assert_all_near(&filled(&block.table, name), &ws.map(of), 1e-12);
    }
    let notes = spheres.notes();
    assert_eq!(numbers_of(&notes, RemarkCode::AssumedStrengths, ["rows", "all"]), [1.0, 3.0]);
    assert_eq!(numbers_of(&notes, RemarkCode::RowsOutOfRange, ["rows", "all"]), [1.0, 3.0]);
    // The fit ends at a/R = 0.41.
    assert!(text_of(&notes, RemarkCode::RowsOutOfRange, "range").contains("0.41"));
    assert_eq!(spheres.unused(), ["strain_gradient_length_m"]);
    // The same rows once more are counted on.
    fill(&mut spheres, &text);
    assert_eq!(numbers_of(&spheres.notes(), RemarkCode::AssumedStrengths, ["rows", "all"]), [2.0, 6.0]);
    assert_eq!(numbers_of(&spheres.notes(), RemarkCode::RowsOutOfRange, ["rows", "all"]), [2.0, 6.0]);
}

#[test]
fn two_equal_bodies_halve_the_force_of_a_sphere() {
    let text = format!("{BODY},radius_m,interference_m\n200e9,0.3,1e9,,1e-3,1e-8\n");
    let [rigid, equal] = [None, Some(steel_body())].map(|counterface| {
        let (block, _) = fill(&mut Asperities::new(AsperityTable::Sphere, counterface), &text);
        filled(&block.table, "hertz_force_n")[0]
    });
    assert_near(equal, 0.5 * rigid, 1e-12);
}

#[test]
fn sinusoids_under_a_pressure_and_at_an_interference_follow_their_laws() {
    let pair = MaterialPair::against_rigid(steel_body());
    let sinusoid = ElasticPlasticSinusoid::new(&pair, 0.01, 1e9);
    // Complete contact of a sinusoid of amplitude D and wavelength L: sqrt(2) pi E* D/L.
    let complete_pa = 2f64.sqrt() * PI * STEEL_MODULUS_PA * 0.01;
    let mut by_pressure = Asperities::new(AsperityTable::Sinusoid, None);
    let (block, _) =
        fill(&mut by_pressure, &format!("{BODY},aspect_ratio,pressure_pa\n200e9,0.3,1e9,,0.01,5e8\n"));
    let expected = [
        ("complete_contact_pressure_elastic_pa", complete_pa),
        ("area_fraction_elastic", sinusoid.elastic().area_fraction(5e8)),
        ("critical_aspect_ratio", sinusoid.critical_aspect_ratio()),
        ("complete_contact_pressure_ep_pa", sinusoid.complete_contact_pressure_pa()),
        ("area_fraction_ep", sinusoid.area_fraction(5e8)),
        ("mean_gap_over_amplitude", sinusoid.mean_gap_over_amplitude(5e8)),
    ];
    assert_eq!(AsperityTable::Sinusoid.results(), expected.map(|(name, _)| name));
    for (name, value) in expected {
        assert_near(filled(&block.table, name)[0], value, 1e-12);
    }
    assert!(by_pressure.notes().is_empty());
    // An amplitude of 100 nm pressed by half of it.
    let mut by_way = Asperities::new(AsperityTable::SinusoidInterference, None);
    let header = format!("{BODY},wavelength_m,aspect_ratio,interference_m");
    let (block, _) =
        fill(&mut by_way, &format!("{header}\n200e9,0.3,1e9,,1e-5,0.01,5e-8\n200e9,0.3,1,,1e-5,0.9,5e-8\n"));
    let elastic_pa = sinusoid.elastic().pressure_at_interference_pa(0.5);
    let plastic_pa = sinusoid.pressure_at_interference_pa(0.5);
    let expected = [
        ("pressure_elastic_pa", elastic_pa),
        ("area_fraction_elastic", sinusoid.elastic().area_fraction(elastic_pa)),
        ("pressure_ep_pa", plastic_pa),
        ("area_fraction_ep", sinusoid.area_fraction(plastic_pa)),
    ];
    assert_eq!(AsperityTable::SinusoidInterference.results(), expected.map(|(name, _)| name));
    for (name, value) in expected {
        assert_near(filled(&block.table, name)[0], value, 1e-12);
    }
    // The soft and steep one lies beyond B/B_c = 100.
    assert_eq!(numbers_of(&by_way.notes(), RemarkCode::RowsOutOfRange, ["rows", "all"]), [1.0, 2.0]);
    assert!(text_of(&by_way.notes(), RemarkCode::RowsOutOfRange, "range").contains("100"));
}

#[test]
fn bad_cells_and_missing_columns_of_asperities_are_refused_before_anything_is_computed() {
    for law in [AsperityTable::Sphere, AsperityTable::Sinusoid, AsperityTable::SinusoidInterference] {
        let of = |cells: &str| {
            let names = "radius_m,interference_m,aspect_ratio,pressure_pa,wavelength_m";
            let block = table(&format!("{BODY},{names}\n{cells}\n"));
            (law.check(&block).is_ok(), Asperities::new(law, None).check(&block).is_ok())
        };
        assert_eq!(of("200e9,0.3,1e9,,1e-3,1e-7,0.1,1e6,1e-5"), (true, true));
        for bad in [
            "200e9,0.3,,,1e-3,1e-7,0.1,1e6,1e-5",
            "200e9,0.3,1e9,5e9,1e-3,1e-7,0.1,1e6,1e-5",
            "200e9,0.6,1e9,,1e-3,1e-7,0.1,1e6,1e-5",
            "200e9,0.3,1e9,,-1,-1,-1,-1,-1",
        ] {
            assert_eq!(of(bad), (false, false), "{law:?}: {bad}");
        }
        let without = table("youngs_modulus_pa,poisson_ratio\n200e9,0.3\n");
        assert!(law.check(&without).is_err(), "{law:?}");
    }
}

#[test]
fn strengths_hardnesses_and_gradients_that_no_row_of_asperities_uses_are_found() {
    let unused = |columns: &str, cells: &str| {
        let text = format!("youngs_modulus_pa,poisson_ratio,{columns},radius_m,interference_m\n");
        let rows = format!("200e9,0.3,{cells},1e-3,1e-7\n").repeat(2);
        let mut spheres = Asperities::new(AsperityTable::Sphere, None);
        spheres.check(&table(&(text + &rows))).unwrap();
        assert!(spheres.unused_option().is_none());
        spheres.unused()
    };
    let [strength, hardness, gradient] =
        ["yield_strength_pa", "indentation_hardness_pa", "strain_gradient_length_m"];
    assert_eq!(unused(strength, "1e9"), [hardness, gradient]);
    assert_eq!(unused(hardness, "3e9"), [strength, gradient]);
    // A hardness beside a strength changes nothing.
    assert_eq!(unused(&format!("{strength},{hardness}"), "1e9,3e9"), [hardness, gradient]);
}

#[test]
fn rows_of_perssons_theory_are_elastic_hard_or_hardening_as_their_cells_say() {
    let text = "pressure_pa,rms_pressure_pa,hardness_pa,hardness_growth\n1e6,5e7,,\n1e6,0,,\n1e6,5e7,2e7,\n1e6,5e7,2e7,0.01\n\
                3e7,5e7,2e7,\n2e7,5e7,2e7,0\n";
    let elastic_row = |p: f64| [elastic::area_fraction(p, 5e7), elastic::area_fraction(p, 5e7), 0.0];
    let row = |areas: persson::ContactAreas| [areas.contact(), areas.elastic, areas.plastic];
    let expected = [
        elastic_row(1e6),
        [1.0, 1.0, 0.0],
        row(constant_hardness::areas(1e6, 5e7, 2e7)),
        row(growing_hardness::areas_of_squared_growth(1e6, 5e7, 2e7, 0.01)),
        [1.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
    ];
    let areas = |rows: &mut Flattened, text: &str| {
        let (block, _) = fill(rows, text);
        let names = ["area_fraction", "elastic_area_fraction", "plastic_area_fraction"];
        let [all, elastic, plastic] = names.map(|name| filled(&block.table, name));
        (0..all.len()).map(|at| [all[at], elastic[at], plastic[at]]).collect::<Vec<_>>()
    };
    let mut rows = Flattened::new(None);
    for (found, expected) in areas(&mut rows, text).iter().zip(&expected) {
        found.iter().zip(expected).for_each(|(found, expected)| assert!((found - expected).abs() < 1e-12));
    }
    assert_eq!(numbers_of(&rows.notes(), RemarkCode::FlowingRows, ["rows", "all"]), [2.0, 6.0]);
    assert!(rows.unused().is_empty());
    areas(&mut rows, text);
    assert_eq!(numbers_of(&rows.notes(), RemarkCode::FlowingRows, ["rows", "all"]), [4.0, 12.0]);
    // Rows that must not yield ignore their hardnesses, whatever they are.
    let mut elastic_rows = Flattened::new(Some(false));
    let found = areas(&mut elastic_rows, text);
    assert_all_near(&found[4], &elastic_row(3e7), 1e-12);
    assert!(elastic_rows.notes().is_empty());
    assert_eq!(elastic_rows.unused(), ["hardness_pa", "hardness_growth"]);
    assert!(elastic_rows.depends_on("pressure_pa") && !elastic_rows.knows("pressure_pa"));
}

#[test]
fn rows_of_perssons_theory_that_cannot_be_carried_are_refused() {
    let is_fine = |yields: Option<bool>, cells: &str| {
        let text = format!("pressure_pa,rms_pressure_pa,hardness_pa,hardness_growth\n{cells}\n");
        let mut rows = Flattened::new(yields);
        let mut block = table(&text);
        let is_checked = rows.check(&block).is_ok();
        let filled = rows.fill_in(&mut block, &Unobserved);
        assert_eq!(is_checked, !matches!(filled, Err(RowsError::Refused(_))), "{cells}");
        is_checked
    };
    // A hardness that grows carries no pressure above it at the longest wavelength.
    assert!(!is_fine(None, "2e7,5e7,2e7,0.01") && is_fine(None, "1e7,5e7,2e7,0.01"));
    // Growth without a hardness.
    assert!(!is_fine(None, "1e6,5e7,,0.01") && is_fine(Some(false), "1e6,5e7,,0.01"));
    assert!(is_fine(None, "1e6,5e7,,0") && !is_fine(Some(true), "1e6,5e7,,"));
    // Spreads are 0 or of a size that numbers have.
    assert!(is_fine(None, "1e6,0,,") && !is_fine(None, "1e6,1e-40,,") && !is_fine(None, "1e6,-1,,"));
    let mut rows = table("pressure_pa,rms_pressure_pa\n1e6,1e7\n");
    let stopped = Flattened::new(None).fill_in(&mut rows, &Counted::cancelled());
    assert!(matches!(stopped, Err(RowsError::Cancelled)));
}

const POPULATION: &str = "model,youngs_modulus_pa,poisson_ratio,yield_strength_pa,indentation_hardness_pa,\
                          strain_gradient_length_m,radius_m,density_per_m2,sigma_s_m,m0_m2,m2,m4_per_m2,separation_m,\
                          pressure_pa";

/// A table of populations with some of its choices.
fn populations(choose: impl FnOnce(&mut Populations)) -> Populations {
    let mut rows = Populations::default();
    choose(&mut rows);
    rows
}

/// The state of elastic spheres of steel with a radius of 1 um and heights of 10 nm.
fn spheres() -> StatisticalContact {
    let population = Population::new(1e-6, 1e12, 1e-8).unwrap();
    StatisticalContact::new(&MaterialPair::against_rigid(steel_body()), &population, &AsperityLaw::Hertz)
}

#[test]
fn a_population_is_pressed_to_the_separation_or_under_the_pressure_that_its_row_gives() {
    let text = format!(
        "{POPULATION}\nhertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,2.0e-8,\nhertz,200e9,0.3,,,5e-6,1e-6,1e12,1e-8,,,,,1.0e6\n\
         hertz,200e9,0.3,,,,,,,,,,,1e6\nbgt,200e9,0.3,,,,,,,1e-16,1e-2,1e11,1e-8,\n"
    );
    let mut rows = populations(|rows| rows.details = true);
    let progress = Counted::new();
    let mut block = table(&text);
    rows.check(&block).unwrap();
    assert!(rows.fill_in(&mut block, &progress).unwrap().is_empty());
    assert_eq!(progress.count(), 2);
    let at = spheres().at_separation(2e-8, 1e-12).unwrap();
    let under = spheres().at_pressure(1e6, 1e-12, None).unwrap();
    let areas = column(&block.table, "area_fraction");
    assert_all_near(&[areas[0].unwrap(), areas[1].unwrap()], &[at.area_fraction, under.area_fraction], 1e-9);
    assert_eq!(&areas[2..], [None, None]);
    assert_near(column(&block.table, "pressure_pa")[0].unwrap(), at.pressure_pa, 1e-9);
    assert_near(column(&block.table, "separation_m")[1].unwrap(), under.separation_m.unwrap(), 1e-9);
    assert_near(column(&block.table, "ln_pressure_pa")[1].unwrap(), 1e6f64.ln(), 1e-12);
    // Given cells stay as they were typed.
    for (name, row, typed) in [("separation_m", 0, "2.0e-8"), ("pressure_pa", 1, "1.0e6")] {
        let Some(Cells::Typed(cells)) = block.table.column(name) else { panic!("{name}") };
        assert_eq!(cells[row].text(), typed);
    }
    let notes = rows.notes();
    assert_eq!(numbers_of(&notes, RemarkCode::RowsWithoutAsperities, ["rows", "all"]), [1.0, 4.0]);
    assert_eq!(numbers_of(&notes, RemarkCode::NarrowSpectra, ["narrow", "all"]), [1.0, 4.0]);
    // No elastic model has a strength, but the plasticity index among the details has.
    assert_eq!(rows.unused(), ["strain_gradient_length_m"]);
    rows.details = false;
    assert_eq!(rows.unused(), ["yield_strength_pa", "indentation_hardness_pa", "strain_gradient_length_m"]);
    rows.fill_in(&mut table(&text), &Unobserved).unwrap();
    assert_eq!(numbers_of(&rows.notes(), RemarkCode::RowsWithoutAsperities, ["rows", "all"]), [2.0, 8.0]);
}

#[test]
fn equal_bodies_halve_the_pressure_of_a_population_at_a_separation() {
    let text = format!("{POPULATION}\nhertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,1e-8,\n");
    let [rigid, equal] = [None, Some(steel_body())].map(|counterface| {
        let (block, _) = fill(&mut populations(|rows| rows.counterface = counterface), &text);
        filled(&block.table, "pressure_pa")[0]
    });
    assert_near(equal, 0.5 * rigid, 1e-9);
}

#[test]
fn a_population_yields_by_its_strength_or_a_third_of_its_hardness_which_gradients_raise() {
    let text = format!(
        "{POPULATION}\nep-sphere,200e9,0.3,1e9,,,1e-6,1e12,1e-8,,,,0,\nep-sphere,200e9,0.3,,3e9,,1e-6,1e12,1e-8,,,,0,\n\
         ep-sphere,200e9,0.3,1e9,,1e-6,1e-6,1e12,1e-8,,,,0,\nhertz,200e9,0.3,,1e6,,1e-6,1e12,1e-8,,,,0,\n"
    );
    let pressures = |strength_cap: Option<Pressure>| {
        let mut rows = populations(|rows| rows.strength_cap = strength_cap);
        let (block, _) = fill(&mut rows, &text);
        (filled(&block.table, "pressure_pa"), rows)
    };
    let (free, rows) = pressures(None);
    assert_eq!(free[0], free[1]);
    assert!(free[2] > 1.01 * free[0] && free[3] > free[2], "{free:?}");
    let notes = rows.notes();
    assert_eq!(numbers_of(&notes, RemarkCode::AssumedStrengths, ["rows", "all"]), [1.0, 4.0]);
    assert_eq!(numbers_of(&notes, RemarkCode::RowsAboveHardness, ["rows", "all"]), [1.0, 4.0]);
    // A strength that may not grow is one that does not.
    let (capped, rows) = pressures(Some(Pressure::Pascals(1e9)));
    assert_near(capped[2], free[0], 1e-9);
    assert!(rows.unused_option().is_none());
    assert_eq!(rows.unused(), ["m0_m2", "m2", "m4_per_m2", "pressure_pa"]);
}

#[test]
fn loads_beyond_complete_contact_or_all_flattened_asperities_are_named_row_by_row() {
    let text = format!(
        "{POPULATION}\nelastic-sine,200e9,0.3,,,,1e-6,1e12,1e-8,,,,,1e14\n\
         ep-sphere,200e9,0.3,1e8,,,1e-6,1e12,1e-8,,,,,1e14\nhertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,,1e6\n"
    );
    let mut rows = Populations::default();
    let (block, found) = fill(&mut rows, &text);
    assert_eq!(
        found.iter().map(|note| note.code).collect::<Vec<_>>(),
        [RemarkCode::BeyondCompleteContact, RemarkCode::BeyondFlattened]
    );
    for note in &found {
        assert_eq!(note.number("pressure_pa"), Some(1e14));
        assert!(note.number("highest_pressure_pa").unwrap() < 1e14);
    }
    let separations = column(&block.table, "separation_m");
    assert!(separations[0].is_none() && separations[1].is_none() && separations[2].is_some());
    // They are not counted once more.
    let notes = rows.notes();
    assert!(!has(&notes, RemarkCode::IncompleteStates) && !has(&notes, RemarkCode::FlattenedStates));
    assert_eq!(rows.unused(), ["m0_m2", "m2", "m4_per_m2", "separation_m"]);
}

#[test]
fn rows_of_populations_that_lack_something_are_refused_with_the_column() {
    let refusal = |given: Option<GivenColumn>, row: &str| {
        let mut rows = populations(|rows| rows.given = given);
        rows.check(&table(&format!("{POPULATION}\n{row}\n"))).err().map(|refusal| refusal.to_string())
    };
    let (separation, pressure) = (Some(GivenColumn::Separation), Some(GivenColumn::Pressure));
    for (given, row, column) in [
        (None, "soap,200e9,0.3,,,,1e-6,1e12,1e-8,,,,0,", "model"),
        (None, "hertz,200e9,0.7,,,,1e-6,1e12,1e-8,,,,0,", "poisson_ratio"),
        (None, "ep-sphere,200e9,0.3,,,,1e-6,1e12,1e-8,,,,0,", "yield_strength_pa"),
        (None, "ep-sphere,200e9,0.3,1e9,1e9,,1e-6,1e12,1e-8,,,,0,", "indentation_hardness_pa"),
        (None, "ep-sphere,200e9,0.3,1e9,,-1,1e-6,1e12,1e-8,,,,0,", "strain_gradient_length_m"),
        (None, "hertz,200e9,0.3,,,,1e-6,,1e-8,,,,0,", "density_per_m2"),
        (None, "hertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,0,1e6", "separation_m"),
        (None, "hertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,,", "pressure_pa"),
        (None, "hertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,,-1", "pressure_pa"),
        (separation, "hertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,,1e6", "separation_m"),
        (pressure, "hertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,0,", "pressure_pa"),
    ] {
        let words = refusal(given, row).unwrap_or_else(|| panic!("{row} is not refused"));
        assert!(words.contains(column), "{words}");
    }
    for given in [separation, pressure] {
        assert_eq!(refusal(given, "hertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,0,1e6"), None);
    }
    // Spheres need their three columns, and summits theirs; a table of both needs all.
    let is_fine = |roughness: &str, models: &[&str]| {
        let rows = models.iter().map(|model| format!("{model},200e9,0.3,0\n")).collect::<String>();
        let text = format!("model,youngs_modulus_pa,poisson_ratio,separation_m{roughness}\n");
        let empty = roughness.matches(',').map(|_| ",").collect::<String>();
        Populations::default().check(&table(&(text + &rows.replace(",0\n", &format!(",0{empty}\n"))))).is_ok()
    };
    let (asperities, moments) = (",radius_m,density_per_m2,sigma_s_m", ",m0_m2,m2,m4_per_m2");
    assert!(is_fine(asperities, &["hertz"]) && !is_fine(moments, &["hertz"]) && !is_fine("", &["hertz"]));
    assert!(is_fine(moments, &["bgt"]) && !is_fine(asperities, &["bgt"]));
    assert!(!is_fine(moments, &["bgt", "hertz"]) && !is_fine(asperities, &["bgt", "hertz"]));
    assert!(is_fine(&format!("{asperities}{moments}"), &["bgt", "hertz"]));
    assert!(is_fine(asperities, &[]) && !is_fine(moments, &[]));
    let mut rows = Populations::default();
    let mut block = table(&format!("{POPULATION}\nhertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,0,\n"));
    assert!(matches!(rows.fill_in(&mut block, &Counted::cancelled()), Err(RowsError::Cancelled)));
}

#[test]
fn columns_and_options_that_no_population_depends_on_are_found() {
    let hertz = table(&format!("{POPULATION}\nhertz,200e9,0.3,,,,1e-6,1e12,1e-8,,,,0,\n"));
    let sphere = table(&format!("{POPULATION}\nep-sphere,200e9,0.3,1e9,,,1e-6,1e12,1e-8,,,,0,\n"));
    let grows = table(&format!("{POPULATION}\nep-sphere,200e9,0.3,1e9,,1e-6,1e-6,1e12,1e-8,,,,0,\n"));
    let summits = table(&format!("{POPULATION}\nbgt,200e9,0.3,,,,,,,1e-16,1e-2,1e13,,1e6\n"));
    let hardness = || populations(|rows| rows.options.hardness = Some(Hardness::Cosine));
    let cap = || populations(|rows| rows.strength_cap = Some(Pressure::Pascals(2e9)));
    let unused = |rows: Populations, blocks: &[&InputTable]| {
        let mut rows = rows;
        blocks.iter().for_each(|block| rows.check(block).unwrap());
        (rows.unused_option(), rows.unused())
    };
    assert_eq!(unused(hardness(), &[]).0, None);
    assert_eq!(unused(hardness(), &[&hertz]).0, Some("hardness_formula"));
    assert_eq!(unused(hardness(), &[&hertz, &sphere]).0, None);
    assert_eq!(unused(cap(), &[&sphere]).0, Some("strength_cap"));
    assert_eq!(unused(cap(), &[&grows, &sphere]).0, None);
    let gradient = ModelOptions { strain_gradient: true, ..ModelOptions::default() };
    assert_eq!(unused(populations(|rows| rows.options = gradient), &[&hertz]).0, None);
    let strengths = ["yield_strength_pa", "indentation_hardness_pa", "strain_gradient_length_m"];
    let asperities = ["radius_m", "density_per_m2", "sigma_s_m"];
    let of_summits = [&strengths[..], &asperities, &["separation_m"]].concat();
    assert_eq!(unused(Populations::default(), &[&summits]).1, of_summits);
    assert_eq!(unused(Populations::default(), &[&summits, &hertz]).1, strengths);
    assert!(unused(Populations::default(), &[&summits, &sphere]).1.is_empty());
    let rows = Populations::default();
    assert!(rows.knows("pressure_pa") && !rows.knows("rms_pressure_pa"));
}

/// The request of a row of spheres with heights of 10 nm.
fn request<'m>(material: &'m Material, radius_m: f64, at: Condition) -> StateRequest<'m> {
    StateRequest { material, roughness: RowRoughness([radius_m, 1e12, 1e-8]), at }
}

#[test]
fn states_of_arrays_are_counted_over_all_blocks_of_rows() {
    // Two blocks of rows: a hardness of 3 GPa, none, and a radius that is no radius.
    let [hard, plain] = [hard(3e9), steel()].map(|material| material.material().unwrap());
    let asked = |row: usize| match row % 3 {
        0 => request(&hard, 1e-6, Condition::Pressure(1e6)),
        1 => request(&hard, 2e-6, Condition::Pressure(1e6)),
        _ => request(&hard, -1.0, Condition::Pressure(1e6)),
    };
    let question =
        StatesQuestion { model: model("ep-sphere"), skips_bad_rows: true, ..StatesQuestion::default() };
    let progress = Counted::new();
    let (columns, found) = question.states().unwrap().compute(3000, asked, &progress).unwrap();
    assert_eq!(progress.count(), 3000);
    assert_eq!((found.counts.all, found.assumed_strengths, found.bad), (2000, 2000, 1000));
    assert_eq!(found.first_bad, Some(2));
    assert!(columns.iter().all(|column| column[2].is_nan() && column[3].is_finite()));
    assert_eq!(columns[1][2998], 1e6);
    let notes = question.notes_on(std::iter::once(&hard), &found, 3000);
    assert_eq!(numbers_of(&notes, RemarkCode::AssumedStrengths, ["rows", "all"]), [2000.0, 3000.0]);
    assert_eq!(numbers_of(&notes, RemarkCode::BadRows, ["rows", "all"]), [1000.0, 3000.0]);
    assert_eq!(note(&notes, RemarkCode::BadRows).unwrap().place.row, Some(2));
    // A strength of its own is not assumed, and elastic spheres assume none.
    let strong = questions::MaterialInput { yield_strength: Some(Pressure::Pascals(1e9)), ..steel() };
    let strong = strong.material().unwrap();
    for (name, material, refused) in
        [("ep-sphere", &strong, false), ("hertz", &hard, false), ("ep-sphere", &plain, true)]
    {
        let question = StatesQuestion { model: model(name), ..StatesQuestion::default() };
        let asked =
            |row: usize| request(material, if row < 4 { 1e-6 } else { 2e-6 }, Condition::Pressure(1e6));
        match question.states().unwrap().compute(5, asked, &Unobserved) {
            Ok((_, found)) => assert_eq!((found.assumed_strengths, refused), (0, false), "{name}"),
            Err(error) => assert!(refused && matches!(error, RowsError::Row { row: 0, .. }), "{error}"),
        }
    }
    let stopped = question.states().unwrap().compute(3000, asked, &Counted::cancelled());
    assert!(matches!(stopped, Err(RowsError::Cancelled)));
    assert!(StatesQuestion::default().check().is_err());
    let options = ModelOptions { hardness: Some(Hardness::Cosine), ..ModelOptions::default() };
    assert!(StatesQuestion { options, model: model("hertz"), ..StatesQuestion::default() }.check().is_err());
}

#[test]
fn narrow_spectra_of_arrays_are_counted_over_all_blocks_with_the_range_of_alpha() {
    let steel = steel().material().unwrap();
    // m0 m4/m2^2 is 1.4996 at first, 1.2 in the second block, and 10 in between.
    let asked = |row: usize| StateRequest {
        material: &steel,
        roughness: RowRoughness([
            1e-16,
            1e-2,
            match row {
                0 => 1.4996e12,
                2999 => 1.2e12,
                _ => 1e13,
            },
        ]),
        at: Condition::Separation(1e-8),
    };
    let question = StatesQuestion { model: model("bgt"), ..StatesQuestion::default() };
    let (_, found) = question.states().unwrap().compute(3000, asked, &Unobserved).unwrap();
    let notes = question.notes_on(std::iter::once(&steel), &found, 3000);
    assert_eq!(numbers_of(&notes, RemarkCode::NarrowSpectra, ["narrow", "all"]), [2.0, 3000.0]);
    // Rounded down, or the first would read 1.5, from which on there are summits.
    assert_eq!(text_of(&notes, RemarkCode::NarrowSpectra, "alphas"), "1.2 to 1.499");
    let mut one = NarrowSpectra::default();
    assert!(one.remark(3).is_none());
    one.add(1.25);
    let notes: Vec<_> = one.remark(3).into_iter().collect();
    assert_eq!(text_of(&notes, RemarkCode::NarrowSpectra, "alphas"), "1.25");
}

#[test]
fn a_soft_gel_presses_above_its_hardness_only_if_that_is_less_than_its_real_pressure() {
    let body = |hardness_pa: f64| questions::MaterialInput {
        youngs_modulus_pa: Some(100.0),
        poisson_ratio: Some(0.3),
        indentation_hardness_pa: Some(hardness_pa),
        ..questions::MaterialInput::default()
    };
    let question = StatesQuestion { model: model("hertz"), ..StatesQuestion::default() };
    let pressed = |hardness_pa: f64| {
        let material = body(hardness_pa).material().unwrap();
        let asked = |_: usize| request(&material, 1e-6, Condition::Separation(1e-8));
        let (columns, found) = question.states().unwrap().compute(1, asked, &Unobserved).unwrap();
        (columns[1][0] / columns[2][0], found.above_hardness)
    };
    let (real_pa, _) = pressed(50.0);
    assert!(real_pa > 1.0 && real_pa < 50.0, "{real_pa}");
    let above = |share: f64| pressed(share * real_pa).1;
    assert_eq!([0.99, 1.0, 1.01].map(above), [1, 0, 0]);
}

#[test]
fn states_at_a_bound_or_outside_their_law_are_counted_by_kind() {
    let pressed = |name: &str, strength_pa: f64, pressure_pa: f64| {
        let input =
            questions::MaterialInput { yield_strength: Some(Pressure::Pascals(strength_pa)), ..steel() };
        let material = input.material().unwrap();
        let question = StatesQuestion { model: model(name), ..StatesQuestion::default() };
        let asked = |_: usize| request(&material, 1e-6, Condition::Pressure(pressure_pa));
        question.states().unwrap().compute(2, asked, &Unobserved).unwrap().1.counts
    };
    let light = pressed("hertz", 1e9, 1e6);
    assert_eq!(
        light,
        StateCounts { all: 2, flattened_share: light.flattened_share, ..StateCounts::default() }
    );
    let complete = pressed("elastic-sine", 1e9, 1e14);
    let flattened = pressed("ep-sphere", 1e8, 1e14);
    let far = pressed("ep-sphere", 3e9, 1e8);
    assert_eq!((complete.incomplete, complete.flattened), (2, 0));
    assert_eq!((flattened.incomplete, flattened.flattened), (0, 2));
    // Jackson and Green fitted strengths up to E*/100.
    assert_eq!((far.out_of_range, far.all), (2, 2));
    let crowded = pressed("hertz", 1e9, 1e12);
    assert_eq!(crowded.clamped, 2);
    let mut all = StateCounts::default();
    [light, complete, flattened, far, crowded, crowded].into_iter().for_each(|counts| all += counts);
    all += StateCounts { flattened_share: 0.25, ..StateCounts::default() };
    let remarks = all.remarks();
    for (code, states) in [
        (RemarkCode::IncompleteStates, 2.0),
        (RemarkCode::FlattenedStates, 2.0),
        (RemarkCode::ClampedStates, all.clamped as f64),
        (RemarkCode::StatesOutOfRange, all.out_of_range as f64),
    ] {
        assert_eq!(numbers_of(&remarks, code, ["states", "all"]), [states, 12.0], "{code:?}");
    }
    let sum = |of: fn(&StateCounts) -> usize| -> usize {
        [light, complete, flattened, far, crowded, crowded].iter().map(of).sum()
    };
    assert_eq!((all.clamped, all.out_of_range), (sum(|one| one.clamped), sum(|one| one.out_of_range)));
    assert_eq!(numbers_of(&remarks, RemarkCode::FlattenedAsperities, ["share"]), [0.25]);
    // One flattened asperity in a hundred does not show.
    let seen = |flattened_share| StateCounts { flattened_share, ..StateCounts::default() }.remarks().len();
    assert_eq!([0.0, 0.01, 0.02].map(seen), [0, 0, 1]);
    assert!(LevelCounts::default().remark().is_none());
}

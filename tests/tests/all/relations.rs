//! Relations between results of two questions (metamorphic tests), on scenes made from drawn parts. Tables as CSV and JSON,
//! and commands against scenes, are compared in `crates/apps/cli/tests/all/relations.rs`.
//!
//! | relation | tolerance | reason |
//! |---|---|---|
//! | exchanged bodies, every model | 1e-12 | E* and the body that yields have no order; both are equally rough |
//! | exchanged spectra of both bodies | 1e-12 | the sum of two spectra has no order |
//! | stresses times 2^k | 1e-12 | areas depend on ratios of stresses; powers of two leave only the printed digits |
//! | units of stresses | 1e-12 | GPa, MPa and Pa name the same stress |
//! | a pressure in H against Pa | 1e-12 | the hardness is a stress like any other |
//! | only E* counts in elastic models | 1e-12 | moduli and Poisson's ratios enter through E* alone |
//! | two equal bodies against half the modulus and a rigid one | 1e-12 | 1/E* adds up |
//! | strength beyond all stresses | 1e-9 | nothing flows |
//! | a load alone or among others, loads in another order | 0 | each load is computed as if it were alone |
//! | curves alone or among others, in another order | 0 | so is each curve |
//! | comments, blank lines, line ends, order of sections in a scene | 0 | they mean nothing |
//! | heights times 2^k and pressures times 2^k, elastic models | 1e-9 | areas depend on p/(E* h') |
//! | lengths times 2^k in all directions | 1e-9 | nothing but the strain gradient has a length of its own |
//! | units of wavelengths and spectra; wavevectors | 1e-9 | one spectrum in other units |
//! | JSON against CSV | 0 | the same numbers in other marks |
//! | order of rows and columns, line ends, comments, separators of a spectrum | 0 | they mean nothing |
//! | more pressure, more area | - | no theory loses contact under load |
//! | order of scans | 1e-12 | sums in another order |
//! | a scan given twice | 1e-12 | it is the same surface |
//! | transposed maps, along the other axis | 1e-12 | an axis has no name |
//! | maps mirrored across their lines | 1e-12 | the mean over lines has no order |
//! | maps mirrored along their lines, lines read backwards | 1e-9 | spectrum and window are even |
//! | heights upside down | 0 | squares |
//! | heights times 2^k | 1e-12 | squares |
//! | a level added, a tilt added | 1e-6 | both are subtracted; the tilt leaves rounding |
//! | units of heights, separators, line ends of scans | 1e-12 | one scan written otherwise |
//! | size times 10 | 1e-9 | wavelengths and values grow with the size; bins are tenths of a decade |

use std::collections::BTreeMap;

use measurements::{CompositeOfFiles, ScanRequest};
use scene::{Overrides, Scene};
use study::models::{Choice, MODELS};
use topography::{Recipe, Window};

/// An elastic-plastic body: Young's modulus and strength in Pa, Poisson's ratio.
#[derive(Clone, Copy)]
struct Solid {
    modulus_pa: f64,
    strength_pa: f64,
    poisson_ratio: f64,
}

impl Solid {
    /// Draws moduli of 50 to 450 GPa, strengths of 0.1 to 5 GPa, and Poisson's ratios of 0.05 to 0.48.
    fn draw(dice: &mut Dice) -> Self {
        Solid {
            modulus_pa: 50e9 * 9f64.powf(dice.number()),
            strength_pa: 0.1e9 * 50f64.powf(dice.number()),
            poisson_ratio: 0.05 + 0.43 * dice.number(),
        }
    }

    fn times(self, factor: f64) -> Self {
        Solid { modulus_pa: factor * self.modulus_pa, strength_pa: factor * self.strength_pa, ..self }
    }

    fn keys(&self) -> String {
        format!(
            "youngs_modulus = \"{} Pa\"\npoisson_ratio = {}\nyield_strength = \"{} Pa\"\n",
            self.modulus_pa, self.poisson_ratio, self.strength_pa
        )
    }
}

/// Numbers in [0, 1) from a linear congruential generator.
pub(crate) struct Dice(pub u64);

impl Dice {
    pub(crate) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A scene of two equally rough bodies with every model that yields.
fn scene(material: Solid, counterface: Solid, pressures_pa: &[f64]) -> String {
    let pressures: Vec<String> = pressures_pa.iter().map(|pressure_pa| format!("{pressure_pa} Pa")).collect();
    let curves = curves_of(|_| true);
    format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\n{}[counterface]\n{}\
         [counterface.surface]\npsd = \"builtin:uncd-measured\"\n[loads]\npressures = {pressures:?}\n\
         [options]\nscales_per_decade = 4\n{curves}",
        material.keys(),
        counterface.keys()
    )
}

/// The curves of the models that a predicate selects.
fn curves_of(is_wanted: impl Fn(bool) -> bool) -> String {
    let wanted = MODELS.iter().filter(|entry| is_wanted(entry.has(Choice::Strength)));
    wanted.map(|entry| format!("[[curve]]\nmodel = \"{entry}\"\n")).collect()
}

/// A scene of one rough body, its spectrum in a file, and a rigid flat.
fn scene_of_file(material: &str, pressures: &[&str], curves: &str) -> String {
    format!(
        "[surface]\npsd = \"psd.csv\"\n[material]\n{material}[loads]\npressures = {pressures:?}\n[options]\n\
         scales_per_decade = 4\n{curves}"
    )
}

/// Rows of a self-affine spectrum: wavelengths from 100 um to 0.1 um in m, C1D in m^3, times a factor of lengths and one
/// of heights.
fn rows(length: f64, height: f64) -> Vec<[f64; 2]> {
    let row = |at: i32| {
        let wavelength_m = 1e-4 * 10f64.powf(-f64::from(at) / 8.0);
        let c1d_m3 = 1e-21 * (wavelength_m / 1e-4).powf(2.6);
        [length * wavelength_m, length * height * height * c1d_m3]
    };
    (0..=24).map(row).collect()
}

/// The file of a spectrum.
fn csv(header: &str, rows: impl IntoIterator<Item = [f64; 2]>) -> String {
    rows.into_iter().fold(format!("{header}\n"), |text, [x, y]| text + &format!("{x:e},{y:e}\n"))
}

/// The file of a spectrum, as scenes read it.
fn of_psd(text: impl Into<Vec<u8>>) -> BTreeMap<String, Vec<u8>> {
    BTreeMap::from([("psd.csv".to_owned(), text.into())])
}

/// The area fractions of every curve under a load, with finer and finer waves.
fn areas_under(text: &str, load: usize) -> Vec<f64> {
    areas_with(text, &BTreeMap::new(), load)
}

/// The area fractions of every curve under a load, of a scene with files.
fn areas_with(text: &str, files: &BTreeMap<String, Vec<u8>>, load: usize) -> Vec<f64> {
    let scene =
        Scene::parse(text, files, &Overrides::default()).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let results = scene.plan().compute().unwrap();
    let areas = results.curves.iter().flat_map(|curve| curve.area_fractions(load));
    let areas: Vec<f64> = areas.map(|(_, area_fraction)| area_fraction).collect();
    assert!(areas.len() > 3 && areas.iter().any(|area| *area < 1.0), "{text}");
    areas
}

/// The area fractions under the first load.
fn areas(text: &str) -> Vec<f64> {
    areas_under(text, 0)
}

#[track_caller]
fn assert_agree(one: &[f64], other: &[f64], tolerance: f64) {
    assert_eq!(one.len(), other.len());
    for (one, other) in one.iter().zip(other) {
        assert!((one - other).abs() <= tolerance * one.abs(), "{one} and {other}");
    }
}

#[test]
fn exchanged_bodies_touch_at_the_same_areas_in_every_model() {
    let mut dice = Dice(1);
    for _ in 0..20 {
        let [one, other] = [(); 2].map(|()| Solid::draw(&mut dice));
        assert_agree(&areas(&scene(one, other, &[1e7])), &areas(&scene(other, one, &[1e7])), 1e-12);
    }
}

#[test]
fn areas_depend_on_ratios_of_stresses() {
    let mut dice = Dice(2);
    for power in [-4, 3] {
        let [one, other] = [(); 2].map(|()| Solid::draw(&mut dice));
        let factor = 2f64.powi(power);
        let scaled = scene(one.times(factor), other.times(factor), &[factor * 1e7]);
        assert_agree(&areas(&scene(one, other, &[1e7])), &areas(&scaled), 1e-12);
    }
}

#[test]
fn a_load_has_the_same_digits_alone_and_among_others_and_remarks_change_nothing() {
    let mut dice = Dice(3);
    let [one, other] = [(); 2].map(|()| Solid::draw(&mut dice));
    let among = areas_under(&scene(one, other, &[1e6, 1e7, 1e8]), 1);
    let alone = scene(one, other, &[1e7]);
    assert_agree(&among, &areas(&alone), 0.0);
    assert_agree(&among, &areas(&alone.replace('\n', " # a remark\n\n")), 0.0);
}

const STEEL: &str = "youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"1 GPa\"\n";

const HEADER: &str = "wavelength_m,C1D_m3";

#[test]
fn stresses_have_one_meaning_in_all_units() {
    let files = of_psd(csv(HEADER, rows(1.0, 1.0)));
    let all = curves_of(|_| true);
    let reference = areas_with(&scene_of_file(STEEL, &["20 MPa"], &all), &files, 0);
    let material = STEEL.replace("210 GPa", "210e3 MPa").replace("1 GPa", "1e9 Pa");
    for pressure in ["2e7 Pa", "0.02 GPa", "20000 kPa"] {
        assert_agree(&reference, &areas_with(&scene_of_file(&material, &[pressure], &all), &files, 0), 1e-12);
    }
}

#[test]
fn a_pressure_in_hardness_is_that_pressure() {
    let files = of_psd(csv(HEADER, rows(1.0, 1.0)));
    let material = STEEL.replace("yield_strength = \"1 GPa\"", "indentation_hardness = \"4 GPa\"");
    let scene = |pressure| scene_of_file(&material, &[pressure], "[[curve]]\nmodel = \"elastic-plastic\"\n");
    assert_agree(&areas_with(&scene("5e-3 H"), &files, 0), &areas_with(&scene("20 MPa"), &files, 0), 1e-12);
}

#[test]
fn only_the_contact_modulus_counts_in_elastic_models() {
    let files = of_psd(csv(HEADER, rows(1.0, 1.0)));
    let elastic = curves_of(|yields| !yields);
    let areas = |material: &str| areas_with(&scene_of_file(material, &["20 MPa"], &elastic), &files, 0);
    let body = |modulus_pa: f64, poisson_ratio: f64| {
        format!("youngs_modulus = \"{modulus_pa:e} Pa\"\npoisson_ratio = {poisson_ratio}\n")
    };
    let reference = areas(&body(200e9, 0.25));
    assert_agree(&reference, &areas(&body(200e9 / (1.0 - 0.0625), 0.0)), 1e-12);
    let twice = format!("{}[counterface]\n{}", body(400e9, 0.25), body(400e9, 0.25));
    assert_agree(&reference, &areas(&twice), 1e-12);
}

#[test]
fn a_strength_beyond_all_stresses_is_none() {
    let files = of_psd(csv(HEADER, rows(1.0, 1.0)));
    let areas = |model: &str, strength: &str| {
        let material = STEEL.replace("1 GPa", strength);
        let curve = format!("[[curve]]\nmodel = \"{model}\"\n");
        areas_with(&scene_of_file(&material, &["20 MPa"], &curve), &files, 0)
    };
    assert_agree(&areas("elastic", "1 GPa"), &areas("elastic-plastic", "200 GPa"), 1e-9);
    assert_agree(&areas("persson", "1 GPa"), &areas("persson-plastic", "200 GPa"), 1e-9);
}

#[test]
fn loads_and_curves_have_no_order_and_more_load_more_contact() {
    let files = of_psd(csv(HEADER, rows(1.0, 1.0)));
    let all = curves_of(|_| true);
    let upwards = scene_of_file(STEEL, &["2 MPa", "20 MPa", "90 MPa"], &all);
    let downwards = scene_of_file(STEEL, &["90 MPa", "20 MPa", "2 MPa"], &all);
    let of_load: Vec<Vec<f64>> = (0..3).map(|load| areas_with(&upwards, &files, load)).collect();
    for (load, areas) in of_load.iter().enumerate() {
        assert_agree(areas, &areas_with(&downwards, &files, 2 - load), 0.0);
    }
    for pair in of_load.windows(2) {
        assert!(pair[0].iter().zip(&pair[1]).all(|(less, more)| less < more || *more == 1.0));
    }
    let mut alone = Vec::new();
    for entry in MODELS.iter() {
        let curve = format!("[[curve]]\nmodel = \"{entry}\"\n");
        let scene = scene_of_file(STEEL, &["20 MPa"], &curve);
        alone.extend(areas_with(&scene, &files, 0));
    }
    assert_agree(&of_load[1], &alone, 0.0);
}

#[test]
fn scenes_may_be_written_in_another_order_and_with_other_line_ends() {
    let files = of_psd(csv(HEADER, rows(1.0, 1.0)));
    let curve = "[[curve]]\nmodel = \"elastic-plastic\"\n";
    let reference = areas_with(&scene_of_file(STEEL, &["20 MPa"], curve), &files, 0);
    let turned = format!(
        "{curve}[options]\nscales_per_decade = 4\n[loads]\npressures = [\"20 MPa\"]\n[material]\n{}[surface]\n\
         psd = \"psd.csv\"\n",
        STEEL.lines().rev().fold(String::new(), |text, line| text + line + "\n")
    );
    assert_agree(&reference, &areas_with(&turned, &files, 0), 0.0);
    assert_agree(&reference, &areas_with(&turned.replace('\n', "\r\n"), &files, 0), 0.0);
}

#[test]
fn similar_surfaces_touch_alike() {
    let all = curves_of(|_| true);
    let elastic = curves_of(|yields| !yields);
    let reference = of_psd(csv(HEADER, rows(1.0, 1.0)));
    for factor in [0.25, 8.0] {
        let similar = of_psd(csv(HEADER, rows(factor, factor)));
        let scene = scene_of_file(STEEL, &["20 MPa"], &all);
        assert_agree(&areas_with(&scene, &reference, 0), &areas_with(&scene, &similar, 0), 1e-9);
        let higher = of_psd(csv(HEADER, rows(1.0, factor)));
        let scenes = [20.0, 20.0 * factor]
            .map(|pressure_mpa| scene_of_file(STEEL, &[&format!("{pressure_mpa} MPa")], &elastic));
        assert_agree(&areas_with(&scenes[0], &reference, 0), &areas_with(&scenes[1], &higher, 0), 1e-9);
    }
}

#[test]
fn one_spectrum_may_be_written_in_many_ways() {
    let scene = scene_of_file(STEEL, &["20 MPa"], &curves_of(|_| true));
    let areas = |text: String| areas_with(&scene, &of_psd(text), 0);
    let reference = areas(csv(HEADER, rows(1.0, 1.0)));
    let with = |header: &str, x: fn(f64) -> f64, factor: f64| {
        areas(csv(header, rows(1.0, 1.0).into_iter().map(|row| [x(row[0]), factor * row[1]])))
    };
    assert_agree(&reference, &with("wavelength_um,C1D_m3", |length_m| 1e6 * length_m, 1.0), 1e-9);
    assert_agree(&reference, &with("wavelength_nm,C1D_nm3", |length_m| 1e9 * length_m, 1e27), 1e-9);
    let wavevector = |length_m: f64| std::f64::consts::TAU / length_m;
    assert_agree(&reference, &with("wavevector_rad_per_m,C1D_m3", wavevector, 1.0), 1e-9);

    let mut backwards = rows(1.0, 1.0);
    backwards.reverse();
    assert_agree(&reference, &areas(csv(HEADER, backwards)), 0.0);
    let exchanged = rows(1.0, 1.0).into_iter().map(|[x, y]| [y, x]);
    assert_agree(&reference, &areas(csv("C1D_m3,wavelength_m", exchanged)), 0.0);
    let text = csv(HEADER, rows(1.0, 1.0));
    assert_agree(&reference, &areas(text.replace('\n', "\r\n")), 0.0);
    assert_agree(&reference, &areas(text.replace(',', "\t")), 0.0);
    assert_agree(&reference, &areas(format!("\u{feff}# a remark\n{text}")), 0.0);
    let json: Vec<String> = rows(1.0, 1.0)
        .iter()
        .map(|[x, y]| format!("{{\"wavelength_m\": {x:e}, \"C1D_m3\": {y:e}}}"))
        .collect();
    assert_agree(&reference, &areas(format!("[{}]", json.join(",\n"))), 0.0);
}

#[test]
fn exchanged_spectra_of_both_bodies_touch_alike() {
    let files = BTreeMap::from([
        ("psd.csv".to_owned(), csv(HEADER, rows(1.0, 1.0)).into_bytes()),
        ("other.csv".to_owned(), csv(HEADER, rows(0.5, 2.0)).into_bytes()),
    ]);
    let areas = |one: &str, other: &str| {
        let counterface = format!("{STEEL}[counterface]\n{STEEL}[counterface.surface]\npsd = \"{other}\"\n");
        let scene = scene_of_file(&counterface, &["20 MPa"], &curves_of(|_| true)).replace("psd.csv", one);
        areas_with(&scene.replace("swapped", "psd.csv"), &files, 0)
    };
    assert_agree(&areas("psd.csv", "other.csv"), &areas("other.csv", "swapped"), 1e-12);
}

/// A map of 24 by 16 points, or its points in another order.
fn map_text(rows: usize, columns: usize, height: impl Fn(usize, usize) -> f64) -> String {
    let line = |row| (0..columns).map(|column| format!("{}", height(row, column))).collect::<Vec<_>>();
    (0..rows).fold(String::new(), |text, row| text + &line(row).join(" ") + "\n")
}

/// The height of a random map at a point, in nm, to full digits.
fn height_nm(row: usize, column: usize) -> f64 {
    let mut dice = Dice(1 + 1000 * row as u64 + column as u64);
    let (x, y) = (column as f64, row as f64);
    5.0 * (dice.number() + dice.number()) + 40.0 * (0.7 * x).sin() + 30.0 * (0.9 * y + 0.4 * x).cos()
}

/// Wavelengths and values of the composite of scans.
fn composite(scans: &[&str], texts: &[(&str, String)], recipe: &Recipe) -> Vec<[f64; 2]> {
    let files: BTreeMap<String, Vec<u8>> =
        texts.iter().map(|(name, text)| ((*name).to_owned(), text.clone().into_bytes())).collect();
    let requests: Vec<ScanRequest> = scans.iter().map(|scan| scan.parse().unwrap()).collect();
    let found = CompositeOfFiles::read(&requests, &files, recipe).unwrap_or_else(|error| panic!("{error}"));
    let bins = &found.spectrum.composite.bins;
    bins.iter().map(|bin| [bin.wavelength_m, bin.c1d_m3]).collect()
}

#[track_caller]
fn assert_scaled(one: &[[f64; 2]], other: &[[f64; 2]], factors: [f64; 2], tolerance: f64) {
    assert!(one.len() > 2);
    for at in 0..2 {
        let scaled: Vec<f64> = one.iter().map(|row| factors[at] * row[at]).collect();
        let other: Vec<f64> = other.iter().map(|row| row[at]).collect();
        assert_agree(&scaled, &other, tolerance);
    }
}

#[test]
fn maps_may_be_turned_mirrored_and_written_otherwise() {
    let recipe = Recipe::default();
    let plain = || map_text(24, 24, height_nm);
    let of = |text: String, options: &str| {
        composite(&[&format!("a.txt:{options},shortest=1um")], &[("a.txt", text)], &recipe)
    };
    let given = "unit=nm,size=24um";
    let reference = of(plain(), given);
    let same = |other: &[[f64; 2]], tolerance| assert_scaled(&reference, other, [1.0, 1.0], tolerance);
    let turned = map_text(24, 24, |row, column| height_nm(column, row));
    same(&of(turned, &format!("{given},direction=y")), 1e-12);
    same(&of(map_text(24, 24, |row, column| height_nm(23 - row, column)), given), 1e-12);
    same(&of(map_text(24, 24, |row, column| height_nm(row, 23 - column)), given), 1e-9);
    same(&of(map_text(24, 24, |row, column| -height_nm(row, column)), given), 0.0);
    same(&of(map_text(24, 24, |row, column| 1000.0 + height_nm(row, column)), given), 1e-6);
    let tilted = |row: usize, column: usize| height_nm(row, column) + 3.0 * column as f64 - 2.0 * row as f64;
    same(&of(map_text(24, 24, tilted), given), 1e-6);
    same(&of(plain().replace(' ', "\t"), given), 0.0);
    same(&of(plain().replace(' ', ";").replace('\n', "\r\n"), given), 0.0);
    same(&of(map_text(24, 24, |row, column| 1e-3 * height_nm(row, column)), "unit=um,size=24um"), 1e-12);

    let higher = of(map_text(24, 24, |row, column| 4.0 * height_nm(row, column)), given);
    assert_scaled(&reference, &higher, [1.0, 16.0], 1e-12);
    let larger = composite(&["a.txt:unit=nm,size=240um,shortest=10um"], &[("a.txt", plain())], &recipe);
    assert_scaled(&reference, &larger, [10.0, 10.0], 1e-9);
}

#[test]
fn scans_have_no_order_and_count_once() {
    let texts = [
        ("a.txt", map_text(24, 24, height_nm)),
        ("b.txt", map_text(24, 24, |row, column| height_nm(row + 50, column))),
    ];
    let recipe = Recipe::default();
    let [a, b] = ["a.txt:unit=nm,size=24um,shortest=1um", "b.txt:unit=nm,size=24um,shortest=1um"];
    let reference = composite(&[a, b], &texts, &recipe);
    assert_scaled(&reference, &composite(&[b, a], &texts, &recipe), [1.0, 1.0], 1e-12);
    let once = composite(&[a], &texts, &recipe);
    assert_scaled(&once, &composite(&[a, a], &texts, &recipe), [1.0, 1.0], 1e-12);
}

#[test]
fn lines_may_be_read_backwards() {
    for (window, points) in Window::ALL.iter().flat_map(|window| [16, 63, 64].map(|points| (window, points)))
    {
        let recipe = Recipe { window: Some(*window), ..Recipe::default() };
        let line = |height: &dyn Fn(usize) -> f64| {
            let text = (0..points).fold(String::new(), |text, at| text + &format!("{} {}\n", at, height(at)));
            composite(&["a.txt:unit=um,shortest=2um"], &[("a.txt", text)], &recipe)
        };
        let forwards = line(&|at| height_nm(0, at));
        assert_scaled(&forwards, &line(&|at| height_nm(0, points - 1 - at)), [1.0, 1.0], 1e-9);
    }
}

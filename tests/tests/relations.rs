//! Relations between results of two questions (metamorphic tests), on scenes made from drawn parts.
//!
//! | relation | tolerance | reason |
//! |---|---|---|
//! | exchanged bodies | 1e-12 | E* and the body that yields have no order; both are equally rough |
//! | stresses times 2^k | 1e-12 | areas depend on ratios of stresses; powers of two leave only the printed digits |
//! | a load alone or among others | 0 | each load is computed as if it were alone |
//! | comments and blank lines in a scene | 0 | they mean nothing |

use scene::{Overrides, Scene};
use study::NoFiles;
use study::models::{Choice, MODELS};

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
struct Dice(u64);

impl Dice {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A scene of two equally rough bodies with every model that yields.
fn scene(material: Solid, counterface: Solid, pressures_pa: &[f64]) -> String {
    let pressures: Vec<String> = pressures_pa.iter().map(|pressure_pa| format!("{pressure_pa} Pa")).collect();
    let yielding = MODELS.iter().filter(|entry| entry.has(Choice::Strength));
    let curves: String = yielding.map(|entry| format!("[[curve]]\nmodel = \"{entry}\"\n")).collect();
    format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\n{}[counterface]\n{}\
         [counterface.surface]\npsd = \"builtin:uncd-measured\"\n[loads]\npressures = {pressures:?}\n\
         [options]\nscales_per_decade = 4\n{curves}",
        material.keys(),
        counterface.keys()
    )
}

/// The area fractions of every curve under a load, with finer and finer waves.
fn areas_under(text: &str, load: usize) -> Vec<f64> {
    let scene = Scene::parse(text, &NoFiles, &Overrides::default())
        .unwrap_or_else(|error| panic!("{error:?}\n{text}"));
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
fn exchanged_bodies_touch_at_the_same_areas_in_every_model_that_yields() {
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

//! The numbers of a judgement, from waves, closed forms and elements that are called directly.

use elements::half_space::{Elements, Grid, Loading};
use judge::{
    CurveVerdict, ERRORS_GIVEN, ElementArea, Judgement, Reference, Verdict, WindowOutcome,
    exponent_of_stiffness,
};
use persson::corrections::{Correction, algebraic_variance_pa2};
use persson::{constant_hardness, elastic};
use scene::{JudgeSettings, Scene};
use spectrum::random_surfaces::{AreaSpectrum, Phases, Synthesis};
use spectrum::{Normalisation, cumulative_moments};
use study::Unobserved;
use study::plan::{Plan, Results};
use study::student::widening;
use units::RemarkCode;

use crate::scenes::{ELASTIC, SelfAffine, White, coarse, judged, layered, scene, scene_on};

/// Waves of a surface, and of the surfaces that half-spaces flatten by the pressures that the layer takes.
struct Waves {
    surface: AreaSpectrum,
    /// Those with the stiffness of the layer, and with its stiffness for waves shorter by a hundredth.
    flattened: [AreaSpectrum; 2],
}

impl Waves {
    fn new(scene: &Scene, results: &Results) -> Self {
        let surface = AreaSpectrum::from_profile(&results.psd).unwrap();
        let layer = scene.material.unwrap().pair.layer_compliance();
        let stiffened = |raised: f64| match layer {
            Some(layer) => surface.weighted(|q| layer.relative_at(raised * q).powi(-2)),
            None => surface.clone(),
        };
        Waves { flattened: [1.0, 1.01].map(stiffened), surface }
    }

    fn cut(&self, longest_m: f64, shortest_m: f64) -> Option<Self> {
        let [alike, shorter] = &self.flattened;
        let cut = |waves: &AreaSpectrum| waves.cut(longest_m, shortest_m).ok();
        Some(Waves { surface: cut(&self.surface)?, flattened: [cut(alike)?, cut(shorter)?] })
    }

    /// Twice the rms pressure of full contact over E*.
    fn gradient(&self) -> f64 {
        self.flattened[0].mean_square_gradient().sqrt()
    }

    /// The exponent n of E*(q) ~ q^n.
    fn exponent(&self) -> f64 {
        let [alike, shorter] = self.flattened.each_ref().map(AreaSpectrum::mean_square_gradient);
        0.5 * (shorter / alike).ln() / 1.01f64.ln()
    }

    /// Persson's area with the correction of Nayak's alpha.
    fn area(&self, modulus_pa: f64, pressure_pa: f64, hardness_pa: Option<f64>) -> f64 {
        let moments = self.flattened[0].moments();
        let alpha = moments.m0_m2 * moments.m4_per_m2 / moments.m2.powi(2);
        let factor = Correction::factor_of_nayak(alpha) * (1.0 + 0.85 * self.exponent());
        let variance_pa2 = (0.5 * modulus_pa * self.gradient()).powi(2);
        let rms_pa = algebraic_variance_pa2(factor.clamp(0.01, 1.0), pressure_pa, variance_pa2).sqrt();
        hardness_pa.map_or_else(
            || elastic::area_fraction(pressure_pa, rms_pa),
            |hardness_pa| constant_hardness::areas(pressure_pa, rms_pa, hardness_pa).contact(),
        )
    }
}

/// An area with its relative error.
#[derive(Debug, Clone, Copy)]
struct Area(f64, f64);

impl Area {
    fn new(of: ElementArea) -> Self {
        Area(of.area_fraction, of.relative_error())
    }

    /// Checks an area to within a tolerance, and its error to within twenty times that.
    #[track_caller]
    fn assert_is(self, found: ElementArea, tolerance: f64) {
        let (Area(area, error), found) = (self, Area::new(found));
        assert!(
            (found.0 / area - 1.0).abs() < tolerance && (found.1 / error - 1.0).abs() < 20.0 * tolerance,
            "{found:?} {self:?}"
        );
    }

    fn times(self, factor: f64, error: f64) -> Self {
        Area((self.0 * factor).min(1.0), self.1.hypot(error))
    }

    /// At least the load over the hardness.
    fn at_least(self, least: f64) -> Self {
        let area = self.0.max(least);
        Area(area, self.1 * self.0 / area)
    }
}

/// A band of waves in a scene.
struct Window<'s> {
    scene: &'s Scene,
    waves: Waves,
    longer: Option<Waves>,
    all: Waves,
    index: usize,
    is_last: bool,
    grid: usize,
    box_m: f64,
}

impl Window<'_> {
    fn modulus_pa(&self) -> f64 {
        self.scene.material.unwrap().pair.composite_modulus_pa()
    }

    /// The pressure that the longer waves leave.
    fn pressure_pa(&self, nominal_pa: f64, hardness_pa: Option<f64>) -> f64 {
        nominal_pa
            / self.longer.as_ref().map_or(1.0, |on| on.area(self.modulus_pa(), nominal_pa, hardness_pa))
    }

    fn area_by_closed_form(&self, pressure_pa: f64, hardness_pa: Option<f64>) -> f64 {
        self.waves.area(self.modulus_pa(), pressure_pa, hardness_pa)
    }

    /// The area of elements under a load; `None` if too few points would touch.
    fn elements(&self, nominal_pa: f64, hardness_pa: Option<f64>) -> Option<Area> {
        let pressure_pa = self.pressure_pa(nominal_pa, hardness_pa);
        let share = hardness_pa.map_or(0.0, |bound_pa| (pressure_pa / bound_pa).min(1.0));
        if share > 0.98 {
            // Evenly distributed between the load over the hardness and all.
            let area = 0.5 * (1.0 + share);
            return Some(Area(area, (1.0 - share) / 12f64.sqrt() / area));
        }
        let points = (self.grid * self.grid) as f64;
        let area_per_pa = (2.0 / (self.modulus_pa() * self.waves.gradient()))
            .max(hardness_pa.map_or(0.0, |bound_pa| 1.0 / bound_pa));
        let enough_pa = 2000f64.min(0.98 * points) / (area_per_pa * points);
        if self.is_last && pressure_pa < enough_pa {
            let closed_form = |pressure_pa| self.area_by_closed_form(pressure_pa, hardness_pa);
            let factor = closed_form(pressure_pa) / closed_form(enough_pa);
            let decades = (enough_pa / pressure_pa).log10();
            return Some(self.pressed(enough_pa, hardness_pa).times(factor, 0.03 * decades));
        }
        (area_per_pa * pressure_pa * points > 200.0).then(|| self.pressed(pressure_pa, hardness_pa))
    }

    /// Two surfaces under elements.
    fn pressed(&self, pressure_pa: f64, hardness_pa: Option<f64>) -> Area {
        let seed = JudgeSettings::default().seed + ((self.index as u64) << 32);
        let synthesis = Synthesis::square(self.grid, self.box_m, seed, Phases::FixedModulus);
        let grid = Grid::new(self.grid, self.grid, self.box_m, self.box_m).unwrap();
        let loading = Loading {
            contact_modulus_pa: self.modulus_pa(),
            nominal_pressure_pa: pressure_pa,
            saturation_pa: hardness_pa,
            tolerance: 1e-4,
        };
        let layer = self.scene.material.unwrap().pair.layer_compliance();
        let areas = [0, 1].map(|realisation| {
            let of = |spectrum: &AreaSpectrum| spectrum.surface(&synthesis, realisation).unwrap();
            let scale = self.waves.gradient() / of(&self.waves.flattened[0]).mean_square_gradient().sqrt();
            let heights_m = of(&self.waves.surface).scaled(scale).heights_m;
            let mut elements = match layer {
                Some(layer) => Elements::periodic_on(grid, &heights_m, |q| layer.relative_at(q)),
                None => Elements::periodic(grid, &heights_m),
            }
            .unwrap();
            let numbers = elements.press(&loading, &Unobserved).unwrap().numbers;
            numbers.area_fraction_corrected.max(hardness_pa.map_or(0.0, |bound_pa| pressure_pa / bound_pa))
        });
        let mean = 0.5 * (areas[0] + areas[1]);
        // Of two values the standard error is half of what they differ.
        let error = widening(2) * 0.5 * (areas[0] - areas[1]).abs() / mean;
        Area(mean, error.hypot(0.015))
    }

    /// The factor from an area on the window to that of the surface, and its relative error.
    fn seam(&self, nominal_pa: f64, hardness_pa: Option<f64>) -> (f64, f64) {
        let Some(longer) = &self.longer else { return (1.0, 0.0) };
        let pressure_pa = self.pressure_pa(nominal_pa, hardness_pa);
        let by_share = nominal_pa / pressure_pa;
        let of_all = self.all.area(self.modulus_pa(), nominal_pa, hardness_pa);
        let by_closed_form = of_all / self.area_by_closed_form(pressure_pa, hardness_pa);
        let apart = 0.5 * (by_share / by_closed_form).ln().abs();
        let least = if hardness_pa.is_some() { 0.05 } else { 0.02 };
        let on_layer = 0.15 * self.all.exponent().abs().min(1.0);
        let light = 0.003 * self.modulus_pa() * longer.gradient() / nominal_pa;
        let light = 0.03 * light.log10().max(0.0);
        ((by_share * by_closed_form).sqrt(), apart.max(least).hypot(on_layer).hypot(light))
    }
}

/// The windows of a judgement, in their order.
fn windows<'s>(
    scene: &'s Scene,
    results: &Results,
    judgement: &Judgement,
    per_shortest: f64,
) -> Vec<(f64, Window<'s>)> {
    let waves = Waves::new(scene, results);
    let mut bands: Vec<(f64, f64)> = Vec::new();
    for row in judgement.windows.iter().filter(|row| !row.is_whole_band) {
        if bands.last() != Some(&(row.longest_m, row.shortest_m)) {
            bands.push((row.longest_m, row.shortest_m));
        }
    }
    let grid = judgement.extent.as_ref().unwrap().grid;
    let from_m = results.psd.longest_wavelength_m();
    let window = |(index, &(longest_m, shortest_m)): (usize, &(f64, f64))| Window {
        scene,
        waves: waves.cut(longest_m, shortest_m).unwrap(),
        longer: waves.cut(from_m, longest_m),
        all: waves.cut(from_m, shortest_m).unwrap(),
        index,
        is_last: index + 1 == bands.len(),
        grid,
        box_m: (grid as f64 / per_shortest * shortest_m).max(2.0 * longest_m),
    };
    bands.iter().enumerate().map(|of| (of.1.0, window(of))).collect()
}

fn hardness_pa(reference: Reference) -> Option<f64> {
    match reference {
        Reference::Yielding { hardness_pa } => Some(hardness_pa),
        Reference::Elastic | Reference::Growing => None,
    }
}

#[track_caller]
fn assert_near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
}

fn nominal_pa(scene: &Scene, load: usize) -> f64 {
    scene.needs.loads[load].nominal_pressure_pa()
}

/// Checks areas of elements on all windows and on the whole band.
fn assert_elements(scene: &Scene, grid: usize, per_shortest: f64) -> (Results, Judgement) {
    let (results, judgement) = judged(scene, &coarse(grid, 2));
    let windows = windows(scene, &results, &judgement, per_shortest);
    assert_eq!(windows.len(), judgement.extent.as_ref().unwrap().windows);
    let reference = |row: &WindowOutcome| verdict(&judgement, row.curve, row.load).reference;
    for row in judgement.windows.iter().filter(|row| !row.is_whole_band) {
        let window = &windows.iter().find(|(longest_m, _)| *longest_m == row.longest_m).unwrap().1;
        let (load_pa, bound_pa) = (nominal_pa(scene, row.load), hardness_pa(reference(row)));
        assert_near(row.pressure_pa, window.pressure_pa(load_pa, bound_pa));
        assert_near(
            row.pressure_over_gradient,
            row.pressure_pa / (window.modulus_pa() * window.waves.gradient()),
        );
        let Some(elements) = window.elements(load_pa, bound_pa) else {
            assert_eq!((row.elements, row.verdict), (None, Verdict::NotJudged), "{row:?}");
            continue;
        };
        // Pressures on a surface begin with those of the last load, which the tolerance of the solution forgets.
        elements.assert_is(row.elements.unwrap(), 1e-3);
        let elements = Area::new(row.elements.unwrap());
        let (factor, error) = window.seam(load_pa, bound_pa);
        let least = bound_pa.map_or(0.0, |bound_pa| (load_pa / bound_pa).min(1.0));
        elements.times(factor, error).at_least(least).assert_is(row.elements_of_whole.unwrap(), 1e-9);
    }
    let (_, last) = windows.last().unwrap();
    for of in &judgement.references {
        let (load_pa, bound_pa) = (nominal_pa(scene, of.load), hardness_pa(of.reference));
        let (factor, error) = last.seam(load_pa, bound_pa);
        let end_error = last.all.surface.conversion().end_error;
        assert_eq!(judgement.error_of_spectrum_end, end_error);
        let least = bound_pa.map_or(0.0, |bound_pa| (load_pa / bound_pa).min(1.0));
        let is_own = |row: &&WindowOutcome| {
            !row.is_whole_band && (row.load, reference(row)) == (of.load, of.reference)
        };
        let on_last = judgement.windows.iter().rfind(is_own).unwrap().elements.unwrap();
        let expected = Area::new(on_last).times(factor, error).times(1.0, end_error).at_least(least);
        expected.assert_is(of.elements.unwrap(), 1e-9);
        let Area(area, error) = expected;
        let range = of.range.unwrap();
        assert_near(range.low, (area - ERRORS_GIVEN * error * area).max(0.1 * area).max(least));
        assert_near(range.high, (area + ERRORS_GIVEN * error * area).min(1.0));
        // The elements of a reference are those of every curve that is compared with it.
        for row in judgement.curves.iter().filter(|row| (row.load, row.reference) == (of.load, of.reference))
        {
            assert_eq!((row.elements, row.range), (of.elements, of.range));
        }
    }
    assert_verdicts(scene, &results, &judgement);
    (results, judgement)
}

fn verdict(judgement: &Judgement, curve: usize, load: usize) -> &CurveVerdict {
    judgement.curves.iter().find(|row| (row.curve, row.load) == (curve, load)).unwrap()
}

/// Checks that every curve under every load has its own area, its windows, and the worst of these.
fn assert_verdicts(scene: &Scene, results: &Results, judgement: &Judgement) {
    let loads = scene.needs.loads.len();
    assert_eq!(judgement.curves.len(), loads * scene.needs.curves.len());
    for (at, row) in judgement.curves.iter().enumerate() {
        assert_eq!((row.curve, row.load), (at / loads, at % loads));
        let area = results.curves[row.curve].area_fractions(row.load).last().map(|(_, area)| *area);
        assert_eq!(row.area_fraction, area);
        let own = || {
            judgement
                .windows
                .iter()
                .filter(|on| (on.curve, on.load) == (row.curve, row.load) && !on.is_whole_band)
        };
        let whole = judgement
            .windows
            .iter()
            .find(|on| (on.curve, on.load) == (row.curve, row.load) && on.is_whole_band);
        if let Some(whole) = whole {
            assert_eq!((whole.elements, whole.verdict), (row.elements, row.verdict));
            assert_near(whole.pressure_pa, nominal_pa(scene, row.load));
        }
        let mut worst = (f64::NEG_INFINITY, 0.0);
        let (mut compared, mut agreeing) = (0, 0);
        for on in own().filter(|on| on.verdict.compares()) {
            let elements = on.elements.unwrap();
            let ratio = on.area_fraction.unwrap() / elements.area_fraction;
            assert_eq!(on.ratio(), Some(ratio));
            assert_eq!(on.reason.number("ratio"), Some(ratio));
            assert_eq!(on.verdict, Verdict::from_ratio(ratio, elements.relative_error()));
            let beyond = ratio.ln().abs() - (1.0 + 2.0 * elements.relative_error()).ln();
            if beyond > worst.0 {
                worst = (beyond, on.shortest_m);
            }
            compared += 1;
            agreeing += usize::from(on.verdict == Verdict::Agrees);
        }
        assert_eq!((row.windows, row.agreeing), (compared, agreeing));
        assert_eq!(row.worst_window.map(|on| on.shortest_m), (compared > 0).then_some(worst.1), "{row:?}");
        assert_eq!(row.holds(), row.verdict == Verdict::Agrees && agreeing as f64 > 0.5 * compared as f64);
    }
}

const LOADS: &str = "\"3 GPa\", \"10 kPa\", \"300 MPa\", \"1 MPa\"";

#[test]
fn elements_press_the_waves_of_each_window_under_the_load_that_longer_waves_leave() {
    let scene = scene(2.2, "", LOADS, &ELASTIC[..2]);
    let (results, judgement) = assert_elements(&scene, 64, 4.0);
    let too_light = judgement.windows.iter().filter(|on| on.reason.code == RemarkCode::TooLight);
    assert!(too_light.count() > 1);
    // Persson's theory takes the rms pressure of full contact alone.
    let windows = windows(&scene, &results, &judgement, 4.0);
    for on in judgement.windows.iter().filter(|on| on.curve == 1 && !on.is_whole_band) {
        let window = &windows.iter().find(|(longest_m, _)| *longest_m == on.longest_m).unwrap().1;
        let rms_pa = 0.5 * window.modulus_pa() * window.waves.gradient();
        let area = elastic::area_fraction(on.pressure_pa, rms_pa);
        assert!((on.area_fraction.unwrap() / area - 1.0).abs() < 2e-3, "{on:?} {area}");
    }
}

#[test]
fn elements_on_a_white_band_have_eight_points_on_the_shortest_wave() {
    let scene = scene_on(&White(1.0), "", "\"300 MPa\", \"3 GPa\"", &ELASTIC[1..2]);
    let (_, judgement) = assert_elements(&scene, 48, 8.0);
    assert!((judgement.rms_gradient / 0.05 - 1.0).abs() < 0.02, "{}", judgement.rms_gradient);
}

#[test]
fn elements_that_flow_take_their_hardness_as_the_largest_pressure() {
    let curves = ["model = \"persson-plastic\"", "model = \"persson\""];
    let scene =
        scene(2.2, "yield_strength = \"1 GPa\"", "\"2.99 GPa\", \"1 GPa\", \"300 MPa\", \"1 MPa\"", &curves);
    let (_, judgement) = assert_elements(&scene, 48, 8.0);
    let references: Vec<Reference> = [0, 4].map(|row| judgement.curves[row].reference).to_vec();
    assert_eq!(references[1], Reference::Elastic);
    assert_near(hardness_pa(references[0]).unwrap(), 3e9);
    assert_eq!(judgement.references.len(), 8, "two bodies under four loads");
}

#[test]
fn elements_on_a_layer_press_waves_with_its_stiffness() {
    // Where a stiff coat flattens long waves the short ones are of one range, and have twice the points.
    for (constants, per_shortest) in [("", 4.0), ("youngs_modulus = \"20 GPa\"\npoisson_ratio = 0.3", 8.0)] {
        assert_elements(&layered(1.5, "50 nm", constants), 48, per_shortest);
    }
}

#[test]
fn the_stiffness_of_a_thin_layer_on_a_rigid_base_falls_with_the_wavenumber_and_that_of_a_thick_one_is_even() {
    let exponent = |thickness: &str, constants: &str| {
        let scene = layered(1.5, thickness, constants);
        let psd = scene.plan().compute().unwrap().psd;
        exponent_of_stiffness(&psd, &scene.material.unwrap().pair.layer_compliance().unwrap()).unwrap()
    };
    let steel = "youngs_modulus = \"200 GPa\"\npoisson_ratio = 0.3";
    assert!((exponent("1 pm", "") + 1.0).abs() < 0.01, "{}", exponent("1 pm", ""));
    for (thickness, constants) in [("1 mm", ""), ("20 nm", steel)] {
        let exponent = exponent(thickness, constants);
        assert!(exponent.abs() < 1e-6, "{thickness} {exponent}");
    }
    assert!(exponent("20 nm", "youngs_modulus = \"20 GPa\"\npoisson_ratio = 0.3") > 0.05);
}

#[test]
fn a_scene_yields_from_the_scale_at_which_an_elastic_contact_exceeds_its_hardness() {
    let plain = |material: &str| scene(2.2, material, "\"1 GPa\", \"100 MPa\"", &ELASTIC[1..2]);
    let scenes = [plain(""), plain("yield_strength = \"2 GPa\""), layered(1.5, "50 nm", "")];
    for scene in &scenes {
        let results = scene.plan().compute().unwrap();
        let judgement = judge::JudgePlan::new(scene, &results, &coarse(48, 2));
        let judgement = judgement.run(&Unobserved).unwrap();
        let modulus_pa = scene.material.unwrap().pair.composite_modulus_pa();
        let waves = Waves::new(scene, &results);
        let moments = cumulative_moments(&results.psd, Normalisation::default());
        let rms_pa: Vec<(f64, f64)> = moments
            .iter()
            .map(|down_to| {
                let own = waves.cut(results.psd.longest_wavelength_m(), down_to.wavelength_m);
                let stiffening =
                    own.map_or(1.0, |own| own.gradient() / own.surface.mean_square_gradient().sqrt());
                (down_to.wavelength_m, modulus_pa * (0.5 * down_to.m2).sqrt() * stiffening)
            })
            .collect();
        let steep = moments.iter().find(|moments| (0.5 * moments.m2).sqrt() > 0.1);
        assert_eq!(judgement.steep_from_m, steep.map(|moments| moments.wavelength_m));
        let last = rms_pa.last().unwrap().1;
        assert_near(judgement.rms_gradient, (2.0 * moments.last().unwrap().m2).sqrt());
        for (load, yielding) in judgement.yielding.iter().enumerate() {
            let load_pa = nominal_pa(scene, load);
            assert_eq!(yielding.load, load);
            assert_near(yielding.elastic_pressure_pa, load_pa / elastic::area_fraction(load_pa, last));
            let hardness_pa = scene.material.unwrap().hardness_pa();
            let flowing = hardness_pa.map(|hardness_pa| {
                constant_hardness::areas(load_pa, last, hardness_pa).contact()
                    / elastic::area_fraction(load_pa, last)
            });
            assert_eq!(yielding.flowing_over_elastic.is_some(), flowing.is_some());
            if let Some(flowing) = flowing {
                assert_near(yielding.flowing_over_elastic.unwrap(), flowing);
            }
            let pressures = rms_pa
                .iter()
                .map(|(at_m, rms_pa)| (*at_m, load_pa / elastic::area_fraction(load_pa, *rms_pa)));
            let above = hardness_pa.and_then(|hardness_pa| {
                pressures.clone().find(|(_, pressure_pa)| *pressure_pa > hardness_pa)
            });
            assert_eq!(yielding.above_constant.map(|above| above.wavelength_m), above.map(|(at_m, _)| at_m));
            assert_eq!(yielding.above_constant.map(|above| above.pressure_pa).is_some(), above.is_some());
            assert!(!yielding.hardness_grows && yielding.above_growing.is_none());
        }
    }
}

/// A spectrum whose surface is steep from some scale on.
#[test]
fn slopes_are_steep_from_the_scale_at_which_full_contact_takes_a_tenth_of_the_modulus() {
    let scene = scene_on(&SelfAffine { decades: 2.2, has_step: false }, "", "\"1 GPa\"", &ELASTIC[1..2]);
    let steeper = |factor: f64| {
        let given = &scene.surface.psd;
        let psd = &given.with_values(given.c1d_m3().iter().map(|value| factor * value).collect()).unwrap();
        let results = Plan { psd, ..scene.plan() }.compute().unwrap();
        let m2 = cumulative_moments(&results.psd, Normalisation::default());
        let judgement = judge::JudgePlan::new(
            &scene,
            &results,
            &JudgeSettings { budget: 1.0, ..JudgeSettings::default() },
        );
        (judgement.run(&Unobserved).unwrap(), m2)
    };
    let (plain, moments) = steeper(1.0);
    // The spectrum is raised so that the middle cutoff is the first that exceeds it.
    let middle = moments.len() / 2;
    let factor = 1.001 * 2.0 * 0.1f64.powi(2) / moments[middle].m2;
    let (raised, _) = steeper(factor);
    assert_eq!(raised.steep_from_m, Some(moments[middle].wavelength_m));
    assert!(plain.curves.iter().all(|row| row.reason.code == RemarkCode::BeyondBudget));
    assert_near(raised.rms_gradient / plain.rms_gradient, factor.sqrt());
}

//! Measured maps: as the answer, or beside scans that hold more.

use std::f64::consts::TAU;

use elements::half_space::{Elements, Grid, Loading};
use judge::{Basis, Headline, JudgePlan, JudgeSettings, Judgement, Reference, Verdict};
use numerics::parallel::Unobserved;
use scene::{Overrides, Scene};
use spectrum::random_surfaces::MapWaves;
use study::Files;
use study::student::widening;
use units::RemarkCode;

use crate::scenes::coarse;

const POINTS: usize = 64;
const SIDE_M: f64 = 6.4e-6;
const CONTACT_MODULUS_PA: f64 = 100e9;
const PRESSURE_PA: f64 = 350e6;

/// Files by name: maps, and traces with the waves below them.
struct Scans(Vec<(&'static str, String)>);

impl Files for Scans {
    fn read(&self, name: &str) -> std::io::Result<Vec<u8>> {
        let found = self.0.iter().find(|(known, _)| *known == name);
        found.map(|(_, text)| text.clone().into_bytes()).ok_or(std::io::ErrorKind::NotFound.into())
    }

    fn read_beside(&self, _: &str, _: &str) -> std::io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

/// A map of waves with random phases, as steep across its rows as `across` times along them.
fn waves(across: f64) -> Vec<f64> {
    let mut state = 7u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut heights_m = vec![0.0; POINTS * POINTS];
    for m in 0..=12i32 {
        for n in -12..=12i32 {
            let length = f64::from(m).hypot(f64::from(n) / across);
            let phase = TAU * random();
            if length == 0.0 || length > 12.0 || (m == 0 && n < 0) {
                continue;
            }
            let amplitude_m = 12e-9 * length.powf(-1.8);
            for (at, height_m) in heights_m.iter_mut().enumerate() {
                let (x, y) = ((at % POINTS) as f64 / POINTS as f64, (at / POINTS) as f64 / POINTS as f64);
                *height_m += amplitude_m * (TAU * (f64::from(m) * x + f64::from(n) * y) + phase).cos();
            }
        }
    }
    heights_m
}

/// The map with its peaks worn off.
fn worn(heights_m: Vec<f64>) -> Vec<f64> {
    let mut sorted = heights_m.clone();
    sorted.sort_by(f64::total_cmp);
    let plateau_m = sorted[sorted.len() * 7 / 10];
    heights_m.into_iter().map(|height_m| height_m.min(plateau_m + 0.05 * (height_m - plateau_m))).collect()
}

fn text(heights_m: &[f64]) -> String {
    heights_m
        .chunks(POINTS)
        .map(|row| row.iter().map(|height_m| format!("{height_m:e} ")).collect::<String>() + "\n")
        .collect()
}

/// A trace of shorter waves, `steep` times as steep as the map along its rows.
fn trace(steep: f64) -> String {
    let at = |point: usize| 2e-9 * point as f64;
    let height_m = |x_m: f64| {
        let waves = (1..=40).map(|n| (f64::from(n), f64::from(n * n % 37)));
        steep * waves.map(|(n, phase)| 2e-11 * (TAU * (2.0 * n * x_m / 1e-6) + phase).cos()).sum::<f64>()
    };
    (0..2000).map(|point| format!("{:e} {:e}\n", at(point), height_m(at(point)))).collect()
}

fn judged(files: &Scans, surface: &str, rest: &str) -> (Judgement, Headline) {
    judged_under(PRESSURE_PA, files, surface, rest)
}

fn judged_under(pressure_pa: f64, files: &Scans, surface: &str, rest: &str) -> (Judgement, Headline) {
    let loads = format!("\"{pressure_pa} Pa\"");
    let judgement = judged_with(&coarse(64, 2), &loads, files, surface, rest);
    let headline = *judgement.headline(0).unwrap();
    (judgement, headline)
}

fn judged_with(settings: &JudgeSettings, loads: &str, files: &Scans, surface: &str, rest: &str) -> Judgement {
    let text = format!(
        "[surface]\n{surface}\n[material]\nyoungs_modulus = \"100 GPa\"\npoisson_ratio = 0\n{rest}[loads]\npressures = [{loads}]\n\
         [[curve]]\nmodel = \"persson\"\n[[curve]]\nmodel = \"elastic\"\n"
    );
    let scene = Scene::parse(&text, files, &Overrides::default()).unwrap_or_else(|error| panic!("{error}"));
    let results = scene.plan().compute().unwrap();
    JudgePlan::new(&scene, &results, settings).run(&Unobserved).unwrap()
}

fn map_alone(heights_m: &[f64], more: &str, rest: &str) -> (Judgement, Headline) {
    map_under(PRESSURE_PA, heights_m, more, rest)
}

fn map_under(pressure_pa: f64, heights_m: &[f64], more: &str, rest: &str) -> (Judgement, Headline) {
    let files = Scans(vec![("map.txt", text(heights_m))]);
    let surface = format!("scans = [{{ file = \"map.txt\", unit = \"m\", size = \"6.4 um\"{more} }}]");
    judged_under(pressure_pa, &files, &surface, rest)
}

fn pressed(heights_m: &[f64], saturation_pa: Option<f64>) -> [f64; 5] {
    pressed_under(PRESSURE_PA, heights_m, saturation_pa)
}

/// Corrected and counted area, mean gap \[m\], stiffness \[Pa/m\], and the share of the contact that has flowed.
fn pressed_under(nominal_pressure_pa: f64, heights_m: &[f64], saturation_pa: Option<f64>) -> [f64; 5] {
    let grid = Grid::new(POINTS, POINTS, SIDE_M, SIDE_M).unwrap();
    let mut elements = Elements::periodic(grid, heights_m).unwrap();
    let loading = Loading {
        contact_modulus_pa: CONTACT_MODULUS_PA,
        nominal_pressure_pa,
        saturation_pa,
        tolerance: 1e-6,
    };
    let contact = elements.press(&loading, &Unobserved).unwrap();
    let stiffness = elements.stiffness_pa_per_m(&contact, CONTACT_MODULUS_PA, &Unobserved).unwrap().unwrap();
    let numbers = contact.numbers;
    let plastic_share = numbers.plastic_area_fraction / numbers.area_fraction;
    [numbers.area_fraction_corrected, numbers.area_fraction, numbers.mean_gap_m, stiffness, plastic_share]
}

/// Checks that a headline holds the area of a map, narrowly.
fn assert_holds(headline: &Headline, [corrected, counted, ..]: [f64; 5]) {
    assert!(
        headline.maps.is_some() && headline.low < corrected && counted < headline.high,
        "{headline:?} {corrected} {counted}"
    );
    assert!(headline.high / headline.low < 1.3, "{headline:?}");
    let middle = 0.5 * (corrected + counted);
    assert!((headline.area_fraction.unwrap() / middle - 1.0).abs() < 0.01, "{headline:?} {middle}");
}

#[test]
fn a_map_that_is_the_only_scan_is_the_answer_whatever_its_phases_and_directions() {
    for heights_m in [waves(1.0), worn(waves(1.0)), waves(3.0)] {
        let exact = pressed(&heights_m, None);
        for direction in ["", ", direction = \"y\"", ", direction = \"both\""] {
            let (judgement, headline) = map_alone(&heights_m, direction, "[interface]\n");
            assert_holds(&headline, exact);
            let maps = headline.maps.unwrap();
            assert!((maps.mean_gap_m.unwrap() / exact[2] - 1.0).abs() < 0.01, "{maps:?} {exact:?}");
            assert!((maps.stiffness_pa_per_m.unwrap() / exact[3] - 1.0).abs() < 0.02, "{maps:?} {exact:?}");
            assert_eq!(maps.plastic_share, None);
            // Models are held against the map.
            let of_curves =
                judgement.curves.iter().map(|curve| curve.elements.map(|found| found.area_fraction));
            assert!(of_curves.into_iter().all(|area| area == headline.area_fraction));
        }
    }
}

#[test]
fn a_map_that_is_the_answer_is_the_surface_to_look_at() {
    for (rest, saturation_pa) in [("", None), ("indentation_hardness = \"1.2 GPa\"\n", Some(1.2e9))] {
        let heights_m = worn(waves(1.0));
        let (judgement, headline) = map_alone(&heights_m, "", rest);
        let surface = judgement.surface.unwrap();
        assert_eq!(
            (surface.map.as_deref(), surface.columns, surface.shortest_m),
            (Some("map.txt"), POINTS, None)
        );
        let [contact] = &surface.contacts[..] else { panic!() };
        let [_, counted, ..] = pressed(&heights_m, saturation_pa);
        assert!((contact.area_fraction() / counted - 1.0).abs() < 0.01, "{counted} {headline:?}");
        assert!(contact.area_fraction() > headline.area_fraction.unwrap());
        // The highest points touch.
        let highest = (0..surface.heights_m.len())
            .max_by(|a, b| surface.heights_m[*a].total_cmp(&surface.heights_m[*b]));
        assert!(contact.touching[highest.unwrap()]);
    }
}

#[test]
fn a_map_tells_a_worn_surface_and_one_with_a_direction_from_a_gaussian_one() {
    let of = |heights_m: &[f64], direction: &str| map_alone(heights_m, direction, "").0.maps[0].clone();
    let gaussian = of(&waves(1.0), "");
    assert!(!gaussian.differs() && !gaussian.has_direction(), "{gaussian:?}");
    let worn = of(&worn(waves(1.0)), "");
    assert!(worn.differs() && !worn.has_direction() && worn.ratio() > 1.2, "{worn:?}");
    // Slopes across rows that are three times as steep: by the spectrum along them more touches, by that across them less.
    let [along, across] = ["", ", direction = \"y\""].map(|direction| of(&waves(3.0), direction));
    assert!(along.has_direction() && along.differs() && along.ratio() < 0.8, "{along:?}");
    // The few ridges along which it is gentle scatter too much for a verdict.
    assert!(across.has_direction() && across.ratio() > 1.05, "{across:?}");
    assert!(along.gradient_over_spectrum > 1.5 && across.gradient_over_spectrum < 0.9);
    // Both have the steps of the same map.
    let squares = [along, across].map(|map| map.gradient_over_spectrum.powi(-2));
    assert!((squares[0] + squares[1] - 2.0).abs() < 1e-6, "{squares:?}");
}

#[test]
fn a_map_has_an_area_of_its_own_down_to_twenty_points() {
    let heights_m = worn(waves(1.0));
    let mut pressed_maps = 0;
    for pressure_pa in [1e5, 1e6, 20e6, 80e6] {
        let [corrected, counted, ..] = pressed_under(pressure_pa, &heights_m, None);
        let (_, headline) = map_under(pressure_pa, &heights_m, "", "");
        let points = counted * (POINTS * POINTS) as f64;
        assert_eq!(headline.maps.is_some(), points >= 20.0, "{points} {headline:?}");
        if headline.maps.is_some() {
            pressed_maps += 1;
            let middle = 0.5 * (corrected + counted);
            // Waves along diagonals that the points do not resolve are left out.
            assert!((headline.area_fraction.unwrap() / middle - 1.0).abs() < 0.25, "{headline:?} {middle}");
        }
    }
    assert!((1..4).contains(&pressed_maps), "{pressed_maps}");
}

#[test]
fn a_map_whose_edges_do_not_match_has_their_error() {
    let tilted: Vec<f64> = waves(1.0)
        .iter()
        .enumerate()
        .map(|(at, height_m)| height_m + 40e-9 * (2.0 * (at % POINTS) as f64 / POINTS as f64 - 1.0).powi(3))
        .collect();
    let (_, periodic) = map_alone(&waves(1.0), "", "");
    let (_, open) = map_alone(&tilted, "", "");
    let width = |headline: &Headline| (headline.high - headline.low) / headline.area_fraction.unwrap();
    assert!(
        open.maps.is_some() && width(&open) > 4.0 * 0.08 && width(&periodic) < 0.2,
        "{periodic:?} {open:?}"
    );
}

#[test]
fn a_map_that_yields_is_pressed_with_its_hardness() {
    let heights_m = worn(waves(1.0));
    let (_, headline) = map_alone(&heights_m, "", "indentation_hardness = \"700 MPa\"\n");
    let exact = pressed(&heights_m, Some(700e6));
    assert_holds(&headline, exact);
    let maps = headline.maps.unwrap();
    assert_eq!(maps.stiffness_pa_per_m, None, "nobody asked");
    assert!((maps.plastic_share.unwrap() - exact[4]).abs() < 0.01 && exact[4] > 0.05, "{maps:?} {exact:?}");
    let (_, asked) = map_alone(&heights_m, "", "indentation_hardness = \"700 MPa\"\n[interface]\n");
    let stiffness_pa_per_m = asked.maps.unwrap().stiffness_pa_per_m.unwrap();
    assert!((stiffness_pa_per_m / exact[3] - 1.0).abs() < 0.02, "{asked:?} {exact:?}");
    // A surface that flows has the area of the load over the hardness at least, and no map is needed.
    let (_, flows) = map_alone(&heights_m, "", "indentation_hardness = \"355 MPa\"\n");
    assert!(flows.maps.is_none() && flows.low >= PRESSURE_PA / 355e6);
}

/// A map with a few high and narrow peaks.
fn spiky() -> Vec<f64> {
    let mut heights_m = waves(1.0);
    for (row, column) in [(9, 40), (23, 11), (37, 52), (50, 27), (61, 3)] {
        heights_m[row * POINTS + column] += 120e-9;
    }
    heights_m
}

#[test]
fn peaks_of_a_map_that_flow_are_counted_where_no_gaussian_surface_of_its_spectrum_would_yield() {
    let heights_m = spiky();
    let hardness = "indentation_hardness = \"9 GPa\"\n";
    let yields = format!("{hardness}[[curve]]\nmodel = \"persson-plastic\"\n");
    let (judgement, headline) = map_under(20e6, &heights_m, "", &yields);
    assert!(judgement.yielding[0].above_constant.is_none(), "{:?}", judgement.yielding);
    let [corrected, counted, ..] = pressed_under(20e6, &heights_m, Some(9e9));
    let elastic = pressed_under(20e6, &heights_m, None)[1];
    assert_eq!(headline.basis, Basis::Elements(Reference::Yielding { hardness_pa: 9e9 }));
    // Waves along diagonals that the points do not resolve are left out.
    let middle = 0.5 * (corrected + counted);
    assert!((headline.area_fraction.unwrap() / middle - 1.0).abs() < 0.15, "{headline:?} {middle}");
    assert!(headline.low > 2.0 * elastic, "{headline:?} {elastic}");
    // Bodies so hard that no peak flows stay elastic.
    let (_, hard) = map_under(20e6, &heights_m, "", &yields.replace("9 GPa", "40 GPa"));
    assert_eq!(hard.basis, Basis::Elements(Reference::Elastic));
}

#[test]
fn a_map_is_pressed_with_the_waves_of_the_band_alone() {
    let heights_m = waves(1.0);
    let [whole, smooth] = ["", "[cutoffs]\nshortest_wavelength = \"1.6 um\"\n"]
        .map(|cutoff| map_alone(&heights_m, "", cutoff).1);
    // Without its short waves a surface touches more.
    assert!(
        whole.maps.is_some() && smooth.maps.is_some() && smooth.low > 1.1 * whole.high,
        "{smooth:?} {whole:?}"
    );
}

#[test]
fn a_map_that_touches_less_takes_no_contact_below_the_load_over_its_hardness() {
    let files = Scans(vec![("map.txt", text(&waves(3.0))), ("trace.txt", trace(10.0))]);
    let scans = "scans = [{ file = \"map.txt\", unit = \"m\", size = \"6.4 um\" }, { file = \"trace.txt\", unit = \"m\" }]";
    let (judgement, headline) = judged(&files, scans, "indentation_hardness = \"1 GPa\"\n");
    assert!(judgement.maps[0].differs() && judgement.maps[0].ratio() < 0.9, "{:?}", judgement.maps);
    assert_eq!(headline.low, PRESSURE_PA / 1e9, "{headline:?}");
}

#[test]
fn a_light_load_tells_a_worn_surface_by_a_heavier_one() {
    let (light, headline) = map_under(1e5, &worn(waves(1.0)), "", "");
    assert!(headline.maps.is_none(), "{headline:?}");
    assert!(light.maps[0].differs() && light.maps[0].ratio() > 1.2, "{:?}", light.maps);
    assert!(
        2.0 * light.maps[0].pressure_over_gradient * (POINTS * POINTS) as f64 > 199.0,
        "{:?}",
        light.maps
    );
}

#[test]
fn a_map_that_is_the_answer_is_held_against_gaussian_surfaces_under_each_load() {
    let heights_m = worn(waves(1.0));
    let files = Scans(vec![("map.txt", text(&heights_m))]);
    let surface = "scans = [{ file = \"map.txt\", unit = \"m\", size = \"6.4 um\" }]";
    let judgement = judged_with(&coarse(64, 2), "\"350 MPa\", \"1 GPa\"", &files, surface, "");
    assert_eq!(judgement.maps.len(), 2);
    for (load, map) in judgement.maps.iter().enumerate() {
        let reference = judgement.references.iter().find(|area| area.load == load).unwrap();
        assert_eq!((map.load, Some(map.twins)), (load, reference.of_spectrum));
        assert_eq!(Some(map.area_fraction), judgement.headline(load).unwrap().area_fraction);
    }
    // A surface that is worn touches more than a Gaussian one the lighter the load.
    assert!(judgement.maps[0].ratio() > 1.1 * judgement.maps[1].ratio(), "{:?}", judgement.maps);
}

#[test]
fn a_model_that_meets_a_map_and_misses_gaussian_surfaces_agrees_by_accident() {
    let mut seen = [0, 0];
    for heights_m in [waves(1.0), worn(waves(1.0)), waves(3.0)] {
        for pressure_pa in [100e6, 200e6, 350e6, 700e6, 1.2e9, 2e9] {
            let (judgement, _) = map_under(pressure_pa, &heights_m, "", "");
            for row in &judgement.curves {
                let (Some(ratio), Some(elements)) = (row.ratio(), row.elements) else { continue };
                let meets = Verdict::from_ratio(ratio, elements.relative_error()) == Verdict::Agrees;
                if judgement.references[0].maps.is_none() || !meets || row.windows == 0 {
                    continue;
                }
                let is_accident = 2 * row.agreeing <= row.windows;
                seen[usize::from(is_accident)] += 1;
                let expected = match is_accident {
                    true => (Verdict::OutOfRange, RemarkCode::AgreesByAccident),
                    false => (Verdict::Agrees, RemarkCode::ComparedAreas),
                };
                assert_eq!((row.verdict, row.reason.code), expected, "{row:?}");
                assert_eq!(row.reason.number("agreeing"), Some(row.agreeing as f64));
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
}

#[test]
fn maps_that_stand_for_the_surface_are_named_alone() {
    // A map ten times as wide has none of the short waves.
    let named = |size: &str| {
        let files = Scans(vec![("a.txt", text(&waves(1.0))), ("b.txt", text(&waves(1.0)))]);
        let (judgement, headline) =
            judged(&files, &TWO_MAPS.replacen("b.txt\", unit = \"m\", size = \"6.4", size, 1), "");
        assert!(headline.maps.is_some(), "{headline:?}");
        judgement.maps.iter().map(|map| map.map.clone()).collect::<Vec<_>>()
    };
    assert_eq!(named("b.txt\", unit = \"m\", size = \"6.4"), ["a.txt, b.txt"]);
    assert_eq!(named("b.txt\", unit = \"m\", size = \"64"), ["a.txt"]);
}

#[test]
fn a_map_beside_scans_that_hold_more_of_the_slopes_widens_the_range_by_what_it_differs() {
    let both = |heights_m: &[f64], steep: f64| {
        let files = Scans(vec![("map.txt", text(heights_m)), ("trace.txt", trace(steep))]);
        let scans = "scans = [{ file = \"map.txt\", unit = \"m\", size = \"6.4 um\" }, { file = \"trace.txt\", unit = \"m\" }]";
        judged(&files, scans, "")
    };
    // Traces that are much less steep than the map change nothing.
    let (_, of_map) = both(&worn(waves(1.0)), 1e-3);
    assert!(of_map.maps.is_some(), "{of_map:?}");
    let (judgement, headline) = both(&worn(waves(1.0)), 10.0);
    let (ratio, range) = (judgement.maps[0].ratio(), judgement.references[0].range.unwrap());
    assert!(headline.maps.is_none() && judgement.maps[0].differs() && ratio > 1.2, "{headline:?} {ratio}");
    assert_eq!((headline.low, headline.high), (range.low, (range.high * ratio).min(1.0)));
    let (judgement, headline) = both(&waves(1.0), 10.0);
    let range = judgement.references[0].range.unwrap();
    assert!(!judgement.maps[0].differs());
    assert_eq!((headline.low, headline.high), (range.low, range.high));
}

/// Two maps of 6.4 um.
const TWO_MAPS: &str = "scans = [{ file = \"a.txt\", unit = \"m\", size = \"6.4 um\" }, { file = \"b.txt\", unit = \"m\", size = \"6.4 um\" }]";

#[test]
fn a_map_is_compared_with_four_surfaces_of_its_waves_under_the_same_pressure_over_their_gradient() {
    let heights_m = waves(3.0);
    // A trace that holds more of the slopes leaves the map no answer of its own.
    let files = Scans(vec![("map.txt", text(&heights_m)), ("trace.txt", trace(10.0))]);
    let surface = "scans = [{ file = \"map.txt\", unit = \"m\", size = \"6.4 um\" }, { file = \"trace.txt\", unit = \"m\" }]";
    let loads = "\"1 TPa\", \"350 MPa\", \"351 MPa\", \"1 MPa\", \"700 MPa\"";
    let judgement = judged_with(&coarse(64, 2), loads, &files, surface, "");
    let own = MapWaves::new(&heights_m, POINTS, [SIDE_M; 2], true, 4.0);
    let surface = own.surface();
    let gradient_pa = CONTACT_MODULUS_PA * surface.mean_square_gradient().sqrt();
    // Under the lightest load two hundred points would touch; a load within a hundredth of another, and one that presses the map flat,
    // have no row.
    let least_pa = 200.0 / (2.0 * (POINTS * POINTS) as f64) * gradient_pa;
    let expected = [(1, 350e6), (3, least_pa), (4, 700e6)];
    assert!(least_pa > 1e6 && least_pa < 340e6, "{least_pa}");
    assert_eq!(judgement.maps.len(), expected.len(), "{:?}", judgement.maps);
    for (map, (load, pressure_pa)) in judgement.maps.iter().zip(expected) {
        assert_eq!((map.load, &map.map[..]), (load, "map.txt"));
        assert!((map.pressure_over_gradient / (pressure_pa / gradient_pa) - 1.0).abs() < 1e-6, "{map:?}");
        let area = |heights_m: &[f64], pressure_pa: f64| pressed_under(pressure_pa, heights_m, None)[0];
        assert!((map.area_fraction / area(&surface.heights_m, pressure_pa) - 1.0).abs() < 1e-3, "{map:?}");
        let of_twins_pa = map.gradient_over_spectrum * pressure_pa;
        let areas = [0, 1, 2, 3].map(|at| area(&own.twin(1, at).heights_m, of_twins_pa));
        let mean = areas.iter().sum::<f64>() / 4.0;
        let variance = areas.iter().map(|area| (area - mean).powi(2)).sum::<f64>() / 3.0;
        let error = (widening(4) * (variance / 4.0).sqrt()).hypot(0.015 * mean);
        assert!((map.twins.area_fraction / mean - 1.0).abs() < 1e-3, "{map:?} {mean}");
        assert!((map.twins.standard_error / error - 1.0).abs() < 0.02, "{map:?} {error}");
    }
}

#[test]
fn two_maps_have_the_mean_of_their_areas_gaps_stiffnesses_and_flowing_shares() {
    let maps = [waves(1.0), worn(waves(1.0))];
    let files = Scans(vec![("a.txt", text(&maps[0])), ("b.txt", text(&maps[1]))]);
    let rest = "indentation_hardness = \"700 MPa\"\n[interface]\n";
    let (_, headline) = judged(&files, TWO_MAPS, rest);
    let [first, second] = maps.map(|heights_m| pressed(&heights_m, Some(700e6)));
    let mean = |of: fn(&[f64; 5]) -> f64| 0.5 * (of(&first) + of(&second));
    let found = headline.maps.unwrap();
    let near = |found: Option<f64>, expected: f64| (found.unwrap() / expected - 1.0).abs() < 5e-3;
    assert!(near(headline.area_fraction, mean(|of| 0.5 * (of[0] + of[1]))), "{headline:?}");
    assert!(near(found.mean_gap_m, mean(|of| of[2])) && near(found.stiffness_pa_per_m, mean(|of| of[3])));
    assert!(near(found.plastic_share, mean(|of| of[4])), "{found:?} {first:?} {second:?}");
    // Half of what they differ, widened, with the error of the grid and half of what the perimeters take.
    let areas = [first, second].map(|of| 0.5 * (of[0] + of[1]));
    let apart = widening(2) * 0.5 * (areas[0] - areas[1]).abs() / (0.5 * (areas[0] + areas[1]));
    let ends = mean(|of| 0.5 * (of[1] - of[0]) / (of[0] + of[1]));
    let error = apart.hypot(0.015).hypot(ends);
    let area = headline.area_fraction.unwrap();
    assert!(
        (headline.high / (area * (1.0 + 2.0 * error)).min(1.0) - 1.0).abs() < 0.01,
        "{headline:?} {error}"
    );
}

#[test]
fn the_error_of_a_map_is_that_of_its_grid_its_perimeter_and_its_edges_and_few_points() {
    let heights_m = waves(1.0);
    let judged_at = |loads: &str, heights_m: &[f64]| {
        let files = Scans(vec![("map.txt", text(heights_m))]);
        let surface = "scans = [{ file = \"map.txt\", unit = \"m\", size = \"6.4 um\" }]";
        judged_with(&coarse(64, 2), loads, &files, surface, "")
    };
    let loads = "\"20 MPa\", \"350 MPa\"";
    for (load, of) in judged_at(loads, &heights_m).references.iter().enumerate() {
        let [corrected, counted, ..] = pressed_under([20e6, 350e6][load], &heights_m, None);
        let error = ((counted - corrected) / (2.0 * (counted + corrected))).hypot(0.015);
        let elements = of.elements.unwrap();
        assert!(
            of.maps.is_some() && (elements.relative_error() / error - 1.0).abs() < 0.02,
            "{of:?} {error}"
        );
    }
    let steps = |at: usize| 40e-9 * (2.0 * (at % POINTS) as f64 / POINTS as f64 - 1.0).powi(3);
    let tilted: Vec<f64> = heights_m.iter().enumerate().map(|(at, height_m)| height_m + steps(at)).collect();
    for of in &judged_at(loads, &tilted).references {
        let elements = of.elements.unwrap();
        let points = elements.area_fraction * (POINTS * POINTS) as f64;
        let least = 0.08f64.hypot(points.sqrt().recip()).hypot(0.015);
        let found = elements.relative_error();
        // Perimeters take a tenth, of which a quarter counts.
        assert!(of.maps.is_some() && found > least && found < least.hypot(0.12), "{of:?} {least}");
    }
}

#[test]
fn maps_are_pressed_as_finely_as_the_budget_allows() {
    let heights_m = waves(1.0);
    let files = Scans(vec![("a.txt", text(&heights_m)), ("b.txt", text(&heights_m))]);
    // Two maps under two loads; on the coarsest grid with one surface the windows cost less.
    let whole = 4.0 * 20.0 * (POINTS * POINTS) as f64;
    let error = |budget: f64| {
        let settings =
            JudgeSettings { grid: Some(32), realisations: Some(1), budget, ..JudgeSettings::default() };
        let judgement = judged_with(&settings, "\"350 MPa\", \"100 MPa\"", &files, TWO_MAPS, "");
        judgement
            .references
            .iter()
            .map(|of| of.maps.map(|_| of.elements.unwrap().relative_error()))
            .collect::<Vec<_>>()
    };
    // The middle of a map does not repeat itself, and has the error of its edges.
    assert!(error(whole * (1.0 + 1e-9)).iter().all(|error| error.unwrap() < 0.07), "{:?}", error(whole));
    let less = error(whole * (1.0 - 1e-9));
    assert!(less.iter().all(|error| error.is_none_or(|error| error > 0.08)), "{less:?}");
    let coarsest = 4.0 * 20.0 * 0.75f64.powf(0.3) * 48.0 * 48.0;
    assert!(error(coarsest * (1.0 - 1e-9)).iter().all(Option::is_none));
    assert!(error(coarsest * (1.0 + 1e-9)).iter().any(Option::is_some));
}

/// Heights of one map and of another that faces it.
fn facing(own_m: &[f64], other_m: &[f64]) -> Vec<f64> {
    let rows = own_m.chunks(POINTS).zip(other_m.chunks(POINTS));
    rows.flat_map(|(own, other)| own.iter().zip(other.iter().rev()).map(|(own, other)| own + other)).collect()
}

fn judged_faces(own_m: &[f64], other_m: &[f64]) -> (Scene, Judgement) {
    let files = Scans(vec![("own.txt", text(own_m)), ("other.txt", text(other_m))]);
    let scan = |name: &str| format!("scans = [{{ file = \"{name}\", unit = \"m\", size = \"6.4 um\" }}]");
    let scene = format!(
        "[surface]\n{}\n[material]\nyoungs_modulus = \"100 GPa\"\npoisson_ratio = 0\n[counterface.surface]\n{}\n[interface]\n\
         [loads]\npressures = [\"{PRESSURE_PA} Pa\"]\n[[curve]]\nmodel = \"persson\"\n",
        scan("own.txt"),
        scan("other.txt")
    );
    let scene = Scene::parse(&scene, &files, &Overrides::default()).unwrap_or_else(|error| panic!("{error}"));
    let results = scene.plan().compute().unwrap();
    let judgement = JudgePlan::new(&scene, &results, &coarse(64, 2)).run(&Unobserved).unwrap();
    (scene, judgement)
}

#[test]
fn faces_that_are_one_map_each_are_pressed_as_their_sum() {
    let own_m = waves(1.0);
    let (scene, judgement) = judged_faces(&own_m, &worn(own_m.clone()));
    let exact = pressed(&facing(&own_m, &worn(own_m.clone())), None);
    let headline = judgement.headline(0).unwrap();
    assert_holds(headline, exact);
    let stiffness = headline.maps.unwrap().stiffness_pa_per_m.unwrap();
    assert!((stiffness / exact[3] - 1.0).abs() < 0.02, "{stiffness} {exact:?}");
    let codes = |scene: &Scene| scene.surface.notes.iter().map(|note| note.code).collect::<Vec<_>>();
    assert!(
        codes(&scene).contains(&RemarkCode::FacingMaps) && !codes(&scene).contains(&RemarkCode::FacesFit)
    );

    // Halves of one joint: most of their heights cancel, which their spectra do not know.
    let mate_m: Vec<f64> =
        facing(&vec![0.0; own_m.len()], &own_m).iter().map(|height_m| -0.6 * height_m).collect();
    let (scene, judgement) = judged_faces(&own_m, &mate_m);
    assert!(codes(&scene).contains(&RemarkCode::FacesFit));
    let exact = pressed(&facing(&own_m, &mate_m), None);
    assert_holds(judgement.headline(0).unwrap(), exact);
}

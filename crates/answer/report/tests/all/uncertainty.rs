//! Draws in a report: intervals, their causes, assumptions, and the next measurement.

use std::collections::BTreeMap;

use conclusions::{Conclusions, Evidence, NextStep};
use findings::answer::SceneAnswer;
use findings::sensitivity::{Sensitivity, sensitivities};
use questions::RunOptions;
use report::details::details;
use report::products::{self, SceneProducts};
use report::run_stamp::RunStamp;
use scene::{Overrides, Scene};
use study::NoFiles;
use study::plan::{Results, Work};
use tables::Format;
use uncertainty::{
    Advice, AreaBand, AreaInterval, BandPoint, DecadeOfVariance, Group, Index, Indices, InstrumentInput,
    InstrumentName, OverlapMisfit, Resampled, Settling, SpectrumErrors, Step, StepKind, Uncertainty,
    UncertaintySettings,
};
use units::{Remark, RemarkCode};

const SCENE: &str = r#"
    title = "Diamond, as measured"
    surface = { psd = "builtin:uncd-measured" }
    material = { youngs_modulus = "463 GPa +- 5 GPa", poisson_ratio = 0.2, yield_strength = "1.8 GPa" }
    loads = { pressures = ["1 MPa", "100 MPa"] }
    [[curve]]
    model = "elastic"
    [[curve]]
    model = "persson"
    [[curve]]
    model = "hertz"
    [[figure]]
    name = "area"
    shows = "area"
    [[figure]]
    name = "load"
    shows = "area-against-load"
    curves = ["hertz"]
    cutoff_multiples = [1]
    loads = { from = "100 kPa", to = "1 GPa", points = 9 }
"#;

/// A scene with one curve, which is the nearest to the answer.
const ONE_CURVE: &str = r#"
    title = "Diamond, as measured"
    surface = { psd = "builtin:uncd-measured" }
    material = { youngs_modulus = "463 GPa +- 5 GPa", poisson_ratio = 0.2, yield_strength = "1.8 GPa" }
    loads = { pressures = ["1 MPa"] }
    [[curve]]
    model = "elastic"
"#;

struct Study {
    scene: Scene,
    results: Results,
    answer: SceneAnswer,
    sensitivities: Vec<Sensitivity>,
}

impl Study {
    fn new() -> Self {
        Study::of(SCENE)
    }

    fn of(scene: &str) -> Self {
        let scene = Scene::parse(scene, &NoFiles, &Overrides::default()).unwrap();
        let results = scene.plan().compute().unwrap();
        let answer = SceneAnswer::from_results(&scene, &results);
        let sensitivities = sensitivities(&scene, &results, &study::Unobserved).unwrap();
        Study { scene, results, answer, sensitivities }
    }

    fn evidence<'a>(&'a self, uncertainty: Option<&'a Uncertainty>) -> Evidence<'a> {
        Evidence {
            scene: &self.scene,
            results: &self.results,
            answer: &self.answer,
            judgement: None,
            uncertainty,
        }
    }

    fn words(&self, uncertainty: &Uncertainty) -> String {
        let evidence = self.evidence(Some(uncertainty));
        // As it stands before lines are broken.
        let text = details(&evidence, &Conclusions::new(&evidence));
        text.replace("\n  ", " ")
    }

    fn files(&self, uncertainty: Option<&Uncertainty>) -> BTreeMap<String, String> {
        let mut files = BTreeMap::new();
        let evidence = self.evidence(uncertainty);
        let products = SceneProducts {
            evidence,
            conclusions: &Conclusions::new(&evidence),
            sensitivities: Some(&self.sensitivities),
            run_stamp: &RunStamp::default(),
        };
        let names = products.each_file(Format::Csv, |name, content| {
            let mut bytes = Vec::new();
            content(&mut bytes)?;
            files.insert(name.to_owned(), String::from_utf8(bytes).unwrap());
            Ok::<(), std::io::Error>(())
        });
        assert_eq!(names.unwrap().len(), files.len());
        files
    }

    /// Draws of two instruments and of the material, by hand.
    fn drawn(&self) -> Uncertainty {
        let instrument = |name, scans, resampled, z_calibration_is_assumed| InstrumentInput {
            name,
            scans,
            resampled,
            z_calibration: 0.03,
            z_calibration_is_assumed,
            slope_uncertainty: 0.0,
            gain: [-0.01, 0.04],
            band_m: [2e-5, 4e-9],
        };
        let guessed = InstrumentName::Guessed("AFM".to_owned());
        let given = InstrumentName::Given("stylus".to_owned());
        let loads = self.scene.needs.loads.len();
        let places =
            (0..self.scene.needs.curves.len()).flat_map(|curve| (0..loads).map(move |load| (curve, load)));
        let areas: Vec<AreaInterval> = places.clone().map(|(curve, load)| self.area(curve, load)).collect();
        let bands = places.clone().map(|(curve, load)| self.band(curve, load)).collect();
        Uncertainty {
            settings: UncertaintySettings::default(),
            draws: 1000,
            ended_early: false,
            groups: vec![Group::Scans, Group::Instruments, Group::Material],
            instruments: vec![
                instrument(given, 2, Resampled::Scans(2), false),
                instrument(guessed, 3, Resampled::Scans(3), true),
            ],
            overlaps: vec![OverlapMisfit {
                instruments: [0, 1],
                misfit: 0.08,
                scatter: 0.03,
                expected: 0.07,
                bins: 6,
                longest_m: 2e-5,
                shortest_m: 4e-6,
            }],
            spectrum_errors: Vec::new(),
            guesses: vec![Remark::new(RemarkCode::FewScans).with("instrument", "stylus").with("scans", 2)],
            areas,
            quantities: Vec::new(),
            open_channels: Vec::new(),
            bands,
            advice: places.map(|(curve, load)| advice(curve, load)).collect(),
            work: Work::default(),
            plans: 1000,
        }
    }

    fn area(&self, curve: usize, load: usize) -> AreaInterval {
        let area_fraction = self.answer.curves[curve][load].as_ref().unwrap().area_fraction;
        let index = |value| Index { value, standard_error: 0.02 };
        let indices = |value| Indices { first_order: index(value), total: index(value) };
        AreaInterval {
            curve,
            load,
            area_fraction,
            median: area_fraction,
            low: 0.7 * area_fraction,
            high: 1.4 * area_fraction,
            within_68: [0.85 * area_fraction, 1.2 * area_fraction],
            monte_carlo_error: 0.03,
            ln_area_sd: 0.18,
            indices: vec![indices(0.7), indices(0.2), indices(0.06)],
        }
    }

    fn band(&self, curve: usize, load: usize) -> AreaBand {
        let point = |(wavelength_m, area): (f64, f64)| {
            let width = 0.35 * (1.0 - wavelength_m.log10() / -5.0).abs().min(1.0) + 0.05;
            let (low, high) = (area * (-width).exp(), area * width.exp());
            BandPoint { wavelength_m, area_fraction: area, median: area, low, high }
        };
        let points = self.results.curves[curve].area_fractions(load).into_iter().map(point).collect();
        AreaBand { curve, load, points }
    }
}

fn advice(curve: usize, load: usize) -> Advice {
    let decade = |longest_m: f64, share| DecadeOfVariance { longest_m, shortest_m: longest_m / 10.0, share };
    let step = |kind, width_ratio| Step { kind, width_ratio, area_ratio: 1.0 };
    Advice {
        curve,
        load,
        decades: vec![decade(1e-5, 0.08), decade(1e-6, 0.28), decade(1e-7, 0.64)],
        instruments: vec![[0.05, 0.08], [0.65, 0.12]],
        steps: vec![
            step(StepKind::MoreScans { instrument: 1, added: 10 }, 0.62),
            step(StepKind::MoreScans { instrument: 1, added: 3 }, 0.744),
            step(StepKind::Calibration { instrument: 1 }, 0.93),
            step(StepKind::MoreScans { instrument: 0, added: 1 }, 0.999),
            Step { kind: StepKind::ShorterWavelengths { to_m: 1.3e-9 }, width_ratio: 1.2, area_ratio: 0.7 },
        ],
        settling: Settling::CannotSettle { slope: -2.6, standard_error: 0.1 },
    }
}

#[test]
fn the_inputs_of_intervals_and_their_assumptions_are_in_the_notes() {
    let study = Study::new();
    let words = study.words(&study.drawn());
    for said in [
        "type A: the scatter of scans between places; type B: the height scales of instruments and the elastic constants",
        "Treat the range as a guess: two stylus scans cannot show how much the surface varies.",
        "stylus and AFM differ by a factor 1.08 from 20 µm to 4 µm, where both measure (standard uncertainty: a factor 1.07): as \
         expected.",
        "Height calibration of AFM unknown, 3 % assumed (set z_calibration).",
        "Instruments guessed from format and maker: AFM (3 scans) (set instrument).",
    ] {
        assert!(words.contains(said), "{said}\n{words}");
    }
    let page = &study.files(Some(&study.drawn()))["report.html"];
    assert!(page.contains("too flat for a limit; the area depends on the cutoff."));
}

#[test]
fn what_carries_an_interval_is_told_as_well_as_it_is_known() {
    let study = Study::of(ONE_CURVE);
    let page = |drawn: &Uncertainty| study.files(Some(drawn))["report.html"].clone();
    let mut drawn = study.drawn();
    assert!(page(&drawn).contains("mostly from the scatter of three AFM scans"));
    // The scatter of no instrument leads.
    drawn.advice[0].instruments = vec![[0.35, 0.0], [0.35, 0.0]];
    assert!(page(&drawn).contains("mostly from the scatter of scans between places"));
    drawn.areas[0].indices[0].first_order.value = 0.45;
    assert!(page(&drawn).contains("the largest part (45 %) from the scatter"));
    drawn.areas[0].indices[0].first_order.standard_error = 0.2;
    let unknown = page(&drawn);
    assert!(!unknown.contains("mostly from") && !unknown.contains(" %) from"), "{unknown}");
    drawn.groups = vec![Group::Strength];
    assert!(page(&drawn).contains(", from the hardness"));
}

#[test]
fn a_guess_an_early_end_and_errors_of_a_file_are_told() {
    let study = Study::new();
    let mut drawn = study.drawn();
    drawn.instruments.clear();
    drawn.overlaps.clear();
    drawn.advice.clear();
    (drawn.draws, drawn.ended_early) = (312, true);
    drawn.guesses = vec![
        Remark::new(RemarkCode::FewDraws).with("draws", 312),
        Remark::new(RemarkCode::SpectrumWithoutErrors).with("name", "s.csv"),
    ];
    drawn.spectrum_errors = vec![SpectrumErrors {
        name: "t.csv".to_owned(),
        samples: 90,
        of: 94,
        correlation_decades: 0.5,
        are_assumed: false,
    }];
    let words = study.words(&drawn);
    for said in [
        "The draws were stopped after 312 of 2000: intervals rest on these, and there is no advice.",
        "Treat the range as a guess: it rests on 312 draws only.",
        "s.csv has no standard errors, so it holds the scatter of the other inputs only",
        "t.csv: 90 of 94 samples have a standard error, the others take that of their neighbours; errors are taken as correlated over 0.5 decades of wavelength.",
        "type A: the standard errors of the spectrum;",
    ] {
        assert!(words.contains(said), "{said}\n{words}");
    }
}

#[test]
fn a_run_with_draws_adds_its_tables_and_a_run_without_has_the_files_that_it_had() {
    let study = Study::new();
    let (plain, drawn) = (study.files(None), study.files(Some(&study.drawn())));
    let added: Vec<&String> = drawn.keys().filter(|name| !plain.contains_key(*name)).collect();
    assert_eq!(added, ["report-advice.csv", "report-sobol.csv", "report-uncertainty.csv"]);
    let options = RunOptions { report: true, judge: Some(false), uncertainty: Some(true) };
    let mut announced = products::file_names(&study.scene, options, Format::Csv);
    announced.sort();
    assert_eq!(announced, drawn.keys().cloned().collect::<Vec<_>>());
    // The tables of figures of areas have their intervals.
    for name in plain.keys().filter(|name| name.ends_with(".csv")) {
        assert_eq!(plain[name] == drawn[name], !["area.csv", "load.csv"].contains(&name.as_str()), "{name}");
    }
    assert!(drawn["area.csv"].contains("elastic at 1 MPa low,elastic at 1 MPa high"));
}

#[test]
fn figures_of_areas_show_the_intervals() {
    let study = Study::new();
    let (plain, drawn) = (study.files(None), study.files(Some(&study.drawn())));
    let legend = ">95 % coverage interval</text>";
    for name in ["area.svg", "load.svg"] {
        assert_eq!(
            (plain[name].matches(legend).count(), drawn[name].matches(legend).count()),
            (0, 1),
            "{name}"
        );
    }
    let bands = |files: &BTreeMap<String, String>| files["area.svg"].matches("class=\"band\"").count();
    assert_eq!(bands(&drawn), bands(&plain) + 6, "one for each line");
}

#[test]
fn the_page_has_a_section_on_how_sure_it_is_and_one_on_what_to_measure_next() {
    let study = Study::of(ONE_CURVE);
    let (plain, drawn) = (study.files(None), study.files(Some(&study.drawn())));
    for id in ["how-sure", "measure-next"] {
        let section = format!("id=\"{id}\">");
        assert!(drawn["report.html"].contains(&section) && !plain["report.html"].contains(&section), "{id}");
    }
    let text = drawn["report.html"].strip_prefix("<!DOCTYPE html>").unwrap();
    let page = roxmltree::Document::parse(text).unwrap();
    let steps = page.descendants().filter(|node| node.has_tag_name("li"));
    let uncertainty = study.drawn();
    let next = Conclusions::new(&study.evidence(Some(&uncertainty))).next;
    let is_of_afm =
        |step: &NextStep| matches!(step, NextStep::MoreScans { instrument, .. } if instrument == "AFM");
    assert!(next.iter().any(is_of_afm), "{next:?}");
    assert!(steps.filter_map(|node| node.text()).any(|step| step.contains("AFM")));
}

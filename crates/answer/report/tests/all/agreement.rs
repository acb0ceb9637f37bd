//! Everything that a scene says about one number agrees: headline, matrix, tables, seal, yield and advice, of thirty
//! scenes.

use std::collections::BTreeMap;

use findings::conclusions::{Conclusions, Evidence, LoadConclusion, ModelCell, NextStep, Source, trust_left};
use interface::conductance::MOST_PLASTIC_SHARE;
use judge::{AGREEMENT, CurveVerdict, Judgement, Verdict};
use questions::{RunOptions, SceneOutcome, Unwatched, run_scene};
use report::products::{ANSWER, Product, SceneProducts};
use report::run_stamp::RunStamp;
use scene::{Overrides, Scene};
use study::interface::InterfaceStates;
use study::interface::{Quantity, Slot};
use units::{Remark, RemarkCode};

/// Spectra without errors, with them, with a hole of 1.3 decades, from roughness parameters; and two bodies.
const SURFACES: [&str; 4] = [
    "surface = { psd = \"plain.csv\" }",
    "surface = { psd = \"errors.csv\" }",
    "surface = { psd = \"hole.csv\" }",
    "surface = { rms_height = \"1.2 um\", rms_slope = 0.2, hurst = 0.8, rolloff_wavelength = \"60 um\" }",
];

/// Bodies that never yield, yield at a constant hardness, or at one that grows; soft and hard, one against another.
const BODIES: [&str; 6] = [
    "material = { youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }",
    "material = { name = \"100Cr6\" }",
    "material = { name = \"diamond\", yield_strength = \"1.8 GPa\", strain_gradient_length = \"5 um\" }",
    "material = { youngs_modulus = \"5 MPa +- 10 %\", poisson_ratio = 0.49 }",
    "material = { name = \"100Cr6\" }\ncounterface = { name = \"gold\" }",
    "material = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, yield_strength = \"100 MPa\", strain_gradient_length = \"2 um\" }",
];

/// Few points and few draws: what is said of them must agree all the same.
const SMALL: &str = "[judge]\ngrid = 64\n[uncertainty]\ndraws = 200\n";

const SEAL: &str =
    "[seal]\npressure_drop = \"1 MPa\"\nviscosity = \"1 mPa s\"\nbreadth = \"100 mm\"\nlength = \"2 mm\"\n";

/// The scenes that come with the program.
const SHIPPED: [&str; 6] = [
    "bolted-joint",
    "contact-challenge",
    "electrical-contact",
    "gasket",
    "uncd-measured",
    "uncd-reconstructed",
];

#[test]
fn headline_matrix_table_seal_yield_and_advice_agree() {
    let files = spectra();
    let mut texts = generated();
    for name in SHIPPED {
        let path = format!("{}/../../../data/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        texts.push(std::fs::read_to_string(path).unwrap());
    }
    assert!(texts.len() >= 30);
    let mut seen = Seen::default();
    for text in &texts {
        let scene = Scene::parse(text, &files, &Overrides::default())
            .unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let options = RunOptions { report: true, judge: None, uncertainty: None };
        let outcome =
            run_scene(&scene, options, &Unwatched).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        println!("{text}");
        check(&scene, &outcome, &mut seen);
    }
    assert!(seen.holes > 0 && seen.yielded > 0 && seen.closed > 0 && seen.conditions > 0, "{seen:?}");
}

/// The caution on adhesion follows the indicator: Pastewka & Robbins' where a range is given, or else Fuller & Tabor's.
#[test]
fn areas_of_sticky_surfaces_carry_a_caution() {
    let files = spectra();
    let sticky = |interface: &str| {
        let text = format!(
            "{}\n{}\n[loads]\npressures = [\"1 kPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\noff = true\n[interface]\n{interface}",
            SURFACES[0], BODIES[3]
        );
        let scene = Scene::parse(&text, &files, &Overrides::default()).unwrap();
        let options = RunOptions { report: true, judge: None, uncertainty: None };
        let outcome = run_scene(&scene, options, &Unwatched).unwrap();
        let states = scene.interface_states(&outcome.results).unwrap();
        let value = |quantity| states.value(Slot { quantity, load: None, curve: None }).unwrap();
        let indicators = [value(Quantity::PastewkaRobbins), value(Quantity::FullerTabor)];
        let is_sticky = |caution: &&Remark| caution.code.name() == "sticky";
        let found = outcome.conclusions.cautions.iter().find(is_sticky).cloned();
        (found.map(|found| (found.code, found.number("left_side").or(found.number("theta")))), indicators)
    };
    let (found, [left_side, _]) =
        sticky("work_of_adhesion = \"100 J/m^2\"\nrange_of_attraction = \"10 nm\"\n");
    assert_eq!(found, Some((RemarkCode::StickyByPastewka, left_side)));
    let (found, [_, theta]) = sticky("work_of_adhesion = \"100 J/m^2\"\n");
    assert_eq!(found, Some((RemarkCode::StickyByFuller, theta)));
    for weak in [
        "work_of_adhesion = \"0.001 mJ/m^2\"\nrange_of_attraction = \"10 nm\"\n",
        "work_of_adhesion = \"0.001 mJ/m^2\"\n",
        "",
    ] {
        assert_eq!(sticky(weak).0, None, "{weak}");
    }
}

/// Counts of what the scenes showed, so that no check is empty.
#[derive(Debug, Default)]
struct Seen {
    holes: usize,
    yielded: usize,
    closed: usize,
    conditions: usize,
}

fn check(scene: &Scene, outcome: &SceneOutcome, seen: &mut Seen) {
    let conclusions = &outcome.conclusions;
    let judgement = outcome.judgement.as_ref().unwrap();
    assert!(!conclusions.loads.is_empty());
    for load in &conclusions.loads {
        check_headline(load);
        check_models(load, judgement, scene);
        seen.conditions += usize::from(load.otherwise.is_some());
    }
    check_advice(conclusions, seen);
    let left = conclusions.cautions.iter().map(trust_left).min();
    assert!(left.is_none_or(|left| left == conclusions.trust));
    if let Some(states) = scene.interface_states(&outcome.results) {
        check_yield(conclusions, &states, seen);
        check_seal(scene, conclusions, &states, seen);
    }
    check_products(scene, outcome);
}

fn check_headline(load: &LoadConclusion) {
    let area = &load.area;
    assert!(0.0 < area.low && area.low <= area.high && area.high <= 1.0, "{area:?}");
    if let Some(area_fraction) = area.area_fraction {
        assert!((area.low..=area.high).contains(&area_fraction), "{area:?}");
        if let Source::Elements(reference) = area.source {
            // Listed models may all be compared with other elements.
            let at = load.references.iter().position(|group| group.reference == reference);
            match at {
                Some(at) => assert_eq!((at, load.references[at].area_fraction), (0, Some(area_fraction))),
                None => assert_eq!((load.tally.agree, load.best_model), (0, None)),
            }
        }
        if let Some(other) = load.otherwise {
            assert!(!(area.low..=area.high).contains(&other.area_fraction));
            assert!((other.ratio * area_fraction / other.area_fraction - 1.0).abs() < 1e-12);
        }
    }
}

fn check_models(load: &LoadConclusion, judgement: &Judgement, scene: &Scene) {
    let mut models = 0;
    for group in &load.references {
        for cell in &group.models {
            models += 1;
            let verdicts = judgement.curves.iter();
            let of_cell: Vec<_> =
                verdicts.filter(|row| (row.curve, row.load) == (cell.curve, load.load)).collect();
            let [row] = of_cell[..] else { panic!("one verdict per model and load") };
            assert_eq!(
                (row.verdict, row.ratio(), row.reference),
                (cell.verdict, cell.ratio, group.reference)
            );
            let Some(ratio) = cell.ratio else { continue };
            let own = cell.area_fraction.unwrap() / group.area_fraction.unwrap();
            assert!((ratio / own - 1.0).abs() < 1e-9, "{ratio} and {own}");
            // The bounds are narrowed by the error of the elements.
            let narrowed = AGREEMENT / (1.0 + row.elements.unwrap().relative_error());
            match cell.verdict {
                Verdict::TooLarge => assert!(ratio > narrowed && ratio > 1.0),
                Verdict::TooSmall => assert!(1.0 / ratio > narrowed && ratio < 1.0),
                Verdict::Agrees => assert!(ratio.max(1.0 / ratio) <= narrowed),
                Verdict::OutOfRange | Verdict::NotJudged => {}
            }
        }
    }
    let tally = load.tally;
    let counted = tally.agree + tally.off + tally.not_valid + tally.not_judged + tally.of_other_elements;
    assert_eq!(counted, models);
    assert!(models <= scene.needs.curves.len());
    let distance = |ratio: Option<f64>| ratio.unwrap().ln().abs();
    match load.best_model {
        Some(best) => {
            assert_eq!(best.verdict, Verdict::Agrees);
            let holds = |cell: &&ModelCell| {
                let is_same = |row: &&CurveVerdict| (row.curve, row.load) == (cell.curve, load.load);
                judgement.curves.iter().find(is_same).is_some_and(CurveVerdict::holds)
            };
            assert!(holds(&&best));
            let mut leading = load.references[0].models.iter().filter(holds);
            assert!(leading.all(|cell| distance(best.ratio) <= distance(cell.ratio)));
        }
        None => {
            let leading = load.references.first().map(|group| group.reference);
            let is_leading = |row: &&CurveVerdict| row.load == load.load && Some(row.reference) == leading;
            let holds = judgement.curves.iter().filter(is_leading).any(CurveVerdict::holds);
            assert!(!holds || load.area.area_fraction.is_none());
        }
    }
}

fn check_advice(conclusions: &Conclusions, seen: &mut Seen) {
    let warns = |code| conclusions.cautions.iter().any(|caution| caution.code == code);
    let advises = |is: fn(&NextStep) -> bool| conclusions.next.iter().any(is);
    let has_hole = warns(RemarkCode::NotMeasured);
    assert_eq!(has_hole, advises(|step| matches!(step, NextStep::CloseHole(_))));
    assert!(!has_hole || matches!(conclusions.next[0], NextStep::CloseHole(_)));
    seen.holes += usize::from(has_hole);
    let hardness_decides = warns(RemarkCode::HardnessDecides);
    assert_eq!(hardness_decides, advises(|step| matches!(step, NextStep::HardnessAtSmallDepth)));
    assert!(!conclusions.loads.iter().any(|load| load.otherwise.is_some()) || hardness_decides);
    let is_finer =
        |step: &NextStep| matches!(step, NextStep::Wavelengths { area_ratio, .. } if *area_ratio < 0.95);
    if conclusions.next.iter().any(is_finer) {
        assert!(warns(RemarkCode::UpperBound));
    }
}

fn check_yield(conclusions: &Conclusions, states: &InterfaceStates<'_>, seen: &mut Seen) {
    for caution in &conclusions.cautions {
        if caution.code != RemarkCode::GapOfYieldingContact {
            continue;
        }
        let share = caution.number("share").unwrap();
        let shares = || conclusions.loads.iter().filter_map(|load| states.plastic_share(load.load));
        assert!(share > MOST_PLASTIC_SHARE && shares().any(|other| other == share));
        assert!(
            conclusions
                .loads
                .iter()
                .any(|load| !matches!(load.area.source, Source::Elements(judge::Reference::Elastic)))
        );
        seen.yielded += 1;
    }
}

fn check_seal(scene: &Scene, conclusions: &Conclusions, states: &InterfaceStates<'_>, seen: &mut Seen) {
    let Some(seal) = &conclusions.seal else { return };
    let tight =
        states.value(Slot { quantity: Quantity::TightPressure, load: None, curve: None }).ok().flatten();
    let closes_pa = seal.closes.map_or(f64::INFINITY, |closing| closing.nominal_pressure_pa);
    assert!(closes_pa <= tight.unwrap_or(f64::INFINITY));
    assert_eq!(seal.closed_under.len() + seal.open_under.len(), scene.needs.loads.len());
    for (loads, is_closed) in [(&seal.closed_under, true), (&seal.open_under, false)] {
        for &load in loads {
            assert_eq!(scene.needs.loads[load].nominal_pressure_pa() >= closes_pa, is_closed);
            let slot = Slot { quantity: Quantity::LeakRateHigh, load: Some(load), curve: None };
            let leak = states.value(slot).ok().flatten();
            let leaks = leak.is_some_and(|leak_m3_per_s| leak_m3_per_s > 0.0);
            assert_eq!(leaks, !is_closed, "{leak:?} under load {load}: {seal:?}");
            seen.closed += usize::from(is_closed);
        }
    }
}

/// The table of verdicts and `answer.json` hold what the conclusions hold.
fn check_products(scene: &Scene, outcome: &SceneOutcome) {
    let evidence = Evidence {
        scene,
        results: &outcome.results,
        answer: &outcome.answer,
        judgement: outcome.judgement.as_ref(),
        uncertainty: outcome.uncertainty.as_ref(),
    };
    let products = SceneProducts {
        evidence,
        conclusions: &outcome.conclusions,
        sensitivities: outcome.sensitivities.as_deref(),
        run_stamp: &RunStamp { date: None, command: None },
    };
    let mut tables = 0;
    let taken: Result<(), ()> = products.each(tables::Format::Csv, |name, product| {
        match product {
            Product::Table { table, .. } if name == "report-models" => {
                tables += 1;
                let column = |wanted| table.columns().find(|(name, _)| *name == wanted).unwrap().1;
                let (tables::Cells::Numbers(ratios), tables::Cells::Typed(verdicts)) =
                    (column("ratio_to_judge"), column("verdict"))
                else {
                    panic!("ratios are numbers, verdicts text")
                };
                let rows = &outcome.judgement.as_ref().unwrap().curves;
                for ((row, ratio), verdict) in rows.iter().zip(ratios).zip(verdicts) {
                    assert_eq!((row.ratio(), row.verdict.name()), (*ratio, &*verdict.text()));
                }
            }
            Product::Text(text) if name == ANSWER => {
                tables += 1;
                let answer: serde_json::Value = serde_json::from_str(text).unwrap();
                for (load, found) in outcome.conclusions.loads.iter().zip(answer["loads"].as_array().unwrap())
                {
                    let agrees = |key: &str, value: f64| {
                        let written = found["area"][key].as_f64().unwrap();
                        assert!((written / value - 1.0).abs() < 1e-14, "{key}: {written} and {value}");
                    };
                    load.area.area_fraction.into_iter().for_each(|value| agrees("area_fraction", value));
                    agrees("low", load.area.low);
                    agrees("high", load.area.high);
                }
            }
            _ => {}
        }
        Ok(())
    });
    assert_eq!((taken, tables), (Ok(()), 2));
}

/// Scenes of all bodies on all surfaces, with loads, seals and lists of curves in turn; one more shows a seal that
/// closes.
fn generated() -> Vec<String> {
    let mut texts = Vec::new();
    for (body, bodies) in BODIES.iter().enumerate() {
        for (surface, surfaces) in SURFACES.iter().enumerate() {
            let pressures = match (body + surface) % 3 {
                0 => "\"10 MPa\"",
                1 => "\"1 MPa\", \"30 MPa\"",
                _ => "\"100 kPa\", \"5 MPa\", \"200 MPa\"",
            };
            let pressures = if body == 3 { "\"10 kPa\", \"100 kPa\"" } else { pressures };
            let seal = if (body + surface) % 2 == 0 { SEAL } else { "[interface]\n" };
            let curves = match (body + 2 * surface) % 4 {
                0 => "[[curve]]\nmodel = \"persson\"\n[[curve]]\nmodel = \"elastic\"\n",
                _ => "",
            };
            texts.push(format!(
                "{surfaces}\n{bodies}\nloads = {{ pressures = [{pressures}] }}\n{seal}{curves}{SMALL}"
            ));
        }
    }
    texts.push(format!(
        "{}\n{}\nloads = {{ pressures = [\"1 MPa\", \"60 MPa\"] }}\n{SEAL}",
        SURFACES[3], BODIES[3]
    ));
    texts
}

/// The spectra that the scenes name: C1D falls as q^-2.6 below 50 um, down to 10 nm.
fn spectra() -> BTreeMap<String, Vec<u8>> {
    let spectrum = |head: &str, tail: &dyn Fn(f64) -> String, keeps: &dyn Fn(f64) -> bool| {
        let row = |at: i32| {
            let wavelength_m = 10f64.powf(-3.9 - 0.1 * f64::from(at));
            let c1d_m3 = 2e-17 * (1.0 + (50e-6 / wavelength_m).powi(2)).powf(-1.3);
            keeps(wavelength_m).then(|| format!("{wavelength_m:e},{c1d_m3:e}{}\n", tail(c1d_m3)))
        };
        let rows: String = (0..=41).filter_map(row).collect();
        format!("wavelength_m,C1D_m3{head}\n{rows}").into_bytes()
    };
    let plain = |_: f64| String::new();
    let is_measured = |wavelength_m: f64| !(1.1e-7..2.2e-6).contains(&wavelength_m);
    BTreeMap::from([
        ("plain.csv".to_owned(), spectrum("", &plain, &|_| true)),
        (
            "errors.csv".to_owned(),
            spectrum(",C1D_se_m3", &|c1d_m3| format!(",{:e}", 0.2 * c1d_m3), &|_| true),
        ),
        ("hole.csv".to_owned(), spectrum("", &plain, &is_measured)),
    ])
}

//! Scenes run to all of their results, and intervals of areas.

use std::cell::RefCell;

use asperity::Hardness;
use numerics::parallel::{Progress, Unobserved};
use questions::{
    CurveQuestion, Phase, QuestionError, RunError, RunOptions, SamplingInput, UncertaintyQuestion, Unwatched,
    Watch, run_scene,
};
use scene::{Overrides, Scene, UncertaintySettings};
use spectrum::{AmplitudeDefinition, Normalisation};
use stat_contact::{Flattening, InterferenceLaw};
use study::NoFiles;
use study::material_spreads::MaterialSpreads;
use study::models::ModelOptions;
use study::plan::Tolerance;
use study::spread::Spread;
use units::RemarkCode;

use crate::common::{Counted, assert_near, hard, has, loads, model, surface, unused};

/// A scene of steel with more sections.
fn scene(modulus: &str, more: &str) -> Scene {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"{modulus}\"\npoisson_ratio = 0.3\n\
         indentation_hardness = \"6 GPa\"\n[loads]\npressures = [\"10 MPa\"]\n[options]\nscales_per_decade = 3\n\
         [[curve]]\nmodel = \"persson\"\n{more}"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap_or_else(|error| panic!("{error:?}"))
}

const EXACT: &str = "200 GPa";
const SPREAD: &str = "200 GPa +- 10 GPa";

fn options(report: bool, judge: Option<bool>, uncertainty: Option<bool>) -> RunOptions {
    RunOptions { report, judge, uncertainty }
}

#[test]
fn elements_judge_a_report_and_a_scene_that_says_so_unless_it_or_the_user_turns_them_off() {
    let [plain, judged, off] =
        ["", "[judge]\nseed = 2\n", "[judge]\noff = true\n"].map(|section| scene(EXACT, section));
    for (scene, by_itself, in_a_report) in
        [(&plain, false, true), (&judged, true, true), (&off, false, false)]
    {
        assert_eq!(options(false, None, None).is_judged(scene), by_itself);
        assert_eq!(options(true, None, None).is_judged(scene), in_a_report);
        for wanted in [false, true] {
            assert_eq!(options(!wanted, Some(wanted), None).is_judged(scene), wanted);
        }
    }
}

#[test]
fn inputs_are_drawn_where_one_is_uncertain_unless_the_scene_or_the_user_turns_it_off() {
    let [plain, drawn, off] =
        ["", "[uncertainty]\ndraws = 30\n", "[uncertainty]\noff = true\n"].map(|section| {
            // With an uncertain modulus, and with none.
            [SPREAD, EXACT].map(|modulus| scene(modulus, section))
        });
    for (scenes, by_itself, in_a_report) in [(&plain, true, true), (&drawn, true, true), (&off, false, false)]
    {
        let [uncertain, exact] = scenes;
        assert_eq!(options(false, None, None).is_drawn(uncertain), by_itself);
        assert_eq!(options(true, None, None).is_drawn(uncertain), in_a_report);
        assert!(options(false, None, Some(true)).is_drawn(uncertain));
        assert!(!options(true, None, Some(false)).is_drawn(uncertain));
        for choice in [None, Some(true)] {
            let scatters = !uncertainty::scattering_groups(exact).is_empty();
            assert_eq!(
                options(true, None, choice).is_drawn(exact),
                scatters && (choice.is_some() || in_a_report)
            );
        }
    }
}

/// Writes down which phases begin and end, and cancels one of them.
struct Noted {
    phases: RefCell<Vec<(Phase, Option<usize>)>>,
    cancels: Option<Phase>,
}

struct Stopped(bool);

impl Progress for Stopped {
    fn advance(&self, _: usize) {}

    fn is_cancelled(&self) -> bool {
        self.0
    }
}

impl Watch for Noted {
    fn begin(&self, phase: Phase, steps: usize) -> Box<dyn Progress + '_> {
        self.phases.borrow_mut().push((phase, Some(steps)));
        Box::new(Stopped(self.cancels == Some(phase)))
    }

    fn end(&self, phase: Phase) {
        self.phases.borrow_mut().push((phase, None));
    }
}

#[test]
fn a_run_goes_through_its_phases_and_has_the_results_that_were_asked_for() {
    let sections = "[judge]\ngrid = 32\nrealisations = 2\nbudget = 1e5\n[uncertainty]\ndraws = 20\n";
    let scene = scene(SPREAD, sections);
    let run = |options: RunOptions, cancels: Option<Phase>| {
        let watch = Noted { phases: RefCell::default(), cancels };
        let outcome = run_scene(&scene, options, &watch);
        (outcome, watch.phases.into_inner())
    };
    let (outcome, phases) = run(options(false, None, None), None);
    let outcome = outcome.unwrap();
    assert!(outcome.judgement.is_some() && outcome.uncertainty.is_some() && outcome.sensitivities.is_none());
    let begun: Vec<Phase> =
        phases.iter().filter(|(_, steps)| steps.is_some()).map(|(phase, _)| *phase).collect();
    let ended: Vec<Phase> =
        phases.iter().filter(|(_, steps)| steps.is_none()).map(|(phase, _)| *phase).collect();
    assert_eq!(begun, [Phase::Computing, Phase::Judging, Phase::Drawing]);
    assert_eq!(ended, [Phase::Computing, Phase::Comparing, Phase::Judging, Phase::Drawing]);
    let evidence = outcome.evidence(&scene);
    assert!(evidence.judgement.is_some() && evidence.uncertainty.is_some());
    // The areas are those of the plan.
    let areas = scene.plan().compute().unwrap().curves[0].area_fractions(0);
    assert_eq!(outcome.results.curves[0].area_fractions(0), areas);
    let (plain, phases) = run(options(false, Some(false), Some(false)), None);
    let plain = plain.unwrap();
    assert!(plain.judgement.is_none() && plain.uncertainty.is_none());
    assert_eq!(phases.iter().filter(|(_, steps)| steps.is_some()).count(), 1);
    let report = run_scene(&scene, options(true, Some(false), Some(false)), &Unwatched).unwrap();
    assert!(report.sensitivities.is_some());
    for phase in [Phase::Computing, Phase::Judging] {
        let (stopped, _) = run(options(false, None, Some(false)), Some(phase));
        assert!(matches!(stopped, Err(RunError::Cancelled)), "{phase:?}");
    }
    // So is a run whose draws are stopped before the first.
    let (stopped, _) = run(options(false, Some(false), None), Some(Phase::Drawing));
    assert!(matches!(stopped, Err(RunError::Cancelled)));
    let names = [Phase::Computing, Phase::Judging, Phase::Drawing].map(Phase::steps);
    assert!(names.iter().enumerate().all(|(at, name)| !name.is_empty() && !names[..at].contains(name)));
    assert_eq!(Phase::Comparing.steps(), Phase::Computing.steps());
}

/// Areas of some models of steel whose modulus is known to 5 %.
fn areas(models: &[&str]) -> UncertaintyQuestion {
    UncertaintyQuestion {
        models: models.iter().map(|name| model(name).unwrap()).collect(),
        material: hard(3e9),
        spreads: MaterialSpreads {
            youngs_modulus: Some(Spread::LogNormal { median: 200e9, sigma_ln: 0.05 }),
            ..MaterialSpreads::default()
        },
        pressures: loads(&[1e6, 1e7]),
        choices: UncertaintySettings { draws: 40, ..UncertaintySettings::default() },
        ..UncertaintyQuestion::default()
    }
}

#[test]
fn the_area_of_persson_scatters_as_the_modulus_does() {
    let found = areas(&["persson"]).answer(&surface(), &Unobserved).unwrap();
    assert_eq!(found.uncertainty.areas.len(), 2);
    let curve = CurveQuestion {
        model: model("persson"),
        material: hard(3e9),
        pressures: loads(&[1e6, 1e7]),
        ..CurveQuestion::default()
    };
    let table = curve.answer(&surface(), &Unobserved).unwrap().table;
    let expected = crate::common::filled(&table, "area_fraction");
    let points = found.results.curves[0].area_fractions(1);
    assert_near(points.last().unwrap().1, *expected.last().unwrap(), 1e-12);
    // Nothing of a certain material on a certain spectrum scatters.
    let exact = UncertaintyQuestion { spreads: MaterialSpreads::default(), ..areas(&["persson"]) };
    assert!(matches!(exact.answer(&surface(), &Unobserved), Err(QuestionError::NothingScatters)));
    // One input has all of the variance.
    let mut shared = areas(&["persson"]);
    shared.choices.shares_draws = Some(64);
    assert_eq!(unused(shared.answer(&surface(), &Unobserved)).as_deref(), Some("shares_draws"));
    shared.spreads.strength = Some(Spread::LogNormal { median: 1.0, sigma_ln: 0.05 });
    shared.models = vec![model("persson-plastic").unwrap()];
    assert!(shared.answer(&surface(), &Unobserved).is_ok());
    let cut = UncertaintyQuestion {
        sampling: SamplingInput { cutoff_m: Some(1e-9), ..SamplingInput::default() },
        ..areas(&["persson"])
    };
    assert!(matches!(cut.answer(&surface(), &Unobserved), Err(QuestionError::CutoffBelowData { .. })));
    assert!(
        areas(&["persson"])
            .answer(&surface(), &Counted::cancelled())
            .is_err_and(|error| error.is_cancelled())
    );
}

#[test]
fn every_choice_goes_to_the_models_that_have_it() {
    let mut question = areas(&["ep-sphere", "elastic-sine", "elastic-plastic", "persson"]);
    question.options = ModelOptions {
        strain_gradient: true,
        hardness: Some(Hardness::Cosine),
        flattening: Some(Flattening::Area),
        elastic_plastic_area: stacked_contact::YieldingAreaLaw::ALL.last().copied(),
        interference_law: Some(InterferenceLaw::Bem),
        ..ModelOptions::default()
    };
    question.material.strain_gradient_length_m = Some(1e-6);
    question.normalisation = Some(Normalisation::AsPrinted);
    question.amplitude = Some(AmplitudeDefinition::Parseval);
    question.tolerance = Some(Tolerance::new(1e-4).unwrap());
    let found = question.answer(&surface(), &Unobserved).unwrap();
    let needs = &found.scene.needs;
    let names: Vec<&str> = needs.curves.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(names, ["ep-sphere", "elastic-sine", "elastic-plastic", "persson"]);
    let of = |at: usize| needs.curves[at].model.options();
    let [spheres, sines, stack, persson] = [0, 1, 2, 3].map(of);
    assert_eq!((spheres.hardness, spheres.flattening), (Some(Hardness::Cosine), Some(Flattening::Area)));
    assert!(
        spheres.strain_gradient
            && stack.strain_gradient
            && !persson.strain_gradient
            && !sines.strain_gradient
    );
    assert_eq!(sines.interference_law, Some(InterferenceLaw::Bem));
    assert_eq!(stack.elastic_plastic_area, stacked_contact::YieldingAreaLaw::ALL.last().copied());
    assert_eq!((needs.loads.len(), needs.tolerance), (2, Tolerance::new(1e-4).unwrap()));
    assert_eq!(
        (needs.moments, needs.amplitudes),
        (Some(Normalisation::AsPrinted), Some(AmplitudeDefinition::Parseval))
    );
    // What no model takes is refused.
    let refused = |models: &[&str], change: &dyn Fn(&mut UncertaintyQuestion)| {
        let mut question = areas(models);
        change(&mut question);
        unused(question.answer(&surface(), &Unobserved))
    };
    let hardness = |question: &mut UncertaintyQuestion| question.options.hardness = Some(Hardness::Cosine);
    assert_eq!(refused(&["persson", "hertz"], &hardness).as_deref(), Some("hardness_formula"));
    let gradient = |question: &mut UncertaintyQuestion| question.options.strain_gradient = true;
    assert_eq!(refused(&["persson"], &gradient).as_deref(), Some("strain_gradient"));
    for (option, taker, change) in [
        (
            "normalisation",
            "hertz",
            (|question| question.normalisation = Some(Normalisation::Parseval))
                as fn(&mut UncertaintyQuestion),
        ),
        ("amplitude", "elastic", |question| question.amplitude = Some(AmplitudeDefinition::Parseval)),
        ("tolerance", "hertz", |question| question.tolerance = Some(Tolerance::new(1e-4).unwrap())),
    ] {
        assert_eq!(refused(&["persson"], &change).as_deref(), Some(option));
        assert_eq!(refused(&["persson", taker], &change), None, "{option}");
        assert_eq!(refused(&["persson", taker], &|_| ()), None);
    }
}

#[test]
fn notes_on_uncertain_areas_are_those_of_their_curves() {
    let mut question = areas(&["hertz", "persson"]);
    question.material.indentation_hardness_pa = Some(5e7);
    let notes = question.answer(&surface(), &Unobserved).unwrap().notes();
    let doubted = notes.iter().filter(|note| note.code == RemarkCode::RealAboveHardness).count();
    assert_eq!(doubted, 2);
    assert!(!has(
        &areas(&["persson"]).answer(&surface(), &Unobserved).unwrap().notes(),
        RemarkCode::AssumedStrength
    ));
}

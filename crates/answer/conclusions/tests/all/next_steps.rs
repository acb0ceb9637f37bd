//! The steps that narrow an answer, by the advice of the draws and by what the answer hangs on.

use conclusions::{AnswerUnderLoad, NextStep};
use judge::Otherwise;
use study::bodies::Body;
use uncertainty::{Advice, Group, Settling, Step, StepKind};
use units::{Remark, RemarkCode};

use crate::cautions::caution;
use crate::drawn_scenes::Answered;

/// Elastic bodies on a spectrum with errors, under two loads.
fn elastic(rest: &str) -> Answered {
    Answered::new(&format!(
        "surface = {{ psd = \"errors.csv\" }}\nmaterial = {{ youngs_modulus = \"200 GPa +- 60 %\", poisson_ratio = 0.3 }}\n[loads]\npressures = \
         [\"10 MPa\", \"30 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\ngrid = 32\nrealisations = 2\n[uncertainty]\ndraws = \
         40\nshares_draws = 64\n{rest}"
    ))
}

/// The steps after the advice of the draws is replaced, and the load that they are for.
fn steps(
    answered: &mut Answered,
    advised: Vec<Step>,
    settling: Settling,
) -> (Vec<NextStep>, AnswerUnderLoad) {
    let advice =
        Advice { curve: 0, load: 1, decades: Vec::new(), instruments: Vec::new(), steps: advised, settling };
    answered.uncertainty.as_mut().unwrap().advice = vec![advice];
    let conclusions = answered.conclusions();
    (conclusions.next, conclusions.loads[1].clone())
}

fn step(kind: StepKind, width_ratio: f64, area_ratio: f64) -> Step {
    Step { kind, width_ratio, area_ratio }
}

/// The width of the whole range if that of the inputs becomes so many times as wide: logarithms add as squares.
fn of_whole(load: &AnswerUnderLoad, of_inputs: f64) -> f64 {
    let (elements, inputs) = (load.area.factor_of_elements.ln(), load.area.of_inputs.unwrap().factor.ln());
    (elements.powi(2) + (of_inputs * inputs).powi(2)).sqrt() / (elements.powi(2) + inputs.powi(2)).sqrt()
}

#[test]
fn steps_are_ranked_by_the_whole_range_and_those_of_less_than_a_tenth_are_left_out() {
    let mut answered = elastic("");
    let known = |group| StepKind::KnownExactly { group };
    let advised = vec![
        step(known(Group::Material), 0.7, 1.0),
        step(known(Group::Scans), 0.3, 1.0),
        step(known(Group::Strength), 0.99, 1.0),
        step(StepKind::LongerWavelengths { to_m: 1e-3 }, 0.5, 1.0),
    ];
    let (found, load) = steps(&mut answered, advised, Settling::Unknown);
    let [
        NextStep::Wavelengths { to_m, area_ratio: 1.0 },
        NextStep::Material { group: Group::Material, width_ratio },
        NextStep::FinerScan { .. },
    ] = found[..]
    else {
        panic!("{found:?}")
    };
    // Of one kind the first step counts, and it ranks by its own width.
    assert_eq!(to_m, 1e-3);
    assert!((width_ratio / of_whole(&load, 0.7) - 1.0).abs() < 1e-9, "{width_ratio}");
}

#[test]
fn shorter_waves_are_advised_where_the_area_will_settle_and_fall_by_a_tenth() {
    let mut answered = elastic("");
    let shorter = |area_ratio| vec![step(StepKind::ShorterWavelengths { to_m: 1e-9 }, 1.0, area_ratio)];
    let will = Settling::WillSettle { slope: -4.0, standard_error: 0.1 };
    let (found, _) = steps(&mut answered, shorter(0.6), will);
    assert_eq!(found, [NextStep::Wavelengths { to_m: 1e-9, area_ratio: 0.6 }]);
    assert_eq!(steps(&mut answered, shorter(0.95), will).0, []);
    // Where nobody knows whether the area settles, a finer scan tells.
    let from_m = answered.results.psd.shortest_wavelength_m();
    assert_eq!(steps(&mut answered, shorter(0.6), Settling::Unknown).0, [NextStep::FinerScan { from_m }]);
    // Longer waves narrow by a tenth or are left out.
    let longer = vec![step(StepKind::LongerWavelengths { to_m: 1e-3 }, 0.99, 0.5)];
    assert_eq!(steps(&mut answered, longer, will).0, [NextStep::FinerScan { from_m }]);
}

#[test]
fn instruments_are_named_in_steps_on_scans_and_height_scales() {
    let row = |x: i32| format!("{:e} {:e}\n", f64::from(x) * 1e-6, 1e-7 * (f64::from(x * x) * 0.13).sin());
    let trace: String = (0..512).map(row).collect();
    let files = std::collections::BTreeMap::from([("trace.txt".to_owned(), trace.into_bytes())]);
    let text = "[surface]\nscans = [{ file = \"trace.txt\", unit = \"m\", instrument = \"AFM\", tip_radius = \"none\", z_calibration = 0.8 }]\n[material]\nyoungs_modulus = \
                \"200 GPa\"\npoisson_ratio = 0.3\n[loads]\npressures = [\"10 MPa\", \"30 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\ngrid = \
                32\nrealisations = 2\n[uncertainty]\ndraws = 40\nshares_draws = 64\n";
    let mut answered = Answered::with_files(text, &files);
    let advised = vec![
        step(StepKind::MoreScans { instrument: 0, added: 3 }, 0.2, 1.0),
        step(StepKind::Calibration { instrument: 0 }, 0.4, 1.0),
        step(StepKind::MoreScans { instrument: 0, added: 1 }, 0.1, 1.0),
    ];
    let (found, load) = steps(&mut answered, advised, Settling::Unknown);
    let [scans, height_scale] = [of_whole(&load, 0.2), of_whole(&load, 0.4)];
    assert!(scans < height_scale && height_scale < 0.9, "{load:?}");
    let instrument = "AFM".to_owned();
    let expected = [
        NextStep::MoreScans { instrument: instrument.clone(), added: 3, width_ratio: scans },
        NextStep::HeightScale { instrument, width_ratio: height_scale },
    ];
    for (found, expected) in found.iter().zip(&expected) {
        let of = |step: &NextStep| match step {
            NextStep::MoreScans { instrument, added, width_ratio } => {
                (instrument.clone(), *added, *width_ratio)
            }
            NextStep::HeightScale { instrument, width_ratio } => (instrument.clone(), 0, *width_ratio),
            other => panic!("{other:?}"),
        };
        let ((name, added, width), (other_name, other_added, other_width)) = (of(found), of(expected));
        assert_eq!((name, added), (other_name, other_added));
        assert!((width / other_width - 1.0).abs() < 1e-9, "{found:?} {expected:?}");
    }
    // Further scans are advised already; without them a second one is.
    let is_second = |step: &NextStep| *step == NextStep::SecondScan { instrument: "AFM".to_owned() };
    assert!(!found.iter().any(is_second), "{found:?}");
    let (found, _) = steps(&mut answered, Vec::new(), Settling::Unknown);
    assert!(found.iter().any(is_second), "{found:?}");
}

#[test]
fn a_hole_is_closed_first_where_it_decides_and_never_where_it_narrows_nothing() {
    let scene = |rest: &str| {
        Answered::new(&format!(
            "surface = {{ psd = \"hole.csv\" }}\nmaterial = {{ youngs_modulus = \"200 GPa +- 60 %\", poisson_ratio = 0.3 }}\n[loads]\npressures = \
             [\"10 MPa\", \"30 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\ngrid = 32\nrealisations = 2\n[uncertainty]\ndraws = \
             40\nshares_draws = 64\n{rest}"
        ))
    };
    let mut answered = scene("");
    let hole = answered.scene.surface.holes[0];
    let closed = |width| vec![step(StepKind::KnownExactly { group: Group::Holes }, width, 1.0)];
    let body = step(StepKind::KnownExactly { group: Group::Material }, 0.1, 1.0);
    let is_of_hole = |found: &[NextStep]| found.iter().position(|step| *step == NextStep::CloseHole(hole));
    let [mut first, mut last] = [0.05, 0.3].map(closed);
    first.push(body.clone());
    last.push(body);
    assert_eq!(is_of_hole(&steps(&mut answered, first, Settling::Unknown).0), Some(0));
    assert_eq!(is_of_hole(&steps(&mut answered, last, Settling::Unknown).0), Some(1));
    assert_eq!(is_of_hole(&steps(&mut answered, closed(0.999), Settling::Unknown).0), None);
    // Without draws nobody knows by how much.
    answered.uncertainty = None;
    assert_eq!(is_of_hole(&answered.conclusions().next), Some(0));
}

#[test]
fn a_hardness_that_may_grow_is_measured_at_small_depth() {
    let mut answered = elastic("");
    let hardness_pa = 1e9;
    let judgement = answered.judgement.as_mut().unwrap();
    let headline = &mut judgement.headlines[1];
    let mut elements = judgement.references[1].elements.unwrap();
    (elements.area_fraction, elements.standard_error) = (3.0 * headline.high, 0.0);
    headline.otherwise = Some(Otherwise { hardness_pa, elements });
    let (found, load) = steps(&mut answered, Vec::new(), Settling::Unknown);
    let finer = NextStep::FinerScan { from_m: answered.results.psd.shortest_wavelength_m() };
    assert_eq!(found, [NextStep::HardnessAtSmallDepth, finer.clone()]);
    let (best, other) = (load.area.area_fraction.unwrap(), load.otherwise.unwrap());
    assert_eq!((other.hardness_pa, other.area_fraction), (hardness_pa, elements.area_fraction));
    assert_eq!((other.low, other.high), (elements.area_fraction, elements.area_fraction));
    assert!((other.ratio / (elements.area_fraction / best) - 1.0).abs() < 1e-12);
    assert_eq!(load.factor_of_hardness(), Some(other.ratio));
    let cautions = answered.conclusions().cautions;
    let decides = cautions.iter().find(|caution| caution.code == RemarkCode::HardnessDecides).unwrap();
    assert_eq!(decides.number("ratio"), Some(other.ratio));
    // Within the range it decides nothing.
    elements.area_fraction = best;
    answered.judgement.as_mut().unwrap().headlines[1].otherwise = Some(Otherwise { hardness_pa, elements });
    let (found, load) = steps(&mut answered, Vec::new(), Settling::Unknown);
    assert_eq!((found, load.otherwise, load.factor_of_hardness()), (vec![finer], None, None));
}

#[test]
fn a_tip_of_unknown_radius_is_measured_and_the_scan_that_it_blurs_most_is_named() {
    let mut answered = elastic("");
    let blurred = |file: &str, below_m: f64| {
        let remark = Remark::new(RemarkCode::TipIndicated).about(vec![file.to_owned()]);
        remark.with("may_show_below_m", below_m)
    };
    answered.scene.surface.notes =
        vec![blurred("a.txt", 1e-7), blurred("b.txt", 3e-7), blurred("c.txt", 2e-7)];
    let conclusions = answered.conclusions();
    let tip = conclusions.cautions.iter().find(|caution| caution.code == RemarkCode::TipMayShow).unwrap();
    assert_eq!(tip.number("may_show_below_m"), Some(3e-7));
    // It goes before what narrows the range.
    assert_eq!(conclusions.next[0], NextStep::TipRadius { scan: "b.txt".to_owned() });
}

#[test]
fn the_hardness_of_a_softer_body_that_has_none_is_found_out_first() {
    let answered = Answered::new(
        "surface = { psd = \"plain.csv\" }\nmaterial = { youngs_modulus = \"200 GPa\", poisson_ratio = 0.3, indentation_hardness = \"6 GPa\" \
         }\ncounterface = { youngs_modulus = \"500 MPa\", poisson_ratio = 0.4 }\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \
         \"persson\"\n[judge]\noff = true\n",
    );
    let body = Body::Counterface.words().to_owned();
    assert_eq!(answered.conclusions().next.first(), Some(&NextStep::HardnessOfSofter { body }));
}

#[test]
fn flatness_is_asked_for_where_gaps_are_and_the_spectrum_does_not_roll_off_and_then_longer_waves() {
    let next = |psd: &str, rest: &str| -> Vec<NextStep> {
        let answered = Answered::new(&format!(
            "surface = {{ psd = \"{psd}\" }}\nmaterial = {{ youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }}\n[loads]\npressures = [\"10 MPa\"]\n\
             [[curve]]\nmodel = \"persson\"\n[judge]\noff = true\n{rest}"
        ));
        let from_m = answered.results.psd.longest_wavelength_m();
        let of_waves = [NextStep::Flatness { from_m }, NextStep::WiderScan { from_m }];
        let conclusions = answered.conclusions();
        let is_cautioned = caution(&conclusions, RemarkCode::GapNotSettled).is_some();
        let steps: Vec<NextStep> =
            conclusions.next.into_iter().filter(|step| of_waves.contains(step)).collect();
        assert_eq!(is_cautioned, !steps.is_empty());
        steps
    };
    let flatness = "flatness = \"5 um over 40 mm\"\n";
    for asks in ["[interface]\n", "[interface]\ngas = \"air\"\n", "[seal]\n"] {
        assert!(matches!(next("power.csv", asks)[..], [NextStep::Flatness { .. }]), "{asks}");
        assert_eq!(next("plain.csv", asks), [], "{asks}");
    }
    for asks in [format!("[interface]\n{flatness}"), format!("[seal]\n[interface]\n{flatness}")] {
        assert!(matches!(next("power.csv", &asks)[..], [NextStep::WiderScan { .. }]), "{asks}");
    }
    assert_eq!(next("power.csv", ""), []);
    assert_eq!(next("power.csv", "[interface]\nshear_strength = \"50 MPa\"\n"), []);
}

//! Cautions, the trust that they leave, and their form in `answer.json`.

use conclusions::{Conclusions, Source, Trust, trust_left};
use judge::{Reference, Verdict};
use study::bodies::Body;
use units::{Remark, RemarkCode};

use crate::drawn_scenes::Answered;

/// A scene without draws and with two curves; `judge` is a line of its section.
fn scene(surface: &str, bodies: &str, judge: &str, rest: &str) -> Answered {
    Answered::new(&format!(
        "surface = {{ psd = \"{surface}.csv\" }}\n{bodies}\n[loads]\npressures = [\"10 MPa\", \"30 MPa\"]\n[[curve]]\nmodel = \
         \"persson\"\n[[curve]]\nmodel = \"elastic\"\n[judge]\n{judge}\n{rest}"
    ))
}

const STEEL: &str = "material = { youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }";
const SMALL: &str = "grid = 32\nrealisations = 2";

pub fn caution(conclusions: &Conclusions, code: RemarkCode) -> Option<&Remark> {
    conclusions.cautions.iter().find(|caution| caution.code == code)
}

#[test]
fn each_caution_leaves_a_trust_and_the_lowest_counts() {
    let hole = |longest_m: f64| {
        Remark::new(RemarkCode::NotMeasured).with("longest_m", longest_m).with("shortest_m", 1e-7)
    };
    for (caution, expected) in [
        (Remark::new(RemarkCode::TooFewScales), Trust::None),
        (Remark::new(RemarkCode::InstrumentsDisagree), Trust::Poor),
        (Remark::new(RemarkCode::HardnessDecides), Trust::Poor),
        (Remark::new(RemarkCode::NotJudged), Trust::Poor),
        (Remark::new(RemarkCode::StickyByPastewka), Trust::Poor),
        (Remark::new(RemarkCode::StickyByFuller), Trust::Poor),
        (Remark::new(RemarkCode::ThinLayer), Trust::Poor),
        (Remark::new(RemarkCode::FarTooSteepSurface), Trust::Poor),
        (hole(1.1e-6), Trust::Poor),
        (hole(0.9e-6), Trust::Fair),
        (Remark::new(RemarkCode::NotMeasured), Trust::Fair),
        (Remark::new(RemarkCode::TooSteep), Trust::Fair),
        (Remark::new(RemarkCode::FewScans), Trust::Fair),
        (Remark::new(RemarkCode::MadeOfNumbers), Trust::Fair),
        (Remark::new(RemarkCode::NotGaussianMap), Trust::Fair),
        (Remark::new(RemarkCode::LayUnknown), Trust::Good),
    ] {
        assert_eq!(trust_left(&caution), expected, "{caution:?}");
    }
    let names = [Trust::None, Trust::Poor, Trust::Fair, Trust::Good].map(Trust::name);
    assert_eq!(names, ["none", "poor", "fair", "good"]);
    assert!(Trust::None < Trust::Poor && Trust::Poor < Trust::Fair && Trust::Fair < Trust::Good);
}

#[test]
fn a_judged_area_of_a_whole_spectrum_has_few_cautions_and_each_defect_brings_its_own() {
    let clean = scene("plain", STEEL, SMALL, "").conclusions();
    for code in [
        RemarkCode::NotJudged,
        RemarkCode::NotMeasured,
        RemarkCode::TooFewScales,
        RemarkCode::MadeOfNumbers,
        RemarkCode::NoModelAgrees,
        RemarkCode::FewScans,
        RemarkCode::GapOfYieldingContact,
    ] {
        assert!(caution(&clean, code).is_none(), "{code:?}");
    }
    let unjudged = scene("plain", STEEL, "off = true", "").conclusions();
    assert!(caution(&unjudged, RemarkCode::NotJudged).is_some() && unjudged.trust == Trust::Poor);
    let hole = scene("hole", STEEL, SMALL, "");
    let (found, expected) = (hole.conclusions(), hole.scene.surface.holes[0]);
    let hole = caution(&found, RemarkCode::NotMeasured).unwrap();
    let ends = (hole.number("longest_m"), hole.number("shortest_m"));
    assert_eq!(ends, (Some(expected.longest_m), Some(expected.shortest_m)));
    let short = scene("short", STEEL, "off = true", "").conclusions();
    let scales = caution(&short, RemarkCode::TooFewScales).unwrap().number("scales");
    assert!(scales.is_some_and(|scales| scales < 6.0) && short.trust == Trust::None, "{scales:?}");
}

#[test]
fn a_body_that_is_less_stiff_and_has_no_hardness_is_a_caution_unless_it_is_a_rubber() {
    let body = |modulus: &str, hardness: &str| {
        format!("youngs_modulus = \"{modulus}\"\npoisson_ratio = 0.3\n{hardness}\n")
    };
    let hard = "indentation_hardness = \"2 GPa\"";
    let of = |rough: String, counterface: String| {
        let bodies = format!("[material]\n{rough}[counterface]\n{counterface}");
        let conclusions = scene("plain", &bodies, "off = true", "").conclusions();
        let found = caution(&conclusions, RemarkCode::SofterWithoutHardness)?;
        Some(found.numbers.clone())
    };
    let named = |softer: Body, harder: Body| {
        Some(vec![("softer", softer.words().into()), ("harder", harder.words().into())])
    };
    let [steel, polymer] = ["200 GPa", "500 MPa"];
    assert_eq!(of(body(steel, hard), body(polymer, "")), named(Body::Counterface, Body::Rough));
    assert_eq!(of(body(polymer, ""), body(steel, hard)), named(Body::Rough, Body::Counterface));
    // A hardness of both, of the less stiff one, or of none; a rubber.
    let soft = "indentation_hardness = \"30 MPa\"";
    assert_eq!(of(body(steel, hard), body(polymer, soft)), None);
    assert_eq!(of(body(steel, ""), body(polymer, soft)), None);
    assert_eq!(of(body(steel, ""), body(polymer, "")), None);
    assert_eq!(of(body(steel, hard), body("5 MPa", "")), None);
}

#[test]
fn a_surface_scanned_at_fewer_than_three_places_is_a_caution() {
    let trace = |place: i32| {
        let row = |x: i32| {
            format!("{:e} {:e}\n", f64::from(x) * 1e-6, 1e-7 * (f64::from(x * x + place) * 0.13).sin())
        };
        (0..512).map(row).collect::<String>().into_bytes()
    };
    let of = |places: i32| {
        let names: Vec<String> = (0..places).map(|place| format!("{place}.txt")).collect();
        let files = names.iter().cloned().zip((0..places).map(trace)).collect();
        let scans: String = names
            .iter()
            .map(|name| format!("{{ file = \"{name}\", unit = \"m\", tip_radius = \"none\" }},"))
            .collect();
        let text = format!(
            "[surface]\nscans = [{scans}]\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n[loads]\npressures = [\"10 \
             MPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\noff = true\n[uncertainty]\noff = true\n"
        );
        let conclusions = Answered::with_files(&text, &files).conclusions();
        assert!(caution(&conclusions, RemarkCode::LayUnknown).is_some());
        caution(&conclusions, RemarkCode::FewScans).map(|few| few.number("scans").unwrap())
    };
    assert_eq!([1, 2, 3].map(of), [Some(1.0), Some(2.0), None]);
}

#[test]
fn the_trace_whose_heights_are_skewed_most_is_named_and_maps_show_their_lay() {
    let skewed = |file: &str, skewness: f64| {
        Remark::new(RemarkCode::TraceSkewed).about(vec![file.to_owned()]).with("skewness", skewness)
    };
    let mut answered = scene("plain", STEEL, "off = true", "");
    answered.scene.surface.notes = vec![skewed("a.txt", 1.2), skewed("b.txt", -2.2), skewed("c.txt", 1.5)];
    let conclusions = answered.conclusions();
    let found = caution(&conclusions, RemarkCode::SkewedHeights).unwrap();
    assert_eq!(found.text("touches"), Some("more"));
    assert_eq!((found.place.files.as_slice(), trust_left(found)), (&["b.txt".to_owned()][..], Trust::Fair));
    assert!(caution(&conclusions, RemarkCode::LayUnknown).is_none());
    answered.scene.surface.notes = vec![skewed("a.txt", 1.2)];
    let conclusions = answered.conclusions();
    assert_eq!(caution(&conclusions, RemarkCode::SkewedHeights).unwrap().text("touches"), Some("less"));
}

#[test]
fn the_scan_of_which_waves_of_one_length_carry_most_is_named() {
    let line = |file: &str, share: f64| {
        let remark = Remark::new(RemarkCode::NarrowLine).about(vec![file.to_owned()]);
        remark.with("share", share).with("wavelength_m", 1e-4)
    };
    let mut answered = scene("plain", STEEL, "off = true", "");
    answered.scene.surface.notes = vec![line("a.txt", 0.4), line("b.txt", 0.9)];
    let conclusions = answered.conclusions();
    let found = caution(&conclusions, RemarkCode::DirectionalWaves).unwrap();
    assert_eq!((found.number("share"), found.number("wavelength_m")), (Some(0.9), Some(1e-4)));
    assert_eq!((found.place.files.as_slice(), trust_left(found)), (&["b.txt".to_owned()][..], Trust::Fair));
}

#[test]
fn cautions_on_roughness_are_left_out_where_the_area_hangs_on_the_hardness_and_nothing_else_is_asked() {
    let of = |hardness: &str, rest: &str| {
        let text = format!(
            "surface = {{ rms_height = \"0.3 um\", rms_slope = 0.2, hurst = 0.8, rolloff_wavelength = \"60 um\" }}\nmaterial = {{ youngs_modulus = \"70 \
             GPa\", poisson_ratio = 0.33, indentation_hardness = \"{hardness}\" }}\n[loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \
             \"persson-plastic\"\n[judge]\n{SMALL}\n{rest}"
        );
        Answered::new(&text).conclusions()
    };
    let softer = of("300 MPa", "[counterface]\nyoungs_modulus = \"30 GPa\"\npoisson_ratio = 0.3\n");
    let codes: Vec<RemarkCode> = softer.cautions.iter().map(|caution| caution.code).collect();
    assert_eq!(codes, [RemarkCode::SofterWithoutHardness]);
    let of = |hardness: &str, rest: &str| {
        let conclusions = of(hardness, rest);
        let made = caution(&conclusions, RemarkCode::MadeOfNumbers);
        made.map(|made| made.text("body").unwrap().to_owned())
    };
    let surface = Some("the surface".to_owned());
    assert_eq!(of("300 MPa", ""), None);
    assert_eq!(of("300 MPa", "[interface]\n"), surface);
    assert_eq!(of("300 MPa", "[seal]\n"), surface);
    assert_eq!(of("300 MPa", "[interface]\nshear_strength = \"50 MPa\"\n"), None);
    assert_eq!(of("90 GPa", ""), surface);
}

#[test]
fn models_that_all_miss_the_elements_of_every_load_are_counted() {
    let mut answered = scene("plain", STEEL, SMALL, "");
    let mut with = |verdicts: [Verdict; 4]| {
        let judgement = answered.judgement.as_mut().unwrap();
        for (row, verdict) in judgement.curves.iter_mut().zip(verdicts) {
            row.verdict = verdict;
        }
        let conclusions = answered.conclusions();
        let remark = conclusions.cautions.iter().find(|caution| caution.code.name() == "no-model-agrees");
        let tally = conclusions.loads[0].tally;
        let counts = [tally.agree, tally.off, tally.not_valid, tally.not_judged, tally.of_other_elements];
        (remark.map(|remark| (remark.code, remark.number("models"))), counts)
    };
    use Verdict::{Agrees, NotJudged, OutOfRange, TooLarge, TooSmall};
    let both = Some((RemarkCode::NoModelAgrees, Some(2.0)));
    // Rows run over the loads of one curve, then of the next.
    assert_eq!(with([TooLarge, TooSmall, TooSmall, TooLarge]), (both, [0, 2, 0, 0, 0]));
    assert_eq!(with([OutOfRange, OutOfRange, OutOfRange, OutOfRange]), (both, [0, 0, 2, 0, 0]));
    assert_eq!(with([TooLarge, TooSmall, TooSmall, Agrees]).0, None);
    assert_eq!(with([NotJudged, NotJudged, NotJudged, NotJudged]), (None, [0, 0, 0, 2, 0]));
    // A model with elements of its own is no model of this contact.
    let judgement = answered.judgement.as_mut().unwrap();
    for (row, verdict) in judgement.curves.iter_mut().zip([TooLarge, TooLarge, Agrees, Agrees]) {
        row.verdict = verdict;
        if verdict == Agrees {
            row.reference = Reference::Yielding { hardness_pa: 1e9 };
        }
    }
    let conclusions = answered.conclusions();
    let remark = caution(&conclusions, RemarkCode::TheModelDisagrees).unwrap();
    assert_eq!(remark.number("models"), Some(1.0));
    let load = &conclusions.loads[0];
    assert_eq!((load.tally.off, load.tally.agree, load.tally.of_other_elements), (1, 0, 1));
    assert_eq!(load.references[0].reference, Reference::Elastic);
}

#[test]
fn the_nearest_model_comes_first_and_stands_for_the_elements() {
    let mut answered = scene("plain", STEEL, SMALL, "");
    for (row, area_over_elements) in
        answered.judgement.as_mut().unwrap().curves.iter_mut().zip([1.3, 0.5, 0.8, 1.9])
    {
        let elements = row.elements.unwrap().area_fraction;
        row.area_fraction = Some(area_over_elements * elements);
        row.verdict = Verdict::NotJudged;
    }
    answered.judgement.as_mut().unwrap().headlines.iter_mut().for_each(|headline| headline.best_curve = None);
    let loads = answered.conclusions().loads;
    let order =
        |load: usize| loads[load].references[0].models.iter().map(|cell| cell.curve).collect::<Vec<_>>();
    // 1.3 against 0.8 (1.25 the other way), and 0.5 against 1.9.
    assert_eq!((order(0), order(1)), (vec![1, 0], vec![1, 0]));
    assert_eq!((loads[0].nearest_curve(), loads[0].best_model), (Some(1), None));
    answered.judgement.as_mut().unwrap().headlines[0].best_curve = Some(0);
    let load = answered.conclusions().loads[0].clone();
    assert_eq!((load.nearest_curve(), load.best_model.map(|cell| cell.curve)), (Some(0), Some(0)));
    let group = &load.references[0];
    let of_elements = answered.judgement.as_ref().unwrap().references[0];
    assert_eq!(group.area_fraction, of_elements.elements.map(|elements| elements.area_fraction));
    assert_eq!(group.range, of_elements.range);
}

#[test]
fn a_gap_of_peaks_that_flow_is_doubted_where_a_leak_or_a_shear_takes_it() {
    let soft = "material = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, indentation_hardness = \"300 MPa\" }";
    let share = |bodies: &str, judge: &str, rest: &str| {
        let answered = scene("plain", bodies, judge, rest);
        let states = answered.scene.interface_states(&answered.results).unwrap();
        let largest = states.plastic_share(0).unwrap_or(0.0).max(states.plastic_share(1).unwrap_or(0.0));
        let found = caution(&answered.conclusions(), RemarkCode::GapOfYieldingContact).cloned();
        let what = found.as_ref().map(|found| found.text("what").unwrap().to_owned());
        (found.map(|found| found.number("share").unwrap()), largest, what)
    };
    let joint = "[seal]\npressure_drop = \"100 kPa\"\nviscosity = \"1 mPa s\"\nbreadth = \"100 mm\"\nlength = \"2 mm\"";
    let (found, largest, what) = share(soft, "off = true", joint);
    assert!(largest > 0.03 && found == Some(largest), "{found:?} {largest}");
    assert_eq!(what.as_deref(), Some("channels of leaks"));
    let shear = "[interface]\ntangential_stress = \"10 kPa\"\nfriction = 0.5\n";
    let (found, largest, what) = share(soft, "off = true", shear);
    assert_eq!((found, what.as_deref()), (Some(largest), Some("tangential loads")));
    let both = share(soft, "off = true", &format!("{shear}{joint}")).2;
    assert_eq!(both.as_deref(), Some("channels of leaks and tangential loads"));
    // A seal without a rate, and a gap alone, have their own states; hard bodies do not flow.
    assert_eq!(share(soft, "off = true", "[seal]").0, None);
    assert_eq!(share(soft, "off = true", "[interface]").0, None);
    let hard = soft.replace("300 MPa", "200 GPa");
    let (found, largest, _) = share(&hard, "off = true", joint);
    assert!(largest <= 0.03 && found.is_none());
}

#[test]
fn the_fluid_of_a_joint_parts_bodies_under_the_lightest_load_below_its_pressure() {
    let of = |drop: &str| {
        let joint = format!(
            "[seal]\npressure_drop = \"{drop}\"\nviscosity = \"1 mPa s\"\nbreadth = \"100 mm\"\nlength = \"2 mm\""
        );
        let conclusions = scene("plain", STEEL, "off = true", &joint).conclusions();
        let first = conclusions.cautions[0].clone();
        (first.code == RemarkCode::FluidParts)
            .then(|| (first.number("fluid_pressure_pa").unwrap(), first.number("pressure_pa").unwrap()))
    };
    assert_eq!(of("20 MPa"), Some((20e6, 10e6)));
    assert_eq!(of("9 MPa"), None);
}

#[test]
fn answers_in_json_name_cautions_and_keep_their_data_beside_them() {
    let mut conclusions = scene("plain", STEEL, "off = true", "").conclusions();
    let doubt = Remark::new(RemarkCode::FarTooSteepSurface).with("rms_slope", 3.0);
    let disagree =
        Remark::new(RemarkCode::InstrumentsDisagree).about(vec!["AFM".to_owned()]).with("ratio", 2.0);
    conclusions.cautions = vec![doubt, disagree];
    let json = serde_json::to_value(&conclusions).unwrap();
    let expected = serde_json::json!([
        { "caution": "doubt", "steep-surface": { "rms_slope": 3.0 } },
        { "caution": "instruments-disagree", "names": ["AFM"], "ratio": 2.0 },
    ]);
    assert_eq!(json["cautions"], expected);
}

#[test]
fn areas_without_elements_are_those_of_their_models() {
    let [one, two] = ["", "[[curve]]\nmodel = \"elastic\"\n"].map(|further| {
        let text = format!(
            "surface = {{ psd = \"plain.csv\" }}\n{STEEL}\n[loads]\npressures = [\"10 MPa\"]\n[judge]\noff = true\n[[curve]]\nmodel = \
             \"persson\"\n{further}"
        );
        let answered = Answered::new(&text);
        let areas: Vec<f64> =
            answered.results.curves.iter().map(|curve| curve.area_fractions(0).last().unwrap().1).collect();
        (answered.conclusions().loads[0].area, areas)
    });
    let (area, of_models) = one;
    assert_eq!((area.source, area.area_fraction), (Source::Model { curve: 0 }, Some(of_models[0])));
    assert_eq!((area.low, area.high, area.factor_of_elements), (of_models[0], of_models[0], 1.0));
    let (area, of_models) = two;
    let (low, high) = (of_models[0].min(of_models[1]), of_models[0].max(of_models[1]));
    assert_eq!((area.source, area.area_fraction, area.low, area.high), (Source::Models, None, low, high));
    assert!((area.factor_of_elements - high / low).abs() < 1e-12 && high > 1.1 * low);
}

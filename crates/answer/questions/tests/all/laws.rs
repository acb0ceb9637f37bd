//! Gaps under loads, laws made from them, and conductance.

use asperity::Hardness;
use interface::conductance::{CutSurface, PressureRatio};
use interface::finite_elements::Dialect;
use interface::gas::{GapGas, plastic_separation_m};
use numerics::parallel::Unobserved;
use persson::Band;
use questions::{
    CurveQuestion, FoundConductance, FoundLaw, GapModel, GapQuestion, GasInput, LawAnswer, LawForm,
    LawQuantity, LawQuestion, LawTableQuestion, NamedGas, PlasticCorrelation, QuestionError, SamplingInput,
    TransportInput,
};
use spectrum::{Normalisation, cumulative_moments};
use stat_contact::{InterferenceLaw, SummitHeights};
use study::growth_law::GrowthLaw;
use study::materials;
use study::models::{ModelOptions, with_gaps};
use study::plan::Tolerance;
use study::surface::Surface;
use units::display::three_digits;
use units::{Pressure, RemarkCode, RemarkLevel, SceneKeys};

use crate::common::{
    Counted, STEEL_MODULUS_PA, assert_all_near, assert_near, by, column, filled, hard, has, loads, missing,
    model, numbers_of, power_law, small, spectrum_of, surface, text_of, unused,
};

fn law(by: GapModel, from_pa: f64, to_pa: f64) -> LawQuestion {
    LawQuestion { by, from: Pressure::Pascals(from_pa), to: Pressure::Pascals(to_pa) }
}

fn found(by: GapModel, from_pa: f64, to_pa: f64, surface: &Surface) -> FoundLaw {
    law(by, from_pa, to_pa).answer(surface, &Unobserved).unwrap()
}

/// A surface with a plateau above 30 um, so that its light loads are a law of their own.
fn rolled_off() -> Surface {
    let row = |i: i32| {
        let wavelength_m = 1e-3 * 10f64.powf(f64::from(-i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", 1e-19 * (wavelength_m / 3e-5).min(1.0).powf(2.6))
    };
    spectrum_of(&(0..=30).map(row).collect::<String>())
}

#[test]
fn a_law_has_the_area_that_the_curve_of_its_model_ends_with() {
    let surface = surface();
    let grows = ModelOptions { hardness_law: Some(GrowthLaw::NixGao), ..ModelOptions::default() };
    let cases = with_gaps().map(|entry| (entry.name, ModelOptions::default()));
    for (name, options) in cases.chain([("persson-plastic", grows)]) {
        let mut material = hard(3e9);
        material.strain_gradient_length_m = options.hardness_law.is_some().then_some(1e-6);
        let normalisation = (name == "hertz").then_some(Normalisation::AsPrinted);
        let by = GapModel { material, options: options.clone(), normalisation, ..by(Some(name)) };
        let sampling = SamplingInput { cutoff_m: Some(2e-6), ..SamplingInput::default() };
        let by = GapModel { sampling, ..by };
        let curve = CurveQuestion {
            model: model(name),
            material,
            options,
            normalisation,
            sampling,
            pressures: loads(&[1e7]),
            ..CurveQuestion::default()
        };
        let curve = curve.answer(&surface, &Unobserved).unwrap().table;
        let expected = column(&curve, "area_fraction").last().copied().flatten().unwrap();
        let found = found(by.clone(), 1e6, 1e7, &surface);
        assert_eq!((found.range_pa, found.model.name), ([1e6, 1e7], name));
        assert_near(found.law.at(1e7).unwrap().area_fraction, expected, 1e-6);
        let question = GapQuestion { by, pressures: loads(&[1e7]), ..GapQuestion::default() };
        assert_eq!(question.steps(&surface).unwrap(), 0);
        let gaps = question.answer(&surface, &Unobserved).unwrap().table;
        assert_all_near(&filled(&gaps, "area_fraction"), &[expected], 1e-6);
        let gap_m = found.law.at(1e7).unwrap().mean_gap_m;
        assert_eq!(column(&gaps, "mean_gap_m"), [gap_m]);
    }
}

#[test]
fn options_that_gaps_ignore_are_refused_by_their_names() {
    let refused = |name: Option<&str>, change: &dyn Fn(&mut GapModel)| {
        let mut model = GapModel { material: hard(3e9), ..by(name) };
        change(&mut model);
        let question = GapQuestion { by: model.clone(), pressures: loads(&[1e6]), ..GapQuestion::default() };
        let (gap, law) = (unused(question.check()), unused(law(model, 1e6, 1e7).check()));
        assert_eq!(gap, law);
        gap
    };
    type Change = fn(&mut GapModel);
    let changes: [(&str, Change, &[&str]); 10] = [
        (
            "normalisation",
            |by| by.normalisation = Some(Normalisation::Parseval),
            &["hertz", "ep-sphere", "elastic-sine"],
        ),
        (
            "tolerance",
            |by| by.tolerance = Some(Tolerance::new(1e-6).unwrap()),
            &["hertz", "ep-sphere", "elastic-sine"],
        ),
        ("hardness_formula", |by| by.options.hardness = Some(Hardness::Cosine), &["ep-sphere"]),
        (
            "interference_law",
            |by| by.options.interference_law = Some(InterferenceLaw::Bem),
            &["elastic-sine"],
        ),
        ("summit_heights", |by| by.options.summit_heights = Some(SummitHeights::Gaussian), &[]),
        ("band", |by| by.options.band = Some(Band::Profile), &["persson", "persson-plastic"]),
        ("strength_cap", |by| by.material.strength_cap = Some(Pressure::Pascals(4e9)), &[]),
        (
            "scales_per_decade",
            |by| by.sampling.scales_per_decade = std::num::NonZeroU32::new(5),
            &["hertz", "ep-sphere", "elastic-sine", "persson", "persson-plastic"],
        ),
        (
            "cutoff",
            |by| by.sampling.cutoff_m = Some(1e-5),
            &["hertz", "ep-sphere", "elastic-sine", "persson", "persson-plastic"],
        ),
        (
            "strain_gradient_length",
            |by| by.material.strain_gradient_length_m = Some(1e-6),
            &["hertz", "ep-sphere", "elastic-sine", "persson", "persson-plastic"],
        ),
    ];
    for (option, change, takers) in changes {
        for name in [
            None,
            Some("hertz"),
            Some("ep-sphere"),
            Some("elastic-sine"),
            Some("persson"),
            Some("persson-plastic"),
        ] {
            let expected = match name {
                Some(name) if takers.contains(&name) => None,
                _ => Some(option.to_owned()),
            };
            assert_eq!(refused(name, &change), expected, "{name:?} {option}");
        }
    }
    let random = GapQuestion {
        random: small(1),
        pressures: loads(&[1e6]),
        by: by(Some("hertz")),
        ..GapQuestion::default()
    };
    assert_eq!(unused(random.check()).as_deref(), Some("grid"));
    assert_eq!(missing(law(by(None), 1e6, 1e7).answer(&surface(), &Unobserved)), ["model"]);
    let in_hardnesses =
        LawQuestion { from: Pressure::Hardnesses(1e-3), ..law(by(Some("persson")), 1e6, 1e7) };
    assert!(matches!(in_hardnesses.check(), Err(QuestionError::Load { option: "pressure_range", .. })));
    let question = |name| GapQuestion {
        by: by(name),
        pressures: loads(&[1e6]),
        random: name.map_or(small(1), |_| Default::default()),
        ..GapQuestion::default()
    };
    for name in [None, Some("hertz"), Some("persson")] {
        let stopped = question(name).answer(&surface(), &Counted::cancelled());
        assert!(stopped.is_err_and(|error| error.is_cancelled()), "{name:?}");
    }
    let cut = GapModel {
        sampling: SamplingInput { cutoff_m: Some(1e-9), ..SamplingInput::default() },
        ..by(Some("hertz"))
    };
    assert!(matches!(
        law(cut, 1e6, 1e7).answer(&surface(), &Unobserved),
        Err(QuestionError::CutoffBelowData { .. })
    ));
}

#[test]
fn doubts_about_gaps_follow_theory_load_and_band() {
    let surface = rolled_off();
    let notes = |name: &str, band: Option<Band>, from_pa: f64, to_pa: f64| {
        let options = ModelOptions { band, ..ModelOptions::default() };
        found(GapModel { options, ..by(Some(name)) }, from_pa, to_pa, &surface).notes
    };
    let limit = |name: &str| notes(name, None, 1e4, 1e9);
    // Asperities push each other down once more than 2 % touch.
    assert_eq!(numbers_of(&limit("hertz"), RemarkCode::BeyondLightLoads, ["area"]), [0.02]);
    assert!(!has(&notes("hertz", None, 1e3, 1e4), RemarkCode::BeyondLightLoads));
    assert!(
        !has(&limit("persson"), RemarkCode::BeyondLightLoads)
            && !has(&limit("hertz"), RemarkCode::LightLoads)
    );
    let law = found(by(Some("persson")), 1e4, 1e9, &surface).law;
    let [up_to_pa, share] = numbers_of(&limit("persson"), RemarkCode::LightLoads, ["up_to_pa", "share"]);
    assert_near(up_to_pa, law.light_load_limit_pa(0.01).unwrap(), 1e-9);
    assert_eq!(share, 0.01);
    assert!(!has(&limit("persson"), RemarkCode::NoRollOff));
    assert!(has(&notes("persson", Some(Band::Profile), 1e4, 1e9), RemarkCode::WavesOfProfiles));
    assert!(!has(&limit("persson"), RemarkCode::WavesOfProfiles));
    // Only the waves of the surface are converted from those of profiles.
    let steps = spectrum_of("1e-4,1e-17\n5e-5,1e-17\n4e-5,9e-17\n2e-5,1e-19\n1e-5,1e-20\n");
    let levelled = |name: &str, band: Option<Band>| {
        let options = ModelOptions { band, ..ModelOptions::default() };
        has(
            &found(GapModel { options, ..by(Some(name)) }, 1e4, 1e5, &steps).notes,
            RemarkCode::SpectrumLevelled,
        )
    };
    assert!(
        levelled("persson", None) && !levelled("persson", Some(Band::Profile)) && !levelled("hertz", None)
    );
    let fine = GapModel { tolerance: Some(Tolerance::new(1e-15).unwrap()), ..by(Some("hertz")) };
    assert_eq!(found(fine, 1e4, 1e9, &surface).notes.len(), limit("hertz").len() + 1);
}

#[test]
fn gaps_that_are_negative_missing_or_of_few_asperities_are_counted() {
    let surface = surface();
    let notes = |name: &str, hardness_pa: f64, pressures_pa: &[f64]| {
        let by = GapModel { material: hard(hardness_pa), ..by(Some(name)) };
        let question = GapQuestion { by, pressures: loads(pressures_pa), ..GapQuestion::default() };
        let answer = question.answer(&surface, &Unobserved).unwrap();
        (column(&answer.table, "mean_gap_m"), answer.notes)
    };
    let rms_height_m = found(by(Some("hertz")), 1e4, 1e9, &surface).law.rms_height_m;
    let (gaps, found) = notes("hertz", 1e15, &[1e-3, 1e8, 1e11]);
    let is_few = |gap: &Option<f64>| gap.unwrap() > 3.0 * rms_height_m;
    assert_eq!(gaps.iter().map(is_few).collect::<Vec<_>>(), [true, false, false]);
    assert!(gaps[1].unwrap() > 0.0 && gaps[2].unwrap() < 0.0, "{gaps:?}");
    assert_eq!(numbers_of(&found, RemarkCode::FewTouch, ["loads", "all"]), [1.0, 3.0]);
    assert_eq!(numbers_of(&found, RemarkCode::NegativeGaps, ["loads", "all"]), [1.0, 3.0]);
    assert!(!has(&found, RemarkCode::MissingGaps));
    // From the hardness on everything touches.
    let (gaps, found) = notes("persson-plastic", 1e8, &[9e7, 1.1e8]);
    assert!(gaps[0].is_some() && gaps[1].is_none());
    assert_eq!(numbers_of(&found, RemarkCode::MissingGaps, ["loads", "all"]), [1.0, 2.0]);
    assert!(!has(&found, RemarkCode::FewTouch));
}

#[test]
fn a_pressure_above_the_hardness_is_doubted_unless_the_hardness_grows() {
    let surface = surface();
    let times = |name: &str, options: ModelOptions| {
        let mut material = hard(1e8);
        material.strain_gradient_length_m =
            (options.strain_gradient || options.hardness_law.is_some()).then_some(1e-6);
        let found = found(GapModel { material, options, ..by(Some(name)) }, 1e6, 5e7, &surface);
        let real_pa = 5e7 / found.law.at(5e7).unwrap().area_fraction;
        (real_pa / 1e8, has(&found.notes, RemarkCode::RealAboveHardness), found.notes)
    };
    let (expected, is_above, notes) = times("hertz", ModelOptions::default());
    assert!(is_above && expected > 1.0);
    assert_near(numbers_of(&notes, RemarkCode::RealAboveHardness, ["in_hardnesses"])[0], expected, 1e-9);
    for options in [
        ModelOptions { strain_gradient: true, ..ModelOptions::default() },
        ModelOptions { hardness_law: Some(GrowthLaw::Power(0.3)), ..ModelOptions::default() },
    ] {
        let name = if options.strain_gradient { "ep-sine" } else { "persson-plastic" };
        let (real, is_above, _) = times(name, options);
        assert!(real > 1.0 && !is_above, "{name} {real}");
    }
}

#[test]
fn the_law_of_light_loads_ends_where_it_is_off_by_its_share() {
    let surface = rolled_off();
    let law = found(by(Some("persson")), 1e3, 1e9, &surface);
    let light = law.law.light_loads().unwrap();
    let (exponential, remark) = law.exponential(0.05).unwrap();
    assert_eq!((exponential.decay_length_m, exponential.share), (light.decay_length_m, 0.05));
    let remark = remark.unwrap();
    assert_eq!(
        (remark.number("to_pa"), remark.number("up_to_pa")),
        (Some(1e9), Some(exponential.holds_up_to_pa))
    );
    let short = found(by(Some("persson")), 1e-3, 0.5 * exponential.holds_up_to_pa, &surface);
    assert!(short.exponential(0.05).unwrap().1.is_none());
    assert!(matches!(law.exponential(2.0), Err(QuestionError::Value { option: "error", .. })));
    let spheres = found(by(Some("hertz")), 1e4, 1e6, &surface);
    assert!(
        matches!(spheres.exponential(0.05), Err(QuestionError::NoExponentialLaw(entry)) if entry.name == "hertz")
    );
    // Between its ends the law is straight within the tolerance.
    let progress = Counted::new();
    let sampled = law.sampled(0.02, &progress).unwrap();
    for pressure_pa in [2e4, 3e6, 4e8] {
        let gap_m = law.law.at(pressure_pa).unwrap().mean_gap_m.unwrap();
        assert_near(sampled.pressure_pa(sampled.overclosure_m(gap_m)), pressure_pa, 0.02);
    }
    assert!(progress.count() > 10);
    assert!(law.sampled(0.02, &Counted::cancelled()).is_err_and(|error| error.is_cancelled()));
}

#[test]
fn a_file_names_the_model_and_every_caution_in_its_comments() {
    let mut steep = by(Some("hertz"));
    steep.material = hard(1e8);
    let law = found(steep, 1e4, 1e9, &power_law(2.2));
    let cautions: Vec<_> = law.notes.iter().filter(|note| note.level == RemarkLevel::Caution).collect();
    let lines = law.description(&SceneKeys);
    assert!(!cautions.is_empty());
    // The last line says by how much flow moves the law.
    assert_eq!(lines.len(), 2 + cautions.len());
    assert!(lines[0].contains(law.model.full_name) && lines[0].contains(law.model.citation));
    for (line, caution) in lines[1..].iter().zip(cautions) {
        assert!(line.contains(&caution.words(&SceneKeys)), "{line}");
    }
    // Notes that are no cautions stay out.
    let calm = found(by(Some("persson")), 1e5, 1e6, &rolled_off());
    let calm_cautions = calm.notes.iter().filter(|note| note.level == RemarkLevel::Caution).count();
    assert!(calm.notes.len() > calm_cautions);
    assert_eq!(calm.description(&SceneKeys).len(), 1 + calm_cautions);
}

const HEAT: TransportInput = TransportInput {
    thermal_conductivity_w_per_m_k: Some(50.0),
    counterface_thermal_conductivity_w_per_m_k: Some(150.0),
    resistivity_ohm_m: None,
    counterface_resistivity_ohm_m: None,
};

const CURRENT: TransportInput = TransportInput {
    thermal_conductivity_w_per_m_k: None,
    counterface_thermal_conductivity_w_per_m_k: None,
    resistivity_ohm_m: Some(1e-7),
    counterface_resistivity_ohm_m: Some(3e-7),
};

fn conducts(quantity: LawQuantity, law: LawQuestion) -> LawTableQuestion {
    let transport = if quantity == LawQuantity::Heat { HEAT } else { CURRENT };
    LawTableQuestion { law, quantity, transport, ..LawTableQuestion::default() }
}

fn conductance(question: &LawTableQuestion, surface: &Surface) -> FoundConductance {
    match question.answer(surface, &Unobserved).unwrap() {
        LawAnswer::Conductance(found) => found,
        LawAnswer::Pressure(_) => panic!("no conductance"),
    }
}

/// The question for a correlation instead of a model, of steel with a hardness of 1 GPa.
fn correlated(correlation: PlasticCorrelation, from_pa: f64, to_pa: f64) -> LawTableQuestion {
    let by = GapModel { material: hard(1e9), ..by(None) };
    LawTableQuestion {
        correlation: Some(correlation),
        ..conducts(LawQuantity::Heat, law(by, from_pa, to_pa))
    }
}

#[test]
fn heat_and_current_follow_the_stiffness_by_barbers_analogy_and_gas_the_gap() {
    let surface = surface();
    let stiff = found(by(Some("persson")), 1e5, 1e8, &surface);
    let stiffness = |p: f64| stiff.law.at(p).unwrap().stiffness_pa_per_m.unwrap();
    // Harmonic mean of the conductivities; 2/(rho1 + rho2) of resistivities.
    for (quantity, k_s) in [(LawQuantity::Heat, 75.0), (LawQuantity::Current, 2.0 / 4e-7)] {
        let mut question = conducts(quantity, law(by(Some("persson")), 1e5, 1e8));
        if quantity == LawQuantity::Heat {
            question.gas = GasInput {
                name: Some(NamedGas::Air),
                pressure: Some(Pressure::Pascals(2e5)),
                ..GasInput::default()
            };
        }
        let found = conductance(&question, &surface);
        let progress = Counted::new();
        let table = found.sampled(0.01, &progress).unwrap();
        let points = &table.points[1..];
        assert!(progress.count() >= points.len());
        assert_all_near(&[points[0].pressure_pa, points[points.len() - 1].pressure_pa], &[1e5, 1e8], 1e-9);
        let temperature_k = NamedGas::REFERENCE_TEMPERATURE_K;
        let gas = GapGas::new(
            NamedGas::Air.conductivity_w_per_m_k(temperature_k).unwrap(),
            NamedGas::Air.parameter_m(temperature_k, 2e5).unwrap(),
        )
        .unwrap();
        for point in points {
            assert_near(point.contact_si, k_s * stiffness(point.pressure_pa) / STEEL_MODULUS_PA, 1e-9);
            let gap_m = stiff.law.at(point.pressure_pa).unwrap().mean_gap_m.unwrap();
            let of_gas = gas.conductance_w_per_m2_k(gap_m, stiff.law.rms_height_m);
            assert_near(point.gas_si, if quantity == LawQuantity::Heat { of_gas } else { 0.0 }, 1e-9);
        }
        assert!(found.sampled(0.01, &Counted::cancelled()).is_err_and(|error| error.is_cancelled()));
    }
}

#[test]
fn correlations_follow_their_formulas_with_slope_height_and_hardness() {
    let surface = surface();
    let moments = cumulative_moments(&surface.psd, Normalisation::Parseval);
    let last = moments.last().unwrap();
    let sigma_m = last.m0_m2.sqrt();
    // The mean absolute slope of a Gaussian surface from the rms gradient of the surface, sqrt(2) times that of a profile.
    let cut = CutSurface::from_rms_slope(sigma_m, last.rms_slope()).unwrap();
    let m = cut.mean_absolute_slope();
    for (correlation, factor, exponent) in [
        (PlasticCorrelation::CooperMikicYovanovich, 1.45, 0.985),
        (PlasticCorrelation::Yovanovich, 1.25, 0.95),
    ] {
        let mut question = correlated(correlation, 1e5, 1e7);
        question.gas =
            GasInput { conductivity_w_per_m_k: Some(0.03), parameter_m: Some(4e-7), ..GasInput::default() };
        let table = conductance(&question, &surface).sampled(0.01, &Unobserved).unwrap();
        let gas = GapGas::new(0.03, 4e-7).unwrap();
        for point in &table.points[1..] {
            let share = point.pressure_pa / 1e9;
            assert_near(point.contact_si, factor * 75.0 * m / sigma_m * share.powf(exponent), 1e-6);
            let apart_m =
                plastic_separation_m(sigma_m, PressureRatio::new(point.pressure_pa, 1e9).unwrap()).unwrap();
            assert_near(point.gas_si, gas.conductance_w_per_m2_k(apart_m, sigma_m), 1e-6);
        }
        // No elastic constant counts.
        question.law.by.material.youngs_modulus_pa = None;
        question.law.by.material.poisson_ratio = None;
        let same = conductance(&question, &surface).sampled(0.01, &Unobserved).unwrap();
        assert_eq!(same.points, table.points);
    }
}

#[test]
fn comments_on_conductance_grow_with_what_it_leaves_out() {
    let surface = surface();
    let lines = |question: &LawTableQuestion| {
        let found = conductance(question, &surface);
        let cautions = found.notes.iter().filter(|note| note.level == RemarkLevel::Caution).count();
        let lines = found.description(&SceneKeys);
        assert!(lines.iter().all(|line| line.len() > 20), "{lines:?}");
        (lines.len() - cautions, lines)
    };
    let of = |hardness_pa: f64, name: &str, quantity| {
        conducts(quantity, law(GapModel { material: hard(hardness_pa), ..by(Some(name)) }, 1e5, 1e6))
    };
    let with = |name: &str, quantity| of(90e9, name, quantity);
    // Model, formula, and what is clean; one more if the model yields or leaves out that the contact does, and one for the gas.
    assert_eq!(lines(&of(3e9, "persson", LawQuantity::Heat)).0, 4);
    let (count, elastic) = lines(&with("persson", LawQuantity::Heat));
    assert_eq!(count, 3);
    let modulus = units::display::pressure(STEEL_MODULUS_PA);
    assert!(elastic[1].contains(&three_digits(75.0)) && elastic[1].contains(&modulus), "{elastic:?}");
    assert_eq!(lines(&with("ep-sphere", LawQuantity::Heat)).0, 4);
    let (count, current) = lines(&with("persson", LawQuantity::Current));
    assert_eq!((count, current.last() == elastic.last()), (3, false));
    let gas = GasInput { conductivity_w_per_m_k: Some(0.03), parameter_m: Some(1.0), ..GasInput::default() };
    assert_eq!(lines(&LawTableQuestion { gas, ..with("persson", LawQuantity::Heat) }).0, 4);
    // The range of a fit, p/H from 1e-6 to 0.023, and that of the table.
    let fitted = |from_pa: f64, to_pa: f64| {
        let (count, lines) = lines(&correlated(PlasticCorrelation::Yovanovich, from_pa, to_pa));
        assert_eq!(count, 3);
        let ends = [from_pa / 1e9, to_pa / 1e9].map(three_digits);
        let line = lines.iter().find(|line| ends.iter().all(|end| line.contains(end.as_str())));
        let line = line.unwrap_or_else(|| panic!("{ends:?} {lines:?}")).clone();
        line.len() - ends[0].len() - ends[1].len()
    };
    let inside = fitted(1e4, 1e6);
    assert_eq!([fitted(1e4, 2e6), fitted(2e4, 1e6)], [inside; 2]);
    assert!([fitted(1e2, 1e6), fitted(1e4, 1e8), fitted(1e2, 1e8)].iter().all(|beyond| *beyond > inside));
    let [yovanovich, cooper] = [PlasticCorrelation::Yovanovich, PlasticCorrelation::CooperMikicYovanovich]
        .map(|correlation| lines(&correlated(correlation, 1e4, 1e6)).1[0].clone());
    assert!(yovanovich.contains("0.95") && cooper.contains("0.985"));
}

#[test]
fn a_conductance_above_the_hardness_names_the_correlation_for_flowed_peaks() {
    let surface = surface();
    let notes = |name: &str| {
        let by = GapModel { material: hard(1e8), ..by(Some(name)) };
        conductance(&conducts(LawQuantity::Heat, law(by, 1e6, 5e7)), &surface).notes
    };
    assert_eq!(text_of(&notes("persson"), RemarkCode::RealAboveHardness, "model"), "yovanovich");
    let elastic = notes("persson");
    let others = elastic.iter().filter(|note| note.code != RemarkCode::RealAboveHardness);
    assert!(others.clone().count() > 0);
    let is_named = |note: &&units::Remark| {
        note.numbers.iter().any(|(_, value)| *value == units::RemarkValue::Text("yovanovich".to_owned()))
    };
    assert_eq!(others.filter(is_named).count(), 0);
    // A sinusoid that yields bears a little more than the hardness, which is no reason for a correlation.
    assert!(notes("ep-sine").iter().filter(is_named).count() == 0);
}

#[test]
fn options_that_a_quantity_ignores_and_properties_that_it_lacks_are_named() {
    let persson = || law(GapModel { material: hard(3e9), ..by(Some("persson")) }, 1e5, 1e6);
    let mechanical = || LawTableQuestion { law: persson(), ..LawTableQuestion::default() };
    let heat = || conducts(LawQuantity::Heat, persson());
    let current = || conducts(LawQuantity::Current, persson());
    let yovanovich = || correlated(PlasticCorrelation::Yovanovich, 1e5, 1e6);
    let gas = GasInput { name: Some(NamedGas::Air), ..GasInput::default() };
    let name = || Some("joint".to_owned());
    for fine in [mechanical(), heat(), current(), yovanovich(), LawTableQuestion { gas, ..heat() }] {
        fine.check().unwrap();
    }
    for form in [LawForm::Table, LawForm::Exponential] {
        LawTableQuestion { form: Some(form), name: name(), dialect: Some(Dialect::Abaqus), ..mechanical() }
            .check()
            .unwrap();
    }
    let both = TransportInput { resistivity_ohm_m: Some(1e-7), ..HEAT };
    let mut model = yovanovich();
    model.law.by.options.band = Some(Band::Profile);
    let mut normalised = yovanovich();
    normalised.law.by.normalisation = Some(Normalisation::Parseval);
    let gradient = |mut question: LawTableQuestion| {
        question.law.by.material.strain_gradient_length_m = Some(1e-6);
        question
    };
    let exponential = || LawTableQuestion { form: Some(LawForm::Exponential), ..mechanical() };
    let table = || LawTableQuestion { form: Some(LawForm::Table), ..mechanical() };
    gradient(table()).check().unwrap();
    for (question, option) in [
        (LawTableQuestion { name: name(), dialect: Some(Dialect::Csv), ..mechanical() }, "name"),
        (LawTableQuestion { transport: HEAT, ..mechanical() }, "thermal_conductivity"),
        (LawTableQuestion { transport: CURRENT, ..mechanical() }, "resistivity"),
        (LawTableQuestion { gas, ..mechanical() }, "gas"),
        (gradient(exponential()), "strain_gradient_length"),
        (LawTableQuestion { form: Some(LawForm::Table), ..heat() }, "form"),
        (LawTableQuestion { name: name(), ..heat() }, "name"),
        (LawTableQuestion { transport: both, ..heat() }, "resistivity"),
        (
            LawTableQuestion {
                transport: TransportInput { thermal_conductivity_w_per_m_k: Some(1.0), ..CURRENT },
                ..current()
            },
            "thermal_conductivity",
        ),
        (LawTableQuestion { gas, ..current() }, "gas"),
        (model, "band"),
        (normalised, "normalisation"),
        (gradient(yovanovich()), "strain_gradient_length"),
        (LawTableQuestion { gas: GasInput { parameter_m: Some(1.0), ..gas }, ..heat() }, "gas_parameter"),
    ] {
        assert_eq!(unused(question.check()).as_deref(), Some(option), "{question:?}");
    }
    for (transport, quantity, option) in [
        (
            TransportInput { thermal_conductivity_w_per_m_k: None, ..HEAT },
            LawQuantity::Heat,
            "thermal_conductivity",
        ),
        (
            TransportInput { counterface_thermal_conductivity_w_per_m_k: None, ..HEAT },
            LawQuantity::Heat,
            "counterface_thermal_conductivity",
        ),
        (
            TransportInput { counterface_resistivity_ohm_m: None, ..CURRENT },
            LawQuantity::Current,
            "counterface_resistivity",
        ),
    ] {
        let question = LawTableQuestion { transport, ..conducts(quantity, persson()) };
        assert_eq!(missing(question.check()), [option]);
    }
    let negative = TransportInput { thermal_conductivity_w_per_m_k: Some(-1.0), ..HEAT };
    let negative = LawTableQuestion { transport: negative, ..heat() };
    assert!(matches!(negative.check(), Err(QuestionError::Value { option: "thermal_conductivity", .. })));
    let half =
        LawTableQuestion { gas: GasInput { parameter_m: Some(1e-7), ..GasInput::default() }, ..heat() };
    assert_eq!(missing(half.check()), ["gas_conductivity"]);
    let cold = LawTableQuestion { gas: GasInput { temperature_k: Some(1.0), ..gas }, ..heat() };
    assert!(matches!(cold.check(), Err(QuestionError::Value { option: "gas_temperature", .. })));
    let mut soft = yovanovich();
    soft.law.by.material = crate::common::steel();
    assert_eq!(missing(soft.check()), ["indentation_hardness", "yield_strength"]);
    let only = LawTableQuestion { correlation: Some(PlasticCorrelation::Yovanovich), ..mechanical() };
    assert!(matches!(only.check(), Err(QuestionError::ConductanceOnly(PlasticCorrelation::Yovanovich))));
    let mut layered = yovanovich();
    layered.law.by.material.layer = Some(questions::LayerInput::default());
    assert_eq!(unused(layered.check()).as_deref(), Some("layer_thickness"));
    assert!(matches!(heat().answer(&surface(), &Counted::cancelled()), Err(error) if error.is_cancelled()));
}

#[test]
fn the_table_of_materials_fills_the_properties_of_the_quantity_alone() {
    let [copper, steel] = ["annealed copper", "304"].map(|name| materials::named(name).unwrap());
    let filled = |quantity, transport| {
        let question = LawTableQuestion { quantity, transport, ..LawTableQuestion::default() };
        question.filled_from(Some(&copper), Some(&steel)).transport
    };
    let none = TransportInput::default();
    assert_eq!(filled(LawQuantity::Pressure, none), none);
    // Copper conducts about 400 W/(m K), and stainless steel 15.
    let heat = filled(LawQuantity::Heat, none);
    let pair = [heat.thermal_conductivity_w_per_m_k, heat.counterface_thermal_conductivity_w_per_m_k];
    let [own, other] = pair.map(Option::unwrap);
    assert!((390.0..410.0).contains(&own) && (14.0..17.0).contains(&other), "{own} {other}");
    assert!(heat.resistivity_ohm_m.is_none());
    let current = filled(LawQuantity::Current, none);
    let [own, other] = [current.resistivity_ohm_m, current.counterface_resistivity_ohm_m].map(Option::unwrap);
    assert!((1.6e-8..1.8e-8).contains(&own) && (6e-7..8e-7).contains(&other), "{own} {other}");
    assert!(current.thermal_conductivity_w_per_m_k.is_none());
    assert_eq!(filled(LawQuantity::Heat, HEAT), HEAT);
}

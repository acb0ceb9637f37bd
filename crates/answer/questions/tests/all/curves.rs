//! Contact and spectra over the cutoff: curves of every theory, and the spectrum alone.

use std::num::NonZeroU32;

use asperity::FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
use numerics::parallel::Unobserved;
use persson::Band;
use persson::corrections::Correction;
use questions::{
    CurveCounts, CurveQuestion, GapQuestion, LawQuestion, QuestionError, SamplingInput, SpectrumQuantity,
    SpectrumQuestion,
};
use spectrum::{AmplitudeDefinition, AsperityParameters, Normalisation, amplitudes, cumulative_moments};
use study::growth_law::GrowthLaw;
use study::models::ModelOptions;
use study::plan::{CurveResult, Plan, PlanError, Tolerance};
use study::surface::Surface;
use tables::Table;
use units::{Pressure, PressureRange, Remark, RemarkCode};

use crate::common::{
    Counted, assert_all_near, assert_near, by, column, filled, hard, has, loads, missing, model, numbers_of,
    power_law, spectrum_of, steel, surface, unused,
};

fn curve(name: &str, pressures_pa: &[f64]) -> CurveQuestion {
    CurveQuestion {
        model: model(name),
        material: hard(3e9),
        pressures: loads(pressures_pa),
        ..CurveQuestion::default()
    }
}

/// The rows of a curve, computed as a plan.
fn rows(question: &CurveQuestion, surface: &Surface) -> CurveResult {
    let plan =
        Plan { psd: &surface.psd, sampling: question.sampling.sampling(), needs: question.needs().unwrap() };
    plan.compute().unwrap().curves.remove(0)
}

fn codes(notes: &[Remark]) -> Vec<RemarkCode> {
    notes.iter().map(|note| note.code).collect()
}

#[test]
fn a_curve_in_parts_is_the_curve_at_once_and_names_its_loads_if_there_are_several() {
    let surface = surface();
    for name in ["elastic", "ep-sphere", "persson", "persson-plastic"] {
        let names =
            |table: &Table| -> Vec<String> { table.columns().map(|(name, _)| name.to_owned()).collect() };
        let columns = [&[1e6][..], &[1e6, 1e7]].map(|pressures_pa| {
            let question = curve(name, pressures_pa);
            let prepared = question.on(&surface).unwrap();
            assert_eq!(prepared.pressures_pa(), pressures_pa.iter().copied().map(Some).collect::<Vec<_>>());
            let stream = prepared.stream().unwrap();
            let progress = Counted::new();
            let mut parts = Vec::new();
            let of_parts = stream.parts::<PlanError>(&progress, |part| {
                parts.push(part);
                Ok(())
            });
            let whole = stream.whole(&Unobserved).unwrap();
            assert_eq!(stream.steps(), whole.table.rows(), "{name}");
            assert_eq!(progress.count() > 0, name == "ep-sphere", "{name}");
            assert_eq!(of_parts.unwrap(), whole.notes);
            let areas: Vec<_> = parts.iter().flat_map(|part| column(part, "area_fraction")).collect();
            assert_eq!(areas, column(&whole.table, "area_fraction"), "{name}");
            assert_eq!(names(&parts[0]), names(&whole.table));
            // An answer has the notes from before its rows and those on them, which others may have computed.
            let answer = question.answer(&surface, &Unobserved).unwrap();
            assert_eq!(answer.notes, [stream.notes(), whole.notes.clone()].concat());
            let on_rows = prepared.notes_on(&rows(&question, &surface));
            assert!(on_rows.ends_with(&whole.notes), "{name}");
            names(&whole.table)
        });
        // Statistical rows have their pressures in any case.
        let more = usize::from(name != "ep-sphere");
        assert_eq!(columns[1].len(), columns[0].len() + more, "{name}: {columns:?}");
    }
}

#[test]
fn a_curve_takes_its_needs_from_the_question() {
    let tolerance = Tolerance::new(1e-4).unwrap();
    let range = "1 MPa:4 MPa:3".parse::<PressureRange>().unwrap();
    let question = CurveQuestion {
        name: Some("mine".to_owned()),
        separations_m: vec![1e-7],
        pressure_ranges: vec![range],
        tolerance: Some(tolerance),
        normalisation: Some(Normalisation::AsPrinted),
        ..curve("hertz", &[1e5])
    };
    let needs = question.needs().unwrap();
    assert_eq!((needs.tolerance, needs.moments), (tolerance, Some(Normalisation::AsPrinted)));
    assert_eq!((needs.loads.len(), needs.load_count(), &needs.separations_m), (1, 4, &vec![1e-7]));
    assert_eq!(needs.curves[0].name, "mine");
    let surface = surface();
    let pressures = question.on(&surface).unwrap().pressures_pa();
    assert_eq!((pressures.len(), pressures[0], pressures[4]), (5, Some(1e5), None));
    // The last block of rows is at the separation.
    let separations = column(&question.answer(&surface, &Unobserved).unwrap().table, "separation_m");
    assert_eq!(separations.last(), Some(&Some(1e-7)));
    let amplitude = Some(AmplitudeDefinition::Parseval);
    let stack = CurveQuestion { amplitude, ..curve("elastic", &[1e6]) };
    assert_eq!(stack.needs().unwrap().amplitudes, amplitude);
    // Persson's theory needs amplitudes for a hardness that grows with them.
    let options = ModelOptions { hardness_law: Some(GrowthLaw::NixGao), ..ModelOptions::default() };
    let mut grows = CurveQuestion { options, amplitude, ..curve("persson-plastic", &[1e6]) };
    grows.material.strain_gradient_length_m = Some(1e-6);
    assert_eq!(grows.needs().unwrap().amplitudes, amplitude);
    let grows_twice = CurveQuestion { amplitude: None, ..grows.clone() };
    assert_eq!(grows_twice.needs().unwrap().amplitudes, Some(AmplitudeDefinition::default()));
    let default = Some(AmplitudeDefinition::default());
    assert!(CurveQuestion { amplitude: default, ..curve("persson", &[1e6]) }.check().is_ok());
    assert_eq!(
        unused(CurveQuestion { amplitude, ..curve("persson", &[1e6]) }.check()).as_deref(),
        Some("amplitude")
    );
}

#[test]
fn a_curve_without_a_model_or_a_load_says_what_it_lacks() {
    assert_eq!(missing(CurveQuestion { model: None, ..curve("hertz", &[1e6]) }.check()), ["model"]);
    assert_eq!(missing(curve("hertz", &[]).check()), ["pressure", "separation"]);
    assert_eq!(missing(curve("persson", &[]).check()), ["pressure"]);
    let range = "1 MPa:4 MPa:3".parse::<PressureRange>().unwrap();
    assert!(CurveQuestion { pressure_ranges: vec![range], ..curve("persson", &[]) }.check().is_ok());
    assert!(CurveQuestion { separations_m: vec![1e-8], ..curve("hertz", &[]) }.check().is_ok());
    let no_hardness = CurveQuestion { material: steel(), ..curve("persson-plastic", &[1e6]) };
    assert!(matches!(no_hardness.check(), Err(QuestionError::Material(_))));
    let in_hardnesses =
        CurveQuestion { material: steel(), pressures: vec!["0.1 H".parse().unwrap()], ..curve("hertz", &[]) };
    assert!(matches!(
        in_hardnesses.check(),
        Err(QuestionError::Load { option: "pressure", label: Some(_), .. })
    ));
}

#[test]
fn a_hardness_that_grows_carries_no_load_above_itself_and_says_so_before_any_row() {
    let surface = surface();
    let options = ModelOptions { hardness_law: Some(GrowthLaw::Power(0.2)), ..ModelOptions::default() };
    let stream = |pressures_pa: &[f64]| {
        let question = CurveQuestion { options: options.clone(), ..curve("persson-plastic", pressures_pa) };
        question.on(&surface).unwrap().stream().map(|stream| stream.steps())
    };
    assert!(stream(&[1e6, 1e7]).is_ok());
    assert!(matches!(stream(&[1e6, 4e9]), Err(QuestionError::Hardness(_))));
}

#[test]
fn a_figure_has_a_line_for_each_load_and_separation_up_to_two_dozen() {
    let range = |points| PressureRange { from: Pressure::Pascals(1e5), to: Pressure::Pascals(1e7), points };
    let check = |pressures: usize, points: u32, separations: usize, figure: bool| {
        let pressures_pa: Vec<f64> = (0..pressures).map(|at| 1e4 * (at + 1) as f64).collect();
        let question = CurveQuestion {
            pressure_ranges: vec![range(points)],
            separations_m: (0..separations).map(|at| 1e-9 * at as f64).collect(),
            figure,
            ..curve("hertz", &pressures_pa)
        };
        match question.check() {
            Err(QuestionError::TooManyLines { lines, most: CurveQuestion::MOST_LINES, .. }) => lines,
            other => {
                other.unwrap();
                0
            }
        }
    };
    assert_eq!([check(10, 2, 12, true), check(11, 2, 12, true), check(11, 2, 12, false)], [0, 25, 0]);
    let question =
        CurveQuestion { figure: true, pressure_ranges: vec![range(2)], ..curve("persson", &[1e6]) };
    let found = question.answer(&surface(), &Unobserved).unwrap();
    let figure = found.figure.unwrap();
    assert_eq!(figure.series.len(), 3);
    let areas = filled(&found.table, "area_fraction");
    let last = areas.len() / 3 - 1;
    assert_near(figure.series[0].points.last().unwrap().1, areas[last], 1e-12);
    assert!(curve("persson", &[1e6]).answer(&surface(), &Unobserved).unwrap().figure.is_none());
}

#[test]
fn notes_before_the_rows_are_those_of_the_theory() {
    let surface = surface();
    let notes = |question: &CurveQuestion| question.on(&surface).unwrap().stream().unwrap().notes();
    let stack = notes(&curve("elastic", &[1e6]));
    let sampling =
        numbers_of(&stack, RemarkCode::Sampling, ["scales", "longest_m", "shortest_m", "per_decade"]);
    assert_all_near(&sampling, &[21.0, 1e-4, 1e-6, 10.0], 1e-9);
    assert!(!has(&stack, RemarkCode::FirstRowIsEmpty));
    let spheres = notes(&curve("hertz", &[1e6]));
    assert!(has(&spheres, RemarkCode::FirstRowIsEmpty) && !has(&spheres, RemarkCode::Sampling));
    // Asperities yield at a third of the hardness, which is all that is given; Persson's theory takes it itself.
    for (name, is_assumed) in [("hertz", false), ("ep-sphere", true), ("persson-plastic", false)] {
        let found = notes(&curve(name, &[1e6]));
        assert_eq!(has(&found, RemarkCode::AssumedStrength), is_assumed, "{name}");
        if is_assumed {
            assert_eq!(numbers_of(&found, RemarkCode::AssumedStrength, ["yield_strength_pa"]), [1e9]);
        }
    }
    let fine = CurveQuestion { tolerance: Some(Tolerance::new(1e-15).unwrap()), ..curve("hertz", &[1e6]) };
    assert_eq!(notes(&fine).len(), spheres.len() + 1);
    // Waves of a surface are those of its profiles, converted: a step in the spectrum is levelled.
    let steps = spectrum_of("1e-4,1e-17\n5e-5,1e-17\n4e-5,9e-17\n2e-5,1e-19\n1e-5,1e-20\n");
    let of_band = |band| {
        let options = ModelOptions { band: Some(band), ..ModelOptions::default() };
        let question = CurveQuestion { options, ..curve("persson", &[1e6]) };
        has(&question.on(&steps).unwrap().stream().unwrap().notes(), RemarkCode::SpectrumLevelled)
    };
    assert!(of_band(Band::Surface) && !of_band(Band::Profile));
}

#[test]
fn few_asperities_touch_below_the_pressure_at_a_gap_of_three_rms_heights() {
    let surface = surface();
    let law = LawQuestion { by: by(Some("persson")), ..LawQuestion::default() };
    let law = law.answer(&surface, &Unobserved).unwrap().law;
    let light = law.light_loads().unwrap();
    let limit_pa = light.pressure_at_gap_pa(3.0, law.rms_height_m);
    let question = |pressures_pa: &[f64]| curve("persson", pressures_pa);
    let notes = |pressures_pa: &[f64]| {
        let question = question(pressures_pa);
        let prepared = question.on(&surface).unwrap();
        let stream = prepared.stream().unwrap();
        assert_eq!(stream.light_loads(), Some(light));
        let gaps =
            GapQuestion { by: by(Some("persson")), pressures: loads(pressures_pa), ..GapQuestion::default() };
        (stream.notes(), gaps.answer(&surface, &Unobserved).unwrap().notes)
    };
    let (curve_notes, gap_notes) = notes(&[1e3 * limit_pa, 0.9 * limit_pa]);
    for notes in [&curve_notes, &gap_notes] {
        assert_near(numbers_of(notes, RemarkCode::FewTouchBelow, ["limit_pa"])[0], limit_pa, 1e-9);
        // The power law begins without a roll-off.
        let [share] = numbers_of(notes, RemarkCode::NoRollOff, ["share_of_first_decade"]);
        assert_near(share, light.share_of_first_decade, 1e-9);
    }
    let (curve_notes, gap_notes) = notes(&[1.1 * limit_pa]);
    assert!([curve_notes, gap_notes].iter().all(|notes| !has(notes, RemarkCode::FewTouchBelow)));
    assert!(curve("hertz", &[1e6]).on(&surface).unwrap().stream().unwrap().light_loads().is_none());
}

#[test]
fn a_correction_says_where_it_was_fitted_and_which_cutoffs_lie_outside() {
    let corrected = |correction, surface: &Surface| {
        let options = ModelOptions { correction, band: Some(Band::Profile), ..ModelOptions::default() };
        let question = CurveQuestion { options, ..curve("persson", &[1e6]) };
        question.on(surface).unwrap().stream().unwrap().notes()
    };
    let correction = Correction::ALL.first().copied();
    let smooth = power_law(2.6);
    let notes = corrected(correction, &smooth);
    let [least, most] = numbers_of(&notes, RemarkCode::FittedRange, ["least", "most"]);
    assert_eq!([least, most], Correction::FITTED_ALPHA);
    // Alpha by the moments of the lower crate.
    let moments = cumulative_moments(&smooth.psd, Normalisation::Parseval);
    let alpha = |of: &spectrum::Moments| of.m0_m2 * of.m4_per_m2 / (of.m2 * of.m2);
    let outside: Vec<_> = moments.iter().filter(|of| !(least..=most).contains(&alpha(of))).collect();
    assert!(!outside.is_empty() && outside.len() < moments.len());
    let names = ["cutoffs", "all", "first_m", "last_m", "first_alpha", "last_alpha"];
    let (first, last) = (outside[0], outside[outside.len() - 1]);
    assert_all_near(
        &numbers_of(&notes, RemarkCode::OutsideFit, names),
        &[
            outside.len() as f64,
            moments.len() as f64,
            first.wavelength_m,
            last.wavelength_m,
            alpha(first),
            alpha(last),
        ],
        1e-6,
    );
    assert!(!has(&corrected(None, &smooth), RemarkCode::FittedRange));
}

#[test]
fn rows_outside_the_range_of_their_theory_are_counted_load_after_load() {
    let pressures_pa = [1e7, 1e9];
    let counted = |question: &CurveQuestion, surface: &Surface| {
        let rows = rows(question, surface);
        let mut counts = CurveCounts::default();
        counts.add(&rows);
        let once = counts.remarks();
        let answer = question.answer(surface, &Unobserved).unwrap();
        assert!(once.iter().all(|note| answer.notes.contains(note)), "{once:?}");
        counts.add(&rows);
        (rows, once, counts.remarks())
    };
    // A stack so soft that the sinusoid is not trusted.
    let mut soft = curve("elastic-plastic", &pressures_pa);
    soft.material.indentation_hardness_pa = Some(2e7);
    let rough = power_law(2.2);
    let (found, once, twice) = counted(&soft, &rough);
    let levels: Vec<_> = found.stacked().unwrap().iter().flatten().collect();
    let is_beyond = |ratio: f64| ratio > FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
    let beyond =
        levels.iter().filter(|level| level.aspect_ratio_over_critical.is_some_and(is_beyond)).count();
    assert!(beyond > 0 && beyond < levels.len(), "{beyond} of {}", levels.len());
    let expected = [beyond as f64, levels.len() as f64];
    assert_eq!(numbers_of(&once, RemarkCode::LevelsOutOfRange, ["levels", "all"]), expected);
    assert_eq!(
        numbers_of(&twice, RemarkCode::LevelsOutOfRange, ["levels", "all"]),
        expected.map(|n| 2.0 * n)
    );
    assert!(counted(&curve("elastic", &pressures_pa), &rough).1.is_empty());
    // Slopes above 0.2, and a load above the hardness.
    let mut flows = curve("persson-plastic", &pressures_pa);
    flows.material.indentation_hardness_pa = Some(5e8);
    let steep = {
        let row = |i: i32| {
            let wavelength_m = 1e-4 * 10f64.powf(f64::from(-i) / 10.0);
            format!("{wavelength_m:e},{:e}\n", 4e-21 * (wavelength_m / 1e-6).powf(2.2))
        };
        spectrum_of(&(0..=20).map(row).collect::<String>())
    };
    let (found, once, twice) = counted(&flows, &steep);
    let cuts: Vec<_> = found.persson().unwrap().iter().flatten().collect();
    let steep_cuts: Vec<_> = cuts.iter().filter(|cut| cut.rms_gradient > 0.2).collect();
    assert!(
        !steep_cuts.is_empty() && steep_cuts.len() < cuts.len(),
        "{} of {}",
        steep_cuts.len(),
        cuts.len()
    );
    let longest_m = steep_cuts.iter().map(|cut| cut.wavelength_m).fold(0.0, f64::max);
    let steepest = steep_cuts.iter().map(|cut| cut.rms_gradient).fold(0.0, f64::max);
    let names = ["steep", "all", "longest_steep_m", "steepest"];
    let counts = [steep_cuts.len() as f64, cuts.len() as f64];
    let [n, all] = counts;
    assert_eq!(numbers_of(&once, RemarkCode::SteepCutoffs, names), [n, all, longest_m, steepest]);
    assert_eq!(
        numbers_of(&twice, RemarkCode::SteepCutoffs, names),
        [2.0 * n, 2.0 * all, longest_m, steepest]
    );
    assert_eq!(numbers_of(&once, RemarkCode::FlowingLoads, ["loads"]), [1.0]);
    assert_eq!(numbers_of(&twice, RemarkCode::FlowingLoads, ["loads"]), [2.0]);
    assert!(counted(&curve("persson-plastic", &pressures_pa), &surface()).1.is_empty());
    // The first cutoffs leave a spectrum too narrow for summits.
    let (found, once, _) = counted(&curve("bgt", &pressures_pa), &surface());
    let states: Vec<_> = found.statistical().unwrap().iter().flatten().collect();
    let narrow = states.iter().filter(|row| row.too_narrow_alpha.is_some()).count();
    let contacts = states.iter().filter(|row| row.contact.is_some()).count();
    assert!(narrow > 0);
    let expected = [narrow as f64, (narrow + contacts) as f64];
    assert_eq!(numbers_of(&once, RemarkCode::NarrowSpectra, ["narrow", "all"]), expected);
}

#[test]
fn a_real_pressure_above_the_hardness_is_doubted_with_a_model_that_yields() {
    let surface = surface();
    let mut question = curve("hertz", &[1e6, 2e8]);
    question.material.indentation_hardness_pa = Some(1e8);
    let rows = rows(&question, &surface);
    let notes = question.on(&surface).unwrap().notes_on(&rows);
    let highest_pa = rows.highest_real_pressure_pa(0).max(rows.highest_real_pressure_pa(1));
    let [times] = numbers_of(&notes, RemarkCode::RealAboveHardness, ["in_hardnesses"]);
    assert_near(times, highest_pa / 1e8, 1e-9);
    let [times] = numbers_of(&notes, RemarkCode::NominalAboveHardness, ["in_hardnesses"]);
    assert_near(times, 2.0, 1e-12);
    assert!(!codes(&notes).contains(&RemarkCode::FirstRowIsEmpty));
}

#[test]
fn scales_that_take_part_end_at_the_cutoff_which_must_leave_something_out() {
    let surface = surface();
    let cut = |cutoff_m: f64| {
        let sampling = SamplingInput { cutoff_m: Some(cutoff_m), scales_per_decade: NonZeroU32::new(5) };
        CurveQuestion { sampling, ..curve("elastic", &[1e6]) }.answer(&surface, &Unobserved)
    };
    let wavelengths = filled(&cut(1e-5).unwrap().table, "wavelength_m");
    // Five scales in the decade from 100 um to 10 um, and both ends.
    assert_eq!(wavelengths.len(), 6);
    assert_near(wavelengths[5], 1e-5, 1e-9);
    let shortest_m = surface.psd.shortest_wavelength_m();
    assert!(cut(shortest_m).is_ok());
    match cut(0.9e-6) {
        Err(QuestionError::CutoffBelowData { cutoff_m, shortest_m: found_m, surface }) => {
            assert_eq!((cutoff_m, found_m, surface.as_str()), (0.9e-6, shortest_m, "rough.csv"));
        }
        other => panic!("{:?}", other.map(|answer| answer.notes)),
    }
}

fn of_spectrum(quantity: SpectrumQuantity, surface: &Surface) -> questions::Answer {
    let progress = Counted::new();
    let question = SpectrumQuestion { quantity, figure: true, ..SpectrumQuestion::default() };
    let answer = question.answer(surface, &progress).unwrap();
    assert_eq!(progress.count(), SpectrumQuestion::STEPS);
    answer
}

#[test]
fn moments_and_amplitudes_are_those_of_the_spectrum() {
    let surface = surface();
    for normalisation in [Normalisation::Parseval, Normalisation::AsPrinted] {
        let found = of_spectrum(SpectrumQuantity::Moments { normalisation }, &surface);
        let moments = cumulative_moments(&surface.psd, normalisation);
        let of = |name: &str| column(&found.table, name).into_iter().skip(1).flatten().collect::<Vec<_>>();
        let expected = |of: fn(&spectrum::Moments) -> f64| moments.iter().map(of).collect::<Vec<_>>();
        assert_all_near(&of("m0_m2"), &expected(|moments| moments.m0_m2), 1e-12);
        assert_all_near(&of("m4_per_m2"), &expected(|moments| moments.m4_per_m2), 1e-12);
        let asperities: Vec<_> = moments.iter().filter_map(AsperityParameters::from_moments).collect();
        let radii: Vec<f64> = asperities.iter().map(|one| one.radius_m).collect();
        assert_all_near(&of("radius_m"), &radii, 1e-12);
        assert!(found.figure.is_some());
        // Cutoffs with an alpha that no Gaussian isotropic surface has.
        let offenders: Vec<_> = moments
            .iter()
            .filter(|of| AsperityParameters::from_moments(of).is_some_and(|one| !one.is_gaussian_isotropic()))
            .collect();
        assert!(offenders.len() > 1);
        let alpha = |of: &&spectrum::Moments| of.m0_m2 * of.m4_per_m2 / (of.m2 * of.m2);
        let least = offenders.iter().map(alpha).fold(f64::INFINITY, f64::min);
        let names = ["least_alpha", "cutoffs", "longest_m", "shortest_m"];
        let [least_alpha, cutoffs, longest_m, shortest_m] =
            numbers_of(&found.notes, RemarkCode::NotGaussianMoments, names);
        assert!(
            (least_alpha - least).abs() <= 5.1e-4
                && (1e3 * least_alpha - (1e3 * least_alpha).round()).abs() < 1e-9
        );
        assert_eq!(cutoffs, offenders.len() as f64);
        assert_eq!(
            (longest_m, shortest_m),
            (offenders[0].wavelength_m, offenders[offenders.len() - 1].wavelength_m)
        );
    }
    let definition = AmplitudeDefinition::Parseval;
    let found = of_spectrum(SpectrumQuantity::Amplitude { definition }, &surface);
    let scales = amplitudes(&surface.psd, definition);
    let expected: Vec<f64> = scales.iter().map(|scale| scale.amplitude_m).collect();
    assert_all_near(&filled(&found.table, "amplitude_m"), &expected, 1e-12);
    let drawn = found.figure.unwrap();
    let highest = drawn.series[0].points.iter().map(|point| point.1).fold(0.0, f64::max);
    assert_near(highest, expected.iter().copied().fold(0.0, f64::max), 1e-12);
    assert!(!has(&found.notes, RemarkCode::NotGaussianMoments));
    let plain = SpectrumQuestion::default().answer(&surface, &Unobserved).unwrap();
    assert!(plain.figure.is_none());
}

#[test]
fn a_fit_finds_the_hurst_exponent_of_a_power_law_in_its_band_and_doubts_one_out_of_range() {
    let fit = |from_m, to_m, surface: &Surface| {
        let found = of_spectrum(SpectrumQuantity::Fit { from_m, to_m }, surface);
        assert!(found.figure.is_none());
        (filled(&found.table, "hurst_exponent")[0], found.notes)
    };
    // C1D falls with q^-(1 + 2 H).
    for (exponent, hurst) in [(2.6, 0.8), (3.4, 1.2), (0.6, -0.2)] {
        let (found, notes) = fit(None, None, &power_law(exponent));
        assert!((found - hurst).abs() < 1e-6, "{found}");
        assert!(has(&notes, RemarkCode::PurePowerLaw));
        let is_out = !(0.0..=1.0).contains(&hurst);
        assert_eq!(has(&notes, RemarkCode::HurstOutOfRange), is_out);
        if is_out {
            assert_eq!(numbers_of(&notes, RemarkCode::HurstOutOfRange, ["hurst_exponent"]), [hurst]);
        }
    }
    // Steeper below 10 um than above.
    let row = |i: i32| {
        let wavelength_m = 1e-4 * 10f64.powf(f64::from(-i) / 10.0);
        let over = wavelength_m / 1e-5;
        format!("{wavelength_m:e},{:e}\n", 1e-20 * over.powf(if over > 1.0 { 1.6 } else { 2.6 }))
    };
    let kinked = spectrum_of(&(0..=20).map(row).collect::<String>());
    for (from_m, to_m, hurst) in [
        (Some(1e-5), Some(1e-6), 0.8),
        (Some(1e-6), Some(1e-5), 0.8),
        (Some(1.01e-5), None, 0.8),
        (None, Some(0.99e-5), 0.3),
    ] {
        let (found, _) = fit(from_m, to_m, &kinked);
        assert!((found - hurst).abs() < 1e-3, "{from_m:?} {to_m:?}: {found}");
    }
    // A plateau rolls off.
    let row = |i: i32| {
        let wavelength_m = 1e-4 * 10f64.powf(f64::from(-i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", 1e-20 * (wavelength_m / 2e-5).min(1.0).powf(2.6))
    };
    let (found, notes) = fit(None, None, &spectrum_of(&(0..=20).map(row).collect::<String>()));
    assert!((0.7..1.0).contains(&found) && !has(&notes, RemarkCode::PurePowerLaw), "{found}");
}

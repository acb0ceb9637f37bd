//! Everything that an answer says agrees, of two hundred drawn scenes: the seal with its interval, one range, the cause with the shares,
//! the next measurement with the widths, ticks with their rule, and what was asked with what is shown.

use conclusions::{
    AnswerUnderLoad, AskedValue, Cause, Conclusions, ModelCell, NextStep, PeakState, SealVerdict, Source,
    foremost, trust_left,
};
use findings::features::slope_shares;
use judge::{AGREEMENT, CurveVerdict, Reference, Verdict};
use study::interface::{InterfaceStates, Quantity, Slot};
use study::linear_laws::rms_gradients;
use study::models::Choice;
use units::RemarkCode;

use crate::drawn_scenes::{Answered, drawn};

const SCENES: usize = 200;

/// Counts of what the scenes showed, so that no check is empty.
#[derive(Debug, Default)]
struct Seen {
    tight: usize,
    likely: usize,
    open: usize,
    parted: usize,
    by_hardness: usize,
    by_roughness: usize,
    by_both: usize,
    by_growth: usize,
    by_adhesion: usize,
    flowed: usize,
    partly: usize,
    elastic: usize,
    ticks: usize,
    narrowing: usize,
    without_number: usize,
}

#[test]
fn the_relations_of_an_answer_hold_for_two_hundred_drawn_scenes() {
    let numbers: Vec<usize> = (0..SCENES).collect();
    let seen = numerics::parallel::map(&numbers, |&at| {
        let answered = Answered::new(&drawn(at));
        let mut seen = Seen::default();
        check(&answered, &mut seen);
        seen
    });
    let total = |of: fn(&Seen) -> usize| seen.iter().map(of).sum::<usize>();
    let counts = [
        total(|seen| seen.tight),
        total(|seen| seen.likely),
        total(|seen| seen.open),
        total(|seen| seen.parted),
        total(|seen| seen.by_hardness),
        total(|seen| seen.by_roughness),
        total(|seen| seen.by_both),
        total(|seen| seen.by_growth),
        total(|seen| seen.by_adhesion),
        total(|seen| seen.flowed),
        total(|seen| seen.partly),
        total(|seen| seen.elastic),
        total(|seen| seen.ticks),
        total(|seen| seen.narrowing),
        total(|seen| seen.without_number),
    ];
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
}

/// Shows the scene that a check fails on.
struct ShownIfWrong<'t>(&'t str);

impl Drop for ShownIfWrong<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("{}", self.0);
        }
    }
}

fn check(answered: &Answered, seen: &mut Seen) {
    let _shown = ShownIfWrong(&answered.text);
    let conclusions = answered.conclusions();
    assert!(!conclusions.loads.is_empty());
    let states = answered.scene.interface_states(&answered.results);
    for load in &conclusions.loads {
        check_range(answered, load, seen);
        check_ticks(answered, load, seen);
        check_cause(answered, load, seen);
        match &states {
            Some(states) => {
                check_seal(answered, &conclusions, load, states, seen);
                check_asked(answered, load, states, seen);
            }
            None => assert!(load.seal.is_none() && load.asked.is_empty()),
        }
    }
    check_next(&conclusions, seen);
    let left = conclusions.cautions.iter().map(trust_left).min();
    assert!(left.is_none_or(|left| left == conclusions.trust));
}

/// The one range holds the estimate and the range of the elements.
fn check_range(answered: &Answered, load: &AnswerUnderLoad, seen: &mut Seen) {
    let area = &load.area;
    assert!(0.0 < area.low && area.low <= area.high && area.high <= 1.0, "{area:?}");
    let headline = answered.judgement.as_ref().and_then(|judgement| judgement.headline(load.load));
    if let Some(headline) = headline {
        assert!(area.low <= headline.low && headline.high <= area.high, "{area:?} {headline:?}");
    }
    match area.area_fraction {
        Some(area_fraction) => assert!((area.low..=area.high).contains(&area_fraction), "{area:?}"),
        None => seen.without_number += 1,
    }
    if let Some(other) = load.otherwise {
        assert!(!(area.low..=area.high).contains(&other.area_fraction));
    }
}

/// A tick says that a model is within a factor of 4/3 of its elements, their error included.
fn check_ticks(answered: &Answered, load: &AnswerUnderLoad, seen: &mut Seen) {
    let judgement = answered.judgement.as_ref().unwrap();
    let row_of = |cell: &ModelCell| {
        let is_same = |row: &&CurveVerdict| (row.curve, row.load) == (cell.curve, load.load);
        judgement.curves.iter().find(is_same).unwrap()
    };
    for cell in load.references.iter().flat_map(|group| &group.models) {
        let row = row_of(cell);
        assert_eq!((row.verdict, row.ratio()), (cell.verdict, cell.ratio));
        let Some(ratio) = cell.ratio else { continue };
        let narrowed = AGREEMENT / (1.0 + row.elements.unwrap().relative_error());
        match cell.verdict {
            Verdict::TooLarge => assert!(ratio > narrowed && ratio > 1.0),
            Verdict::TooSmall => assert!(1.0 / ratio > narrowed && ratio < 1.0),
            Verdict::Agrees => {
                assert!(ratio.max(1.0 / ratio) <= narrowed);
                seen.ticks += 1;
            }
            Verdict::OutOfRange | Verdict::NotJudged => {}
        }
    }
    let tally = load.tally;
    let counted = tally.agree + tally.off + tally.not_valid + tally.not_judged + tally.of_other_elements;
    assert_eq!(counted, load.references.iter().map(|group| group.models.len()).sum::<usize>());
    if let Some(best) = load.best_model {
        assert_eq!(best.verdict, Verdict::Agrees);
        let distance = |cell: &ModelCell| cell.ratio.unwrap().ln().abs();
        let holding = load.references[0].models.iter().filter(|cell| row_of(cell).holds());
        assert!(holding.into_iter().all(|cell| distance(&best) <= distance(cell)));
    }
}

/// A cause is the hardness where the area is the load over it, and roughness where nothing flows.
fn check_cause(answered: &Answered, load: &AnswerUnderLoad, seen: &mut Seen) {
    let hardness_pa = match load.area.source {
        Source::Elements(Reference::Yielding { hardness_pa }) => Some(hardness_pa),
        Source::Model { curve } => {
            let flows = answered.scene.needs.curves[curve].model.entry.has(Choice::Strength);
            answered.scene.hardness_pa().filter(|_| flows)
        }
        _ => None,
    };
    let area_fraction = load.area.area_fraction.unwrap_or(load.area.high);
    let over_least = hardness_pa.map(|hardness_pa| area_fraction * hardness_pa / load.nominal_pressure_pa);
    let is_all_flow = over_least.is_some_and(|ratio| ratio <= 1.1) && area_fraction < 0.999;
    let decides = load.factor_of_hardness().is_some();
    if load.cause == Cause::Adhesion {
        seen.by_adhesion += 1;
        return;
    }
    assert_eq!(matches!(load.cause, Cause::Hardness { .. }), is_all_flow && !decides, "{load:?}");
    assert_eq!(matches!(load.cause, Cause::GrowthOfHardness { .. }), decides);
    match load.cause {
        Cause::GrowthOfHardness { .. } => seen.by_growth += 1,
        Cause::Hardness { .. } => seen.by_hardness += 1,
        Cause::Roughness { decade } | Cause::HardnessAndRoughness { decade, .. } => {
            let shares = slope_shares(&rms_gradients(&answered.results.psd));
            assert!(shares.iter().all(|other| other.share <= decade.share));
            let psd = &answered.results.psd;
            assert!(decade.longest_m <= psd.longest_wavelength_m());
            assert!(decade.shortest_m >= psd.shortest_wavelength_m());
            match load.cause {
                Cause::Roughness { .. } => seen.by_roughness += 1,
                _ => seen.by_both += 1,
            }
        }
        Cause::FullContact => assert!(area_fraction >= 0.999),
        Cause::Adhesion | Cause::Unknown => {}
    }
}

/// YES only above the whole interval of the pressure that closes the seal, NO only below all of it, and nothing leaks through a tight one.
fn check_seal(
    answered: &Answered,
    conclusions: &Conclusions,
    load: &AnswerUnderLoad,
    states: &InterfaceStates<'_>,
    seen: &mut Seen,
) {
    assert_eq!(load.seal.is_some(), states.request.seal.is_some());
    let Some(seal) = load.seal else { return };
    let closing = conclusions.seal.unwrap().closes.unwrap();
    let best_pa = closing.nominal_pressure_pa;
    assert!(closing.low <= best_pa && best_pa <= closing.high, "{closing:?}");
    let flows_pa = states.closed_by_yielding_from_pa();
    assert_eq!(closing.by_yielding, flows_pa == Some(best_pa));
    assert!(flows_pa.is_none_or(|flows_pa| best_pa <= flows_pa));
    let pressure_pa = load.nominal_pressure_pa;
    let is_parted = states.request.parts_bodies(pressure_pa);
    let first = conclusions.cautions.first().map(|caution| caution.code);
    if is_parted {
        assert_eq!((seal.verdict, first), (SealVerdict::Open, Some(RemarkCode::FluidParts)));
        seen.parted += 1;
        return;
    }
    let expected = match pressure_pa {
        _ if pressure_pa >= closing.high => SealVerdict::Tight,
        _ if pressure_pa >= best_pa => SealVerdict::LikelyTight,
        _ if pressure_pa >= closing.low => SealVerdict::LikelyOpen,
        _ => SealVerdict::Open,
    };
    assert_eq!(seal.verdict, expected);
    assert_eq!(seal.open_share.is_some(), answered.uncertainty.is_some());
    assert!(seal.open_share.is_none_or(|share| (0.0..=1.0).contains(&share)));
    let has_rate = states.request.seal.unwrap().joint.is_some();
    let is_open = pressure_pa < best_pa;
    assert_eq!(seal.leak_rate_m3_per_s.is_some(), has_rate && is_open, "{seal:?}");
    match seal.verdict {
        SealVerdict::Tight => seen.tight += 1,
        SealVerdict::LikelyTight | SealVerdict::LikelyOpen => seen.likely += 1,
        SealVerdict::Open => seen.open += 1,
    }
}

/// Checks that the scene's questions are answered, no others are, and each number is that of the state of the peaks.
fn check_asked(answered: &Answered, load: &AnswerUnderLoad, states: &InterfaceStates<'_>, seen: &mut Seen) {
    let text = &answered.text;
    let has = |key: &str| text.contains(key);
    let is_open = has("[interface]") && !has("gas =") && !has("shear_strength");
    let of_area = has("nominal_area") && !has("gas =") && !has("shear_strength") && !has("[seal]");
    let request = states.request;
    let conducts = request.conductivities.is_some();
    let asks_heat = of_area || has("thermal_conductivity") || has("gas =");
    let asks_current = of_area || has("resistivity");
    let shown = |wanted: &[Quantity]| load.asked.iter().any(|asked| wanted.contains(&asked.quantity));
    let heat = [
        Quantity::ThermalConductance,
        Quantity::ThermalConductanceWithGas,
        Quantity::GasConductance,
        Quantity::ThermalResistance,
    ];
    let current = [Quantity::ElectricalConductance, Quantity::ElectricalResistance];
    // In full contact some have no value.
    let has_value = |wanted: &[Quantity]| {
        let slot = |quantity| Slot { quantity, load: Some(load.load), curve: None };
        wanted.iter().any(|quantity| states.value(slot(*quantity)).ok().flatten().is_some())
    };
    let by_spots = if conducts { &heat[..2] } else { &heat[2..3] };
    for (wanted, is_asked, by) in [
        (&[Quantity::Stiffness][..], is_open, &[Quantity::Stiffness][..]),
        (&[Quantity::MeanGap], is_open, &[Quantity::MeanGap]),
        (&heat, asks_heat, by_spots),
        (&current, asks_current, &current),
    ] {
        assert_eq!(shown(wanted), is_asked && has_value(by), "{wanted:?} {:?}", load.asked);
    }
    assert_eq!(shown(&[Quantity::FrictionCoefficient]), has("shear_strength"));
    let resists = shown(&[Quantity::ThermalResistance, Quantity::ElectricalResistance]);
    assert_eq!(resists, has("nominal_area") && (shown(&heat) && conducts || shown(&current)));
    for asked in &load.asked {
        // Where some draws flow altogether no gap may be left.
        let may_close = asked.quantity == Quantity::MeanGap;
        assert!((asked.low > 0.0 || may_close && asked.low == 0.0) && asked.low <= asked.high, "{asked:?}");
        assert!(asked.value.is_none_or(|value| (asked.low..=asked.high).contains(&value)), "{asked:?}");
        check_state(answered, load, states, asked, seen);
    }
}

fn check_state(
    answered: &Answered,
    load: &AnswerUnderLoad,
    states: &InterfaceStates<'_>,
    asked: &AskedValue,
    seen: &mut Seen,
) {
    let Some(state) = asked.state else { return };
    let share = states.plastic_share(load.load).unwrap_or(0.0);
    let value = |quantity| {
        let slot = Slot { quantity, load: Some(load.load), curve: None };
        states.value(slot).ok().flatten()
    };
    let per_area = states.request.nominal_area_m2.unwrap_or(1.0);
    match state {
        PeakState::Elastic => {
            assert!(share <= 0.03);
            seen.elastic += 1;
        }
        PeakState::Partly | PeakState::Unknown => {
            assert!(share > 0.03);
            seen.partly += 1;
        }
        PeakState::Flowed => {
            assert!(share > 0.9);
            let theory = match asked.quantity {
                Quantity::ElectricalResistance => {
                    value(Quantity::ElectricalConductance).map(|found| 1.0 / (found * per_area))
                }
                Quantity::ThermalResistance => value(match states.request.gas {
                    Some(_) => Quantity::ThermalConductanceWithGas,
                    None => Quantity::ThermalConductance,
                })
                .map(|found| 1.0 / (found * per_area)),
                other => value(other),
            };
            let (theory, shown) = (theory.unwrap(), asked.value.unwrap());
            assert!((shown / theory - 1.0).abs() < 1e-12, "{shown} {theory}");
            assert!(answered.uncertainty.is_some() || asked.high / asked.low < 1.57, "{asked:?}");
            seen.flowed += 1;
        }
    }
}

/// Advice narrows the range by a tenth at least, the most useful first; the strength comes first where the area hangs on it.
fn check_next(conclusions: &Conclusions, seen: &mut Seen) {
    let middle = foremost(&conclusions.loads).unwrap();
    let widths: Vec<f64> = conclusions
        .next
        .iter()
        .filter_map(|step| match step {
            NextStep::MoreScans { width_ratio, .. }
            | NextStep::HeightScale { width_ratio, .. }
            | NextStep::Material { width_ratio, .. } => Some(*width_ratio),
            _ => None,
        })
        .collect();
    assert!(widths.iter().all(|width| *width < 0.9) && widths.is_sorted(), "{widths:?}");
    // No step narrows what the elements leave.
    let of_elements = middle.area.factor_of_elements.ln();
    let whole = of_elements.hypot(middle.area.of_inputs.map_or(0.0, |inputs| inputs.factor.ln()));
    assert!(widths.iter().all(|width| *width >= of_elements / whole * (1.0 - 1e-9)), "{widths:?} {middle:?}");
    seen.narrowing += widths.len();
    let warns = |code| conclusions.cautions.iter().any(|caution| caution.code == code);
    let has = |wanted: &NextStep| conclusions.next.contains(wanted);
    let is_of_surface = |step: &NextStep| matches!(step, NextStep::Surface { .. });
    assert_eq!(conclusions.next.iter().any(is_of_surface), warns(RemarkCode::MadeOfNumbers));
    assert_eq!(has(&NextStep::MoreScales), warns(RemarkCode::TooFewScales));
    let sticks = warns(RemarkCode::StickyByPastewka) || warns(RemarkCode::StickyByFuller);
    assert_eq!(has(&NextStep::Adhesion), sticks);
    assert!(conclusions.loads.iter().all(|load| (load.cause == Cause::Adhesion) == sticks));
    assert!(!sticks || !warns(RemarkCode::UpperBound));
    let is_blocker = |step: &&NextStep| {
        use NextStep::{Adhesion, Flatness, HardnessOfSofter, MoreScales, Surface};
        !matches!(step, Surface { .. } | MoreScales | Adhesion | Flatness { .. } | HardnessOfSofter { .. })
    };
    if matches!(middle.cause, Cause::Hardness { .. }) {
        let first = conclusions.next.iter().find(is_blocker);
        let is_of_hardness = |step: &NextStep| matches!(step, NextStep::Hardness | NextStep::Material { .. });
        assert!(first.is_none_or(is_of_hardness), "{first:?}");
        assert!(!conclusions.next.iter().any(|step| matches!(step, NextStep::CloseHole(_))));
    }
    let settles =
        |step: &NextStep| matches!(step, NextStep::Wavelengths { area_ratio, .. } if *area_ratio < 0.9);
    if conclusions.next.iter().any(settles) {
        assert!(warns(RemarkCode::UpperBound));
    }
}

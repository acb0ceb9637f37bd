//! The paper's statements on a strength that grows at small scales: rows 11, 12, 13, 16, 17 and 18.

use findings::features::{Plateau, ratio};
use stacked_contact::{Level, Regime};
use units::display::{length, pressure};

use super::area::{converged, level_part, slope_below};
use super::plasticity::agreement;
use super::{furthest_from_one, highest, lengths, lowest, numbers, range};
use crate::evidence::{
    ELASTIC, Evidence, GRADIENT_AND_PLAIN, HERTZ, Name, PLASTIC_GRADIENT, SINE_ELASTIC, SINE_GRADIENT,
    SPHERE_GRADIENT,
};
use crate::ledger::{Finding, Statement, verdict};

pub(super) const STACK_RETURNS_TO_ELASTIC: Statement = Statement {
    number: 11,
    statement: "With the strain gradient the stacked elastic-plastic area returns to the elastic one at the last scales.",
    how: "Ratio of the two areas over all cutoffs and loads, and how many levels yield. Reproduced if it ends within 1 % of 1 \
              at every load.",
    unit: "last ratio furthest from 1",
    check: |evidence| {
        let pairs = evidence.areas_of([PLASTIC_GRADIENT, ELASTIC]).into_iter();
        let ratios: Vec<Vec<(f64, f64)>> =
            pairs.map(|[gradient, elastic]| ratio(&gradient, &elastic)).collect();
        let finals: Vec<f64> =
            ratios.iter().filter_map(|ratio| ratio.last()).map(|(_, ratio)| *ratio).collect();
        let returns = agreement(evidence, PLASTIC_GRADIENT, ELASTIC).iter().all(Option::is_some);
        let (_, levels) = evidence.stack(PLASTIC_GRADIENT);
        let yielding = levels.iter().flatten().filter(|level| level.regime == Regime::Plastic).count();
        Finding::new(
            furthest_from_one(&finals),
            format!(
                "ratio {} at the end, {} over all cutoffs; {yielding} of {} levels yield",
                numbers(finals),
                numbers(ratios.iter().flatten().map(|(_, ratio)| *ratio)),
                levels.iter().flatten().count()
            ),
            verdict(returns),
            match (returns, yielding) {
                (true, 0) => {
                    "It is the elastic area throughout: no scale yields at these loads, so there is nothing to return from."
                }
                (true, _) => "It leaves the elastic area where scales yield and comes back to it.",
                (false, _) => "It does not come back to the elastic area within this spectrum.",
            }
            .to_owned(),
        )
    },
};

pub(super) const STATISTICAL_STAY_PLASTIC: Statement = Statement {
    number: 12,
    statement: "With the strain gradient the statistical elastic-plastic models still differ from the elastic ones.",
    how: "Ratio of area with strain gradient to the elastic area at the last cutoff, spheres and sinusoids, at every load. \
              Reproduced if all differ from 1 by more than 10 %.",
    unit: "ratio nearest to 1",
    check: |evidence| {
        let spheres = final_ratios(evidence, SPHERE_GRADIENT, HERTZ);
        let sines = final_ratios(evidence, SINE_GRADIENT, SINE_ELASTIC);
        let both = || spheres.iter().chain(&sines).copied();
        let nearest = both().min_by(|a, b| (a - 1.0).abs().total_cmp(&(b - 1.0).abs()));
        let differ = both().all(|ratio| (ratio - 1.0).abs() > 0.1);
        let below = both().any(|ratio| ratio < 1.0);
        Finding::new(
            nearest.unwrap_or(f64::NAN),
            format!("spheres {}, sinusoids {}", numbers(spheres.iter().copied()), numbers(sines.iter().copied())),
            verdict(differ),
            match (differ, below) {
                (true, true) => {
                    "They differ, but some lie below the elastic area: the sphere's law is used far beyond the strengths it was \
                     fitted to."
                }
                (true, false) => "They differ, and lie above the elastic areas.",
                (false, _) => "Some of them come within 10 % of the elastic area.",
            }
            .to_owned(),
        )
    },
};

pub(super) const STRENGTH_AT_DEPTH: Statement = Statement {
    number: 13,
    statement: "The strength is of the order of 40 to 45 GPa at a few nm, and 29 GPa at 10 to 40 nm.",
    how: "Eq. (8) at depths of 3 nm and 20 nm, and the strengths that the scales of the stack meet. Reproduced if the formula \
              gives 30 to 60 GPa at 3 nm, 20 to 40 GPa at 20 nm, and some scale of the stack meets a strength below 60 GPa.",
    unit: "Pa, Eq. (8) at 3 nm",
    check: |evidence| {
        let (model, levels) = evidence.stack(PLASTIC_GRADIENT);
        let strength = model.strength().expect("this stack yields");
        let (shallow_pa, deep_pa) = (strength.at_depth_pa(3e-9), strength.at_depth_pa(20e-9));
        // The first scale meets the strength at large depth; if nothing was deformed above, there is none.
        let met = |levels: &Vec<Level>| -> Vec<f64> {
            let strengths = levels.iter().skip(1).filter_map(|level| level.yield_strength_pa);
            strengths.filter(|strength_pa| strength_pa.is_finite()).collect()
        };
        let met: Vec<f64> = levels.iter().flat_map(met).collect();
        let least_pa = lowest(met.iter().copied());
        let formula = (30e9..=60e9).contains(&shallow_pa) && (20e9..=40e9).contains(&deep_pa);
        let holds = formula && least_pa <= 60e9;
        Finding::new(
            shallow_pa,
            format!(
                "Eq. (8): {} at 3 nm, {} at 20 nm; the scales of the stack meet {}",
                pressure(shallow_pa),
                pressure(deep_pa),
                range(met, pressure)
            ),
            verdict(holds),
            if holds {
                "Formula and stack agree with the printed strengths in order of magnitude."
            } else {
                "Eq. (8) gives the printed strengths only at somewhat larger depths, and the shallow deformation of the scales \
                 makes them stronger still in the stack."
            }
            .to_owned(),
        )
    },
};

pub(super) const LOWERS_AREA: Statement = Statement {
    number: 16,
    statement: "A strength that grows at small scales lowers the area.",
    how: "Ratio of the area with strain gradient to that without at the last cutoff, for the stack, spheres and sinusoids, and \
              the cutoffs at which it is above 1. Reproduced if every last ratio is below 1.",
    unit: "largest last ratio",
    check: |evidence| {
        let finals = GRADIENT_AND_PLAIN.map(|(gradient, plain)| final_ratios(evidence, gradient, plain));
        let largest = highest(finals.iter().flatten().copied());
        let raised: Vec<String> = GRADIENT_AND_PLAIN
            .iter()
            .filter_map(|(gradient, plain)| {
                let cutoffs_m = raised_cutoffs_m(evidence, *gradient, *plain);
                (!cutoffs_m.is_empty()).then(|| format!("{} at {}", gradient.0, lengths(cutoffs_m)))
            })
            .collect();
        Finding::new(
            largest,
            format!(
                "stack {}, spheres {}, sinusoids {}; raised by more than 0.1 %: {}",
                numbers(finals[0].iter().copied()),
                numbers(finals[1].iter().copied()),
                numbers(finals[2].iter().copied()),
                if raised.is_empty() { "nowhere".to_owned() } else { raised.join(", ") }
            ),
            verdict(largest < 1.0),
            match (largest < 1.0, raised.is_empty()) {
                (true, true) => "It does, at every cutoff.",
                (true, false) => "It does at the last cutoff, though not at every longer one, where the published laws step down.",
                (false, _) => "Not in every model.",
            }
            .to_owned(),
        )
    },
};

pub(super) const STACK_CONVERGES: Statement = Statement {
    number: 17,
    statement: "With the strain gradient the stacked area converges between 1 and 10 nm.",
    how: "Convergence wavelength at 1 % and 0.1 % at every load. Reproduced if those at 1 % mean convergence and lie there.",
    unit: "m, at 1 %",
    check: |evidence| {
        let curves = evidence.areas(PLASTIC_GRADIENT);
        let found = converged(&curves, 0.01);
        let certain = found.iter().all(|found| found.converged);
        let within = found.iter().all(|found| (1e-9..=10e-9).contains(&found.wavelength_m));
        Finding::new(
            found[0].wavelength_m,
            format!(
                "{} (1 %), {} (0.1 %); the spectrum ends at {}",
                lengths(found.iter().map(|found| found.wavelength_m)),
                lengths(converged(&curves, 0.001).iter().map(|found| found.wavelength_m)),
                length(evidence.shortest_m())
            ),
            verdict(certain && within),
            match (certain, within) {
                (true, true) => "It converges there, at every load, as the elastic stack does.",
                (true, false) => "It converges elsewhere.",
                (false, _) => {
                    "The spectrum ends less than half a decade below, so it cannot show convergence."
                }
            }
            .to_owned(),
        )
    },
};

pub(super) const SPHERES_LEVEL_OFF: Statement = Statement {
    number: 18,
    statement: "With the strain gradient the elastic-plastic sphere model is level near 0.1 um and falls again below 1 nm.",
    how: "Widest stretch of area against cutoff that is level within a factor of 1.2; exponent below 1 nm. Reproduced if the \
              stretch spans half a decade and includes 0.1 um at every load, and the exponent is above 0.1.",
    unit: "exponent below 1 nm, or over the last decade where the spectrum ends before",
    check: |evidence| {
        let curves = evidence.areas(SPHERE_GRADIENT);
        let plateaus: Vec<Plateau> = curves.iter().filter_map(|curve| level_part(curve)).collect();
        let level = !curves.is_empty()
            && plateaus.len() == curves.len()
            && plateaus.iter().all(|plateau| {
                plateau.decades() >= 0.5 && plateau.longest_m >= 0.1e-6 && plateau.shortest_m <= 0.1e-6
            });
        let reaches = evidence.shortest_m() < 1e-9;
        let from_m = if reaches { 1e-9 } else { 10.0 * evidence.shortest_m() };
        let slopes: Vec<f64> = curves.iter().filter_map(|curve| slope_below(curve, from_m)).collect();
        let falls = reaches && lowest(slopes.iter().copied()) > 0.1;
        let parts = [(level, "the level part near 0.1 um"), (falls, "the fall below 1 nm")];
        let mut finding = Finding::of_parts(
            lowest(slopes.iter().copied()),
            format!(
                "level from {} down to {}; exponent {} below {}",
                lengths(plateaus.iter().map(|plateau| plateau.longest_m)),
                lengths(plateaus.iter().map(|plateau| plateau.shortest_m)),
                numbers(slopes.iter().copied()),
                length(from_m)
            ),
            &parts,
        );
        if !reaches {
            finding.remark +=
                &format!(" The spectrum ends at {}, before 1 nm.", length(evidence.shortest_m()));
        }
        finding
    },
};

/// Ratio of two families of curves at the last cutoff, for every load.
fn final_ratios(evidence: &Evidence, numerator: Name, denominator: Name) -> Vec<f64> {
    let pairs = evidence.areas_of([numerator, denominator]).into_iter();
    pairs.filter_map(|[above, below]| Some(above.last()?.1 / below.last()?.1)).collect()
}

/// Cutoffs \[m\], at any load, at which the strain gradient raises the area.
fn raised_cutoffs_m(evidence: &Evidence, gradient: Name, plain: Name) -> Vec<f64> {
    let pairs = evidence.areas_of([gradient, plain]).into_iter();
    let raised = pairs.flat_map(|[gradient, plain]| ratio(&gradient, &plain));
    raised.filter(|(_, ratio)| *ratio > 1.001).map(|(wavelength_m, _)| wavelength_m).collect()
}

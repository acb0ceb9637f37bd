//! The paper's statements on yielding and hardness: rows 5, 9 and 15.

use asperity::ElasticPlasticSinusoid;
use findings::features::{agrees_from, ratio};
use stacked_contact::setting_level;
use units::display::{length, three_digits};

use super::{lengths, lowest, numbers};
use crate::evidence::{ALL, Evidence, Name, PLASTIC, PLASTIC_AND_ELASTIC};
use crate::ledger::{Finding, Statement, verdict};

pub(super) const CONVERGED_PRESSURE: Statement = Statement {
    number: 5,
    statement: "The converged real pressure of the elastic-plastic stack is about 8 H.",
    how: "Load over area at the last cutoff, in H, at every load; beside it the full-contact pressure p*_ep of the setting \
              scale, and twice that. Reproduced if the first lies between 6 H and 10 H.",
    unit: "H",
    check: |evidence| {
        let pressures = real_pressures(evidence, PLASTIC);
        let (model, levels) = evidence.stack(PLASTIC);
        let strength_pa = model.strength().expect("this stack yields").macroscopic_strength_pa();
        let (level, _) = setting_level(&model, &levels[0]).expect("the paper's spectrum has scales");
        let aspect_ratio = level.amplitude_m / level.wavelength_m;
        let sinusoid = ElasticPlasticSinusoid::new(model.pair(), aspect_ratio, strength_pa);
        let complete = sinusoid.complete_contact_pressure_pa() / evidence.hardness_pa();
        let holds = pressures.iter().all(|pressure| (6.0..=10.0).contains(pressure));
        Finding::new(
            pressures[0],
            format!(
                "{} H; p*_ep of the setting scale {} H, twice that {} H",
                numbers(pressures),
                three_digits(complete),
                three_digits(2.0 * complete)
            ),
            verdict(holds),
            "The area law exceeds complete contact and is held at it, so scales flatten at about half of p*_ep; p*_ep and \
                     twice that are given beside it, and nothing is tuned towards 8 H."
                .to_owned(),
        )
    },
};

pub(super) const PLASTIC_ABOVE_ELASTIC: Statement = Statement {
    number: 9,
    statement: "The elastic-plastic areas lie above the elastic ones, from cutoffs of 1 to 10 um on.",
    how: "The longest cutoff from which on the elastic-plastic area is more than 1 % above the elastic one, for the stack, \
              spheres and sinusoids at every load; the ratio at the last cutoff. Reproduced if all of them part so, at 1 to 10 um.",
    unit: "smallest ratio at the last cutoff",
    check: |evidence| {
        let mut partings = Vec::new();
        let mut finals = Vec::new();
        let mut all_part = true;
        for (plastic, elastic) in PLASTIC_AND_ELASTIC {
            let mut own = Vec::new();
            for [plastic, elastic] in evidence.areas_of([plastic, elastic]) {
                let ratios = ratio(&plastic, &elastic);
                finals.extend(ratios.last().map(|(_, ratio)| *ratio));
                let above = ratios.iter().rev().take_while(|(_, ratio)| *ratio > 1.01).last();
                all_part &= above.is_some();
                own.extend(above.map(|(wavelength_m, _)| *wavelength_m));
            }
            partings.push((plastic, own));
        }
        let within = partings.iter().flat_map(|(_, own)| own).all(|parting| (1e-6..=10e-6).contains(parting));
        let list = |(name, own): &(Name, Vec<f64>)| {
            let at = if own.is_empty() { "not".to_owned() } else { lengths(own.iter().copied()) };
            format!("{} {at}", name.0)
        };
        let least = lowest(finals.iter().copied());
        Finding::new(
            least,
            format!(
                "above for good from: {}; ratio at {}: {}",
                partings.iter().map(list).collect::<Vec<_>>().join(", "),
                length(evidence.shortest_m()),
                numbers(finals)
            ),
            verdict(all_part && within),
            match (all_part, within) {
                (true, true) => "All three part in that range and end above.",
                (true, false) => "All three end above the elastic ones, but not all part within 1 to 10 um.",
                (false, _) => "Not all of them end above the elastic ones.",
            }
            .to_owned(),
        )
    },
};

pub(super) const BEYOND_HARDNESS: Statement = Statement {
    number: 15,
    statement: "Hardness does not limit the real pressure.",
    how: "Load over area at the last cutoff, in H, for every model at every load. Reproduced if all are above 1 H.",
    unit: "H, the lowest",
    check: |evidence| {
        let of = |name: &Name| (name.0, real_pressures(evidence, *name));
        let pressures: Vec<(&str, Vec<f64>)> = ALL.iter().map(of).collect();
        let least = lowest(pressures.iter().flat_map(|(_, pressures)| pressures.iter().copied()));
        let list =
            |(name, pressures): &(&str, Vec<f64>)| format!("{name} {}", numbers(pressures.iter().copied()));
        Finding::new(
            least,
            format!("in H: {}", pressures.iter().map(list).collect::<Vec<_>>().join(", ")),
            verdict(least > 1.0),
            if least > 1.0 {
                "Every model ends above the hardness: neighbouring scales carry each other, or the strength has grown."
            } else {
                "Some models end below the hardness on this spectrum."
            }
            .to_owned(),
        )
    },
};

/// Load over final area in units of the hardness, for every load.
pub(super) fn real_pressures(evidence: &Evidence, name: Name) -> Vec<f64> {
    let hardness_pa = evidence.hardness_pa();
    evidence.final_areas(name).into_iter().map(|(load_pa, area)| load_pa / area / hardness_pa).collect()
}

/// Cutoff from which two families of curves agree within 1 % down to the end, at every load; `None` if they do not.
pub(super) fn agreement(evidence: &Evidence, one: Name, other: Name) -> Vec<Option<f64>> {
    let pairs = evidence.areas_of([one, other]).into_iter();
    pairs.map(|[one, other]| agrees_from(&ratio(&one, &other), 0.01)).collect()
}

//! What the interface does besides touching, in plain words.

use interface::conductance::{ELECTRON_MEAN_FREE_PATH_M, MOST_PLASTIC_SHARE, PressureRatio};
use study::interface::{InterfaceStates, Quantity, Slot};
use study::scene::Scene;
use uncertainty::Uncertainty;
use units::display::{counted, length, pressure, three_digits};

use crate::coverage::level;
use crate::curve_names::in_full;
use crate::listing::{capital, listed};
use crate::persson_words;

/// More loads than this are left to the table.
const LOADS_TOLD: usize = 3;

/// `mean gap 2.31 um`, with its unit.
pub(crate) fn value(quantity: Quantity, value: f64) -> String {
    match quantity.unit() {
        "m" => length(value),
        "Pa" => pressure(value),
        "" => three_digits(value),
        unit => format!("{} {unit}", three_digits(value)),
    }
}

/// `2.31 um (95 %: 2.1 um to 2.5 um)`.
pub(crate) fn with_interval(slot: Slot, found: f64, uncertainty: Option<&Uncertainty>) -> String {
    let own = value(slot.quantity, found);
    let interval = uncertainty.and_then(|uncertainty| {
        let interval = uncertainty.quantity(slot).filter(|interval| interval.low < interval.high)?;
        let [low, high] = [interval.low, interval.high].map(|end| value(slot.quantity, end));
        Some(format!(" ({}: {low} to {high})", level(uncertainty)))
    });
    own + &interval.unwrap_or_default()
}

/// What is told in short: a sentence for what all loads share, and one for each of the first loads.
pub(crate) fn sentences(
    states: &InterfaceStates<'_>,
    scene: &Scene,
    uncertainty: Option<&Uncertainty>,
) -> Vec<String> {
    let slots = states.slots();
    let told = |slot: &Slot| {
        let found = states.value(*slot).ok().flatten()?;
        let of_curve = slot
            .curve
            .map_or_else(String::new, |curve| format!(" by {}", in_full(&scene.needs.curves[curve])));
        Some(format!("{}{of_curve} {}", slot.quantity.words(), with_interval(*slot, found, uncertainty)))
    };
    let of = |load: Option<usize>| -> Vec<String> {
        slots.iter().filter(|slot| slot.load == load).filter_map(told).collect()
    };
    let loads = &scene.needs.loads;
    let mut sentences: Vec<String> = (0..loads.len().min(LOADS_TOLD))
        .map(|load| {
            let tight = is_tight(states, &slots, load).then(|| "no channel is open: tight".to_owned());
            let parts: Vec<String> = of(Some(load)).into_iter().chain(tight).collect();
            format!("What it means at {}: {}.", loads[load].label, parts.join("; "))
        })
        .collect();
    if loads.len() > LOADS_TOLD {
        let more = counted(loads.len() - LOADS_TOLD, "load");
        sentences.push(format!("{} more in report-interface.", capital(&more)));
    }
    let of_all = of(None);
    sentences.extend((!of_all.is_empty()).then(|| format!("{}.", capital(&of_all.join("; ")))));
    sentences
}

fn is_tight(states: &InterfaceStates<'_>, slots: &[Slot], load: usize) -> bool {
    let of_channel = |slot: &&Slot| slot.load == Some(load) && slot.quantity == Quantity::ChannelWavelength;
    slots.iter().find(of_channel).is_some_and(|slot| matches!(states.value(*slot), Ok(None)))
}

/// What the numbers leave out or go beyond.
pub(crate) fn notes(states: &InterfaceStates<'_>, scene: &Scene) -> Vec<String> {
    let loads = &scene.needs.loads;
    let least_pa = loads.iter().map(|load| load.nominal_pressure_pa()).fold(f64::INFINITY, f64::min);
    let mut notes = match states.light_loads() {
        Some(light) => persson_words::separation(&light, states.roughness(), states.rms_height_m(), least_pa),
        None => Vec::new(),
    };
    let at = |is_meant: &dyn Fn(usize) -> bool| -> Vec<&str> {
        (0..loads.len()).filter(|load| is_meant(*load)).map(|load| loads[load].label.as_str()).collect()
    };
    let plastic = at(&|load| states.plastic_share(load).is_some_and(|share| share > MOST_PLASTIC_SHARE));
    if !plastic.is_empty() {
        notes.push(format!(
            "at {} more than {} % of the contact has flowed: gap, stiffness and what follows from them are those of the elastic \
             theory, and say less the more has flowed",
            listed(&plastic),
            100.0 * MOST_PLASTIC_SHARE
        ));
    }
    let asked = states.asked();
    if asked.conductivities.is_some() || asked.resistivities.is_some() {
        notes.push(format!(
            "conductances take both bodies to be clean (films are not considered) and spots to be wider than the mean free path of \
             what crosses them, about {} for electrons in a good metal",
            length(ELECTRON_MEAN_FREE_PATH_M)
        ));
    }
    if asked.conductivities.is_some() && scene.hardness_pa().is_some() {
        notes.extend(states.mean_absolute_slope().ok().map(|slope| {
            format!(
                "the correlations for flowed peaks take the mean absolute slope at {}, {}: it grows with every shorter wavelength, \
                 and so do they; Barber’s analogy does not",
                length(states.pressed().results.psd.shortest_wavelength_m()),
                three_digits(slope)
            )
        }));
        let outside = at(&|load| {
            states.pressure_ratio(load).ok().flatten().is_some_and(|ratio| !ratio.range().is_within())
        });
        let [least, most] = PressureRatio::FITTED;
        if !outside.is_empty() {
            notes.push(format!(
                "at {} the pressure over the hardness is outside {least} to {most}, for which these correlations stand",
                listed(&outside)
            ));
        }
    }
    if let Some(seal) = &asked.seal {
        notes.push(format!(
            "channels close where {} of the nominal area touches; contact areas of the seal are those of a form fitted to boundary \
             elements, and a leak rate is an order of magnitude",
            seal.threshold.area_fraction()
        ));
    }
    if asked.adhesion.is_some() {
        notes.push(
            "the parameters of adhesion are indicators at the shortest wavelength; no area follows from them"
                .to_owned(),
        );
    }
    notes
}

/// Which keys would give more.
pub(crate) fn further_keys(scene: &Scene) -> Option<String> {
    let asked = scene.interface.as_ref();
    let is_missing = |has: Option<bool>| !has.unwrap_or(false);
    let keys = [
        (asked.is_none(), "[interface] (mean gap and stiffness)"),
        (
            is_missing(asked.map(|asked| asked.conductivities.is_some())),
            "thermal_conductivity of [material] and [counterface] (heat)",
        ),
        (is_missing(asked.map(|asked| asked.resistivities.is_some())), "resistivity of both (current)"),
        (is_missing(asked.map(|asked| asked.seal.is_some())), "[seal] (leaks)"),
        (
            is_missing(asked.map(|asked| asked.shear_strength_pa.is_some())),
            "interface.shear_strength (friction)",
        ),
        (is_missing(asked.map(|asked| asked.adhesion.is_some())), "interface.work_of_adhesion (adhesion)"),
    ];
    let missing: Vec<&str> = keys.iter().filter(|(is_missing, _)| *is_missing).map(|(_, key)| *key).collect();
    (!missing.is_empty())
        .then(|| format!("More of what the contact does is told where the scene has {}.", listed(&missing)))
}
